// Every public function of the runtime, and its answer when it is called under some control word.
#ifndef MEETC_TESTS_RUNTIME_WORDS_ENTRIES_HPP
#define MEETC_TESTS_RUNTIME_WORDS_ENTRIES_HPP

#include <meetc/environment/control_word.hpp>

#include <exception>
#include <span>
#include <string>
#include <vector>

namespace words_test {

// A setting of the calling thread's floating-point environment, and the word that it leaves.
struct setting {
  std::string name;
  void (*set)(unsigned which);
  unsigned which;
};
std::span<const setting> settings(); // the first is the default one

// Calls functions under a setting. An exception is their answer; the setting must be the same after each call, the flags of
// past exceptions included.
class caller {
public:
  explicit caller(const setting &s) : setting_(s) {}
  template <class F> void operator()(const F &f) {
    enter();
    try {
      meetc::call_apart(f);
    } catch (const std::exception &e) {
      leave();
      answer += std::string("thrown: ") + e.what();
      return;
    }
    leave();
  }

  std::string answer; // bytes
  bool kept = true;   // the setting

  template <class T> void add(const T &number) {
    answer.append(reinterpret_cast<const char *>(&number), sizeof number);
  }
  template <class T> void add_all(const T *numbers, std::size_t n) {
    answer.append(reinterpret_cast<const char *>(numbers), n * sizeof *numbers);
  }
  template <class T> void add_all(const std::vector<T> &numbers) {
    add(numbers.size());
    add_all(numbers.data(), numbers.size());
  }

private:
  void enter();
  void leave();
  const setting &setting_;
};

struct entry {
  const char *name; // as tests/runtime/words/declared.awk prints it
  void (*call)(caller &under);
};
std::span<const entry> core_entries();
std::span<const entry> world_entries(); // of core: pairs within a mesh, contacts, bodies
std::span<const entry> io_entries();
std::span<const entry> table_entries(); // the functions that a table points to

} // namespace words_test

#endif
