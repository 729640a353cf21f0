// Questions by name; calls of programs that live long: sets that move, and results in chunks; and what answers and sets hold.
#ifndef MEETC_TESTS_RUNTIME_WORDS_LIVE_CALLS_HPP
#define MEETC_TESTS_RUNTIME_WORDS_LIVE_CALLS_HPP

#include "entries.hpp"

#include "meet/core/query/collide.hpp"

namespace words_test {

void add(caller &to, const meetc::result &r);
void add(caller &to, const meetc::prepared &p);

void call_ask(caller &under);
void call_collide_in_chunks(caller &under);
void call_moving_set(caller &under);
void call_refuse(caller &under);
void call_cancelled(caller &under);
void call_execution(caller &under);

} // namespace words_test

#endif
