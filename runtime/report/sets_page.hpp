// report/sets_page.hpp: the answer about two sets, or about one with itself, as a page.
#ifndef MEETC_REPORT_SETS_PAGE_HPP
#define MEETC_REPORT_SETS_PAGE_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/report/drawn_side.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace meetc::report {

// Contacts of more pairs of elements would make a page that no browser shows well.
inline constexpr std::size_t most_contacts = 200'000;

// A set as it is drawn, and whether options or a pose moved it.
struct page_side {
  const painted &drawn;
  bool moved = false;
};

struct page_question {
  const predicate_info &predicate;
  rung precision = rung::certified;
  const char *precision_name = "certified";
  double tolerance = 0;
  double moved = 0; // by the tolerance: an element, at most
};

// Pairs of items, all of them, and where the pairs of elements meet. Without contacts, their number says why.
struct page_answer {
  std::span<const index_pair> pairs;
  const contact_set<double> *contacts = nullptr;
  std::size_t element_pairs = 0; // of a predicate with contacts
};

// The precision of an answer and what it promises; and the numbers that reading has moved.
std::string precision_in_words(rung precision, const char *name);
std::string rounding_in_words(const io::rounded_numbers &moved, std::string_view of = "");

// "1,690 pairs touch: 920 faces of A, 767 faces of B"
std::string touching_in_words(std::uint64_t pairs, const io::element_set &a, std::uint64_t touched_a,
                              const io::element_set &b, std::uint64_t touched_b);

// The bytes depend on the sets, their names and the answer alone. Throws io::error for a kind that cannot be drawn.
std::string page_of_two(const page_side &a, const page_side &b, const page_question &asked, const page_answer &found);

// merged: corners with equal coordinates are one. A pair stands once.
std::string page_of_one(const page_side &a, bool merged, const page_answer &found);

} // namespace meetc::report

#endif
