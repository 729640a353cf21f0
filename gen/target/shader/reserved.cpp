#include "gen/target/shader/reserved.hpp"

#include <array>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

namespace meetc::target {
namespace {

// Keywords of GLSL 4.60 and what it reserves, without the words of C++, which no name has.
const char *const in_glsl =
    "active atomic_uint attribute bool buffer bvec2 bvec3 bvec4 cast centroid coherent common dmat2 dmat2x2 dmat2x3 "
    "dmat2x4 dmat3 dmat3x2 dmat3x3 dmat3x4 dmat4 dmat4x2 dmat4x3 dmat4x4 discard dvec2 dvec3 dvec4 external filter "
    "fixed flat fvec2 fvec3 fvec4 half highp hvec2 hvec3 hvec4 in input inout interface invariant ivec2 ivec3 ivec4 "
    "layout lowp mat2 mat2x2 mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 mat4x4 mediump noinline "
    "noperspective out output partition patch precise precision readonly resource sample shared smooth subroutine "
    "superp uint uniform uvec2 uvec3 uvec4 varying vec2 vec3 vec4 writeonly";

// The same of WGSL, with its types that need no argument.
const char *const in_wgsl =
    "Self abstract alias array as asm_fragment async await become binding_array bitcast column_major compile "
    "compile_fragment const_assert continuing crate debugger demote demote_to_helper diagnostic enable export extends "
    "f16 f32 fallthrough final finally fn from fxgroup get globallycoherent groupshared handle i32 impl "
    "implements import instanceof invariant let loop macro macro_rules match meta mod module move mut mutable "
    "nointerpolation noncoherent nonuniform null of override package packoffset pass pixelfragment priv "
    "ptr pub pure quat ref regardless register requires select self set smooth snorm storage super target texture "
    "trait type typeof u32 unless unorm unsafe unsized use var vec2f vec2h vec2i vec2u vec3f vec3h vec3i vec3u vec4f "
    "vec4h vec4i vec4u mat2x2f mat2x3f mat2x4f mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f mat2x2h mat2x3h "
    "mat2x4h mat3x2h mat3x3h mat3x4h mat4x2h mat4x3h mat4x4h vertexinput wgsl where with workgroup yield";

// The many types of images.
constexpr std::array<std::string_view, 13> families{
    "sampler",  "isampler", "usampler",     "image",         "iimage",        "uimage", "texture",
    "itexture", "utexture", "subpassInput", "isubpassInput", "usubpassInput", "atomic"};

std::set<std::string> words() {
  std::set<std::string> out;
  for (const char *list : {in_glsl, in_wgsl}) {
    std::istringstream text(list);
    out.insert(std::istream_iterator<std::string>(text), {});
  }
  return out;
}

} // namespace

bool is_reserved_in_shaders(const std::string &name) {
  static const std::set<std::string> all = words();
  for (const std::string_view family : families)
    if (name.starts_with(family))
      return true;
  return all.count(name) > 0;
}

} // namespace meetc::target
