#include "tests/gen/bound/search.hpp"

namespace meetc::bounds_test {
namespace {
int bits_of(std::int64_t n) {
  int k = 0;
  for (std::uint64_t m = static_cast<std::uint64_t>(std::abs(n)); m; m >>= 1)
    ++k;
  return k;
}
// The spacing of numbers near n.
std::int64_t unit_at(std::int64_t n, int precision) {
  return std::int64_t{1} << std::max(0, bits_of(n) - precision);
}
} // namespace

std::int64_t any_number(const number_range &r, random_numbers &random) {
  const std::int64_t m = random.integer(-(std::int64_t{1} << r.precision) + 1, (std::int64_t{1} << r.precision) - 1);
  const int room = std::max(0, r.bits - r.precision);
  return m << random.integer(0, room);
}

std::int64_t stepped(std::int64_t n, std::int64_t steps, const number_range &r) {
  for (; steps != 0; steps -= steps > 0 ? 1 : -1) {
    const std::int64_t toward = steps > 0 ? 1 : -1;
    // The spacing from a power of two towards zero is half as large.
    const bool inwards = (n > 0) != (toward > 0);
    const std::int64_t unit = unit_at(inwards && n != 0 ? std::abs(n) - 1 : n, r.precision);
    const std::int64_t next = n + toward * unit;
    if (bits_of(next) > r.bits)
      return n;
    n = next;
  }
  return n;
}

sample any_sample(const stage_case &c, const number_range &r, random_numbers &random) {
  sample s;
  const auto n = static_cast<std::size_t>(c.inputs());
  s.numbers.resize(n);
  const int family = static_cast<int>(random.integer(0, 5));
  const number_range same{r.precision, r.precision}, few{std::min(r.precision, 3), std::min(r.precision, 3)};
  std::int64_t centre[3];
  for (std::int64_t &x : centre)
    x = any_number(r, random);
  for (std::size_t i = 0; i < n; ++i) {
    std::int64_t &x = s.numbers[i];
    switch (family) {
    case 0: // independent
      x = any_number(r, random);
      break;
    case 1: // of one scale
      x = any_number(same, random);
      break;
    case 2: // close together
      x = stepped(centre[i % 3], random.integer(-3, 3), r);
      break;
    case 3: // powers of two and their neighbours
      x = std::int64_t{1} << random.integer(0, r.bits - 1);
      x = random.one_in(2) ? x : -x;
      x = stepped(x, random.integer(-1, 1), r);
      break;
    case 4: // on a coarse grid
      x = any_number(few, random);
      x = random.one_in(2) ? x : x << std::max(0, r.bits - few.bits);
      break;
    default: // with equal coordinates
      x = i >= 3 && random.one_in(2)
              ? s.numbers[i - 3 * static_cast<std::size_t>(random.integer(1, static_cast<int>(i) / 3))]
              : any_number(r, random);
    }
  }
  return s;
}

void change_one(sample &s, const number_range &r, random_numbers &random) {
  std::int64_t &x = s.numbers[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.numbers.size()) - 1))];
  switch (random.integer(0, 6)) {
  case 0:
    x = any_number(r, random);
    break;
  case 1:
    x = -x;
    break;
  case 2: // another number, or its neighbour
    x = s.numbers[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.numbers.size()) - 1))];
    x = stepped(x, random.integer(-1, 1), r);
    break;
  case 3:
    if (bits_of(x) < r.bits)
      x *= 2;
    break;
  case 4:
    if (x % 2 == 0)
      x /= 2;
    break;
  default:
    x = stepped(x, random.integer(-4, 4), r);
  }
}

} // namespace meetc::bounds_test
