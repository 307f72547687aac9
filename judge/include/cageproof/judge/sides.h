// SPDX-License-Identifier: MIT
// Foreign code that says on which side of a cage points lie, judged.
#pragma once

#include "cageproof/judge/element_campaign.h"

#include <string_view>
#include <vector>

namespace cageproof::judge {

/// The name that stands for a kind of coordinates where code is asked for sides.
inline constexpr std::string_view kSides = "inside";

/// Asks on which side points lie, for one number each, 1 inside, 0 on the cage, -1 outside. Points are anywhere, next
/// to faces, edges and vertices on either side, exactly on them, far away, in other units of length, and far from the
/// origin, also of cages whose faces no axis is parallel to. The truth is exact.
/// \param dimension 3, triangles in space, or 2, segments in the plane
/// \param options regimes as side_regimes() names them; `single` and `ours` do not matter
SubjectCampaign run_side_campaign(ForeignCode& code, const ElementCampaignOptions& options, int dimension = 3);

/// "generic", "near-face", "near-edge", "near-vertex", "on-face", "on-edge", "on-vertex", "far", "units", "offset"; in
/// the plane without faces.
std::vector<std::string_view> side_regimes(int dimension = 3);

}  // namespace cageproof::judge
