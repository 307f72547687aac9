// SPDX-License-Identifier: MIT
#include "curve_picture.h"

#include "cageproof/core/catalogue/role.h"
#include "colours.h"
#include "digest.h"
#include "figure.h"
#include "series_styles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace cageproof::reports {
namespace {

// Filled and open circle, square, triangle up, triangle down, diamond: filled in double, open in other scalars.
constexpr std::array<std::array<int, 2>, 5> kShapes{{{7, 6}, {5, 4}, {9, 8}, {11, 10}, {13, 12}}};
constexpr double kSmallestDrawn = 0.1;
constexpr std::size_t kManyPoints = 40;

// The looks of a curve, as gnuplot has them; recommended evaluations are drawn thicker.
class Styles {
 public:
  explicit Styles(const RunResult& result) : series_(result) {}
  std::string line(const ResultCurve& curve) const {
    const SeriesStyle style = series_.of(curve.evaluation, curve.scalar);
    const bool leads = curve.role == name_of(Role::Recommended) && curve.scalar == "double";
    return fmt::format("linecolor rgb '{}' dashtype {} linewidth {} pointtype {} pointsize {}", style.colour,
                       dash_type(style.dash), leads ? 1.8 : 1, kShapes[style.shape][style.filled ? 0 : 1],
                       curve.errors.size() > kManyPoints ? 0.25 : 0.6);
  }

 private:
  static std::string dash_type(const std::vector<int>& dash) {
    return dash.empty() ? "1" : fmt::format("({})", fmt::join(dash, ","));
  }
  SeriesStyles series_;
};

using Curves = std::vector<const ResultCurve*>;

bool drawable(const ResultCurve& curve) {
  return std::ranges::any_of(curve.parameters, [](double p) { return p > 0 && std::isfinite(p); });
}

// Bounds on the promised digits. \param curves of one subject, regime and check
std::set<double> bounds(const RunResult& result, const Curves& curves, int order) {
  const ResultCurve& one = *curves.front();
  std::set<double> found;
  for (const ResultRow& row : result.rows) {
    if (!row.bound || row.order != order || row.subject != one.subject || row.setting != one.setting ||
        row.check != "digits")
      continue;
    for (const ResultCurve* curve : curves)
      if (curve->order == order && row.evaluation == curve->evaluation && row.scalar == curve->scalar &&
          *row.bound > 0 && std::isfinite(*row.bound))
        found.insert(*row.bound);
  }
  return found;
}

struct Range {
  int low_decade = 0, high_decade = 0;
};

// One range for all three panels, so that they can be compared.
Range error_range(const Curves& curves, const std::array<std::set<double>, 3>& promised) {
  double high = 1e2;
  for (const ResultCurve* curve : curves)
    for (const double error : curve->errors)
      if (std::isfinite(error)) high = std::max(high, error);
  for (const auto& set : promised)
    if (!set.empty()) high = std::max(high, *set.rbegin());
  return {static_cast<int>(std::floor(std::log10(kSmallestDrawn))), static_cast<int>(std::ceil(std::log10(high))) + 1};
}

Range parameter_range(const Curves& curves) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const ResultCurve* curve : curves)
    for (const double p : curve->parameters)
      if (p > 0 && std::isfinite(p)) low = std::min(low, p), high = std::max(high, p);
  Range range{static_cast<int>(std::floor(std::log10(low))), static_cast<int>(std::ceil(std::log10(high)))};
  if (range.low_decade == range.high_decade) --range.low_decade, ++range.high_decade;
  return range;
}

// Ticks at round decades, at most `most` of them.
std::string tics(Range range, int most) {
  constexpr std::array steps{1, 2, 3, 5, 10, 20, 25, 50, 100, 200};
  const int span = range.high_decade - range.low_decade;
  const auto* step = std::ranges::find_if(steps, [&](int s) { return span / s < most; });
  if (step == steps.end()) --step;
  const int first = static_cast<int>(std::ceil(1.0 * range.low_decade / *step)) * *step;
  return fmt::format("1e{},1e{},1e{}", first, *step, range.high_decade);
}

// Data blocks: $dN the finite errors (small ones lifted to the lower edge), $iN the infinite ones at the upper edge.
std::string data(const Curves& curves, Range errors) {
  std::string text;
  for (std::size_t n = 0; n < curves.size(); ++n) {
    std::string finite, infinite;
    const std::size_t count = std::min(curves[n]->parameters.size(), curves[n]->errors.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double p = curves[n]->parameters[i], error = curves[n]->errors[i];
      if (!(p > 0) || !std::isfinite(p)) continue;
      if (std::isfinite(error)) finite += fmt::format("{} {}\n", p, std::max(error, kSmallestDrawn));
      // Values that are not finite leave a gap in the line.
      else finite += "\n", infinite += fmt::format("{} 1e{}\n", p, errors.high_decade);
    }
    text += fmt::format("$d{} << EOD\n{}EOD\n$i{} << EOD\n{}EOD\n", n, finite.empty() ? "NaN NaN\n" : finite, n,
                        infinite.empty() ? "NaN NaN\n" : infinite);
  }
  return text;
}

