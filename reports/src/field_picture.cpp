// SPDX-License-Identifier: MIT
#include "field_picture.h"

#include "slice_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace cageproof::reports {
namespace {

constexpr std::array kAxes{"x", "y", "z"};

// The two axes that a slice spans, and the one that it cuts.
struct Plane {
  int across = 0, up = 1, cut = 2;
};

Plane plane_of(const ImageField& field) {
  for (const int cut : {2, 1, 0})
    if (field.points[cut] == 1) return {cut == 0 ? 1 : 0, cut == 2 ? 1 : 2, cut};
  return {};
}

std::string key_note(bool infinite, bool masked) {
  std::string text;
  if (infinite)
    text += fmt::format(", keyentry with points pointtype 5 pointsize 1.2 linecolor rgb '{}' title 'not finite'",
                        kInfiniteColour);
  if (masked)
    text += fmt::format(", keyentry with points pointtype 5 pointsize 1.2 linecolor rgb '{}' title 'no value'",
                        kMaskedColour);
  return text;
}

bool is_infinite(double x) { return std::isinf(x); }
bool is_masked(double x) { return std::isnan(x); }

// Long titles are written smaller, so that the picture's edge does not cut them.
int title_size(const std::string& title) {
  constexpr std::size_t most_at_full_size = 72;
  return title.size() <= most_at_full_size ? 10 : std::max(5, static_cast<int>(10 * most_at_full_size / title.size()));
}

// The title in the first line, the meaning of grey and red in the second.
std::string frame(const std::string& title, int height) {
  return fmt::format(
      "set border linecolor rgb '#666666'\nset tics nomirror out scale 0.5\nset size ratio -1\n"
      "set label 1 {} at screen 0.5,{} center noenhanced font ',{}'\n"
      "set key at screen 0.5,{} center top horizontal Left reverse samplen 0.5 width 1 maxcols 2\n",
      gnuplot_text(title), 1 - 14.0 / height, title_size(title), 1 - 24.0 / height);
}
constexpr int kHead = 52, kFoot = 48;

}  // namespace

Picture image_picture(const ImageField& field, const Colours& colours, const std::string& title, std::string file,
                      const MeshField* outline) {
  const Plane plane = plane_of(field);
  const std::array<int, 3> strides{1, field.points[0], field.points[0] * field.points[1]};
  const int slice = field.points[plane.cut] / 2;
  std::string grid, infinite;
  bool masked = false;
  for (int j = 0; j < field.points[plane.up]; ++j) {
    for (int i = 0; i < field.points[plane.across]; ++i) {
      const double value =
          colours.values[i * strides[plane.across] + j * strides[plane.up] + slice * strides[plane.cut]];
      masked = masked || is_masked(value);
      grid += gnuplot_number(value) + (i + 1 < field.points[plane.across] ? " " : "\n");
      if (is_infinite(value)) infinite += fmt::format("{} {}\n", i, j);
    }
  }
  const auto at = [&](int axis, int column) {
    return fmt::format("({} + {}*${})", field.origin[axis], field.spacing[axis], column);
  };
  const std::string x = at(plane.across, 1), y = at(plane.up, 2);
  // As high as the slice's proportions ask for, within reason.
  constexpr int width = 560;
  constexpr double left = 0.125, right = 0.80;
  const double aspect =
      field.points[plane.up] * field.spacing[plane.up] / (field.points[plane.across] * field.spacing[plane.across]);
  constexpr double plot_width = (right - left) * width;
  const double plot_height = std::clamp(plot_width * aspect, 120.0, 560.0);
  const int height = kHead + kFoot + static_cast<int>(plot_height);
  const double cut = field.origin[plane.cut] + slice * field.spacing[plane.cut];
  std::string text = colours.commands + frame(fmt::format("{}  ({} = {:.4g})", title, kAxes[plane.cut], cut), height);
  // A slice of almost no width fills the picture all the same: Gnuplot draws none that is less than a pixel wide.
  constexpr double least = 12;
  const double shorter = std::min(plot_width * aspect, plot_height / aspect);
  std::string stretched;
  if (!(shorter >= least)) {
    text += "set size noratio\n";
    const double factor = plot_height / (plot_width * aspect);
    stretched = fmt::format("; {} is drawn {:.3g} times as large", kAxes[factor > 1 ? plane.up : plane.across],
                            std::max(factor, 1 / factor));
  }
  text +=
      fmt::format("$grid << EOD\n{}EOD\n$infinite << EOD\n{}EOD\n", grid, infinite.empty() ? "NaN NaN\n" : infinite);
  text += fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin at screen {}\n"
      "set xlabel '{} [unit of the cage]{}'\nset ylabel '{} [unit of the cage]'\n"
      "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '{}' fillstyle solid noborder\n",
      left, right, 1 - 1.0 * kHead / height, 1.0 * kFoot / height, kAxes[plane.across], stretched, kAxes[plane.up],
      kMaskedColour);
  for (const auto& [name, axis] : {std::pair{'x', plane.across}, std::pair{'y', plane.up}})
    text += fmt::format("set {}range [{}:{}]\n", name, field.origin[axis] - field.spacing[axis] / 2,
                        field.origin[axis] + (field.points[axis] - 0.5) * field.spacing[axis]);
  std::string segments;
  if (outline != nullptr)
    for (const auto& [from, to] : outline_in_plane(*outline, plane.cut, cut))
      segments += fmt::format("{} {}\n{} {}\n\n", from[plane.across], from[plane.up], to[plane.across], to[plane.up]);
  // Gnuplot takes no empty data.
  text += fmt::format("$outline << EOD\n{}EOD\n", segments.empty() ? "NaN NaN\n" : segments);
  text += fmt::format(
      "plot $grid matrix using {}:{}:3 with image notitle, "
      "$infinite using {}:{}:({}):({}) with boxxyerror fillstyle solid noborder linecolor rgb '{}' notitle, "
      "$outline using 1:2 with lines linewidth 4 linecolor rgb 'white' notitle, "
      "$outline using 1:2 with lines linewidth 1.6 linecolor rgb 'black' notitle{}\n",
      x, y, x, y, field.spacing[plane.across] / 2, field.spacing[plane.up] / 2, kInfiniteColour,
      key_note(!infinite.empty(), masked));
  return {std::move(file), width, height, std::move(text)};
}

