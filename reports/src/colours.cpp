// SPDX-License-Identifier: MIT
#include "colours.h"

#include "gnuplot.h"
#include "palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cageproof::reports {
namespace {

std::string palette_commands() {
  std::string steps;
  for (std::size_t i = 0; i < kPalette.size(); ++i)
    steps += fmt::format("{}{} '{}'", i > 0 ? ", " : "", i, kPalette[i]);
  return fmt::format("set palette defined ({})\n", steps);
}
constexpr double kDecadesBelowLargest = 20;

std::vector<double> samples(const ImageField::Array& array) {
  if (array.components == 1) return array.values;
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i + array.components <= array.values.size(); i += array.components) {
    double sum = 0;
    for (int k = 0; k < array.components; ++k) sum = std::hypot(sum, array.values[i + k]);
    magnitudes.push_back(sum);
  }
  return magnitudes;
}

std::string bar(const Colours& colours, ColourScale scale, const ImageField::Array& array) {
  const std::string label = array.unit.empty() ? array.name : fmt::format("{} [{}]", array.name, array.unit);
  std::string text = fmt::format("{}set cbrange [{}:{}]\nset cblabel {} noenhanced offset 0.6,0\n", palette_commands(),
                                 colours.low, colours.high, gnuplot_text(label));
  if (scale == ColourScale::Log10) {
    const int step = std::max(1, static_cast<int>(std::ceil((colours.high - colours.low) / 8)));
    text += fmt::format("set format cb '10^{{%.0f}}'\nset cbtics {}\n", step);
  }
  return text;
}

}  // namespace

const ImageField::Array& array_named(const std::vector<ImageField::Array>& arrays, const std::string& name,
                                     std::size_t samples) {
  for (const ImageField::Array& array : arrays)
    if (array.components < 1 || array.values.size() != samples * array.components)
      throw std::invalid_argument(fmt::format("field array '{}' has {} values for {} samples of {} components",
                                              array.name, array.values.size(), samples, array.components));
  const auto found = std::ranges::find(arrays, name, &ImageField::Array::name);
  if (found == arrays.end()) throw std::invalid_argument(fmt::format("the field has no array '{}'", name));
  return *found;
}

Colours colours_of(const ImageField::Array& array, ColourScale scale, std::optional<ColourLimits> limits) {
  Colours colours;
  colours.values = samples(array);
  bool any = false;
  for (const double value : colours.values)
    if (std::isfinite(value)) colours.largest = any ? std::max(colours.largest, value) : value, any = true;
  if (scale == ColourScale::Log10) {
    for (double& value : colours.values) value = std::isnan(value) ? value : std::log10(std::abs(value));
    double high = -HUGE_VAL;
    for (const double value : colours.values)
      if (std::isfinite(value)) high = std::max(high, value);
    colours.high = std::isfinite(high) ? std::ceil(high) : 0;
    // An exact zero has no logarithm: it takes the lowest colour.
    double low = colours.high;
    for (const double value : colours.values)
      if (std::isfinite(value)) low = std::min(low, value);
    colours.low = std::max(std::floor(low), colours.high - kDecadesBelowLargest);
    if (limits) colours.low = std::log10(limits->low), colours.high = std::log10(limits->high);
    for (double& value : colours.values)
      if (value < colours.low) value = colours.low;
    if (colours.low == colours.high) --colours.low;
  } else if (any) {
    colours.low = colours.high = colours.largest;
    for (const double value : colours.values)
      if (std::isfinite(value)) colours.low = std::min(colours.low, value);
    if (colours.low == colours.high) colours.high = colours.low + std::max(1e-300, std::abs(colours.low));
    if (limits) colours.low = limits->low, colours.high = limits->high;
  }
  colours.commands = bar(colours, scale, array);
  return colours;
}

}  // namespace cageproof::reports
