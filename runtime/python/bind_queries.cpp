#include "meet/core/answers/pair_list.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/faults.hpp"
#include "meet/python/poses.hpp"

#include <limits>

namespace meetc::python {

namespace {

// A query of two sets in the order of the predicate's kinds.
struct question {
  std::shared_ptr<prepared> a, b;
  std::string predicate, precision;
  std::optional<py::array> owner_a, owner_b;
  int threads;
};

result ask(const question &q, answer_kind want, bool first = false) {
  collide_options options;
  options.want = want;
  options.first_met = first;
  options.threads = q.threads;
  options.owner_a = owners_of(q.owner_a);
  options.owner_b = owners_of(q.owner_b);
  options.progress = check_signals();
  const predicate_info &predicate = predicate_named(q.predicate);
  const rung precision = rung_named(q.precision);
  const py::gil_scoped_release others_run;
  return collide(*q.a, *q.b, predicate, precision, options);
}

// Elements as int32: no_element is -1, and every other number is an element, since a set of Python has at most 2^31 - 1.
py::array pairs(const question &q, bool turn) {
  result found = ask(q, answer_kind::pairs);
  if (turn) {
    const py::gil_scoped_release others_run;
    found.pairs = transposed(std::move(found.pairs));
  }
  const auto rows = static_cast<py::ssize_t>(found.pairs.size());
  return as_array<std::int32_t>(std::move(found.pairs), {rows, 2});
}

py::tuple flags(const question &q) {
  result found = ask(q, answer_kind::flags);
  return py::make_tuple(as_array<bool>(std::move(found.flags.a)), as_array<bool>(std::move(found.flags.b)));
}

py::tuple counts(const question &q) {
  result found = ask(q, answer_kind::counts);
  return py::make_tuple(as_array<std::int64_t>(std::move(found.counts.a)),
                        as_array<std::int64_t>(std::move(found.counts.b)));
}

py::array poses(const question &q, bool still_first, const py::array &at, bool any) {
  require_packed(at, "f", 8, 2, "poses");
  if (at.shape(1) != 12)
    throw py::type_error("poses: twelve numbers are needed for each");
  const predicate_info &predicate = predicate_named(q.predicate);
  collide_options options;
  options.want = any ? answer_kind::any : answer_kind::count;
  options.threads = q.threads;
  options.owner_a = owners_of(q.owner_a);
  options.owner_b = owners_of(q.owner_b);
  options.progress = check_signals();
  const posed_query query{
      still_first ? *q.a : *q.b, still_first ? *q.b : *q.a, predicate, still_first, rung_named(q.precision), options};
  std::vector<std::int64_t> found;
  {
    const py::gil_scoped_release others_run;
    found = over_poses(query, span_of<double>(at));
  }
  return as_array<std::int64_t>(std::move(found));
}

} // namespace

void bind_queries(py::module_ &module) {
  py::class_<question>(module, "Question", "Two sets in the order of the predicate's kinds.")
      .def(py::init([](std::shared_ptr<prepared> a, std::shared_ptr<prepared> b, std::string predicate,
                       std::string precision, std::optional<py::array> owner_a, std::optional<py::array> owner_b,
                       int threads) {
             return question{
                 std::move(a),       std::move(b), std::move(predicate), std::move(precision), std::move(owner_a),
                 std::move(owner_b), threads};
           }),
           py::arg("a"), py::arg("b"), py::arg("predicate"), py::arg("precision"), py::arg("owner_a"),
           py::arg("owner_b"), py::arg("threads"))
      .def("pairs", &pairs, py::arg("turn"))
      .def("flags", &flags)
      .def("counts", &counts)
      .def("count", [](const question &q) { return ask(q, answer_kind::count).count; })
      .def("any", [](const question &q) { return ask(q, answer_kind::any).count != 0; })
      .def("first",
           [](const question &q) {
             return as_array<std::int32_t>(std::move(ask(q, answer_kind::count, true).first_met));
           })
      .def("poses", &poses, py::arg("still_first"), py::arg("poses"), py::arg("any"));
}

} // namespace meetc::python
