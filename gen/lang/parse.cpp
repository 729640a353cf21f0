// A hand-written recursive descent parser for the grammar in syntax.hpp.
#include "gen/lang/hints.hpp"
#include "gen/lang/syntax.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace meetc::lang {
namespace {

constexpr int max_depth = 200; // deeper nesting than anyone writes; protects the stack
constexpr std::size_t max_digits = 300;
constexpr int max_tokens = 4000; // a long chain a + b + ... is a tree as deep as it is long

struct token {
  enum class type { end, number, word, symbol } kind = type::end;
  std::string text;
  location where;
};

class parser {
public:
  explicit parser(const expr_source &source) : source_(source), at_(source.begin) { next(); }

  expr_ptr whole() {
    expr_ptr e = expression();
    if (token_.kind != token::type::end)
      fail(fmt::format("expected the end of the expression, found '{}'{}", token_.text,
                       token_.kind == token::type::word || token_.kind == token::type::number
                           ? "; write an operator between them, such as '*', or f(a, b) for a call"
                           : ""));
    return e;
  }

private:
  expr_source source_;
  std::size_t at_;
  token token_;
  int depth_ = 0, tokens_ = 0;

  location here(std::size_t offset, std::size_t length) const { return {source_.file, offset, length}; }

  [[noreturn]] void fail(const std::string &message) const { throw spec_error(token_.where, message); }

  static bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
  static bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  void next() {
    if (++tokens_ > max_tokens)
      throw spec_error(here(at_, 1), fmt::format("this expression is longer than {} words and symbols", max_tokens));
    const std::string &s = source_.file->text;
    while (at_ < source_.end && std::isspace(static_cast<unsigned char>(s[at_])))
      ++at_;
    const std::size_t start = at_;
    if (at_ >= source_.end) {
      token_ = {token::type::end, "the end", here(source_.end > source_.begin ? source_.end - 1 : source_.begin, 1)};
      return;
    }
    token::type kind = token::type::symbol;
    if (letter(s[at_])) {
      kind = token::type::word;
      while (at_ < source_.end && (letter(s[at_]) || digit(s[at_])))
        ++at_;
    } else if (digit(s[at_])) {
      kind = token::type::number;
      while (at_ < source_.end && digit(s[at_]))
        ++at_;
      if (at_ + 1 < source_.end && s[at_] == '.' && digit(s[at_ + 1]))
        for (++at_; at_ < source_.end && digit(s[at_]);)
          ++at_;
      if (at_ - start > max_digits)
        throw spec_error(here(start, at_ - start), fmt::format("this number has more than {} digits", max_digits));
      if (at_ < source_.end && letter(s[at_]))
        throw spec_error(
            here(start, at_ - start + 1),
            "a number runs into a name; write '*' between them, and a power of ten in full: 1000 or 1/1000");
    } else {
      const bool two =
          at_ + 1 < source_.end && s[at_ + 1] == '=' && std::string("<>=!").find(s[at_]) != std::string::npos;
      at_ += two ? 2 : 1;
      const std::string text = s.substr(start, at_ - start);
      static const std::string single = "+-*/^|&~.,:()[]<>";
      if (!two && single.find(text[0]) == std::string::npos) {
        // Keeps all bytes of a UTF-8 character together.
        while ((s[start] & 0xc0) == 0xc0 && at_ < source_.end && (s[at_] & 0xc0) == 0x80)
          ++at_;
        const std::string symbol = s.substr(start, at_ - start);
        throw spec_error(here(start, at_ - start),
                         fmt::format("'{}' does not belong in an expression{}", symbol, hint_for_symbol(symbol)));
      }
    }
    token_ = {kind, s.substr(start, at_ - start), here(start, at_ - start)};
  }

  bool is(std::string_view text) const {
    return token_.kind != token::type::end && token_.kind != token::type::number && token_.text == text;
  }
  void expect(std::string_view text) {
    if (!is(text))
      fail(fmt::format("expected '{}', found '{}'", text, token_.text));
    next();
  }