Picture mesh_picture(const MeshField& field, const Colours& colours, const std::string& title, std::string file) {
  struct View {
    const char* name;
    Vec3<double> across, up, towards;
  };
  const std::array<View, 2> views{
      {{"front", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {"side", {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};
  const bool infinite = std::ranges::any_of(colours.values, is_infinite);
  const bool masked = std::ranges::any_of(colours.values, is_masked);
  // Points a little larger than their share of the panel, so that a dense mesh looks closed.
  const double size =
      std::clamp(70 / std::sqrt(static_cast<double>(std::max<std::size_t>(1, field.vertices.size()))), 0.35, 1.2);
  constexpr int height = 420;
  std::string text = colours.commands + frame(title, height) + "set multiplot\nunset border\nunset tics\nset cbtics\n";
  Eigen::AlignedBox3d box;
  for (const Vec3<double>& vertex : field.vertices) box.extend(vertex);
  if (box.isEmpty()) box.extend(Vec3<double>(Vec3<double>::Zero()));
  // One scale for both views.
  const double half = std::max(box.sizes().maxCoeff(), 1e-300) * 0.52;
  std::vector<std::size_t> order(field.vertices.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    const double across = views[v].across.dot(box.center()), up = views[v].up.dot(box.center());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return views[v].towards.dot(field.vertices[i]); });
    std::array<std::string, 3> blocks;  // masked, finite, infinite: what must not be overlooked comes last
    for (const std::size_t i : order) {
      const double value = colours.values[i];
      blocks[is_masked(value)     ? 0
             : is_infinite(value) ? 2
                                  : 1] += fmt::format("{:.6g} {:.6g} {}\n", views[v].across.dot(field.vertices[i]),
                                                      views[v].up.dot(field.vertices[i]), gnuplot_number(value));
    }
    for (std::size_t b = 0; b < blocks.size(); ++b)
      text += fmt::format("$v{} << EOD\n{}EOD\n", b, blocks[b].empty() ? "NaN NaN NaN\n" : blocks[b]);
    text += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen 0.87\nset bmargin at screen 0.08\n"
        "set xrange [{}:{}]\nset yrange [{}:{}]\nset xlabel '{}'\n{}\n",
        v == 0 ? 0.02 : 0.43, v == 0 ? 0.42 : 0.83, across - half, across + half, up - half, up + half, views[v].name,
        v == 0 ? "unset colorbox" : "set colorbox");
    text += fmt::format(
        "plot $v0 using 1:2 with points pointtype 7 pointsize {0} linecolor rgb '{1}' notitle, "
        "$v1 using 1:2:3 with points pointtype 7 pointsize {0} linecolor palette notitle, "
        "$v2 using 1:2 with points pointtype 7 pointsize {2} linecolor rgb '{3}' notitle{4}\nunset label 1\n",
        size, kMaskedColour, std::max(size, 0.6), kInfiniteColour, v == 0 ? key_note(infinite, masked) : "");
  }
  return {std::move(file), 760, height, text + "unset multiplot\n"};
}

}  // namespace cageproof::reports
