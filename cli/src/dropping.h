// SPDX-License-Identifier: MIT
// The options of `coordinates` that drop small weights, and the remarks on them.
#pragma once

#include "command_line.h"
#include "sparse_file.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cageproof::cli {

/// The options. Lengths are shares of the cage's size, the diagonal of its bounding box.
struct Dropping {
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< of --drop; NaN: everything is written
  double budget = 1;                                            ///< of --budget: how far a pose may move vertices
  std::string store = "double";                                 ///< of --store

  bool is_asked() const { return !std::isnan(tolerance); }
};

/// Adds --drop, --budget and --store. \param data the option --data, which writes no weights
void add_dropping(Command& command, Dropping& dropping, const Option& data);

/// Refuses options that fit no sparse file. \throws InputError saying which would
void check_dropping(const Dropping& dropping, const std::string& out, int order);

/// \param size the cage's \throws InputError for kinds without bounds on weights, naming those that have bounds
deformation::SparseWeights weights_of(const Dropping& dropping, const CageCoordinates& coordinates, double size);

/// \throws InputError where rounding weights moves points by more than the tolerance
void require_within(const Dropping& dropping, const SparseTotals& totals, double size);

/// For the file's description: `sparse`, with the bound.
nlohmann::ordered_json json_of(const Dropping& dropping, const SparseTotals& totals, double size);

/// Lines that say how many weights were kept, and the bound. \param bytes of the file \param columns numbers of a row
std::vector<std::string> lines_of(const Dropping& dropping, const SparseTotals& totals, double size, std::size_t bytes,
                                  std::size_t columns);

}  // namespace cageproof::cli
