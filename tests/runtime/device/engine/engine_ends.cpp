// The ends of float32: radii and coordinates of FLT_MAX, boxes that overflow, subnormals. Each scene by a query and
// by every pair, with every filter, rung and predicate, against the CPU's query and against the decision of every pair
// without any box.
#include "engine.hpp"

#include <cmath>
#include <limits>

namespace cuda_test {
namespace {

using namespace meetc;

constexpr float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();

// The larger of two sets makes the frame, or the second if they are equally large.
class scenes {
public:
  scenes(comparison &with, const settings &s) : with_(with), random_(s.seed + 30), small_(s.small) {}

  void run() {
    const catalogue &all = cga::catalogue();
    for (int i = 0; i < all.predicate_count; ++i) {
      beside_one_that_overflows(all.predicates[i]);
      palettes(all.predicates[i]);
      one_among_many(all.predicates[i]);
      posed(all.predicates[i]);
    }
  }

private:
  // Rows in which each number comes from the palette, with lengths as magnitudes.
  rows_of drawn(const kind_info &kind, std::size_t n, std::span<const float> palette) {
    rows_of out{&kind, {}};
    for (std::size_t i = 0; i < n * static_cast<std::size_t>(kind.fields); ++i) {
      const float v = palette[random_() % palette.size()];
      out.rows.push_back(kind.roles[i % static_cast<std::size_t>(kind.fields)] == role::length ? std::fabs(v) : v);
    }
    put_in_order(out);
    return out;
  }
  rows_of ordinary(const kind_info &kind, std::size_t n, double offset = 0) {
    return random_rows(kind, n, {1, 0.1, 1, offset}, random_);
  }
  // An element that reaches the end of float32 and, where the kind has a length, so far that its box overflows.
  static void add_huge(rows_of &to) {
    static constexpr float sphere[] = {0, 0, 0, most};
    static constexpr float row[] = {most, most, most, -most, -most, -most, -most, most, most};
    to.rows.insert(to.rows.end(), to.kind->fields == 4 ? sphere : row,
                   (to.kind->fields == 4 ? sphere : row) + to.kind->fields);
    put_in_order(to);
  }

  std::uint64_t same(const std::string &scene, const predicate_info &p, const rows_of &x, const rows_of &y,
                     std::span<const rung> rungs = all_rungs) {
    const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
    options o;
    o.expectations = true;
    with_.same(scene, p, a, b, rungs, o);
    return all_pairs_agree(scene, p, x, y, collide(a, b, p, rung::certified));
  }

  // Every pair, without a box or a filter.
  std::uint64_t all_pairs_agree(const std::string &scene, const predicate_info &p, const rows_of &x, const rows_of &y,
                                const result &have) {
    std::vector<index_pair> pairs, hits;
    for (std::uint32_t i = 0; i < x.size(); ++i)
      for (std::uint32_t j = 0; j < y.size(); ++j)
        pairs.push_back({i, j});
    std::vector<answer> answers(pairs.size());
    p.decide[static_cast<int>(rung::exact)](x.rows.data(), y.rows.data(), pairs.data(), pairs.size(), answers.data());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (answers[i] == answer::yes)
        hits.push_back(pairs[i]);
    bool equal = hits.size() == have.pairs.size();
    for (std::size_t i = 0; equal && i < hits.size(); ++i)
      equal = hits[i].a == have.pairs[i].a && hits[i].b == have.pairs[i].b;
    with_.require(scene, equal, std::string(p.name) + ": the CPU's query is not what the pairs say one by one");
    return hits.size();
  }

  // Small elements about 0 and one whose box is infinite make the frame. An element far beyond the small ones touches
  // the infinite one.
  void beside_one_that_overflows(const predicate_info &p) {
    const std::string scene = "beside one that overflows";
    for (const bool first : {true, false})
      for (const double far : {1e6, 1e30, 3e38}) {
        rows_of x = ordinary(*p.a, first ? 20 : 1, first ? 0 : far),
                y = ordinary(*p.b, first ? 1 : 20, first ? far : 0);
        add_huge(first ? x : y);
        same(scene, p, x, y);
      }
    if (std::string_view(p.name) != "ball_ball")
      return;
    rows_of a{p.a, {1e6F, 0, 0, 1}}, b{p.b, {}};
    for (int i = 0; i < 20; ++i)
      b.rows.insert(b.rows.end(), {static_cast<float>(i % 5) * 0.3F, static_cast<float>(i / 5) * 0.3F, 0, 0.1F});
    b.rows.insert(b.rows.end(), {0, 0, 0, 3.4028235e38F});
    with_.require(scene, same(scene, p, a, b) == 1,
                  "a sphere at 1e6 lies within the one of radius FLT_MAX, and no other");
  }

