// The rules for threads of docs/library.md under ThreadSanitizer, which ends the program with 66 where it finds a race. Each
// thread also compares its answers with those of one thread alone.
#include "tests/runtime/live/scenes.hpp"

#include "meet/core/world/world.hpp"

#include <atomic>
#include <cstdio>
#include <functional>
#include <thread>

using namespace live_test;

namespace {

constexpr int rounds = 3;
std::atomic<int> wrong{0};
void expect(bool holds, const char *what) {
  if (holds)
    return;
  std::printf("wrong: %s\n", what);
  ++wrong;
}

// Runs each of them on a thread of its own, all at once.
void all_at_once(const std::vector<std::function<void()>> &works) {
  std::vector<std::jthread> threads;
  for (const auto &work : works)
    threads.emplace_back([&work] {
      for (int i = 0; i < rounds; ++i)
        work();
    });
}

struct scene {
  const predicate_info &by = predicate("triangle_triangle");
  mesh a = self_test::eight_torus(0.6, 50, 30), b = shaken(a, 0.05F, 1);
  // Numbers that are multiplied for the kernels, so that both sets keep a copy.
  mesh large = a;
  prepared set_a = prepare(a.view(), *by.a), set_b = prepare(b.view(), *by.b), set_large;
  result want = collide(set_a, set_b, by, rung::certified);

  scene() {
    for (float &x : large.xyz)
      x *= 0x1p50F;
    set_large = prepare(large.view(), *by.a);
  }
};

// Fresh sets, whose stored values, multiplied rows and topology nobody has asked for, are asked by all threads.
void one_set_many_callers() {
  const scene s;
  const auto ask = [&](answer_kind want, int threads) {
    return [&s, want, threads] {
      collide_options o;
      o.want = want, o.threads = threads;
      expect(collide(s.set_a, s.set_b, s.by, rung::certified, o).count == s.want.count, "pairs of two sets");
      expect(collide(s.set_large, s.set_large, s.by, rung::certified, o).count > 0, "pairs of large numbers");
    };
  };
  all_at_once({ask(answer_kind::pairs, 2), ask(answer_kind::counts, 2), ask(answer_kind::flags, 1),
               [&] {
                 const result r = collide_in_chunks(s.set_a, s.set_b, s.by, rung::exact, 500, [](auto) {});
                 expect(r.count == s.want.count, "pairs in chunks");
               },
               [&] {
                 self_options o;
                 o.threads = 2;
                 expect(!self_pairs(s.set_a, s.a.view(), self_test::predicates(), o).pairs.empty(), "self pairs");
               },
               [&] {
                 contact_options o;
                 o.threads = 2;
                 const auto c = contacts(s.a.view(), s.b.view(), s.by, s.want.pairs, o);
                 expect(c.codes.size() == s.want.pairs.size(), "contacts");
               },
               [&] { prepare(s.b.view(), *s.by.a, {}, 2); }});
}

void cancelled_while_others_ask() {
  for (int i = 0; i < rounds; ++i) {
    const scene s;
    std::stop_source source;
    const auto until_stopped = [&](const std::function<void()> &call) {
      return [call] {
        try {
          call();
        } catch (const cancelled &) {
        }
      };
    };
    collide_options o;
    o.threads = 2, o.stop = source.get_token();
    all_at_once(
        {until_stopped([&] { collide(s.set_a, s.set_b, s.by, rung::certified, o); }),
         until_stopped([&] { collide(s.set_large, s.set_large, s.by, rung::exact, o); }),
         until_stopped([&] { prepare(s.a.view(), *s.by.a, {}, 2, nullptr, source.get_token()); }),
         [&] {
           std::this_thread::sleep_for(std::chrono::milliseconds(2 + i));
           source.request_stop();
         },
         [&] { expect(collide(s.set_a, s.set_b, s.by, rung::certified).count == s.want.count, "not stopped"); }});
    expect(collide(s.set_a, s.set_b, s.by, rung::certified).count == s.want.count, "after the request");
  }
}

// Each thread has a set that moves, and all collide it with one that does not.
void moving_sets() {
  const scene s;
  const auto move = [&](unsigned seed) {
    return [&s, seed] {
      moving_set moving(s.a.view(), *s.by.a, {}, 2);
      for (unsigned i = 0; i < 3; ++i) {
        const mesh m = shaken(s.a, 0.1F, seed + i);
        moving.update(m.view(), {}, 2);
        const auto ask = [&] {
          expect(collide(moving, s.set_b, s.by, rung::certified).count ==
                     collide(prepare(m.view(), *s.by.a), s.set_b, s.by, rung::certified).count,
                 "a set that moved");
        };
        const std::jthread other(ask); // between two moves several threads ask
        ask();
      }
      moving.reorder(s.a.view(), {}, 2);
    };
  };
  all_at_once({move(1), move(10)});
}

void one_world_many_callers() {
  const scene s;
  const auto shape = std::make_shared<prepared>(prepare(s.a.view(), *s.by.a));
  world bodies(cga::catalogue());
  for (int i = 0; i < 4; ++i) {
    pose at;
    at.m[3] = 0.5 * i;
    bodies.add("body " + std::to_string(i), shape, at);
  }
  world_options o;
  o.threads = 2, o.nested = true;
  const std::size_t want = bodies.touching(o).touching.size();
  const auto ask = [&] { expect(bodies.touching(o).touching.size() == want, "bodies"); };
  all_at_once({ask, ask, ask});
}

} // namespace

int main() {
  one_set_many_callers();
  cancelled_while_others_ask();
  moving_sets();
  one_world_many_callers();
  std::printf("%d wrong\n", wrong.load());
  return wrong > 0;
}