  static location span(const location &from, const location &to) {
    return {from.file, from.offset, to.offset + to.length - from.offset};
  }
  static expr_ptr make(op kind, location where, std::vector<expr_ptr> args, std::string text = {},
                       std::vector<binder> binders = {}) {
    return std::make_shared<expr>(expr{kind, std::move(where), std::move(text), std::move(args), std::move(binders)});
  }
  static expr_ptr binary(op kind, expr_ptr a, expr_ptr b, std::string text = {}) {
    location where = span(a->where, b->where);
    return make(kind, std::move(where), {std::move(a), std::move(b)}, std::move(text));
  }

  struct nested {
    explicit nested(parser &p) : p_(p) {
      if (++p_.depth_ > max_depth)
        p_.fail("nested too deeply");
    }
    ~nested() { --p_.depth_; }
    nested(const nested &) = delete;
    nested &operator=(const nested &) = delete;
    parser &p_;
  };

  expr_ptr expression() {
    const nested guard(*this);
    if (!is("if"))
      return disjunction();
    const location start = token_.where;
    next();
    expr_ptr c = expression();
    expect("then");
    expr_ptr t = expression();
    expect("else");
    expr_ptr e = expression();
    location where = span(start, e->where);
    return make(op::conditional, std::move(where), {c, t, e});
  }
  expr_ptr disjunction() {
    expr_ptr a = conjunction();
    while (is("or")) {
      next();
      a = binary(op::logical_or, a, conjunction());
    }
    return a;
  }
  expr_ptr conjunction() {
    expr_ptr a = negation();
    while (is("and")) {
      next();
      a = binary(op::logical_and, a, negation());
    }
    return a;
  }
  expr_ptr negation() {
    if (!is("not"))
      return comparison();
    const nested guard(*this);
    const location start = token_.where;
    next();
    expr_ptr a = negation();
    location where = span(start, a->where);
    return make(op::logical_not, std::move(where), {a});
  }
  std::optional<op> comparator() const {
    static const std::array<std::pair<const char *, op>, 6> table{{{"<", op::less},
                                                                   {"<=", op::less_equal},
                                                                   {"==", op::equal},
                                                                   {"!=", op::not_equal},
                                                                   {">=", op::greater_equal},
                                                                   {">", op::greater}}};
    for (const auto &[text, kind] : table)
      if (is(text))
        return kind;
    return std::nullopt;
  }
  expr_ptr comparison() {
    expr_ptr a = sum();
    if (const auto kind = comparator()) {
      next();
      a = binary(*kind, a, sum());
      if (comparator())
        fail("comparisons do not chain; join them with 'and'");
    }
    return a;
  }
  expr_ptr sum() {
    expr_ptr a = product();
    while (is("+") || is("-")) {
      const op kind = is("+") ? op::add : op::subtract;
      next();
      a = binary(kind, a, product());
    }
    return a;
  }
  expr_ptr product() {
    expr_ptr a = wedge();
    while (is("*") || is("/")) {
      const op kind = is("*") ? op::multiply : op::divide;
      next();
      a = binary(kind, a, wedge());
    }
    return a;
  }
  expr_ptr wedge() {
    expr_ptr a = unary();
    std::string used;
    while (is("^") || is("|") || is("&")) {
      if (!used.empty() && used != token_.text)
        fail(fmt::format("'{}' and '{}' mixed without parentheses: write (A {} B) {} C or A {} (B {} C)",
                         std::min(used, token_.text), std::max(used, token_.text), used, token_.text, used,
                         token_.text));
      used = token_.text;
      const op kind = is("^") ? op::outer : is("|") ? op::inner : op::builtin;
      next();
      a = binary(kind, a, unary(), kind == op::builtin ? "regressive" : "");
    }
    return a;
  }
  expr_ptr unary() {
    if (!is("-") && !is("~"))
      return postfix();
    const nested guard(*this);
    const token start = token_;
    next();
    expr_ptr a = unary();
    location where = span(start.where, a->where);
    return start.text == "-" ? make(op::negate, std::move(where), {a})
                             : make(op::builtin, std::move(where), {a}, "rev");
  }
  expr_ptr postfix() {
    expr_ptr a = primary();
    while (is(".") || is("[")) {
      if (is(".")) {
        next();
        if (token_.kind != token::type::word)
          fail(fmt::format("expected a member's name after '.', found '{}'{}", token_.text,
                           a->kind == op::number ? "; a number has digits on both sides of its point, as 5.0" : ""));
        location where = span(a->where, token_.where);
        a = make(op::member, std::move(where), {a}, token_.text);
        next();
      } else {
        next();
        expr_ptr i = expression();
        location where = span(a->where, token_.where);
        expect("]");
        a = make(op::index, std::move(where), {a, i});
      }
    }
    return a;
  }
  std::vector<expr_ptr> arguments(std::string_view close) {
    std::vector<expr_ptr> args;
    if (!is(close))
      for (args.push_back(argument()); is(",");) {
        next();
        args.push_back(argument());
      }
    return args;
  }
  // A '*' with nothing beside it is a wildcard: a name that no spec can declare.
  expr_ptr argument() {
    const std::string &s = source_.file->text;
    std::size_t after = at_;
    while (after < source_.end && std::isspace(static_cast<unsigned char>(s[after])))
      ++after;
    if (!is("*") || after >= source_.end || (s[after] != ',' && s[after] != ')'))
      return expression();
    const location where = token_.where;
    next();
    return make(op::name, where, {}, "*");
  }
  // A hint where the symbol before this one makes it an operator of other languages, as && or **, or a number, as .5.
  std::string misread() const {
    const std::string &s = source_.file->text;
    const std::size_t at = token_.where.offset;
    if (is(".") && at + 1 < source_.end && digit(s[at + 1]))
      return "; a number has digits on both sides of its point, as 0.5";
    return at > source_.begin ? hint_for_symbol(s.substr(at - 1, 2)) : "";
  }
  expr_ptr primary() {
    const token start = token_;
    if (token_.kind == token::type::number) {
      next();
      return make(op::number, start.where, {}, start.text);
    }
    if (is("(")) {
      next();
      expr inside = *expression();
      inside.where = span(start.where, token_.where); // with its parentheses, so that it prints as it was written
      expect(")");
      return std::make_shared<expr>(std::move(inside));
    }
    if (is("[")) {
      next();
      auto args = arguments("]");
      location where = span(start.where, token_.where);
      expect("]");
      return make(op::list, std::move(where), std::move(args));
    }
    if (token_.kind != token::type::word)
      fail(fmt::format("expected a value, found '{}'{}", token_.text, misread()));
    static const std::array<const char *, 7> reserved{"if", "then", "else", "and", "or", "not", "in"};
    for (const char *word : reserved)
      if (token_.text == word)
        fail(fmt::format("expected a value, found '{}'", token_.text));
    next();
    if (!is("("))
      return make(op::name, start.where, {}, start.text);
    next();
    if (start.text == "all" || start.text == "any" || start.text == "each")
      return quantifier(start);
    auto args = arguments(")");
    location where = span(start.where, token_.where);
    expect(")");
    return make(op::call, std::move(where), std::move(args), start.text);
  }
  expr_ptr quantifier(const token &start) {
    std::vector<binder> binders;
    for (;;) {
      if (token_.kind != token::type::word)
        fail(fmt::format("expected 'name in list', found '{}'", token_.text));
      std::string name = token_.text;
      next();
      expect("in");
      binders.push_back({std::move(name), expression()});
      if (!is(","))
        break;
      next();
    }
    expect(":");
    expr_ptr body = expression();
    location where = span(start.where, token_.where);
    expect(")");
    const op kind = start.text == "all" ? op::all : start.text == "any" ? op::any : op::each;
    return make(kind, std::move(where), {body}, {}, std::move(binders));
  }
};

} // namespace

expr_ptr parse_expression(const expr_source &text) {
  return parser(text).whole();
}

expr_ptr parse_expression(const std::string &text, const std::string &where) {
  return parse_expression({std::make_shared<source_file>(source_file{where, text}), 0, text.size()});
}

std::string print(const expr &e) {
  return e.where.file->text.substr(e.where.offset, e.where.length);
}

} // namespace meetc::lang
