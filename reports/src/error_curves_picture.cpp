// SPDX-License-Identifier: MIT
#include "error_curves_picture.h"

#include "colours.h"
#include "digest.h"
#include "figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cageproof::reports {
namespace {

constexpr std::array kMarks{7, 5, 9, 11, 13};

struct Powers {
  int low, high;
};

// Around the numbers that have a logarithm.
Powers powers_around(const std::vector<double>& numbers, Powers none) {
  double low = HUGE_VAL, high = 0;
  for (const double x : numbers)
    if (x > 0 && std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
  if (high == 0) return none;
  const Powers found{static_cast<int>(std::floor(std::log10(low))), static_cast<int>(std::ceil(std::log10(high)))};
  return {found.low, std::max(found.high, found.low + 1)};
}

Picture picture_of(const WorkPrecision& result, const std::vector<const WorkPrecisionRow*>& rows) {
  std::vector<double> places, errors;
  for (const WorkPrecisionRow* row : rows) places.push_back(row->distance), errors.push_back(row->largest);
  const Powers x = powers_around(places, {-1, 0}), y = powers_around(errors, {-1, 0});
  const double lowest = std::pow(10.0, y.low), highest = std::pow(10.0, y.high);
  const auto evaluations =
      distinct(rows, [](const WorkPrecisionRow* row) -> const std::string& { return row->evaluation; });
  std::string blocks, plot;
  for (std::size_t e = 0; e < evaluations.size(); ++e) {
    std::map<double, double> curve;
    for (const WorkPrecisionRow* row : rows)
      if (row->evaluation == evaluations[e])
        curve[row->distance] = std::isfinite(row->largest) ? std::max(row->largest, lowest) : highest;
    blocks += fmt::format("$d{} << EOD\n", e);
    for (const auto& [place, error] : curve) blocks += fmt::format("{} {}\n", place, error);
    blocks += "EOD\n";
    plot += fmt::format("{}$d{} with linespoints linecolor rgb '{}' pointtype {} pointsize 0.8 title {} noenhanced",
                        e == 0 ? "" : ", ", e, kCurveColours[e % kCurveColours.size()], kMarks[e % kMarks.size()],
                        gnuplot_text(evaluations[e]));
  }
  const std::string text = fmt::format(
      "set logscale xy\nset format '10^{{%T}}'\nset border 3 linecolor rgb '#666666'\nset tics nomirror scale 0.5\n"
      "set grid xtics ytics linetype 1 linecolor rgb '#e0e0e0' linewidth 0.7\nset xrange [1e{}:1e{}]\n"
      "set yrange [1e{}:1e{}]\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n"
      "set key outside right top Left reverse\nplot {}\n",
      x.low, x.high, y.low, y.high,
      gnuplot_text(fmt::format("{}, {}: {}", result.subject, result.where, rows.front()->sweep)),
      gnuplot_text(rows.front()->axis), gnuplot_text(fmt::format("largest {} [{}]", result.error, result.unit)), plot);
  return {fmt::format("pictures/error_{}.png", file_name(rows.front()->sweep)), 800, 460, blocks + text};
}

}  // namespace

std::vector<Picture> error_curves_pictures(const WorkPrecision& result) {
  std::vector<Picture> pictures;
  const auto sweep_of = [](const WorkPrecisionRow& row) -> const std::string& { return row.sweep; };
  for (const std::string& sweep : distinct(result.rows, sweep_of)) {
    if (sweep.empty()) continue;
    std::vector<const WorkPrecisionRow*> rows;
    for (const WorkPrecisionRow& row : result.rows)
      if (row.sweep == sweep) rows.push_back(&row);
    pictures.push_back(picture_of(result, rows));
  }
  return pictures;
}

}  // namespace cageproof::reports
