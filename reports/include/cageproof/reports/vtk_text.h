// SPDX-License-Identifier: MIT
// Fields as VTK XML, compressed; array names carry units: "relative error [1]". Facts are field data, a text each.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>

namespace cageproof::reports {

/// Arrays of a file. WithLogarithms adds for every array that is not linear and has one component `log10 NAME`, in
/// single precision and floored, and `mask NAME`: 1 where the value is finite, 0 where there is no value (NaN in both),
/// 2 where it is not finite.
enum class FieldArrays { Alone, WithLogarithms };

/// Errors below 1e-17 count as none, because relative to a double nothing is finer.
inline constexpr double kLog10Floor = -17;
/// The values of masks.
inline constexpr unsigned char kNoValue = 0, kHasValue = 1, kNotFinite = 2;

/// log10 of the magnitude, at least kLog10Floor; NaN stays NaN, and infinity takes the largest double's, so that
/// programs find a range.
double floored_log10(double value);
std::string log10_name(const std::string& array);
std::string mask_name(const std::string& array);

/// A cage as geometry: its faces as polygons, and each of its edges once, as segments. Faces of two corners are edges.
MeshField geometry_of(MeshField cage);

/// The text of a .vti file. \pre every array has points x components values
std::string vti_text(const ImageField& field, FieldArrays arrays = FieldArrays::Alone);

/// The text of a .vtp file: polygons and polylines, or vertex cells when there are neither. \pre as vti_text; indices
/// in range
std::string vtp_text(const MeshField& field, FieldArrays arrays = FieldArrays::Alone);

}  // namespace cageproof::reports
