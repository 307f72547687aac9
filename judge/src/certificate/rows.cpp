// SPDX-License-Identifier: MIT
#include "certificate/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::judge {
namespace {

using Line = std::function<std::string(std::size_t)>;

double median_of(std::vector<double> errors) {
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::ranges::nth_element(errors, middle);
  return *middle;
}

LargestError largest(std::span<const Measured> measured, double Measured::*member, const Line& line) {
  LargestError found{no_error, 0, ""};
  std::vector<double> errors;
  std::size_t at = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    double error = measured[i].*member;
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    if (error < 0) continue;
    errors.push_back(error);
    if (error <= found.error) continue;
    found.error = error;
    at = i;
  }
  if (errors.empty()) return {0, 0, ""};
  found.median = median_of(std::move(errors));
  found.input = line(at);
  return found;
}

}  // namespace

CampaignRow row_of(std::string regime, int order, std::span<const Measured> measured, const Line& line) {
  CampaignRow row;
  row.regime = std::move(regime);
  row.order = order;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const Measured& one = measured[i];
    row.samples += one.status == Measured::Status::Error;
    row.without_truth += one.status == Measured::Status::NoTruth;
    row.declined += one.status == Measured::Status::Declined;
    row.failed += one.status == Measured::Status::Failed;
    row.zero += one.status == Measured::Status::Error && one.relative < 0;
    if (one.is_finite) continue;
    if (row.nonfinite++ == 0) row.nonfinite_input = line(i);
  }
  row.relative = largest(measured, &Measured::relative, line);
  row.conditioned = largest(measured, &Measured::conditioned, line);
  row.beside = largest(measured, &Measured::beside, line);
  row.on = largest(measured, &Measured::on, line);
  row.continuous = largest(measured, &Measured::continuous, line);
  row.absolute = largest(measured, &Measured::absolute, line);
  return row;
}

}  // namespace cageproof::judge
