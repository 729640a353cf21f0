#include "tests/proofs/script.hpp"

#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace meetc::proofs_test {
namespace {

// expression = ['-'] product {('+' | '-') product}; product = factor {'*' factor};
// factor = integer | name | 'rnd(' expression ')' | '(' expression ')'.
class reader {
public:
  reader(const std::string &text, const std::map<std::string, rational> &values) : text_(text), values_(values) {}

  rational all() {
    const rational v = expression();
    if (at_ != text_.size())
      throw std::runtime_error("not understood: " + text_.substr(at_) + " in " + text_);
    return v;
  }

private:
  const std::string &text_;
  const std::map<std::string, rational> &values_;
  std::size_t at_ = 0;

  bool take(char c) {
    while (at_ < text_.size() && text_[at_] == ' ')
      ++at_;
    if (at_ == text_.size() || text_[at_] != c)
      return false;
    ++at_;
    return true;
  }
  rational expression() {
    rational sum = take('-') ? rational(-product()) : product();
    for (;;) {
      if (take('+'))
        sum += product();
      else if (take('-'))
        sum -= product();
      else
        return sum;
    }
  }
  rational product() {
    rational out = factor();
    while (take('*'))
      out *= factor();
    return out;
  }
  rational factor() {
    if (take('(')) {
      const rational v = expression();
      if (!take(')'))
        throw std::runtime_error("')' is missing in " + text_);
      return v;
    }
    std::string word;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])))
      word += text_[at_++];
    if (word == "rnd")
      return nearest_float(factor());
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])))
      return rational(word);
    if (!word.empty() && word[0] == 's')
      return 1;
    const auto it = values_.find(word);
    if (it == values_.end())
      throw std::runtime_error("'" + word + "' has no value in " + text_);
    return it->second;
  }
};

rational dyadic(const std::string &text) { // 33b-25
  const std::size_t b = text.find("b-");
  rational q(text.substr(0, b));
  if (b != std::string::npos)
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), std::stoul(text.substr(b + 2)));
  return q;
}

} // namespace

float nearest_float(const rational &q) {
  if (q == 0)
    return 0;
  const int unit = std::ilogb(q.get_d()) - 23; // get_d() truncates, which keeps the exponent
  rational scaled = q;
  if (unit < 0)
    mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-unit));
  else
    mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(unit));
  mpz_class n;
  mpz_fdiv_q(n.get_mpz_t(), scaled.get_num().get_mpz_t(), scaled.get_den().get_mpz_t());
  const rational above = scaled - n, half(1, 2);
  if (above > half || (above == half && mpz_odd_p(n.get_mpz_t())))
    ++n;
  return static_cast<float>(std::ldexp(n.get_d(), unit));
}

std::map<std::string, rational> script::run(std::map<std::string, rational> values) const {
  for (const line &l : lines)
    values[l.name] = reader(l.expression, values).all();
  return values;
}

script parse(const std::string &text) {
  script out;
  std::istringstream in(text);
  for (std::string l; std::getline(in, l);) {
    std::istringstream words(l);
    std::string first, second, third, fourth, fifth;
    words >> first >> second >> third >> fourth >> fifth;
    if (first == "#" && out.kernel.empty() && third.size() > 1 && third.back() == ':') { // kernel stage: 0 1; c D
      out.kernel = second;
      out.stage = third.substr(0, third.size() - 1);
      out.sign = std::stoul(fourth);
    } else if (first == "#" && third == "=") { // d0 = x - y, of A
      const bool difference = fifth != "of";
      if (fourth.back() == ',')
        fourth.pop_back();
      std::string subtrahend;
      if (difference)
        words >> subtrahend;
      out.leaves.push_back({second, fourth, subtrahend.substr(0, subtrahend.find(','))});
    } else if (first == "#" || first.empty() || first[0] == '@' || first[0] == '{' || first[0] == '|' ||
               second == "in") {
      continue;
    } else if (first == "->") { // -> |v - e| <= 33b-25 }
      out.bound = dyadic(l.substr(l.find("<=") + 3, l.rfind(' ') - l.find("<=") - 3));
    } else if (second == "=" && l.back() == ';') {
      const std::size_t from = l.find("= ") + 2;
      out.lines.push_back({first, l.substr(from, l.size() - from - 1)});
    } else {
      throw std::runtime_error("not understood: " + l);
    }
  }
  if (out.kernel.empty() || out.leaves.empty() || out.lines.size() < 2 || out.bound == 0)
    throw std::runtime_error("a part is missing in:\n" + text);
  return out;
}

std::vector<cover> covers(const std::string &text) {
  const std::string before = "in their box form:", after = "# The first of them";
  const std::size_t from = text.find(before), to = text.find(after);
  if (from == std::string::npos || to == std::string::npos)
    throw std::runtime_error("no signs in:\n" + text);
  // A long line continues on the next line, which is indented more.
  std::string said = text.substr(from + before.size(), to - from - before.size());
  const std::string on = "\n#       ";
  for (std::size_t at; (at = said.find(on)) != std::string::npos;)
    said.erase(at, on.size() - 1);
  std::vector<cover> out;
  std::istringstream in(said);
  for (std::string l; std::getline(in, l);) { // #   kernel stage: 0 1; c beta D
    if (l.empty())
      continue;
    const std::size_t colon = l.find(':'), semicolon = l.find("; c ");
    if (l.rfind("#   ", 0) != 0 || colon == std::string::npos || semicolon == std::string::npos)
      throw std::runtime_error("not understood: " + l);
    cover c{l.substr(4, colon - 4), {}, l.substr(semicolon + 4)};
    std::istringstream signs(l.substr(colon + 1, semicolon - colon - 1));
    for (std::size_t sign; signs >> sign;)
      c.signs.push_back(sign);
    out.push_back(c);
  }
  return out;
}

} // namespace meetc::proofs_test
