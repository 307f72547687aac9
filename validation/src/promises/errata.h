// SPDX-License-Identifier: MIT
// The errata of the papers, measured.
#pragma once

#include "cageproof/validation/measurement.h"

namespace cageproof::validation {

struct ErrataOptions {
  std::string formulas = "*";  ///< glob: misprints of other formulas are left out, those of no formula stay
  std::uint64_t seed = 1;
  int samples = 24;  ///< an erratum and formula
  int jobs = 0;      ///< threads; 0: all cores
};

/// The work of measure_errata as a measurement.
std::unique_ptr<const Measurement> errata_measurement(const ErrataOptions& options);

/// Every known erratum, in the order of the papers: once for each formula and order it changes, with the largest
/// relative errors of print and correction in 50 digits against the truth, or once without figures where it changes no
/// formula.
std::vector<ErratumRow> measure_errata(const ErrataOptions& options);

}  // namespace cageproof::validation
