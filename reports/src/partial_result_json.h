// SPDX-License-Identifier: MIT
// Partial results as JSON: doubles survive exactly, and numbers that JSON lacks are strings.
#pragma once

#include "cageproof/core/results/partial_result.h"
#include "json_value.h"

namespace cageproof::reports {

/// Members "rows", "fields", "meshes", "errata", "refused", each an array, left out when empty.
Json partial_result_json(const PartialResult& gathered);

/// One row, as in "rows".
Json row_json(const RowKey& key, const Tally& tally);

/// The inverse; other members are ignored. \throws std::invalid_argument or Json::exception for an object without these
/// members
PartialResult partial_result_of(const Json& json);

}  // namespace cageproof::reports
