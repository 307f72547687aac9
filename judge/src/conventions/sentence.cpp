// SPDX-License-Identifier: MIT
#include "conventions/sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace cageproof::judge {
namespace {

std::string factor_text(const Convention& convention, const Formula& formula) {
  std::string text = name_of_constant(convention.factor);
  if (text.empty()) text = fmt::format("{:.12g} (a constant without a name)", convention.factor);
  std::string above, below;
  for (std::size_t p = 0; p < convention.powers.size(); ++p) {
    const int power = convention.powers[p];
    if (power == 0) continue;
    const auto& name = formula.parameters[p].name;
    std::string& to = power > 0 ? above : below;
    to += fmt::format(" {}", name == "nu" ? "(1 - nu)" : name);
    if (std::abs(power) > 1) to += fmt::format("^{}", std::abs(power));
  }
  if (text == "1" && !above.empty()) text = above.substr(1);
  else text += above;
  if (!below.empty()) text += " /" + below;
  return text;
}

// A sign may come from three habits, which numbers cannot tell apart.
std::string sign_hint(const Convention& convention, const Formula& formula) {
  if (convention.factor >= 0) return {};
  if (formula.flip_sign < 0) return " (the sign of the kernel, or point minus element)";
  return " (the sign of the fundamental solution)";
}

std::string half_hint(const Convention& convention) {
  const bool about_angles = convention.formula.find("angle") != std::string::npos ||
                            convention.formula.find("mean_value") != std::string::npos;
  if (!about_angles) return {};
  const double size = std::abs(convention.factor);
  if (size == 2) return " (angles in place of half angles)";
  return size == 0.5 ? " (half angles in place of angles)" : "";
}

}  // namespace

std::string sentence_of(const Convention& convention, const Formula& registered_for) {
  const Formula& formula = formula_named(convention.formula);
  std::string text = convention.formula == registered_for.name
                         ? "yours is ours"
                         : fmt::format("yours is {} instead of {}", convention.formula, registered_for.name);
  const std::string factor = factor_text(convention, formula);
  if (factor != "1") text += " times " + factor + sign_hint(convention, formula) + half_hint(convention);
  if (!convention.corners.empty()) {
    std::vector<int> order;
    order.reserve(convention.corners.size());
    for (const int k : convention.corners) order.push_back(k + 1);
    text += fmt::format(", with corners in the order {}", fmt::join(order, ", "));
  }
  if (convention.reversed) text += ", with corners the other way round, so that normals point inward";
  if (convention.transposed) text += ", with rows and columns swapped";
  if (convention.normalised) text += ", divided by the sum over the corners";
  if (convention.derivative_sign < 0) text += ", and derivatives by the element's position instead of the point's";
  if (convention.derivative_first) text += ", and gradients stored with the derivative's index first";
  return text;
}

}  // namespace cageproof::judge
