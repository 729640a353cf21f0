// The parts of an emitted predicate, shared by the files that write them.
#pragma once
#include "gen/target/cpp/cpp.hpp"

#include <functional>
#include <map>

namespace meetc::target {

struct emitted_stage {
  lower::stage_kind kind;
  const lower::stage *code;
  const bound::stage_bounds *bounds; // null where no rung needs them
  int first;                         // the number of its first sign
};

// A kernel that consists of signs, with the names of its parts in the text.
struct emitted_predicate {
  const unit &of;
  const lower::kernel &kernel;
  const bound::kernel_bounds *bounds;
  const lower::tolerant_way *tolerant; // null where the scene does not ask for the rung
  std::string name;                    // of its struct
  std::string kind_a, kind_b;          // identifiers
  std::string a, b;                    // the operands
  std::map<int, int> slot;             // the number of an atom's sign
  std::vector<emitted_stage> stages;

  emitted_predicate(const unit &u, std::size_t number);
  const emitted_stage *stage(lower::stage_kind which) const; // null if there is none
  bool has_rare() const { return stage(lower::stage_kind::rare) != nullptr; }
  // Whether some rung reads the bytecode, and whether one reads the bounds of a box.
  bool asks_bytecode() const { return of.asks(lang::rung::exact) || of.asks(lang::rung::certified); }
  bool asks_box() const { return of.asks(lang::rung::certified) && bounds && bounds->groups.weights.empty(); }
  bool asks_plain() const { return of.asks_plain(); }
  bool of_scene(const lower::sub_decision &c) const;
  std::string input(int i) const; // "A.c.y"
  // Declares the operands that a text mentions. They are read from the rows row_a and row_b of type T.
  std::string operands_in(const std::string &text, const std::string &indent) const;
};

// "struct reject_stage ..."; `scope` precedes the name if the stage is defined outside its predicate.
std::string stage_text(const emitted_predicate &p, const emitted_stage &s, const std::string &scope);
// A function of the decision that is true if any of these truths is.
std::string truth_function(const emitted_predicate &p, const std::string &name, const std::vector<int> &any_of,
                           const std::string &scope);

// The predicates whose decisions this decision calls, among those that the scene asks for.
std::vector<std::string> called_by(const emitted_predicate &p);

// The files in detail/: the bounds of the stages before the rare one, and all that only the rungs after fp32 need.
std::string bounds_header(const emitted_predicate &p);
std::string later_header(const emitted_predicate &p);
// After fp32: the whole cascade, or exact integers alone, which decide every pair that is left, and compile in a fifth of the
// time.
enum class last_rungs { all, integers };
// Definitions of the functions that are compiled in the generated library; `head` precedes each.
std::string out_of_line(const emitted_predicate &p, const std::string &head, last_rungs which = last_rungs::all);
// They as a header of this predicate, with exact integers after fp32.
std::string alone_header(const emitted_predicate &p);
// The source of the library that compiles them.
std::string predicate_source(const emitted_predicate &p);
// "triangle_triangle_info": the function in detail:: that returns a predicate's entry in the runtime's table.
std::string info_function(const lower::kernel &k);

// A stage's program as bytecode, for integers of any width (runtime/kernel/meetc/decide/bytecode.hpp): the members registers,
// instruction_count and instruction_at of a stage. The first registers hold the inputs.
std::string bytecode_text(const ir::program &p, int inputs);

} // namespace meetc::target
