// SPDX-License-Identifier: MIT
// Error against a regime's parameter: value, gradient and Hessian side by side, one curve per evaluation and scalar.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "gnuplot.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// The picture of one formula (or kind) in one regime.
struct CurvePicture {
  std::string subject, regime, check;
  std::string parameter_name;
  Picture picture;
};

/// One picture a (subject, regime, check) that has curves with positive parameters, in the order of the curves.
std::vector<CurvePicture> curve_pictures(const RunResult& result);

}  // namespace cageproof::reports
