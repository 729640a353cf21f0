// bench/tables/paper/figures.hpp: the paper's figures as files.
#ifndef MEETC_BENCH_TABLES_PAPER_FIGURES_HPP
#define MEETC_BENCH_TABLES_PAPER_FIGURES_HPP

#include "bench/tables/paper/parts.hpp"

#include <filesystem>
#include <string>

namespace meetc::bench {

inline constexpr int figures = 6;

std::string figure_file(int number); // "figure_1.png"

// Draws a small picture where `quick`. Throws io::error, or app::failure.
void draw_figure(const std::filesystem::path &to, const paper_figure &f, bool quick);

} // namespace meetc::bench

#endif
