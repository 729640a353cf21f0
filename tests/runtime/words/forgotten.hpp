// Functions that no test calls: every_function.sh must name those of them that are public, and no other.
#pragma once
#include <vector>

namespace forgotten {

enum class color { red, green };
struct options {
  std::vector<int> of = {};
};

int plain(int x, const options &how = {}); // not: a_comment(int)
template <class T> T of_template(const std::vector<T> &all) {
  return all.empty() ? T(plain(0)) : all.front();
}
inline constexpr int number = int(3);

class counted {
public:
  explicit counted(int n) : n_(n) {}
  counted(const counted &) = delete;
  int of_class() const { return private_one() + n_; }
  bool operator==(const counted &) const = default;
  struct inner {
    static double of_inner(double x);
  };

private:
  int private_one() const;
  int n_;
};

} // namespace forgotten
