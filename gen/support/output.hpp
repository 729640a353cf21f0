// A command's standard output.
#pragma once
#include "gen/support/source.hpp"

#include <string_view>

namespace meetc {

// Writes text. finish_output() tells of text that could not be written, so that a command ends its work first and keeps
// its exit code.
void say(std::string_view text);

// Says a warning on standard error, with its place as in an error.
void warn(const spec_error &w);

// Writes what is still held back. Throws spec_error where standard output could not be written. A reader that has gone, as
// `head` does after its last line, is no fault; for this the program must ignore SIGPIPE.
void finish_output();

} // namespace meetc
