// front/row_of.hpp: how many numbers of which type an object in memory is.
//
// It is found for numbers, arrays, std::array, vectors of Eigen and glm, and aggregates of one type of number, as struct {float
// x, y, z;} or structs and arrays of such. Nothing is guessed: an aggregate counts if braces with so many numbers of exactly
// this type make one, and no byte of it is left over.
#ifndef MEET_FRONT_ROW_OF_HPP
#define MEET_FRONT_ROW_OF_HPP

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace meet {
namespace detail {

template <class T, std::size_t N> struct numbers_in_row {
  using number = T;
  static constexpr std::size_t count = N;
};

// Becomes a T and nothing else.
template <class T> struct only {
  template <class U>
  requires std::same_as<U, T>
  operator U() const; // NOLINT: it is never called
};
template <class R, class T, std::size_t... I> constexpr bool braces_make(std::index_sequence<I...>) {
  return requires {
    R{(static_cast<void>(I), only<T>())...};
  };
}
template <class R, class T> constexpr bool is_aggregate_of() {
  constexpr std::size_t n = sizeof(R) / sizeof(T);
  if constexpr (n == 0 || n > 32 || n * sizeof(T) != sizeof(R))
    return false;
  else
    return braces_make<R, T>(std::make_index_sequence<n>());
}

template <class R>
concept array_of_known_size = requires {
  typename R::value_type;
  std::tuple_size<R>::value;
};
template <class R>
concept vector_of_eigen = requires {
  typename R::Scalar;
  R::SizeAtCompileTime;
};
template <class R>
concept vector_of_glm = requires {
  typename R::value_type;
  { R::length() } -> std::convertible_to<std::size_t>;
};

template <class R> constexpr auto numbers_of();

// n objects of the type E, which are all of R.
template <class R, class E, std::size_t N> constexpr auto repeated() {
  using each = decltype(numbers_of<E>());
  if constexpr (std::is_void_v<typename each::number>)
    return each();
  else if constexpr (N * each::count * sizeof(typename each::number) == sizeof(R))
    return numbers_in_row<typename each::number, N * each::count>();
  else
    return numbers_in_row<void, 0>();
}

template <class R> constexpr auto numbers_of() {
  if constexpr (std::is_arithmetic_v<R>)
    return numbers_in_row<R, 1>();
  else if constexpr (std::is_bounded_array_v<R>)
    return repeated<R, std::remove_extent_t<R>, std::extent_v<R>>();
  else if constexpr (array_of_known_size<R>)
    return repeated<R, typename R::value_type, std::tuple_size<R>::value>();
  else if constexpr (vector_of_eigen<R>) {
    if constexpr (R::SizeAtCompileTime > 0)
      return repeated<R, typename R::Scalar, static_cast<std::size_t>(R::SizeAtCompileTime)>();
    else
      return numbers_in_row<void, 0>();
  } else if constexpr (vector_of_glm<R>)
    return repeated<R, typename R::value_type, static_cast<std::size_t>(R::length())>();
  else if constexpr (!std::is_aggregate_v<R> || !std::is_trivially_copyable_v<R> || !std::is_standard_layout_v<R>)
    return numbers_in_row<void, 0>();
  else if constexpr (is_aggregate_of<R, float>())
    return numbers_in_row<float, sizeof(R) / sizeof(float)>();
  else if constexpr (is_aggregate_of<R, double>())
    return numbers_in_row<double, sizeof(R) / sizeof(double)>();
  else if constexpr (is_aggregate_of<R, std::uint32_t>())
    return numbers_in_row<std::uint32_t, sizeof(R) / sizeof(std::uint32_t)>();
  else if constexpr (is_aggregate_of<R, std::int32_t>())
    return numbers_in_row<std::int32_t, sizeof(R) / sizeof(std::int32_t)>();
  else
    return numbers_in_row<void, 0>();
}

} // namespace detail

// `count` numbers of the type `number` at the beginning of an R; void and 0: it is not known. A program specialises it for a
// type of its own.
template <class R> struct row_of : decltype(detail::numbers_of<R>()) {};

} // namespace meet

#endif