  void palettes(const predicate_info &p) {
    const float half = most / 2, before = std::nextafter(most, 0.0F), under = std::nextafter(half, 0.0F),
                above = std::nextafter(half, most);
    struct palette {
      const char *name;
      std::vector<float> numbers;
    };
    const palette all[] = {
        {"FLT_MAX alone", {most, -most}},
        {"FLT_MAX and 0", {most, -most, 0, 0}},
        {"about overflow", {half, -half, under, -under, above, -above, most, before, 0}},
        {"the whole range", {most, -most, 1e30F, -1e30F, 1, -1, 0, 0, 1e-30F, least, -least}},
        {"subnormals", {0, least, -least, 3 * least, 0x1p-127F, -0x1p-127F, 0x1.fffffcp-127F, 0x1p-126F}},
        {"FLT_MAX and subnormals", {most, least, 0, -least, -most, 0x1p-126F}},
    };
    std::uint64_t hits = 0, pairs = 0;
    for (const palette &t : all)
      for (const auto &[m, n] : {std::pair<std::size_t, std::size_t>{1, 9}, {9, 1}, {18, 13}, {13, 18}}) {
        const std::size_t times = small_ ? 1 : 8;
        // For fp32 balls enclose boxes, for certified they enclose elements.
        static constexpr rung few_rungs[] = {rung::fp32, rung::certified};
        const std::span<const rung> rungs = small_ ? std::span<const rung>(few_rungs) : all_rungs;
        hits += same(t.name, p, drawn(*p.a, m * times, t.numbers), drawn(*p.b, n * times, t.numbers), rungs);
        pairs += m * n * times * times;
        // Some of them are among ordinary elements.
        rows_of x = drawn(*p.a, m, t.numbers), y = ordinary(*p.b, 4 * n);
        const rows_of more = ordinary(*p.a, 3 * m), few = drawn(*p.b, 2, t.numbers);
        x.rows.insert(x.rows.end(), more.rows.begin(), more.rows.end());
        y.rows.insert(y.rows.end(), few.rows.begin(), few.rows.end());
        same(std::string(t.name) + ", mixed", p, x, y, rungs);
      }
    with_.require("palettes", hits > 0 && hits < pairs, std::string(p.name) + ": all pairs touch, or none does");
  }

  // An element whose box overflows is tested against every other, and costs nothing more: the frame is that of the
  // others.
  void one_among_many(const predicate_info &p) {
    const std::string scene = "one among many";
    const std::size_t n = small_ ? 2000 : 20000, m = small_ ? 100 : 1000;
    for (const bool owner_first : {true, false}) {
      rows_of x = ordinary(*p.a, owner_first ? n : m), y = ordinary(*p.b, owner_first ? m : n, 0.5);
      const std::uint64_t before = near(p, x, y);
      std::uint64_t looked_at = 0;
      if (p.a->fields == 4)
        looked_at += y.size(), add_huge(x);
      if (p.b->fields == 4)
        looked_at += x.size(), add_huge(y); // with the one in x, too
      if (looked_at == 0)
        continue;
      const rung certified[] = {rung::certified};
      with_.same(scene, p, prepare(view_of(x), *p.a), prepare(view_of(y), *p.b), certified);
      with_.require(scene, near(p, x, y) == before + looked_at,
                    std::string(p.name) + ": the frame is not that of the rest");
    }
  }
  std::uint64_t near(const predicate_info &p, const rows_of &x, const rows_of &y) {
    device_set a(with_.on(), prepare(view_of(x), *p.a)), b(with_.on(), prepare(view_of(y), *p.b));
    return with_.every_pair().collide(a, b, p, rung::certified, {.want = answer_kind::count}).near;
  }

  // A pose takes elements to the end of float32, where the box of one overflows, on all sides or on one, and
  // back. That one makes the frame together with small ones about 0; the balls that touch it alone lie far from
  // those.
  void posed(const predicate_info &p) {
    const auto about = [&](const kind_info &kind, std::size_t n, double offset) {
      return random_rows(kind, n, {0.01, 0.01, 1, offset}, random_);
    };
    static constexpr float wide[] = {0, 0, 0, 1}, aside[] = {0.2F, 0, 0, 0.9F},
                           across[] = {1, 1, 0, -1, -1, 0, -1, 1, 1};
    for (const float *sphere : {wide, aside})
      for (const bool first : {true, false}) {
        rows_of x = about(*p.a, first ? 20 : 7, first ? 0 : 0.5), y = about(*p.b, first ? 7 : 20, first ? 0.5 : 0);
        rows_of &owner = first ? x : y;
        const float *const row = owner.kind->fields == 4 ? sphere : across;
        owner.rows.insert(owner.rows.end(), row, row + owner.kind->fields);
        put_in_order(owner);
        const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
        device_set da(with_.on(), a), db(with_.on(), b);
        for (const double scale : {static_cast<double>(most), 1e-44, 1.0}) {
          pose at;
          at.m[0] = at.m[5] = at.m[10] = at.length_scale = scale;
          da.move(at), db.move(at);
          const prepared a_there = prepare(view_of(x), *p.a, at), b_there = prepare(view_of(y), *p.b, at);
          with_.same("a pose to the end", p, a_there, da, b_there, db, all_rungs);
          (first ? db : da).move({}); // the owner of the frame stays there
          with_.same("a pose of one to the end", p, first ? a_there : a, da, first ? b : b_there, db, all_rungs);
        }
      }
  }

  comparison &with_;
  engine random_;
  bool small_;
};

} // namespace

void end_scenes(comparison &with, const settings &s) {
  std::printf("the ends of float32 ...\n");
  scenes(with, s).run();
}

} // namespace cuda_test
