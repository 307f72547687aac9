// SPDX-License-Identifier: MIT
#include "cageproof/core/results/error_measure.h"

#include "cageproof/core/results/run_result.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cageproof {

void ErrorHistogram::add(double error) {
  if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  ++count_;
  max_ = std::max(max_, error);
  if (std::isinf(error)) {
    ++nonfinite_;
    return add_to(bin_count + 1, 1);
  }
  const double position = (std::log10(error) - lowest_decade) * bins_per_decade;
  if (!(position >= 0)) add_to(0, 1);
  else if (position >= bin_count) add_to(bin_count + 1, 1);
  else add_to(static_cast<std::size_t>(position) + 1, 1);
}

void ErrorHistogram::add_to(std::size_t place, std::uint64_t count) {
  const auto at = std::ranges::lower_bound(filled_, place, {}, &std::pair<std::size_t, std::uint64_t>::first);
  if (at != filled_.end() && at->first == place) at->second += count;
  else filled_.insert(at, {place, count});
}

std::array<std::uint64_t, ErrorHistogram::bin_count + 2> ErrorHistogram::counts() const {
  std::array<std::uint64_t, bin_count + 2> counts{};
  for (const auto& [place, count] : filled_) counts[place] = count;
  return counts;
}

void ErrorHistogram::merge(const ErrorHistogram& other) {
  for (const auto& [place, count] : other.filled_) add_to(place, count);
  count_ += other.count_;
  nonfinite_ += other.nonfinite_;
  max_ = std::max(max_, other.max_);
}

double ErrorHistogram::quantile(double q) const {
  if (count_ == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (const auto& [place, count] : filled_) {
    if (place > bin_count) break;
    seen += count;
    if (seen >= wanted)
      return std::min(max_, std::pow(10.0, lowest_decade + static_cast<double>(place) / bins_per_decade));
  }
  return max_;
}

ErrorHistogram ErrorHistogram::restored(const std::array<std::uint64_t, bin_count + 2>& counts, std::uint64_t nonfinite,
                                        double max) {
  ErrorHistogram histogram;
  for (std::size_t place = 0; place < counts.size(); ++place)
    if (counts[place] > 0) histogram.filled_.emplace_back(place, counts[place]);
  histogram.count_ = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  histogram.nonfinite_ = nonfinite;
  histogram.max_ = max;
  if (!(max >= 0) || nonfinite > counts.back() || std::isinf(max) != (nonfinite > 0) ||
      (histogram.count_ == 0 && max > 0))
    throw std::invalid_argument("no histogram has these counts");
  return histogram;
}

std::vector<std::uint64_t> input_bits(const WorstCase& c) {
  std::vector<std::uint64_t> bits{static_cast<std::uint64_t>(c.asked)};
  const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const Vec3<double>& corner : c.corners) std::ranges::for_each(corner, add);
  std::ranges::for_each(c.point, add);
  std::ranges::for_each(c.parameters, add);
  add(c.frame.unit);
  std::ranges::for_each(c.frame.shift, add);
  return bits;
}

namespace {

bool worse(double error_a, std::uint64_t sample_a, double error_b, std::uint64_t sample_b) {
  return error_a != error_b ? error_a > error_b : sample_a < sample_b;
}

bool worse(const WorstCase& a, const WorstCase& b) {
  if (a.error != b.error || a.sample != b.sample) return worse(a.error, a.sample, b.error, b.sample);
  if (a.parameter != b.parameter) return a.parameter < b.parameter;
  return input_bits(a) < input_bits(b);
}

}  // namespace

bool WorstCases::wants(double error, std::uint64_t sample) const {
  return cases_.size() < capacity_ ||
         (!cases_.empty() && !worse(cases_.back().error, cases_.back().sample, error, sample));
}

void WorstCases::add(WorstCase worst_case) {
  if (!wants(worst_case.error, worst_case.sample)) return;
  const auto place = std::ranges::find_if(cases_, [&](const WorstCase& c) { return worse(worst_case, c); });
  cases_.insert(place, std::move(worst_case));
  if (cases_.size() > capacity_) cases_.pop_back();
}

void WorstCases::merge(const WorstCases& other) {
  for (const WorstCase& c : other.cases_) add(c);
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Kept: return "kept";
    case Verdict::Broken: return "BROKEN";
    case Verdict::Undecided: return "undecided";
    case Verdict::NotPromised: break;
  }
  return "not promised";
}

bool RunResult::all_kept() const {
  return std::ranges::none_of(rows, [](const ResultRow& row) { return row.verdict == Verdict::Broken; });
}

}  // namespace cageproof
