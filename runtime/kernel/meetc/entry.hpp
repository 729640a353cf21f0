// What emitted entry points call, for operands as they are stored.
//
// to_row() is the operands' own. It reads them after the check of the environment, and once more for what few pairs
// need, so that the rows of the others can stay in registers.
#ifndef MEETC_ENTRY_HPP
#define MEETC_ENTRY_HPP

#include <meetc/decide.hpp>

namespace meetc {

template <class P, class A, class B> struct rows_of {
  float a[P::inputs_a], b[P::inputs_b];
  MEETC_HD MEETC_INLINE rows_of(const A &x, const B &y) { to_row(x, a), to_row(y, b); }
};
// f(row_a, row_b) of rows that are read here, out of line.
template <class P, class A, class B, class F>
MEETC_NOINLINE MEETC_HD inline auto rarely(const A &x, const B &y, F &&f) {
  const rows_of<P, A, B> rows(x, y);
  return f(rows.a, rows.b);
}

template <class P, class A, class B> MEETC_HD inline bool hit_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, [](const float *a, const float *b) { return decide<P>(integer_signs<P>(a, b)); });
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const answer by_fp32 = certify_here<P, in_fp32>(rows.a, rows.b);
  if (by_fp32 != answer::unsure)
    return before_return(by_fp32 == answer::yes);
  return before_return(rarely<P>(*after_check(&p), *after_check(&q),
                                 [](const float *a, const float *b) { return decide_after_fp32<P>(a, b); }));
}
template <class P, class A, class B> MEETC_HD inline bool hit_exact(const A &x, const B &y) {
  return before_return(rarely<P>(x, y, [](const float *a, const float *b) { return decide<P>(exact_signs<P>(a, b)); }));
}
template <class P, class A, class B> MEETC_HD inline answer filter_fp32(const A &x, const B &y) {
  if (!standard_environment())
    return answer::unsure;
  const rows_of<P, A, B> rows(*after_check(&x), *after_check(&y));
  return before_return(certify_here<P, in_fp32>(rows.a, rows.b));
}
template <class P, class A, class B> MEETC_HD inline sign sign_certified(const A &x, const B &y) {
  if (!standard_environment())
    return rarely<P>(x, y, [](const float *a, const float *b) { return decide_sign<P>(integer_signs<P>(a, b)); });
  const A &p = *after_check(&x);
  const B &q = *after_check(&y);
  const rows_of<P, A, B> rows(p, q);
  const sign_set by_fp32 = certify_sign_here<P, in_fp32>(rows.a, rows.b);
  if (is_known(by_fp32))
    return before_return(known_sign(by_fp32));
  return before_return(rarely<P>(*after_check(&p), *after_check(&q),
                                 [](const float *a, const float *b) { return decide_sign<P>(exact_signs<P>(a, b)); }));
}
template <class P, class A, class B> MEETC_HD inline sign sign_exact(const A &x, const B &y) {
  return before_return(
      rarely<P>(x, y, [](const float *a, const float *b) { return decide_sign<P>(exact_signs<P>(a, b)); }));
}

} // namespace meetc

#endif
