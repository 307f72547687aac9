// SPDX-License-Identifier: MIT
#include "cageproof/judge/sides.h"

#include "certificate/rows.h"
#include "whole_cage/cage_places.h"

#include "cageproof/core/catalogue/name_pattern.h"

#include <fmt/format.h>

namespace cageproof::judge {
namespace {

std::vector<CagePlaces> places_of_sides(std::string_view regime, int dimension) {
  // Cages whose corners are multiples of a power of two, so that doubles lie on them exactly, sheared or not.
  using List = std::vector<std::string_view>;
  const bool is_on = regime.starts_with("on-");
  const List names = dimension == 2 ? List{"square", "l-shape", "comb", "frame"} : List{"cube", "l-block", "thin-box"};
  std::vector<CagePlaces> places;
  if (regime == "units") {
    for (const double unit : {0x1p-30, 0x1p30, 0x1p-10, 0x1p10})
      places.emplace_back(names[1], Placing{.unit = unit, .is_sheared = true});
  } else if (regime == "offset") {
    for (const double far : {1e2, 1e4})
      places.emplace_back(names[1], Placing{.offset = Vec3<double>(far, -far, far), .is_sheared = true});
  } else {
    for (const std::string_view name : names)
      for (const bool is_sheared : {false, true}) places.emplace_back(name, Placing{.is_sheared = is_sheared});
    if (!is_on)
      for (const std::string_view name : dimension == 2 ? List{"star", "figure"} : List{"icosphere", "spiky-box"})
        places.emplace_back(name, Placing{});
  }
  return places;
}

std::string_view name_of_side(double side) { return side > 0 ? "inside" : side < 0 ? "outside" : "on"; }

}  // namespace

std::vector<std::string_view> side_regimes(int dimension) {
  std::vector<std::string_view> all{"generic", "near-face", "near-edge", "near-vertex", "on-face",
                                    "on-edge", "on-vertex", "far",       "units",       "offset"};
  if (dimension == 2) std::erase_if(all, [](std::string_view regime) { return regime.ends_with("-face"); });
  return all;
}

SubjectCampaign run_side_campaign(ForeignCode& code, const ElementCampaignOptions& options, int dimension) {
  SubjectCampaign campaign{std::string(kSides), true, 0, {}, {}, dimension, true};
  const Request request{.kind = kSides};
  for (const std::string_view regime : side_regimes(dimension)) {
    if (!matches(options.regimes, regime)) continue;
    const std::vector<CagePlaces> places = places_of_sides(regime, dimension);
    std::vector<Asked> asked;
    std::vector<int> truths;
    for (int i = 0; i < options.samples; ++i) {
      const CagePlaces& place = places[static_cast<std::size_t>(i) % places.size()];
      CageRequest question = place.question();
      question.points = {place.point_on_any_side(regime, options.seed, static_cast<std::uint64_t>(i))};
      truths.push_back(place.side_of(question.points[0]));
      asked.push_back(asked_of(question));
      asked.back().coordinates = 1;
    }
    const std::vector<Answer> answers = code.ask(request, asked);
    std::vector<Measured> measured(asked.size());
    std::string wrong;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (answers[i].status != Answer::Status::Given) {
        measured[i].status =
            answers[i].status == Answer::Status::Declined ? Measured::Status::Declined : Measured::Status::Failed;
        continue;
      }
      const double side = answers[i].tensors[0][0];
      const bool is_right = side == truths[i];
      measured[i].status = Measured::Status::Error;
      measured[i].absolute = is_right ? 0 : 1;
      measured[i].relative = measured[i].absolute;
      if (is_right || !wrong.empty()) continue;
      const bool is_side = side == 1 || side == 0 || side == -1;
      wrong = fmt::format("{}, and yours says {}", name_of_side(truths[i]),
                          is_side ? std::string(name_of_side(side)) : fmt::format("{}, which is no side", side));
    }
    CampaignRow row =
        row_of(std::string(regime), 0, measured, [&](std::size_t i) { return exact_line(request, asked[i], 0); });
    for (const Measured& one : measured) row.wrong += one.status == Measured::Status::Error && one.absolute > 0;
    row.first_wrong = wrong;
    campaign.rows.push_back(std::move(row));
  }
  return campaign;
}

}  // namespace cageproof::judge
