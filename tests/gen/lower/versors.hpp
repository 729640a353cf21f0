// Algebras with versors for the compiler's tests: planes as vectors of R(3,0,1), and the conformal model with null vectors.
// All operators are written by hand.
#ifndef MEETC_TESTS_COMPILER_VERSORS_HPP
#define MEETC_TESTS_COMPILER_VERSORS_HPP

#include "gen/ir/count.hpp"
#include "tests/gen/fixture.hpp"

#include <fmt/format.h>
#include <ostream>

namespace meetc::compiler_test {

inline const char *const planes_as_vectors = R"([algebra]
vectors = ['e0', 'e1', 'e2', 'e3']
squares = [0, 1, 1, 1]
[constants]
I    = 'e0 ^ e1 ^ e2 ^ e3'
axes = '[e1, e2, e3]'
[kinds.point]
store    = ['x: real', 'y: real', 'z: real']
position = true
blade    = '(e1^e2^e3) - x*(e0^e2^e3) - y*(e0^e3^e1) - z*(e0^e1^e2)'
[kinds.direction]
store = ['x: real', 'y: real', 'z: real']
blade = '-x*(e0^e2^e3) - y*(e0^e3^e1) - z*(e0^e1^e2)'
[kinds.plane]
store = ['a: real', 'b: real', 'c: real', 'd: real']
blade = 'a*e1 + b*e2 + c*e3 + d*e0'
[kinds.line]
store = ['a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real']
blade = 'a*(e2^e3) + b*(e3^e1) + c*(e1^e2) + d*(e0^e1) + e*(e0^e2) + f*(e0^e3)'
[kinds.normal]
store = ['a: real', 'b: real', 'c: real']
blade = 'a*e1 + b*e2 + c*e3'
[kinds.rotor]
store = ['s: real', 'a: real', 'b: real', 'c: real']
blade = 's + a*(e2^e3) + b*(e3^e1) + c*(e1^e2)'
[kinds.motor]
store = ['s: real', 'a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real', 'p: real']
blade = 's + a*(e2^e3) + b*(e3^e1) + c*(e1^e2) + d*(e0^e1) + e*(e0^e2) + f*(e0^e3) + p*I'
[functions]
'gp(A, B)'       = 'A * B'
'rev(M)'         = '2*(M[1] + M[I]*I) - M'
# the same reverse, coefficient by coefficient
'spelled(M)'     = '''M[1] - M[e0^e1]*(e0^e1) - M[e0^e2]*(e0^e2) - M[e0^e3]*(e0^e3) - M[e1^e2]*(e1^e2)
  - M[e1^e3]*(e1^e3) - M[e2^e3]*(e2^e3) + M[I]*I'''
'sandwich(M, X)' = 'M * X * rev(M)'
'by_hand(M, X)'  = 'M * X * spelled(M)'
'back(M, X)'     = 'rev(M) * X * M'
'flipped(X, M)'  = '0 - M * X * rev(M)'
'twice(M, X)'    = 'sandwich(M, sandwich(M, X))'
'reflect(p, X)'  = '-(p * X * p)'
# the mirror image of a unit vector
'unit(p)'        = 'p * e1 * p / (p*p)[1]'
)";

inline const char *const conformal = R"([algebra]
vectors = ['no', 'e1', 'e2', 'e3', 'ni']
metric  = [[0,0,0,0,-1], [0,1,0,0,0], [0,0,1,0,0], [0,0,0,1,0], [-1,0,0,0,0]]
[constants]
I = 'no ^ e1 ^ e2 ^ e3 ^ ni'
[kinds.round]
store = ['o: real', 'x: real', 'y: real', 'z: real', 'i: real']
blade = 'o*no + x*e1 + y*e2 + z*e3 + i*ni'
[kinds.flat]
store = ['x: real', 'y: real', 'z: real', 'i: real']
blade = 'x*e1 + y*e2 + z*e3 + i*ni'
[kinds.versor]
store = ['v: real', 'oa: real', 'ob: real', 'oc: real', 'n: real', 'a: real', 'b: real', 'c: real', 'ia: real', 'ib: real',
         'ic: real', 'q: real', 'na: real', 'nb: real', 'nc: real', 'p: real']
