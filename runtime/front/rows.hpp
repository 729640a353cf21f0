// front/rows.hpp: views of what a program has: ranges, matrices, members of records, pointers with strides.
//
// Nothing is copied, and no number is converted: memory of another type than float is refused when it is compiled. A row<N> is
// where N numbers that belong together lie, one row behind another.
#ifndef MEET_FRONT_ROWS_HPP
#define MEET_FRONT_ROWS_HPP

#include "meet/core/sets/prepared.hpp"
#include "meet/front/row_of.hpp"

#include <iterator>
#include <ranges>
#include <string>

namespace meet {
namespace detail {

// A dense matrix of Eigen, or one with its interface.
template <class M>
concept matrix = requires(const M &m) {
  typename M::Scalar;
  M::IsRowMajor;
  M::RowsAtCompileTime;
  M::ColsAtCompileTime;
  m.data(), m.rows(), m.cols(), m.innerStride(), m.outerStride();
};
template <class M> constexpr auto numbers_together = M::IsRowMajor ? M::ColsAtCompileTime : M::RowsAtCompileTime;

template <class R>
concept range_of_objects = std::ranges::contiguous_range<R> && std::ranges::sized_range<R>;
template <class R>
concept outlives_the_call = std::is_lvalue_reference_v<R> || std::ranges::borrowed_range<R>;

// An index may be signed: a negative one lies beyond all points.
template <class Given, class Wanted>
concept same_numbers = std::same_as<Given, Wanted> ||
    (std::same_as<Wanted, std::uint32_t> &&std::same_as<Given, std::int32_t>);

template <class T> struct place {
  const T *data = nullptr;
  std::size_t count = 0, stride_bytes = 0;
  std::size_t width = 0; // the numbers of one
};

template <class...> inline constexpr bool never = false;

// For N numbers together; 0: for as many as an object has. Rows of one number, and rows that N is a multiple of, are joined.
template <std::size_t N, class T, class Given>
place<T> place_of(const Given *objects, std::size_t count, std::size_t stride_bytes, const char *name) {
  using row = row_of<std::remove_cv_t<Given>>;
  if constexpr (std::is_void_v<typename row::number>)
    static_assert(never<Given>, "meet: it is not known of which numbers this type is made: specialise meet::row_of for "
                                "it, or pass a member of it, or (pointer, count, stride)");
  else if constexpr (std::same_as<typename row::number, double> && std::same_as<T, float>)
    static_assert(never<Given>, "meet: sets are of float, and it does not hold every double: pass "
                                "meet::rounded(...).rows, which says what moves, or meet::unmoved(...).rows, which "
                                "refuses a number that would");
  else if constexpr (std::same_as<T, double> && !std::same_as<typename row::number, T>)
    static_assert(never<Given>, "meet: unmoved() and rounded() take doubles");
  else if constexpr (!same_numbers<typename row::number, T>)
    static_assert(never<Given>, "meet: sets are of float, and indices are std::uint32_t or std::int32_t");
  else if constexpr (N != 0 && N % row::count != 0)
    static_assert(never<Given>, "meet: a row of this kind of element has another number of numbers");
  else {
    constexpr std::size_t together = N == 0 ? row::count : N;
    constexpr std::size_t objects_in_row = together / row::count;
    const auto *const data = reinterpret_cast<const T *>(objects);
    if (objects_in_row == 1)
      return {data, count, stride_bytes, together};
    if (stride_bytes != sizeof(Given) || sizeof(Given) != row::count * sizeof(T))
      throw meetc::usage_error(std::string(name) + ": numbers of one row do not lie together");
    if (count % objects_in_row != 0)
      throw meetc::usage_error(std::string(name) + ": " + std::to_string(count * row::count) +
                               " numbers are no multiple of the " + std::to_string(together) + " of a row");
    return {data, count / objects_in_row, together * sizeof(T), together};
  }
}

template <std::size_t N, class T, class From> place<T> place_in(From &&from, const char *name) {
  using type = std::remove_cvref_t<From>;
  if constexpr (matrix<type>) {
    using scalar = std::remove_cv_t<typename type::Scalar>;
    constexpr auto together = numbers_together<type>;
    constexpr bool is_vector = type::RowsAtCompileTime == 1 || type::ColsAtCompileTime == 1;
    if constexpr (!std::is_lvalue_reference_v<From>)
      static_assert(never<From>, "meet: the matrix is a temporary, and a view of it would outlive it: give it a name");
    else if constexpr (!is_vector && (together <= 0 || (N != 0 && together != static_cast<decltype(together)>(N))))
      static_assert(never<From>,
                    "meet: the numbers of a row must lie together: a matrix with a row for each point needs "
                    "so many columns, known when it is compiled, and Eigen::RowMajor; one with a column for "
                    "each point needs so many rows");
    else {
      const auto inner = static_cast<std::size_t>(from.innerStride()),
                 outer = static_cast<std::size_t>(from.outerStride());
      if (inner != 1)
        throw meetc::usage_error(std::string(name) + ": numbers of one row of the matrix do not lie together");
      if constexpr (is_vector)
        return place_of<N, T>(from.data(), static_cast<std::size_t>(from.size()), sizeof(scalar), name);
      else {
        using row = scalar[static_cast<std::size_t>(together)];
        const auto rows = static_cast<std::size_t>(type::IsRowMajor ? from.rows() : from.cols());
        return place_of<N, T>(reinterpret_cast<const row *>(from.data()), rows, outer * sizeof(scalar), name);
      }
    }
  } else if constexpr (!range_of_objects<From>)
    static_assert(never<From>,
                  "meet: this is neither a contiguous range with a size, such as std::vector or std::span, "
                  "nor a dense matrix");
  else if constexpr (!outlives_the_call<From>)
    static_assert(never<From>, "meet: the container is a temporary, and a view of it would outlive it: give it a name");
  else
    return place_of<N, T>(std::ranges::data(from), static_cast<std::size_t>(std::ranges::size(from)),
                          sizeof(std::ranges::range_value_t<From>), name);
}

// The member `part` of each record.
template <std::size_t N, class T, class From, class Member, class Record>
place<T> place_in(From &&records, Member Record::*part, const char *name) {
  if constexpr (!range_of_objects<From>)
    static_assert(never<From>, "meet: records lie in a contiguous range with a size, such as std::vector or std::span");
  else if constexpr (!outlives_the_call<From>)
    static_assert(never<From>, "meet: the container is a temporary, and a view of it would outlive it: give it a name");
  else {
    const auto count = static_cast<std::size_t>(std::ranges::size(records));
    const auto *const first = std::ranges::data(records);
    return place_of<N, T>(count == 0 ? static_cast<const Member *>(nullptr) : &(first->*part), count, sizeof(*first),
                          name);
  }
}

} // namespace detail

// N floats that belong together, many times: in a range of them or of single floats, in a matrix, in a member of records, or
// behind a pointer with a stride (0: they are packed).
template <std::size_t N> class rows : public detail::place<float> {
public:
  rows(const float *first, std::size_t number, std::size_t bytes_to_next = 0)
      : place{first, number, bytes_to_next == 0 ? N * sizeof(float) : bytes_to_next, N} {}
  template <class From>
  requires(!std::same_as<std::remove_cvref_t<From>, rows>) rows(From &&from)
      : place(detail::place_in<N, float>(std::forward<From>(from), "rows")) {} // NOLINT: implicit
  template <class From, class Member, class Record>
  rows(From &&records, Member Record::*part)
      : place(detail::place_in<N, float>(std::forward<From>(records), part, "rows")) {}
};

// The same of indices, which lie packed.
template <std::size_t N> class corners : public detail::place<std::uint32_t> {
public:
  corners(const std::uint32_t *first, std::size_t number) : place{first, number, N * sizeof(std::uint32_t), N} {}
  template <class From>
  requires(!std::same_as<std::remove_cvref_t<From>, corners>) corners(From &&from) // NOLINT: implicit
      : place(detail::place_in<N, std::uint32_t>(std::forward<From>(from), "indices")) {
    if (stride_bytes != N * sizeof(std::uint32_t))
      throw meetc::usage_error("indices: rows of indices lie packed, one behind another");
  }
};

// Elements in the program's memory, and their kind.
struct elements {
  meetc::view view;
  const meetc::kind_info *kind;

