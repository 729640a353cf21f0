#include "meet/app/output/report_page.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/contact_files.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/text/text.hpp"
#include "meet/report/sets_page.hpp"

#include <fmt/format.h>

#include <optional>

namespace meetc::app {

namespace fs = std::filesystem;

void check_page(const fs::path &to) {
  const std::string extension = io::lower_case(to.extension().string());
  if (!extension.empty() && extension != ".html" && extension != ".htm")
    throw failure(fmt::format("--report {}: a report is a page of HTML; name it {}", to.string(),
                              fs::path(to).replace_extension(".html").string()));
}

bool page_has_contacts(const query &asked) {
  return asked.by.predicate->contacts && asked.tolerance == 0;
}

void write_page(const fs::path &to, const painted &a, const painted &b, const collide_report &r) {
  const query &q = r.asked;
  report::page_question asked{*q.by.predicate, q.precision, name_of(q.precision), q.tolerance};
  if (q.tolerance > 0)
    asked.moved = moved_by_grid(*q.by.predicate, q.grid);
  std::optional<contact_set<double>> contacts;
  report::page_answer found{r.found.list};
  if (page_has_contacts(q)) {
    found.element_pairs = r.found.element_pairs.size();
    if (found.element_pairs <= report::most_contacts)
      found.contacts = &contacts.emplace(find_contacts<double>(r.a, r.b, q, r.found));
  }
  io::write_file(to, report::page_of_two({a, r.moved_a}, {b, r.moved_b}, asked, found));
}

void write_page(const fs::path &to, const painted &a, const predicate_info &predicate, const self_report &r,
                int threads) {
  const std::vector<index_pair> pairs = pairs_of_faces(r);
  std::optional<contact_set<double>> contacts;
  report::page_answer found{pairs, nullptr, r.found.pairs.size()};
  if (found.element_pairs <= report::most_contacts) {
    contact_options options;
    options.threads = threads;
    found.contacts =
        &contacts.emplace(meetc::contacts<double>(view_of(r.a), view_of(r.a), predicate, r.found.pairs, options));
  }
  io::write_file(to, report::page_of_one({a, r.moved}, r.merged, found));
}

} // namespace meetc::app
