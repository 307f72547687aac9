// SPDX-License-Identifier: MIT
// Rows of a certificate, from the errors of single samples.
#pragma once

#include "cageproof/judge/element_campaign.h"

#include <functional>
#include <span>

namespace cageproof::judge {

/// Stands for an error that a sample does not have.
inline constexpr double no_error = -1;

/// Errors of one sample at one order.
struct Measured {
  enum class Status { Error, NoTruth, Declined, Failed } status = Status::NoTruth;
  double relative = no_error, conditioned = no_error, absolute = no_error;
  double beside = no_error, on = no_error;  ///< conditioned, off the element and on it
  double continuous = no_error;             ///< conditioned, on a cage, of blocks that do not jump across it
  bool is_finite = true;
};

/// The row of a regime. \param line the line of `eval` that asks for a sample
CampaignRow row_of(std::string regime, int order, std::span<const Measured> measured,
                   const std::function<std::string(std::size_t)>& line);

}  // namespace cageproof::judge
