// SPDX-License-Identifier: MIT
#include "cageproof/core/error_measure.h"

#include "cageproof/core/run_result.h"

#include <algorithm>
#include <cmath>

namespace cageproof {

void ErrorHistogram::add(double error) {
  if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  ++count_;
  max_ = std::max(max_, error);
  if (std::isinf(error)) {
    ++nonfinite_;
    ++counts_.back();
    return;
  }
  const double position = (std::log10(error) - lowest_decade) * bins_per_decade;
  if (!(position >= 0)) ++counts_.front();
  else if (position >= bin_count) ++counts_.back();
  else ++counts_[static_cast<std::size_t>(position) + 1];
}

void ErrorHistogram::merge(const ErrorHistogram& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  count_ += other.count_;
  nonfinite_ += other.nonfinite_;
  max_ = std::max(max_, other.max_);
}

double ErrorHistogram::quantile(double q) const {
  if (count_ == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
    seen += counts_[i];
    if (seen >= wanted)
      return std::min(max_, std::pow(10.0, lowest_decade + static_cast<double>(i) / bins_per_decade));
  }
  return max_;
}

namespace {

bool worse(double error_a, std::uint64_t sample_a, double error_b, std::uint64_t sample_b) {
  return error_a != error_b ? error_a > error_b : sample_a < sample_b;
}

}  // namespace

bool WorstCases::wants(double error, std::uint64_t sample) const {
  return cases_.size() < capacity_ ||
         (!cases_.empty() && worse(error, sample, cases_.back().error, cases_.back().sample));
}

void WorstCases::add(WorstCase worst_case) {
  if (!wants(worst_case.error, worst_case.sample)) return;
  const auto place = std::ranges::find_if(
      cases_, [&](const WorstCase& c) { return worse(worst_case.error, worst_case.sample, c.error, c.sample); });
  cases_.insert(place, std::move(worst_case));
  if (cases_.size() > capacity_) cases_.pop_back();
}

void WorstCases::merge(const WorstCases& other) {
  for (const WorstCase& c : other.cases_) add(c);
}

std::string_view name_of(Verdict verdict) {
  return verdict == Verdict::Kept ? "kept" : verdict == Verdict::Broken ? "BROKEN" : "not promised";
}

bool RunResult::all_kept() const {
  return std::ranges::none_of(rows, [](const ResultRow& row) { return row.verdict == Verdict::Broken; });
}

}  // namespace cageproof
