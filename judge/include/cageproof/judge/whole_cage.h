// SPDX-License-Identifier: MIT
// Implementations that only give coordinates of whole cages, judged.
#pragma once

#include "cageproof/judge/cage_convention.h"
#include "cageproof/judge/element_campaign.h"
#include "cageproof/judge/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

/// One defect of whole cages, with a question that shows it.
struct CageFinding {
  const Defect* defect = nullptr;
  CageRequest question;              ///< one point
  std::vector<double> ours, theirs;  ///< coordinates of that point, in our convention
  std::size_t cases = 0;
  std::string evidence;
};

struct CageVerdict {
  std::optional<CageConvention> convention;  ///< nothing where none fits; judged as ours then
  std::vector<CageFinding> findings;         ///< none: clean
  std::size_t points = 0;                    ///< that were compared with the truth
};

/// \param dimension of the cages: 3, triangles in space, or 2, segments in the plane
/// \throws InputError for a kind that is unknown, or is not a sum over triangles or segments with numbers for
/// coordinates
void require_judged_kind(std::string_view kind, int dimension = 3);

/// Asks on tetrahedra and an octahedron, in the plane on triangles and an arrowhead, at points inside and, of
/// `mean_value`, on them, in two units of length. Finds the convention first, and judges in it. Numbers inside that are
/// not finite in any unit are left to run_cage_campaign().
/// \param kind "mean_value", "green" or another that require_judged_kind takes \throws InputError as it
CageVerdict judge_whole_cage(const WholeCageFunction& theirs, std::string_view kind, int dimension = 3);

/// The question as foreign code gets it. The number of coordinates is left zero.
Asked asked_of(const CageRequest& question);

/// Foreign code as such a function. \param kind must outlive it
WholeCageFunction whole_cage_function(ForeignCode& code, std::string_view kind);

/// Errors at points inside embedded cages, next to their faces, edges and vertices, exactly on them, in other units of
/// length, and far from the origin; and times. The truth is the kind by `closed_form` in 50 digits. Errors are relative
/// to the largest coordinate of the block: of all vertices, or of all faces.
/// \param kind, dimension as for judge_whole_cage \param name of the code in the times
/// \param convention of the code's numbers, which is undone before they are measured
/// \param options regimes as cage_regimes() names them; `single` and `ours` do not matter
SubjectCampaign run_cage_campaign(ForeignCode& code, std::string_view kind, const std::string& name,
                                  const ElementCampaignOptions& options,
                                  const std::optional<CageConvention>& convention = std::nullopt, int dimension = 3);

/// "inside", "near-face", "near-edge", "near-vertex", "on-face", "on-edge", "on-vertex", "units", "offset". In the
/// plane edges are the segments, and there are no faces.
std::vector<std::string_view> cage_regimes(int dimension = 3);

}  // namespace cageproof::judge