  operator meetc::view() const { return view; } // NOLINT: for calls that know the kind, which must be this one
};

namespace detail {
inline elements of_rows(const meetc::kind_info &kind, const place<float> &at) {
  if (at.width != static_cast<std::size_t>(kind.fields))
    throw meetc::usage_error(std::string(kind.name) + " has the numbers " + kind.csv + "; a row here has " +
                             std::to_string(at.width));
  return {{.data = at.data, .stride_bytes = at.stride_bytes, .elements = at.count}, &kind};
}
} // namespace detail

// Elements of any kind, also of a catalogue of the program's own: rows of its numbers in the order of its spec, or corners of
// points. Throws usage_error where a row has another number of them.
template <class From> elements elements_of(const meetc::kind_info &kind, From &&from) {
  if constexpr (std::derived_from<std::remove_cvref_t<From>, detail::place<float>>)
    return detail::of_rows(kind, from);
  else
    return detail::of_rows(kind, detail::place_in<0, float>(std::forward<From>(from), kind.name));
}
template <std::size_t N>
elements elements_of(const meetc::kind_info &kind, const rows<3> &points, const corners<N> &of) {
  if (N != static_cast<std::size_t>(kind.points))
    throw meetc::usage_error("a " + std::string(kind.name) + " has not " + std::to_string(N) + " corners");
  return {{.data = points.data,
           .vertices = points.count,
           .stride_bytes = points.stride_bytes,
           .index = of.data,
           .elements = of.count},
          &kind};
}

// As meetc::prepare() of the view and the kind.
inline meetc::prepared prepare(const elements &of, const meetc::pose &at = {}, int threads = 0,
                               const meetc::prepared *counterpart = nullptr) {
  return meetc::prepare(of.view, *of.kind, at, threads, counterpart);
}

} // namespace meet

#endif
