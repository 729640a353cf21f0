// A claim: some facts about real numbers cannot all be true. Its proof is a certificate that can be checked
// by multiplying out.
//
// The certificate is a sum of products that is the zero polynomial: each product is a positive number times a
// square times facts of the form p >= 0 or p > 0, or any polynomial times a fact p = 0. If all facts were true,
// no product would be negative; one of them, which has only factors p > 0 and no square, would be positive, and
// so would the sum, which is zero. (The Positivstellensatz of Krivine and Stengle says that such certificates
// exist; the proof does not depend on that.)
#ifndef MEETC_TESTS_DECISIONS_ROUND_CLAIM_HPP
#define MEETC_TESTS_DECISIONS_ROUND_CLAIM_HPP

#include "tests/decisions/round/decision.hpp"

namespace meetc::decisions_round {

enum class relation { equal, at_least, above }; // p = 0, p >= 0, p > 0

struct fact {
  std::string name;
  polynomial value;
  relation is;
};

// factor * squared^2 * the product of the named facts.
struct product {
  int factor;
  std::vector<std::string> of;
  polynomial squared = gram::ring().one;
};
// times * the named fact, which is an equation.
struct equation {
  std::string of;
  polynomial times;
};

struct claim {
  std::string name;
  std::vector<fact> facts;
  std::vector<product> products;
  std::vector<equation> equations;
};

// The reason why the certificate is invalid, or "" if it proves the claim.
std::string refusal(const claim &c);

// All claims that the proof of a decision needs. They are made from the given decision, so a wrong decision gives
// false claims, or claims without a certificate.
std::vector<claim> claims_of(const emitted &e, const decision &d);

// The parts: for two spheres, for one edge, for the face, and for the bound from below.
std::vector<claim> sphere_claims(const decision &d, bool surface);
std::vector<claim> corner_claims(const decision &d);
std::vector<claim> segment_claims(const decision &d);
std::vector<claim> triangle_edge_claims(const decision &d);
std::vector<claim> triangle_claims(const decision &d);
std::vector<claim> far_claims(const decision &d, bool triangle);
// For the single sign, which is not a decision: inside, on and outside a ball.
std::vector<claim> side_claims();

} // namespace meetc::decisions_round

#endif
