// Specs that must fail, each with one clear line, a caret and a trail, through the program itself.
#ifndef MEETC_TESTS_COMPILER_ERROR_FIXTURE_HPP
#define MEETC_TESTS_COMPILER_ERROR_FIXTURE_HPP

#include "tests/gen/fixture.hpp"

#include <span>

namespace meetc::compiler_test {

// A small algebra that works, a.toml. Every broken spec is this one with one piece of text replaced.
extern const char *const small_algebra;
// The text with the first `from` replaced by `to`. The test fails where there is none.
std::string edited(std::string text, const std::string &from, const std::string &to);

// s.toml, the scene for it; `kernels` as the array holds them, quotes included.
std::string small_scene(const std::string &kernels);

struct broken {
  const char *from, *to; // in a.toml
  const char *place;     // "a.toml:19:10", or "" where there is none
  const char *message;   // a piece of the first line
  const char *marked;    // the text above the caret and its tildes
  const char *trail;     // a piece of what follows, or ""
  const char *kernels = "'norm2(meet(sphere, sphere))', 'touch'";
};
void check_broken(std::span<const broken> rows);

// Runs `generate` on files in a folder and checks the shape of every error: exit code 2, nothing on stdout, a
// first line "PLACE: error: MESSAGE", the marked text under a caret, nothing written.
void check_error(const temporary_folder &folder, const std::string &scene, const broken &want);

} // namespace meetc::compiler_test

#endif
