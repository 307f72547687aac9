// SPDX-License-Identifier: MIT
#include "work_precision_picture.h"

#include "colours.h"
#include "digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace cageproof::reports {
namespace {

// "three-quad-75" and "three-quad-300" are of one family; a name without a number is its own.
std::string family_of(const std::string& evaluation) {
  const std::size_t end = evaluation.find_last_not_of("0123456789");
  return evaluation.substr(0, end == evaluation.npos ? 0 : end + 1);
}

struct Decades {
  double low, high;
};

Decades decades(const std::vector<double>& values) {
  double low = HUGE_VAL, high = 0;
  for (const double v : values)
    if (v > 0 && std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (high == 0) low = high = 1;
  return {std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::floor(std::log10(high)) + 1)};
}

}  // namespace

Picture work_precision_picture(const WorkPrecision& result, WorkAxis axis, std::string file) {
  const auto work = [&](const WorkPrecisionRow& row) { return axis == WorkAxis::Nodes ? row.nodes : row.nanoseconds; };
  std::vector<double> works, errors;
  for (const WorkPrecisionRow& row : result.rows) works.push_back(work(row)), errors.push_back(row.largest);
  const Decades x = decades(works), y = decades(errors);
  // Exact results are drawn at the lower edge, those that are not finite at the upper one.
  const auto height = [&](double error) { return std::clamp(error, y.low, y.high); };
  const auto place_of = [](const WorkPrecisionRow& row) -> const std::string& { return row.place; };
  const std::vector<std::string> places = distinct(result.rows, place_of);
  std::string blocks, plot, key;
  const auto add = [](std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; };
  std::map<std::string, std::pair<double, double>> labels;  // the highest point of each evaluation
  int block = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const char* colour = kCurveColours[p % kCurveColours.size()];
    std::map<std::string, std::vector<std::pair<double, double>>> families;
    for (const WorkPrecisionRow& row : result.rows) {
      if (row.place != places[p]) continue;
      const double error = height(row.largest);
      if (work(row) > 0) families[family_of(row.evaluation)].emplace_back(work(row), error);
      else add(plot, fmt::format("{} with lines linecolor rgb '{}' dashtype 2 notitle", error, colour));
      const auto [label, first] = labels.try_emplace(row.evaluation, work(row) > 0 ? work(row) : x.low, error);
      if (!first && error > label->second.second) label->second = {work(row) > 0 ? work(row) : x.low, error};
    }
    for (auto& [family, points] : families) {
      std::ranges::sort(points);
      std::string lines;
      for (const auto& [w, error] : points) lines += fmt::format("{} {}\n", w, error);
      blocks += fmt::format("$d{} << EOD\n{}EOD\n", block, lines);
      add(plot,
          fmt::format("$d{} with linespoints linecolor rgb '{}' pointtype 7 pointsize 0.8 notitle", block, colour));
      ++block;
    }
    key += fmt::format(", keyentry with linespoints linecolor rgb '{}' pointtype 7 title {}", colour,
                       gnuplot_text(places[p]));
  }
  std::string text =
      blocks +
      fmt::format(
          "set logscale xy\nset format '10^{{%T}}'\nset border 3 linecolor rgb '#666666'\nset tics nomirror scale 0.5\n"
          "set grid xtics ytics linetype 1 linecolor rgb '#e0e0e0' linewidth 0.7\nset xrange [{}:{}]\n"
          "set yrange [{}:{}]\n"
          "set title {} noenhanced\nset xlabel {}\nset ylabel {} noenhanced\nset key outside right top noenhanced Left "
          "reverse\n",
          x.low, x.high, y.low, y.high * 3, gnuplot_text(fmt::format("{}, {}", result.subject, result.where)),
          gnuplot_text(axis == WorkAxis::Nodes   ? "quadrature points per element"
                       : result.timed == "point" ? "nanoseconds a point, all of the cage"
                                                 : "nanoseconds a pair of point and element"),
          gnuplot_text(fmt::format("largest {} [{}]", result.error, result.unit)));
  for (const auto& [evaluation, at] : labels)
    // At the right edge to the left of its point, clear of the key.
    text +=
        fmt::format("set label {} at {},{} {} noenhanced font ',8' textcolor rgb '#444444'\n", gnuplot_text(evaluation),
                    at.first, at.second, at.first > x.high / 5 ? "right offset -0.4,0.6" : "left offset 0.4,0.6");
  text += "plot " + (plot.empty() ? "NaN notitle" : plot) + key;
  return {std::move(file), 800, 460, text + "\n"};
}

}  // namespace cageproof::reports
