// Source text, places in it, and the one type of error that carries a place.
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace meetc {

struct source_file {
  std::string path; // as the user wrote it
  std::string text;
};

// A part of a source file. Files live as long as the spec that was read from them.
struct location {
  std::shared_ptr<const source_file> file;
  std::size_t offset = 0;
  std::size_t length = 0;

  explicit operator bool() const { return file != nullptr; }
  std::size_t line() const;   // from 1
  std::size_t column() const; // from 1, in bytes
  std::string text() const;   // "path:line:column"
};

// One step of the path that led to an error, innermost first: "in side(H, p), called at cga3.toml:40:18".
struct trail_step {
  std::string what;
  location where;
};

// A mistake in the user's text. `what()` is one clear line; render() adds the source line, a caret and the call trail.
class spec_error : public std::runtime_error {
public:
  spec_error(location where, const std::string &message);
  spec_error &add_step(std::string what, location at);
  // `as` replaces the word "error".
  std::string render(const char *as = "error") const;
  const std::string &message() const { return message_; }
  const location &where() const { return where_; }

private:
  location where_;
  std::string message_;
  std::vector<trail_step> trail_;
};

// Reads a whole file. If that fails, throws spec_error without a place (the path is in the message).
std::shared_ptr<const source_file> read_source(const std::string &path);

// "; did you mean 'twist'?" for the known name nearest to `name`, or "" where none is near.
std::string nearest(std::string_view name, const std::vector<std::string> &known);

std::string join(const std::vector<std::string> &parts, std::string_view between);

} // namespace meetc
