#include "meet/core/query/collide.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/poses.hpp"
#include "meet/python/questions.hpp"
#include "meet/python/signals.hpp"

namespace meetc::python {

namespace {

// A query of two sets in the order of the predicate's kinds.
struct question {
  std::shared_ptr<prepared> a, b;
  std::string predicate, precision;
  std::optional<py::array> owner_a, owner_b;
  int threads;

  collide_options options(answer_kind want) const {
    collide_options out;
    out.want = want;
    out.threads = threads;
    out.owner_a = owners_of(owner_a);
    out.owner_b = owners_of(owner_b);
    return out;
  }
  result ask(answer_kind want, bool first_met) const {
    collide_options how = options(want);
    how.first_met = first_met;
    const predicate_info &by = predicate_named(predicate);
    const rung with = rung_named(precision);
    result found;
    stoppable(a->elements() + b->elements(), [&](const std::stop_token &stop) {
      how.stop = stop;
      found = collide(*a, *b, by, with, how);
    });
    return found;
  }
};

py::array poses(const question &q, bool still_first, const py::array &at, bool any) {
  require_packed(at, "f", 8, 2, "poses");
  if (at.shape(1) != 12)
    throw py::type_error("poses: twelve numbers are needed for each");
  const predicate_info &predicate = predicate_named(q.predicate);
  posed_query query{still_first ? *q.a : *q.b,
                    still_first ? *q.b : *q.a,
                    predicate,
                    still_first,
                    rung_named(q.precision),
                    q.options(any ? answer_kind::any : answer_kind::count)};
  std::vector<std::int64_t> found;
  const std::span<const double> matrices = span_of<double>(at);
  stoppable((q.a->elements() + q.b->elements()) * matrices.size(), [&](const std::stop_token &stop) {
    query.options.stop = stop;
    found = over_poses(query, matrices);
  });
  return as_array<std::int64_t>(std::move(found));
}

} // namespace

void bind_queries(py::module_ &module) {
  py::class_<question> of(module, "Question", "Two sets in the order of the predicate's kinds.");
  of.def(py::init([](std::shared_ptr<prepared> a, std::shared_ptr<prepared> b, std::string predicate,
                     std::string precision, std::optional<py::array> owner_a, std::optional<py::array> owner_b,
                     int threads) {
           return question{
               std::move(a),       std::move(b), std::move(predicate), std::move(precision), std::move(owner_a),
               std::move(owner_b), threads};
         }),
         py::arg("a"), py::arg("b"), py::arg("predicate"), py::arg("precision"), py::arg("owner_a"), py::arg("owner_b"),
         py::arg("threads"));
  bind_answers(of);
  of.def("poses", &poses, py::arg("still_first"), py::arg("poses"), py::arg("any"));
}

} // namespace meetc::python
