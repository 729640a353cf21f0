// app/input/failure.hpp: the error that ends a command without a result: a message of one line and an exit code.
#ifndef MEETC_APP_INPUT_FAILURE_HPP
#define MEETC_APP_INPUT_FAILURE_HPP

#include "meet/io/files/error.hpp"

namespace meetc::app {

enum exit_code : int { done = 0, check_failed = 1, bad_input = 2, no_device = 3 };

// Like io::error, which also means bad_input, but with another exit code where one applies.
class failure : public io::error {
public:
  explicit failure(std::string_view message, exit_code code = bad_input) : io::error(message), code_(code) {}
  exit_code code() const { return code_; }

private:
  exit_code code_;
};

} // namespace meetc::app

#endif
