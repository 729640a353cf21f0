#include "tests/decisions/flat/atoms.hpp"

#include <map>
#include <stdexcept>

namespace meetc::decisions_test {
namespace {

const poly::ring &coordinates() {
  static const poly::ring r([] {
    std::vector<std::string> names;
    for (int label = 0; label < 6; ++label)
      for (const char *axis : {"x", "y", "z"})
        names.push_back(axis + std::to_string(label));
    return names;
  }());
  return r;
}

using vector = std::array<polynomial, 3>;

vector between(int from, int to) {
  vector v;
  for (int k = 0; k < 3; ++k)
    v[static_cast<std::size_t>(k)] = polynomial::coordinate(to, k) - polynomial::coordinate(from, k);
  return v;
}
vector cross(const vector &u, const vector &v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

polynomial written_out(shape kind, int axis, const labels &of) {
  const auto k = static_cast<std::size_t>(axis);
  if (kind == shape::difference)
    return between(of[1], of[0])[k];
  const vector n = cross(between(of[0], of[1]), between(of[0], of[2]));
  if (kind == shape::turn)
    return n[k];
  const vector d = between(of[0], of[3]);
  return n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
}

template <class L> std::size_t place_of(shape kind, int axis, const L &of) {
  std::size_t bits = 0;
  for (const int i : of)
    bits |= std::size_t{1} << i;
  return (static_cast<std::size_t>(kind) * 3 + static_cast<std::size_t>(axis)) * 64 + bits;
}

} // namespace

polynomial::polynomial(int constant) : p_(coordinates(), poly::rational(constant)) {}

polynomial polynomial::coordinate(int label, int axis) {
  return polynomial(poly::poly::variable(coordinates(), 3 * label + axis));
}

atom_table::atom_table(int n, std::vector<atom> atoms) : n_(n), atoms_(std::move(atoms)) {
  index_.fill(-1);
  for (std::size_t i = 0; i < atoms_.size(); ++i)
    index_[place_of(atoms_[i].kind, atoms_[i].axis, atoms_[i].of)] = static_cast<int>(i);
}

std::pair<std::size_t, int> atom_table::find(shape kind, int axis, std::initializer_list<int> of) const {
  const int at = index_[place_of(kind, axis, of)];
  if (at < 0)
    throw std::logic_error("the emitted decision does not have this sign");
  int sign = atoms_[static_cast<std::size_t>(at)].sign;
  for (const int *i = of.begin(); i != of.end(); ++i)
    for (const int *j = i + 1; j != of.end(); ++j)
      sign = *i < *j ? sign : -sign;
  return {static_cast<std::size_t>(at), sign};
}

atom_table recognise(int n, const std::vector<polynomial> &values) {
  std::map<std::string, atom> known;
  const auto learn = [&](shape kind, int axis, int count) {
    for (const labels &of : subsets(n, count)) {
      const polynomial p = written_out(kind, axis, of);
      known.emplace(p.value().key(), atom{kind, axis, of, 1});
      known.emplace((-p).value().key(), atom{kind, axis, of, -1});
    }
  };
  learn(shape::determinant, 0, 4);
  for (int axis = 0; axis < 3; ++axis) {
    learn(shape::turn, axis, 3);
    learn(shape::difference, axis, 2);
  }
  std::vector<atom> atoms;
  for (const polynomial &v : values) {
    const auto at = known.find(v.value().key());
    if (at == known.end())
      throw std::logic_error("an emitted value is not a determinant, a turn or a difference: " + v.value().text());
    atoms.push_back(at->second);
  }
  return {n, atoms};
}

} // namespace meetc::decisions_test
