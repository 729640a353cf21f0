// bench/tables/gpu/growth_chart.hpp: the chart of how the searches of a device grow with the sets.
#ifndef MEETC_BENCH_TABLES_GPU_GROWTH_CHART_HPP
#define MEETC_BENCH_TABLES_GPU_GROWTH_CHART_HPP

#include "meet/app/text/json.hpp"
#include "meet/bench/harness/chart.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::bench {

// From the object that `meet bench gpu --json` prints. Its rows of balls alone are one family, in which only the number grows.
// Empty where it has no growth table. Throws app::json::exception where it is not such an object.
std::optional<chart> growth_chart(const app::json &results);

// Draws the chart from a file with that object into a folder, as growth.png. Returns the text for standard output. Throws
// io::error, also where the file holds no growth table, and app::failure where gnuplot is missing.
std::string draw_growth(const std::filesystem::path &results, const std::filesystem::path &folder);

} // namespace meetc::bench

#endif
