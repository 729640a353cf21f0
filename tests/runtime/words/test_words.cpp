// Every public function of the runtime, under each control word that another library may have set: answers are equal, nothing
// traps, and the caller's word is as it was.
#include "tests/catch.hpp"

#include "entries.hpp"

#include <set>

using namespace words_test;

namespace {

void check_all(std::span<const entry> entries) {
  for (const entry &e : entries) {
    caller plain(settings().front());
    e.call(plain);
    INFO(e.name);
    CHECK(plain.kept);
    for (const setting &s : settings()) {
      INFO(s.name);
      caller under(s);
      e.call(under);
      CHECK((under.answer == plain.answer));
      CHECK(under.kept);
    }
  }
}

} // namespace

TEST_CASE("words: every public function of core answers alike under each") {
  check_all(core_entries());
  check_all(world_entries());
}

TEST_CASE("words: every public function of io answers alike under each") {
  check_all(io_entries());
}

TEST_CASE("words: every function of a table answers alike under each") {
  check_all(table_entries());
}

TEST_CASE("words: the settings differ from the default one, and from each other") {
  std::set<std::string> names;
  for (const setting &s : settings())
    names.insert(s.name);
  CHECK(names.size() == settings().size());
  // A call without a guard sees them: subnormals vanish, sums round otherwise.
  static volatile float tiny = 0x1p-149F, one = 1, small = 0x1p-30F;
  std::set<std::string> seen;
  for (const setting &s : settings()) {
    caller under(s);
    bool masked = false;
    float sums[3];
    under([&] { masked = meetc::exceptions_are_masked(); });
    if (!masked) // they would trap
      continue;
    under([&] { sums[0] = tiny + tiny, sums[1] = one + small, sums[2] = -one - small; });
    under.add_all(sums, 3);
    seen.insert(under.answer);
  }
  CHECK(seen.size() >= 4); // flushed, to nearest or to zero, up and down
}
