// The functions behind emitted entry points, for operands as they are stored.
//
// to_row() comes with the operands. It reads them after the check of the environment, and again on the rare paths, so
// that the rows can stay in registers on the others. The rare paths are compiled in the generated library
// (P::after_fp32 and its like); on a device, which calls nothing out of line, they are inline.
#ifndef MEETC_DECIDE_ENTRY_HPP
#define MEETC_DECIDE_ENTRY_HPP

#include <meetc/decide/first_stages.hpp>
#if defined(__CUDACC__)
#include <meetc/decide/later_rungs.hpp>
#endif
#if !defined(NDEBUG)
#include <cassert>
#endif

MEETC_NAMESPACE(meetc) {

// A debug build asserts on the host that an operand is valid; with NDEBUG nothing is left of this.
template <class K> MEETC_HD MEETC_INLINE void assert_valid([[maybe_unused]] const K &operand) {
#if !defined(NDEBUG) && !defined(__CUDA_ARCH__)
  if constexpr (requires { valid(operand); })
    assert(valid(operand) && "an operand has a number that is not finite, or breaks the rule of its kind");
#endif
}

template <class P, class A, class B> struct rows_of {
  float a[P::inputs_a], b[P::inputs_b];
  MEETC_HD MEETC_INLINE rows_of(const A &x, const B &y) {
    assert_valid(x), assert_valid(y);
    to_row(x, a), to_row(y, b);
  }
};
// Reads the rows and calls f(row_a, row_b), out of line.
template <class P, class A, class B, class F>
MEETC_NOINLINE MEETC_HD inline auto rarely(const A &x, const B &y, F &&f) {
  const rows_of<P, A, B> rows(x, y);
  return f(rows.a, rows.b);
}

// The library's functions, as function objects.
template <class P> struct after_fp32 {
  MEETC_HD auto operator()(const float *a, const float *b) const {
#if !defined(__CUDA_ARCH__)
    return P::after_fp32(a, b);
#else
    if constexpr (requires { P::value(static_cast<const sign *>(nullptr)); })
      return later_rungs_sign<P>(a, b);
    else
      return later_rungs<P>(a, b);
#endif
  }
};
template <class P> struct exactly {
  MEETC_HD auto operator()(const float *a, const float *b) const {
#if !defined(__CUDA_ARCH__)
    return P::exactly(a, b);
#else
    if constexpr (requires { P::value(static_cast<const sign *>(nullptr)); })
      return decide_exactly_sign<P>(a, b);
    else
      return decide_exactly<P>(a, b);
#endif
  }
};
template <class P> struct whole_filter {
  MEETC_HD answer operator()(const float *a, const float *b) const {
#if !defined(__CUDA_ARCH__)
    return P::whole_filter(a, b);
#else
    return certify<P, in_fp32>(a, b);
#endif
  }
};

template <class P, class A, class B> MEETC_HD inline bool hit_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, after_fp32<P>());
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const first_answer by_fp32 = look<P, in_fp32>(rows.a, rows.b);
  if (by_fp32 == first_answer::no || by_fp32 == first_answer::yes)
    return before_return(by_fp32 == first_answer::yes);
  return before_return(rarely<P>(*after_check(&p), *after_check(&q), after_fp32<P>()));
}
template <class P, class A, class B> MEETC_HD inline bool hit_exact(const A &x, const B &y) {
  return rarely<P>(x, y, exactly<P>());
}
template <class P, class A, class B> MEETC_HD inline answer filter_fp32(const A &x, const B &y) {
  if (!standard_environment())
    return answer::unsure;
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const first_answer by_fp32 = look<P, in_fp32>(rows.a, rows.b);
  if constexpr (has_rare_stage<P>)
    if (by_fp32 == first_answer::rare)
      return before_return(rarely<P>(*after_check(&p), *after_check(&q), whole_filter<P>()));
  return before_return(static_cast<answer>(by_fp32));
}
template <class P, class T, class A, class B> MEETC_HD inline bool hit_plain(const A &x, const B &y) {
  const rows_of<P, A, B> rows(x, y);
  const plain_signs<P, T> signs(rows.a, rows.b);
  sign s[P::atoms + 1];
  if constexpr (P::reject_stage::atoms > 0) {
    signs.template get<typename P::reject_stage>(s);
    if (P::rejected(s))
      return false;
  }
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  if constexpr (has_rare_stage<P>)
    if (P::needs_rare(s)) {
#if !defined(__CUDA_ARCH__)
      return P::template whole_plain<T>(rows.a, rows.b);
#else
      return decide<P>(signs);
#endif
    }
  return P::usual(s);
}

template <class P, class A, class B> MEETC_HD inline sign sign_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, after_fp32<P>());
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const sign_set by_fp32 = certify_sign_here<P, in_fp32>(rows.a, rows.b);
  if (is_known(by_fp32))
    return before_return(known_sign(by_fp32));
  return before_return(rarely<P>(*after_check(&p), *after_check(&q), after_fp32<P>()));
}
template <class P, class A, class B> MEETC_HD inline sign sign_exact(const A &x, const B &y) {
  return rarely<P>(x, y, exactly<P>());
}
template <class P, class T, class A, class B> MEETC_HD inline sign sign_plain(const A &x, const B &y) {
  const rows_of<P, A, B> rows(x, y);
  sign s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    plain_signs<P, T>(rows.a, rows.b).template get<typename P::common_stage>(s);
  return P::value(s);
}

} // MEETC_NAMESPACE(meetc)

#endif
