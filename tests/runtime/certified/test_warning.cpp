// The warning of `meet` where a set leaves the scene's box. The shipped scene has no box, so its catalogue gets one
// here.
#include "tests/catch.hpp"
#include "tests/folder.hpp"

#include "meet/app/commands/collide_command.hpp"

#include <cga/cga_runtime.hpp>
#include <cstdio>
#include <neighbours/neighbours_runtime.hpp>
#include <string>
#include <unistd.h>

namespace {

using test_files::folder, test_files::get, test_files::put;
namespace fs = std::filesystem;

// The text of the command on standard error; its answer must hold `pairs`.
std::string said(float box, const fs::path &a, const fs::path &b, const char *pairs,
                 meetc::rung precision = meetc::rung::certified) {
  meetc::catalogue all = cga::catalogue();
  all.box = box;
  meetc::app::collide_request q;
  q.a = a;
  q.b = b;
  q.json = true;
  q.precision = precision;
  std::fflush(stderr);
  const int kept = ::dup(STDERR_FILENO);
  std::FILE *const file = std::fopen((folder() / "stderr.txt").c_str(), "wb");
  REQUIRE(file);
  ::dup2(::fileno(file), STDERR_FILENO);
  const std::string out = meetc::app::collide(all, neighbours::catalogue(), q).text;
  std::fflush(stderr);
  ::dup2(kept, STDERR_FILENO);
  ::close(kept);
  std::fclose(file);
  CHECK(out.find(std::string("\"pairs\":") + pairs + ",") != std::string::npos);
  return get(folder() / "stderr.txt");
}

} // namespace

TEST_CASE("a set that leaves the scene's box is warned of, once, and the answer stays") {
  const fs::path balls = put("balls.csv", "x,y,z,r\n0,0,0,1\n-0.5,0,3,0.25\n");
  const fs::path rods = put("rods.csv", "x0,y0,z0,x1,y1,z1\n-2,0,0,2,0,0\n-0.5,-1,3,-0.5,1,3\n");
  CHECK(said(0, balls, rods, "2").empty());
  CHECK(said(3, balls, rods, "2").empty());
  CHECK(said(2, balls, rods, "2", meetc::rung::exact).empty());
  const std::string both = "meet: warning: outside of the scene's box, -2 to 2 in each coordinate: A ";
  CHECK(said(2, balls, rods, "2").rfind(both, 0) == 0);
  CHECK(said(2, balls, rods, "2").find(", B [-2, -1, 0] to [2, 1, 3]; fp32") != std::string::npos);
  // The order of the files does not matter, and there is one line.
  const fs::path small = put("small.csv", "x,y,z,r\n0,0,0,1\n");
  const std::string second = said(2, small, rods, "1"), first = said(2, rods, small, "1");
  CHECK(second.find("coordinate: B [-2, -1, 0] to [2, 1, 3]; ") != std::string::npos);
  CHECK(first.find("coordinate: A [-2, -1, 0] to [2, 1, 3]; ") != std::string::npos);
  CHECK(first.find('\n') == first.size() - 1);
}
