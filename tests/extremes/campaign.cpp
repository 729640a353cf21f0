#include "tests/extremes/campaign.hpp"

#include "tests/extremes/judges/geometry.hpp"

#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <thread>

namespace meetc::extremes_test {
namespace {

// Cases [first, last) of a cell. Each chunk has its own random numbers, so threads change nothing.
void run_chunk(cell &c, std::uint64_t seed, std::uint64_t cases, judge by, std::mutex &lock) {
  random_numbers random(seed);
  counts found;
  std::string wrong;
  many_cases together(*c.of);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const pair_of_rows p = c.from->make(c.of->a, c.of->b, random);
    const outcome o = check_case(*c.of, p, random, by);
    together.add(p, o.hit);
    ++found.cases;
    found.hits += o.hit;
    found.boxed += o.boxed;
    for (std::size_t r = 0; r < bounded; ++r)
      found.unsure[r] += o.unsure >> r & 1;
    for (std::size_t r = 0; r < rungs; ++r)
      found.wrong[r] += o.wrong >> r & 1;
    if (o.wrong && wrong.empty())
      wrong = fmt::format("{} on {}, rungs {:#x}: {}", c.of->name, c.from->name, o.wrong, text(p));
  }
  found.sets = together.run(seed, wrong);
  const std::scoped_lock guard(lock);
  c.found += found;
  if (c.first_wrong.empty())
    c.first_wrong = wrong;
}

std::uint64_t mixed(std::uint64_t z) { // splitmix64
  z += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

std::string line(std::string_view family, std::string_view subject, const counts &n, judge by) {
  std::string out = fmt::format("{:<16} {:<22} {:>11} {:>11} |", family, subject, n.cases, n.hits);
  for (std::size_t r = 0; r < per_object; ++r)
    out += fmt::format(" {:>10}", n.unsure[r]);
  out += fmt::format(" | {:>11} {:>11} {:>11} |", n.boxed, n.unsure[per_object], n.unsure[whole_box]);
  for (std::size_t r = 0; r < on_signs; ++r)
    out += fmt::format(" {}", n.wrong[r]);
  return out + (by == judge::signs ? " -\n" : fmt::format(" {}\n", n.wrong[on_signs]));
}

// These are counted, so that no other text has to be trusted.
std::string heading(const std::vector<cell> &cells, judge by) {
  std::uint64_t least = cells.empty() ? 0 : cells.front().found.cases, few = 0;
  std::set<const family *> of_families;
  std::set<const subject *> of_subjects;
  for (const cell &c : cells) {
    least = std::min(least, c.found.cases);
    few += c.found.cases < enough_cases;
    of_families.insert(c.from);
    of_subjects.insert(c.of);
  }
  return fmt::format("judge: {}\n{} families, {} predicates, {} cells that apply, at least {} cases a cell; cells "
                     "with fewer than {} cases: {}\n",
                     by == judge::signs ? "signs (the predicate's decision on integer signs)"
                                        : "geometry (exact distances of hulls and radii alone)",
                     of_families.size(), of_subjects.size(), cells.size(), least, enough_cases, few);
}

} // namespace

std::uint64_t counts::all_wrong() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t w : wrong)
    sum += w;
  for (const lane_counts &set : sets)
    sum += set.wrong;
  return sum;
}

counts &counts::operator+=(const counts &o) {
  cases += o.cases, hits += o.hits, boxed += o.boxed;
  for (std::size_t r = 0; r < bounded; ++r)
    unsure[r] += o.unsure[r];
  for (std::size_t r = 0; r < rungs; ++r)
    wrong[r] += o.wrong[r];
  for (std::size_t set = 0; set < sets.size(); ++set)
    sets[set] += o.sets[set];
  return *this;
}

std::vector<cell> all_cells() {
  std::vector<cell> out;
  for (const family &f : families())
    for (const subject &s : subjects())
      if (f.applies(s.a, s.b))
        out.push_back({&f, &s, {}, {}});
  return out;
}

outcome check_case(const subject &s, const pair_of_rows &p, random_numbers &random, judge by) {
  const float side = box_side(s.a, p.a, s.b, p.b) * static_cast<float>(1 << random.integer(0, 2));
  if (by == judge::signs)
    return s.check(p.a.data(), p.b.data(), side, nullptr);
  const int known = truth_by_geometry(s, p);
  return s.check(p.a.data(), p.b.data(), side, &known);
}

void run(std::vector<cell> &cells, const plan &what, const reporter &report) {
  // A slow judge gets fewer cases at a time, so that the last ones do not keep a single thread busy.
  const std::uint64_t chunk = what.by == judge::signs ? 4096 : 512;
  const std::uint64_t each = (what.cases + cells.size() - 1) / cells.size(), rounds = (each + chunk - 1) / chunk;
  std::atomic<std::uint64_t> next = 0, done = 0;
  std::mutex lock;
  const auto work = [&] {
    for (;;) {
      const std::uint64_t job = next++;
      if (job >= rounds * cells.size())
        return;
      const std::uint64_t round = job / cells.size(), size = std::min(chunk, each - round * chunk);
      run_chunk(cells[job % cells.size()], mixed(mixed(what.seed) + job), size, what.by, lock);
      done += size;
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned i = 0; i < what.threads; ++i)
    pool.emplace_back(work);
  for (auto last = std::chrono::steady_clock::now(); done < each * cells.size();) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (const auto now = std::chrono::steady_clock::now(); report && now - last > std::chrono::seconds(20)) {
      const std::scoped_lock guard(lock);
      report(done, wrong_in(cells));
      last = now;
    }
  }
}

std::string table(const std::vector<cell> &cells, judge by) {
  std::string out = heading(cells, by);
  out += fmt::format("{:<16} {:<22} {:>11} {:>11} | {:>10} {:>10} {:>10} | {:>11} {:>11} {:>11} | {}\n", "family",
                     "predicate", "cases", "hits", "fp32", "fp64", "fp64x2", "in a box", "per object", "whole box",
                     "wrong: fp32 fp64 fp64x2 per_object whole_box exact certified signs");
  for (const cell &c : cells)
    out += line(c.from->name, c.of->name, c.found, by);
  counts all;
  for (const family &f : families()) {
    counts sum;
    for (const cell &c : cells)
      if (c.from == &f)
        sum += c.found;
    out += line(f.name, "(all)", sum, by);
    all += sum;
  }
  for (const subject &s : subjects()) {
    counts sum;
    for (const cell &c : cells)
      if (c.of == &s)
        sum += c.found;
    out += line("(all)", s.name, sum, by);
  }
  out += line("(all)", "(all)", all, by);
  for (std::size_t set = 0; set < all.sets.size(); ++set)
    if (const lane_counts &n = all.sets[set]; n.cases > 0)
      out += fmt::format("in lanes, {}: {} cases, unsure in fp32 {}, in fp64 {}, wrong (both, certified, exact) {}\n",
                         meetc::name_of(static_cast<instruction_set>(set)), n.cases, n.unsure[0], n.unsure[1], n.wrong);
  for (const cell &c : cells)
    if (!c.first_wrong.empty())
      out += "wrong: " + c.first_wrong + "\n";
  return out;
}

std::uint64_t wrong_in(const std::vector<cell> &cells) {
  std::uint64_t sum = 0;
  for (const cell &c : cells)
    sum += c.found.all_wrong();
  return sum;
}

} // namespace meetc::extremes_test
