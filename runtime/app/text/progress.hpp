// app/text/progress.hpp: a line on a terminal that shows the progress of a long computation.
#ifndef MEETC_APP_TEXT_PROGRESS_HPP
#define MEETC_APP_TEXT_PROGRESS_HPP

#include <chrono>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace meetc::app {

// Prints nothing in the first second, and nothing at all unless standard error is a terminal. The destructor removes
// the line.
class progress_line {
public:
  explicit progress_line(std::string what) : what_(std::move(what)) {}
  ~progress_line() {
    if (shown_)
      std::fputs("\r\x1b[K", stderr);
  }
  progress_line(const progress_line &) = delete;
  progress_line &operator=(const progress_line &) = delete;

  void operator()(double fraction) {
    using namespace std::chrono_literals;
    if (!terminal_ || std::chrono::steady_clock::now() - start_ < 1s)
      return;
    std::fprintf(stderr, "\r%s %3d %%", what_.c_str(), static_cast<int>(100 * fraction));
    std::fflush(stderr);
    shown_ = true;
  }

private:
  std::string what_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_ = ::isatty(STDERR_FILENO) == 1, shown_ = false;
};

} // namespace meetc::app

#endif
