// SPDX-License-Identifier: MIT
// [C23]'s figures of a posed bar in space: variants, and Poisson's ratio up to infinity.
#include "embedded_figures.h"

#include <fmt/format.h>

#include <numbers>

namespace cageproof::validation {

std::unique_ptr<const PaperFigure> bar_variants_figure() {
  const auto bent = bent_bar(100 * std::numbers::pi / 180, 1.2);
  const auto somigliana = [&](const std::string& title, const std::string& file, const std::string& variant,
                              const std::string& nu) {
    return PanelPlan{.title = title,
                     .file = file,
                     .method = "somigliana",
                     .parameters = {{"variant", variant}, {"nu", nu}, {"gamma", "0"}},
                     .posed = bent};
  };
  SheetPlan variants{.name = "c23-bar",
                     .heading = "A bar by Somigliana coordinates: global, local and between",
                     .source = "[C23] Figure 4",
                     .text =
                         "Poisson's ratio 0.38, no bulging (γ = 0), as c23-star in the plane. \"off by\": the largest "
                         "distance from the image by the blend, which takes the mean of both variants' rotations and "
                         "stretches, over the cage's size.",
                     .columns = 4,
                     .panels = {{.title = "at rest", .file = "rest"}},
                     .view = bar_view};
  for (const std::string variant : {"global", "blend", "local"}) {
    variants.panels.push_back(somigliana(variant, variant, variant, "0.38"));
    if (variant != "blend") variants.panels.back().compared_with = "blend";
  }
  SheetPlan ratios{.name = "c23-infinite-ratio-bar",
                   .heading = "Poisson's ratio up to infinity, against Green coordinates, in space",
                   .source = "[C23] Figure 7, its lower row",
                   .text =
                       "No bulging (γ = 0). \"off by\": the largest distance from the image by Green coordinates (by "
                       "the mean of stretches), over the cage's size. In the plane an infinite ratio gives these "
                       "(c23-infinite-ratio); in space it does not.",
                   .columns = 3,
                   .panels = {{.title = "at rest", .file = "ratios.rest"}},
                   .view = bar_view};
  for (const std::string variant : {"global", "local"}) {
    for (const auto& [shown, nu] : {std::pair{"0.3", "0.3"}, {"∞", "inf"}}) {
      ratios.panels.push_back(somigliana(fmt::format("Somigliana, {}, ν = {}", variant, shown),
                                         fmt::format("{}.nu{}", variant, nu), variant, nu));
      ratios.panels.back().compared_with = "green";
    }
    if (variant == "global")
      ratios.panels.push_back(
          {.title = "Green", .file = "green", .method = "green", .parameters = {{"stretch", "mean"}}, .posed = bent});
  }
  return deformed_figure({.name = "bar variants",
                          .cage = std::make_shared<const Cage>(bar_cage()),
                          .mesh = rounded_box({0.4, 0.4, 0.9}, 0.12, 0.1),
                          .sheets = {std::move(variants), std::move(ratios)}});
}

}  // namespace cageproof::validation
