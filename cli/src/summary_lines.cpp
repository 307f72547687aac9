// SPDX-License-Identifier: MIT
#include "summary_lines.h"

#include <fmt/format.h>

namespace cageproof::cli {
namespace {

// "1 point", "2 points".
std::string points_of(std::size_t count) { return fmt::format("{} point{}", count, count == 1 ? "" : "s"); }

}  // namespace

std::vector<std::string> lines_of(const validation::CoordinateSummary& s, const CoordinateKind& kind,
                                  const Cage& cage) {
  std::vector<std::string> lines{fmt::format("{}: {} inside, {} on and {} outside {}", points_of(s.points), s.inside,
                                             s.on, s.outside, cage.name())};
  if (cage.name().ends_with(".svg") && s.inside + s.on == 0)
    lines.emplace_back("an SVG's y axis is flipped: points from the same drawing need minus its y");
  if (s.reproduces && s.missing + s.infinite < s.points)
    lines.push_back(fmt::format(
        "largest residual: partition of unity {:.2g} (point {}), linear reproduction {:.2g} cage sizes (point {})",
        s.partition.value, s.partition.point, s.reproduction.value, s.reproduction.point));
  if (s.outside > 0 && !kind.normalised && s.reproduces)
    lines.push_back(
        fmt::format("warning: {} coordinates sum to zero outside the cage: what is deformed with them "
                    "collapses to the origin at {} (normalised kinds, as mean_value, do not)",
                    kind.name, points_of(s.outside)));
  if (s.inexact > 0) {
    const std::string_view far = "far from the cage their weights cancel",
                           near = "weights of walls that are close to each other have opposite signs and cancel";
    const std::string reason = !kind.normalised             ? ""
                               : s.inexact_far == s.inexact ? fmt::format(": {}", far)
                               : s.inexact_far == 0         ? fmt::format(": {}", near)
                                                            : fmt::format(": {}, or {}", far, near);
    lines.push_back(fmt::format("warning: {} coordinates of {} of {} points sum to {} to fewer than 8 digits{}",
                                kind.name, s.inexact, s.points,
                                kind.normalised || s.outside == 0 ? "one" : "one, or zero outside,", reason));
  }
  if (s.misplaced > 0)
    lines.push_back(fmt::format(
        "warning: {} coordinates give {} of {} points back to fewer than 8 digits of the cage's size, at worst {:.2g} "
        "sizes off: the cage lies {:.2g} of its sizes from the origin, where doubles are {:.2g} sizes apart; subtract "
        "the same whole numbers from the coordinates of cage and points before they are rounded to double",
        kind.name, s.misplaced, s.points, s.reproduction.value, s.far_off, s.grain));
  const std::string_view lost = kind.normalised ? "the sum of their weights is zero in double, or leaves its range"
                                                : "terms of theirs leave the range of double";
  if (s.missing > 0) {
    const std::string_view reason = !kind.missing_because.empty() ? kind.missing_because
                                    : cage.allows_invalid_quads() && kind.keeps_quads
                                        ? "the cage's quads are not valid there"
                                        : lost;
    lines.push_back(fmt::format("warning: {} of {} points have no {} coordinates (nan): {}", s.missing, s.points,
                                kind.name, reason));
  }
  if (s.infinite > 0)
    lines.push_back(fmt::format("warning: {} of {} points have infinite {} coordinates: {}", s.infinite, s.points,
                                kind.name, lost));
  const auto tell_derivatives = [&](const validation::Counted& counted, std::string_view what, std::string_view why) {
    if (counted.points > 0)
      lines.push_back(
          fmt::format("warning: {} of {} points have {} derivatives of {} coordinates, the first is point {}: {}",
                      counted.points, s.points, what, kind.name, counted.first, why));
  };
  tell_derivatives(s.derivatives_on, "no finite", "on the cage they have no limit, or leave the range of double");
  tell_derivatives(s.derivatives_missing, "no",
                   !kind.missing_because.empty() ? kind.missing_because : "terms of theirs leave the range of double");
  tell_derivatives(s.derivatives_infinite, "infinite", "they leave the range of double");
  return lines;
}

}  // namespace cageproof::cli
