// Truths of one decision as truths of another.
#pragma once
#include "gen/lower/expand/decision.hpp"

#include <map>

namespace meetc::lower {

// images[i] stands for the sign of atom i. The decisions may be the same one.
class rewriter {
public:
  rewriter(const decision &from, decision &to, const std::vector<sign_value> &images)
      : from_(from), to_(to), images_(images) {}

  int of(int id) {
    if (const auto it = done_.find(id); it != done_.end())
      return it->second;
    const truth_node n = from_.at(id);
    std::vector<int> args;
    for (const int a : n.args)
      args.push_back(of(a));
    return done_[id] = made(n, args);
  }

private:
  int made(const truth_node &n, const std::vector<int> &args) {
    switch (n.kind) {
    case truth_node::type::constant:
      return to_.constant(n.flag != 0);
    case truth_node::type::test:
      return to_.test(image(n.sign), n.flag);
    case truth_node::type::both:
      return to_.both(args);
    case truth_node::type::either:
      return to_.either(args);
    case truth_node::type::negate:
      return to_.negate(args[0]);
    case truth_node::type::choose:
      break;
    }
    return to_.choose(args[0], args[1], args[2]);
  }
  sign_value image(const sign_value &s) const {
    sign_value out{s.unit, {}};
    for (const auto &[atom, exponent] : s.atoms)
      for (int i = 0; i < exponent; ++i)
        out = out * images_[static_cast<std::size_t>(atom)];
    return out;
  }

  const decision &from_;
  decision &to_;
  const std::vector<sign_value> &images_;
  std::map<int, int> done_;
};

} // namespace meetc::lower