blade = '''v + oa*(no^e1) + ob*(no^e2) + oc*(no^e3) + n*(no^ni) + a*(e2^e3) + b*(e3^e1) + c*(e1^e2) + ia*(e1^ni)
  + ib*(e2^ni) + ic*(e3^ni) + q*(no^e1^e2^e3) + na*(no^e2^e3^ni) + nb*(no^e3^e1^ni) + nc*(no^e1^e2^ni)
  + p*(e1^e2^e3^ni)'''
[functions]
'gp(A, B)'    = 'A * B'
'even4(M)'    = '''M[1] + M[no^e1^e2^e3]*(no^e1^e2^e3) + M[no^e2^e3^ni]*(no^e2^e3^ni) + M[no^e1^e3^ni]*(no^e1^e3^ni)
  + M[no^e1^e2^ni]*(no^e1^e2^ni) + M[e1^e2^e3^ni]*(e1^e2^e3^ni)'''
'rev(M)'      = '2*even4(M) - M'
'vector(M)'   = 'M[no]*no + M[e1]*e1 + M[e2]*e2 + M[e3]*e3 + M[ni]*ni'
'moved(M, X)' = 'vector(M * X * rev(M))'
'gram(A, B)'  = '((A ^ B) * (A ^ B))[1]'
'dots(A, B)'  = '((A | B) * (A | B) - (A | A) * (B | B))[1]'
'unit(p)'     = 'p * e1 * p / (p*p)[1]'
)";

// The algebra with these lines added to a kind's table.
inline std::string with(const std::string &algebra, const std::string &kind, const std::string &lines) {
  const std::size_t at = algebra.find("[kinds." + kind + "]"), end = algebra.find("\n[", at) + 1;
  REQUIRE(at != std::string::npos);
  return algebra.substr(0, end) + lines + algebra.substr(end);
}

// Products of two and of four mirror images of a unit vector are the samples of unit versors, since those of two alone have no
// part of grade 4.
inline std::string unit_versor(const std::string &kind, const std::string &vector, const std::string &more = "") {
  return fmt::format("relations.nearly = ['{0} * rev({0}) = 1'{2}]\nrelations.within = 1e-6\n"
                     "samples.of = ['p: {1}', 'q: {1}', 'r: {1}', 't: {1}']\n"
                     "samples.blades = ['unit(p) * unit(q)', 'unit(p) * unit(q) * unit(r) * unit(t)']\n",
                     kind, vector, more);
}
inline std::string with_unit_motors(const std::string &algebra) {
  return with(with(algebra, "rotor", unit_versor("rotor", "normal")), "motor", unit_versor("motor", "plane"));
}

// {multiplications, additions}; a fused multiply-add counts as one of each.
struct ops {
  int multiplications, additions;
  bool operator==(const ops &) const = default;
};
inline std::ostream &operator<<(std::ostream &out, const ops &n) {
  return out << n.multiplications << '/' << n.additions;
}
inline ops plain(const ir::counts &c) {
  return {c.multiplications + c.fused, c.additions + c.fused};
}
inline ops all(const ir::program &p) {
  return plain(ir::count(p.nodes, p.results));
}

// An algebra of its own, with a scene that asks for kernels: "'gp(motor, motor)', …".
inline compilation compiled(const temporary_folder &folder, const std::string &algebra, const std::string &kernels) {
  folder.write("a.toml", algebra);
  folder.write(
      "s.toml",
      fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nbackends = ['cpp', 'c']\nkernels = [{}]\n", kernels));
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  return c;
}

} // namespace meetc::compiler_test

#endif
