#include "tests/extremes/judges/lanes.hpp"

#include "meet/core/cascade/cascade.hpp"
#include "tests/downstream/flags/words.hpp"

#include <cga/cga_runtime.hpp>

namespace meetc::extremes_test {

lane_counts &lane_counts::operator+=(const lane_counts &o) {
  cases += o.cases, wrong += o.wrong;
  for (int r = 0; r < 2; ++r)
    unsure[r] += o.unsure[r];
  return *this;
}

void many_cases::add(const pair_of_rows &p, bool hit) {
  const auto n = static_cast<std::uint32_t>(pairs_.size());
  a_.insert(a_.end(), p.a.begin(), p.a.end());
  b_.insert(b_.end(), p.b.begin(), p.b.end());
  pairs_.push_back({n, n});
  truth_.push_back(hit ? answer::yes : answer::no);
}

pair_of_rows many_cases::rows(std::size_t k) const {
  const auto part = [k, n = pairs_.size()](const row &all) {
    const std::size_t fields = all.size() / n;
    return row(all.begin() + static_cast<std::ptrdiff_t>(k * fields),
               all.begin() + static_cast<std::ptrdiff_t>((k + 1) * fields));
  };
  return {part(a_), part(b_)};
}

counts_by_set many_cases::run(std::uint64_t word, std::string &first_wrong) const {
  counts_by_set out;
  for (int set = 0; set < instruction_set_count; ++set) {
    const catalogue *const all = cga::catalogue_for(static_cast<instruction_set>(set));
    for (int i = 0; all && i < all->predicate_count; ++i) {
      const predicate_info &p = all->predicates[i];
      if (std::string_view(p.name) != of_.name)
        continue;
      lane_counts &to = out[static_cast<std::size_t>(set)];
      to.cases += pairs_.size();
      std::vector<answer> found(pairs_.size());
      const auto ask = [&](const char *rung, const auto &decide, std::uint64_t *unsure) {
        {
          const std::uint64_t which = word++ % (std::size(strange_words) + 1); // the last one: the standard word
          const other_word changed(which < std::size(strange_words) ? strange_words[which] : plain_word);
          decide(row_array(a_.data()), row_array(b_.data()), pairs_.data(), pairs_.size(), found.data());
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
          const bool open = unsure && found[k] == answer::unsure;
          if (open)
            ++*unsure;
          if (open || found[k] == truth_[k])
            continue;
          ++to.wrong;
          if (first_wrong.empty())
            first_wrong =
                std::string(of_.name) + " in lanes, " + name_of(all->compiled_for) + ", " + rung + ": " + text(rows(k));
        }
      };
      ask("bounded in fp32", p.certify[0], &to.unsure[0]);
      ask("bounded in fp64", p.certify[1], &to.unsure[1]);
      ask(
          "certified", [by = cascade(p, meetc::rung::certified)](auto... args) { by.decide(args...); }, nullptr);
      ask("exact", p.decide[static_cast<int>(meetc::rung::exact)], nullptr);
    }
  }
  return out;
}

} // namespace meetc::extremes_test
