// Runs another program and waits for it.
#pragma once
#include <string>
#include <vector>

namespace meetc {

struct finished_process {
  int code = -1;      // of exit; 127: it could not be started; -1: a signal ended it
  double seconds = 0; // of processors, with those of its own children
  std::string said;   // on standard output and standard error
};

// The first word is the program, which is searched for in PATH. Throws spec_error where no process can be made.
finished_process run_process(const std::vector<std::string> &words);

} // namespace meetc
