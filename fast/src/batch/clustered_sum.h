// SPDX-License-Identifier: MIT
// Sums of harmonic layers with data, clusters of far faces at a time, to a stated error.
#pragma once

#include "cluster_tree.h"

#include "cageproof/core/coordinates/prepared_coordinates.h"

#include <memory>

namespace cageproof::closed_form::batch {

/// A sum of far faces by clusters where that is quicker for that many points, else face by face.
/// \param tree made if it is needed; the tree must outlive the sum, and so must `exact`, which sums face by face
/// \param data three sets: of vertices and of faces \param error in the data's unit of length
std::unique_ptr<const StatedSum> clustered_sum(const Lazy<std::shared_ptr<const ClusterTree>>& tree, int faces,
                                               const AppliesData& exact, const CageData& data, double error,
                                               std::size_t points);

}  // namespace cageproof::closed_form::batch
