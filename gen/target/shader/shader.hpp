// Shaders: formulas and plain decisions in float32, as functions of GLSL and of WGSL, in one file without an entry point.
//
// <space>/<space>.glsl and .wgsl have the names of the C header without its suffix for float: cga_sphere,
// cga_meet_sphere_line, cga_meet_sphere_line_blades, cga_ball_ball_fp32. Products and sums are written one by one. GLSL
// marks all values as `precise`, so that no compiler fuses or reorders them; WGSL has no such word.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

std::vector<file> glsl_files(const unit &u);
std::vector<file> wgsl_files(const unit &u);
// The part of the file for one kernel, after the kinds that it needs.
std::string glsl_text(const unit &u, std::size_t kernel);
std::string wgsl_text(const unit &u, std::size_t kernel);

// ---- the parts ----

// The differences between the two languages.
struct shader_language {
  const char *backend, *number, *integer;
  bool keeps_order; // of operations: the stated error is that of this order
  // A member, a parameter, or a value that is assigned later, each without what ends it.
  std::string (*declared)(const std::string &type, const std::string &name);
  const char *after_member, *after_struct;
  std::string (*variable)(const std::string &type, const std::string &name);
  std::string (*head)(const std::string &type, const std::string &name, const std::string &parameters);
  std::string (*keep)(const std::string &name, const std::string &value);  // a number
  std::string (*truth)(const std::string &name, const std::string &value); // a truth
  std::string (*choose)(const std::string &condition, const std::string &then, const std::string &otherwise);
  std::string (*integers)(std::size_t many, const std::string &name); // an array that is assigned later
};

// A name of the spec as one that neither language reserves; with the namespace, and an operand's.
std::string shader_member(const std::string &name);
std::string shader_path(const std::string &path);
std::string shader_name(const unit &u, const std::string &name);
std::string shader_operand(const std::string &name);
// The statements of a program, followed by the results through `result`.
std::string shader_body(const shader_language &l, const ir::program &p, const std::function<std::string(int)> &input,
                        const std::function<std::string(std::size_t, const std::string &)> &result);
// A function with a result of its own, named `result`, of the statements that assign it.
std::string shader_function(const shader_language &l, const std::string &type, const std::string &name,
                            const std::vector<std::string> &parameters, const std::string &result,
                            const std::string &code);
std::string shader_struct(const shader_language &l, const std::string &name,
                          const std::vector<std::pair<std::string, std::string>> &types_and_names);
std::string shader_kinds(const shader_language &l, const unit &u);
std::string shader_formula(const shader_language &l, const unit &u, const lower::kernel &k);
std::string shader_decision(const shader_language &l, const unit &u, const lower::kernel &k);

} // namespace meetc::target
