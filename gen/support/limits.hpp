// The most time and memory that one run may take, for specs that are not trusted.
#pragma once

namespace meetc {

struct limits {
  double seconds = 0; // of the clock on the wall; 0: any
  long megabytes = 0; // of resident memory; 0: any
};

// From here on a thread watches this process. Past a limit it writes one line to stderr and ends the process with `code`.
void watch_limits(const limits &l, int code = 2);

// Ends the watch: what is written from here on is written whole.
void stop_watching_limits();

} // namespace meetc
