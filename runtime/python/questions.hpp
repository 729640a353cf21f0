// python/questions.hpp: the answers about two sets, as methods of a class of Python.
#ifndef MEETC_PYTHON_QUESTIONS_HPP
#define MEETC_PYTHON_QUESTIONS_HPP

#include "meet/core/answers/pair_list.hpp"
#include "meet/python/arrays.hpp"

namespace meetc::python {

// `Question` has result ask(answer_kind, bool first_met), which is called with the interpreter's lock. Elements are int32 in
// Python: no_element is -1, and every other number is an element, since a set has at most 2^31 - 1.
template <class Question> void bind_answers(py::class_<Question> &to) {
  to.def(
      "pairs",
      [](const Question &q, bool turn) {
        result found = q.ask(answer_kind::pairs, false);
        if (turn) {
          const py::gil_scoped_release others_run;
          found.pairs = transposed(std::move(found.pairs));
        }
        const auto rows = static_cast<py::ssize_t>(found.pairs.size());
        return as_array<std::int32_t>(std::move(found.pairs), {rows, 2});
      },
      py::arg("turn"));
  to.def("flags", [](const Question &q) {
    result found = q.ask(answer_kind::flags, false);
    return py::make_tuple(as_array<bool>(std::move(found.flags.a)), as_array<bool>(std::move(found.flags.b)));
  });
  to.def("counts", [](const Question &q) {
    result found = q.ask(answer_kind::counts, false);
    return py::make_tuple(as_array<std::int64_t>(std::move(found.counts.a)),
                          as_array<std::int64_t>(std::move(found.counts.b)));
  });
  to.def("count", [](const Question &q) { return q.ask(answer_kind::count, false).count; });
  to.def("any", [](const Question &q) { return q.ask(answer_kind::any, false).count != 0; });
  to.def("first",
         [](const Question &q) { return as_array<std::int32_t>(std::move(q.ask(answer_kind::none, true).first_met)); });
}

} // namespace meetc::python

#endif