// Evaluations, then the promise and the marker for values that are not finite.
std::vector<std::string> legend(const Curves& curves, const Styles& styles, bool promised, bool infinite) {
  std::vector<std::string> entries;
  std::set<std::string> seen;
  for (const ResultCurve* curve : curves)
    if (seen.insert(curve->evaluation + '\n' + curve->scalar).second)
      entries.push_back(fmt::format("keyentry with linespoints {} title {}", styles.line(*curve),
                                    gnuplot_text(curve->evaluation + ", " + curve->scalar)));
  if (promised) entries.emplace_back("keyentry with lines linecolor rgb '#777777' dashtype 2 title 'promised digits'");
  if (infinite)
    entries.push_back(fmt::format(
        "keyentry with points linecolor rgb '{}' pointtype 9 pointsize 1.3 title 'not finite'", kInfiniteColour));
  return entries;
}

std::string panel(const Curves& curves, const Styles& styles, const std::set<double>& promised, int order) {
  std::string plot;
  for (const double bound : promised)
    plot += fmt::format("{}{} with lines linecolor rgb '#777777' dashtype 2 notitle", plot.empty() ? "" : ", ", bound);
  for (std::size_t n = 0; n < curves.size(); ++n)
    if (curves[n]->order == order)
      plot += fmt::format(
          "{}$d{} with linespoints {} notitle, $i{} with points linecolor rgb '{}' pointtype 9 "
          "pointsize 1.3 notitle",
          plot.empty() ? "" : ", ", n, styles.line(*curves[n]), n, kInfiniteColour);
  return plot.empty() ? "NaN notitle" : plot;
}

Picture draw_curves(const RunResult& result, const Curves& curves, const Styles& styles, std::string file) {
  std::array<std::set<double>, 3> promised;
  for (int order = 0; order < 3; ++order) promised[order] = bounds(result, curves, order);
  const Range errors = error_range(curves, promised), parameters = parameter_range(curves);
  const bool any_promise = std::ranges::any_of(promised, [](const auto& set) { return !set.empty(); });
  const bool any_infinite = std::ranges::any_of(curves, [](const ResultCurve* curve) {
    return std::ranges::any_of(curve->errors, [](double error) { return !std::isfinite(error); });
  });
  const std::vector<std::string> entries = legend(curves, styles, any_promise, any_infinite);
  constexpr std::size_t most_in_a_row = 3;  // fits the width with the longest names
  const std::size_t rows = (entries.size() + most_in_a_row - 1) / most_in_a_row,
                    columns = (entries.size() + rows - 1) / rows;
  const int panel_height = 215, legend_height = 34 + 18 * static_cast<int>(rows),
            height = panel_height + legend_height + 48;
  std::string text = data(curves, errors);
  text += fmt::format(
      "set multiplot\nset logscale xy\nset format '10^{{%T}}'\nset border 3 linecolor rgb '#666666'\n"
      "set tics nomirror scale 0.5\nset grid xtics ytics linetype 1 linecolor rgb '#e0e0e0' linewidth 0.7\n"
      "set xrange [1e{}:1e{}]\nset yrange [1e{}:1e{}]\nset xtics {}\nset ytics {}\n"
      "set tmargin at screen {}\nset bmargin at screen {}\nset xlabel {} noenhanced offset 0,0.3\nunset key\n",
      parameters.low_decade, parameters.high_decade, errors.low_decade, errors.high_decade, tics(parameters, 6),
      tics(errors, 7), 1.0 - 1.0 * legend_height / height, 48.0 / height, gnuplot_text(curves.front()->parameter_name));
  constexpr std::array<std::array<double, 2>, 3> margins{{{0.085, 0.365}, {0.395, 0.675}, {0.705, 0.98}}};
  for (int order = 0; order < 3; ++order) {
    text += fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset title '{}' offset 0,-0.6\n",
                        margins[order][0], margins[order][1], order_name(order));
    text += order == 0 ? "set ylabel 'relative error, units of u' offset 0.3,0\n" : "unset ylabel\nset format y ''\n";
    text += "plot " + panel(curves, styles, promised[order], order) + "\n";
  }
  // The legend is a plot of its own: gnuplot breaks its lines at the plot's width.
  text += fmt::format(
      "unset logscale\nunset border\nunset tics\nunset xlabel\nunset title\nset lmargin at screen 0.01\n"
      "set rmargin at screen 0.99\nset tmargin at screen 0.995\nset bmargin at screen {}\n"
      "set key center center horizontal Left reverse noenhanced maxcols {} samplen 2.2 width 1 spacing 1.1\n"
      "plot [0:1] [0:1] NaN notitle",
      1 - 1.0 * (legend_height - 24) / height, columns);
  for (const std::string& entry : entries) text += ", " + entry;
  return {std::move(file), 960, height, text + "\nunset multiplot\n"};
}

}  // namespace

std::vector<CurvePicture> curve_pictures(const RunResult& result) {
  std::vector<CurvePicture> pictures;
  std::vector<Curves> groups;
  for (const ResultCurve& curve : result.curves) {
    if (!drawable(curve)) continue;
    const auto same = std::ranges::find_if(pictures, [&](const CurvePicture& p) {
      return p.subject == curve.subject && p.regime == curve.setting && p.check == curve.check;
    });
    groups.resize(std::max<std::size_t>(groups.size(), same - pictures.begin() + 1));
    groups[same - pictures.begin()].push_back(&curve);
    if (same == pictures.end())
      pictures.push_back({curve.subject, curve.setting, curve.check, curve.parameter_name, {}});
  }
  const Styles styles(result);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string name = fmt::format("{}.{}.{}", pictures[i].subject, pictures[i].regime, pictures[i].check);
    pictures[i].picture = draw_curves(result, groups[i], styles, fmt::format("pictures/{}.png", file_name(name)));
  }
  return pictures;
}

}  // namespace cageproof::reports
