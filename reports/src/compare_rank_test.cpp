// SPDX-License-Identifier: MIT
#include "compare_rank_test.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace cageproof::reports {
namespace {

// The share of all ways to interleave m and n values that have U at most `u`. Counts follow the recurrence on which
// sample the largest value belongs to; the row for n values of the second sample is built from the one for n - 1.
double share_up_to(std::size_t m, std::size_t n, std::size_t u) {
  const std::size_t most = m * n;
  std::vector<std::vector<double>> counts(m + 1, std::vector<double>(most + 1, 0.));
  for (auto& count : counts) count[0] = 1;  // of no value in the second sample
  for (std::size_t j = 1; j <= n; ++j) {
    std::vector<std::vector<double>> next(m + 1, std::vector<double>(most + 1, 0.));
    next[0][0] = 1;
    for (std::size_t i = 1; i <= m; ++i)
      for (std::size_t v = 0; v <= most; ++v) next[i][v] = (v >= j ? next[i - 1][v - j] : 0) + counts[i][v];
    counts = std::move(next);
  }
  const auto& last = counts[m];
  return std::accumulate(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(std::min(u, most)) + 1, 0.) /
         std::accumulate(last.begin(), last.end(), 0.);
}

}  // namespace

double rank_test(const std::vector<double>& a, const std::vector<double>& b) {
  double u = 0;
  for (const double x : a)
    for (const double y : b) u += x > y ? 1 : x == y ? 0.5 : 0;
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  std::ranges::sort(all);
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size()), total = m + n;
  double ties = 0;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::upper_bound(first, all.end(), *first);
    const double equal = static_cast<double>(last - first);
    ties += equal * equal * equal - equal;
    first = last;
  }
  const double least = std::min(u, m * n - u);
  if (ties == 0 && std::max(a.size(), b.size()) <= 20)
    return std::min(1., 2 * share_up_to(a.size(), b.size(), static_cast<std::size_t>(least)));
  const double variance = m * n / 12 * (total + 1 - ties / (total * (total - 1)));
  if (variance <= 0) return 1;
  const double z = std::max(0., m * n / 2 - least - 0.5) / std::sqrt(variance);
  return std::erfc(z / std::sqrt(2.));
}

double least_rank_p(std::size_t a, std::size_t b) {
  double ways = 1;
  for (std::size_t i = 1; i <= a; ++i) ways *= static_cast<double>(b + i) / static_cast<double>(i);
  return std::min(1., 2 / ways);
}

}  // namespace cageproof::reports
