// The functions in a runtime's table as anyone may call them: under any control word. Each is an entry of the library, and
// holds its guard.
#ifndef MEETC_TABLE_TABLE_ENTRY_HPP
#define MEETC_TABLE_TABLE_ENTRY_HPP

#include <meetc/environment/control_word.hpp>

#include <cstddef>

MEETC_NAMESPACE(meetc) {

template <auto Function> struct table_entry;
template <class Result, class... Arguments, Result (*Function)(Arguments...)> struct table_entry<Function> {
  static Result call(Arguments... arguments) {
    return under_standard_word([&]() -> Result { return Function(arguments...); });
  }
};
// The same function, under the standard word.
template <auto Function> inline constexpr auto guarded = &table_entry<Function>::call;

template <class Shape> void write_boxes(const float *rows, std::size_t n, float *out) {
  for (std::size_t i = 0; i < n; ++i, rows += Shape::fields, out += 6)
    Shape::box(rows, out, out + 3);
}
// kind_info::boxes of a shape.
template <class Shape> inline constexpr auto boxes_of = guarded<write_boxes<Shape>>;

} // MEETC_NAMESPACE(meetc)

#endif
