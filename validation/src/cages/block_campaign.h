// SPDX-License-Identifier: MIT
// The check cage_block_error: evaluations of whole coordinates against the truth, in every regime of a cage.
#pragma once

#include "block_error.h"
#include "cage_regimes.h"
#include "cageproof/validation/measurement.h"
#include "cageproof/validation/question.h"

namespace cageproof::validation {

/// The check's name in row keys.
inline constexpr const char* block_error_check = "cage_block_error";

struct BlockCampaignOptions {
  std::string evaluation;  ///< of whole coordinates
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 150;  ///< of a cage, at most
  /// Approximate limit of the cost of the truths of a kind on a cage; up to six times that on cages of a few elements.
  /// At least four points are taken.
  int milliseconds = 3000;
};

/// Number of a cage's points at which a kind is asked.
int block_points(const CoordinateKind& kind, const Cage& cage, const BlockCampaignOptions& options);

/// A sample of a cage.
struct BlockAt {
  CageSample sample;

  std::uint64_t number() const { return sample.index; }
  /// Its point and its frame.
  WorstCase case_of(const Finding& finding, int order) const;
};

/// The highest order of the coordinates for which the table promises a block error. Higher ones are not asked, because
/// their truths cost several times as much. The highest that exists where the table promises none.
int block_order(const CoordinateKind& kind, const CageCoordinates& coordinates);

/// Errors of an evaluation at a sample, up to block_order: alone and in a block of points, the worse. Coordinates of
/// the cage's own frame are prepared once.
class BlockErrors {
 public:
  /// \throws InputError as CageCoordinates
  BlockErrors(const Cage& cage, const CoordinateKind& kind, std::string evaluation, Triangulation rule);
  const CageCoordinates& coordinates() const { return coordinates_; }
  /// The question at a place. \param place as CageSample::place; valid while this object lives
  Question<BlockAt> question(std::string_view place) const;

 private:
  std::array<Finding, 3> at(const CageSample& sample) const;
  Cage cage_;
  const CoordinateKind& kind_;
  std::string evaluation_;
  Triangulation rule_;
  CageCoordinates coordinates_;
  BlockTruths truths_;
  int order_;
};

/// The kind's rows on the cage, one per place and order. \pre the evaluation computes the kind in the cage
std::unique_ptr<const Measurement> block_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                     const BlockCampaignOptions& options);

/// The sample that a worst case was made of.
CageSample block_sample(const WorstCase& worst);

}  // namespace cageproof::validation
