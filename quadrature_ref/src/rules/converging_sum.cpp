// SPDX-License-Identifier: MIT
#include "converging_sum.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

// Orders whose extrapolations agree to fewer digits than this have no limit; with a logarithm they differ by a tenth.
constexpr double kLimitDigits = 20;

// Digits by which a norm must exceed the error that a rule was asked for. A rule's true error can be a thousand times
// larger where few digits were asked for, and would pass for the norm.
constexpr double kSeen = 4;

// The most work of all sums for a query, in nodes times entries of the tensors: about a second, several with costly
// kernels. A node itself costs as much as kEntriesOfNode entries.
constexpr double kMostWork = 2e7, kEntriesOfNode = 10;

// Combines tensors at distances h, 2h, 4h into one fewer, without the term h^power. A term h^power log h becomes one in
// h^power, which a second call cancels.
void cancel(int power, int order, std::vector<Result<Mp200>>& at) {
  const Mp200 factor = std::ldexp(1.0, power), denominator = factor - 1;
  for (std::size_t j = 0; j + 1 < at.size(); ++j)
    for (int o = 0; o <= order; ++o)
      for (std::size_t i = 0; i < at[j].of(o).size(); ++i)
        at[j].of(o)[i] = (at[j].of(o)[i] * factor - at[j + 1].of(o)[i]) / denominator;
  at.pop_back();
}

void decline(Answer& answer, int order) {
  std::ranges::fill(answer.sums.of(order), std::numeric_limits<Mp200>::quiet_NaN());
  answer.digits[order] = 0;
}

}  // namespace

double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most) {
  Mp200 square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  if (square == 0) return most;
  if (isnan(square)) return 0;
  return std::min(most, log10_norm(b) - log10_magnitude(square) / 2);
}

Answer converge(ConvergingSum& sum, double digits, int order) {
  Answer answer;
  const double most = digits + 8;
  // A sum has some digits more than it was asked for, up to three, since its rules' bounds are bounds: asked for one
  // more than is wanted, the first all but always has them. The second is two digits better, so that the difference is
  // the first one's error. Each digit more would take six in a hundred more points.
  double aim = digits + 1;
  Result<Mp200> rough = sum.at(aim);
  for (int attempt = 0; attempt < 4; ++attempt) {
    aim += 2;
    answer.aim = aim;
    answer.sums = sum.at(aim);
    double least = most;
    for (int o = 0; o <= order; ++o) {
      if (sum.declines(o)) continue;
      answer.digits[o] = agreement(rough.of(o), answer.sums.of(o), most);
      least = std::min(least, answer.digits[o]);
    }
    if (least >= digits) break;
    aim += std::max(0.0, digits - least);
    rough = std::move(answer.sums);
    answer.sums = rough;
  }
  for (int o = 0; o <= order; ++o)
    if (sum.declines(o)) decline(answer, o);
  answer.sums.nodes = sum.nodes();
  return answer;
}

Answer limit_from_inside(const Inside& inside, double digits, int order) {
  // The distance h. The first term left has the factor h^3, which is fifteen digits below those wanted, because a limit
  // may be that much smaller than the coefficients.
  constexpr double kMargin = 15;
  const int times = inside.border ? 2 : 1;
  Mp200 inward = inside.clearance * pow(Mp200(10), Mp200(-(digits + kMargin) / 3));
  const auto nearest = inside.moved(inward);
  Answer answer = converge(*nearest, digits, order);
  std::array<bool, 3> declined{};
  for (int o = 0; o <= order; ++o) declined[o] = nearest->declines(o);
  std::vector<Result<Mp200>> at{answer.sums};
  for (int i = 0; i < 3 * times; ++i) {
    inward *= 2;
    const auto sum = inside.moved(inward);
    sum->take_log10_norms(nearest->log10_norms());
    at.push_back(sum->at(answer.aim));
    answer.sums.nodes += sum->nodes();
    for (int o = 0; o <= order; ++o) declined[o] = declined[o] || sum->declines(o);
  }
  for (const int power : {1, 2})
    for (int i = 0; i < times; ++i) cancel(power, order, at);
  const Result<Mp200> rough = at.front();
  for (int i = 0; i < times; ++i) cancel(3, order, at);
  for (int o = 0; o <= order; ++o) {
    if (declined[o]) {
      decline(answer, o);
      continue;
    }
    auto& tensor = answer.sums.of(o);
    tensor = at.front().of(o);
    const double tiny = inside.log10_natural[o] - digits - 4;
    if (log10_norm(rough.of(o)) < tiny && log10_norm(tensor) < tiny) {
      std::ranges::fill(tensor, Mp200(0));
      answer.digits[o] = digits + 8;
      continue;
    }
    // One digit fewer than the extrapolations share: the last pass only halves the error of another kind of series.
    const double limit = agreement(rough.of(o), tensor, digits + 9) - 1;
    answer.digits[o] = std::min(answer.digits[o], limit);
    if (limit >= kLimitDigits) continue;
    std::ranges::fill(tensor, std::numeric_limits<Mp200>::quiet_NaN());
    answer.digits[o] = std::numeric_limits<double>::quiet_NaN();
  }
  return answer;
}

void ConvergingSum::find_log10_norms(const std::array<double, 3>& log10_mass, const SumWithError& with_error) {
  if (norms_are_known_) return;
  norms_are_known_ = true;
  // Asks for more and more digits relative to the mass, until every order has a norm above its error.
  std::array<double, 3> error;
  std::array<bool, 3> known{};
  for (const double digits : {10.0, 42.0, 92.0, 180.0}) {
    for (int o = 0; o <= order_; ++o) error[o] = known[o] ? log10_norms_[o] - 1 : log10_mass[o] - digits;
    const Result<Mp200> sums = with_error(error);
    bool all_known = true;
    for (int o = 0; o <= order_; ++o) {
      if (known[o]) continue;
      if (!declines(o)) log10_norms_[o] = std::max(log10_norm(sums.of(o)), error[o]);
      known[o] = declines(o) || log10_mass[o] == kNoMass || log10_norms_[o] > error[o] + kSeen;
      all_known = all_known && known[o];
    }
    if (all_known) return;
  }
  for (int o = 0; o <= order_; ++o)
    if (!known[o]) log10_norms_[o] = kDeclined;
}

bool ConvergingSum::too_much(double nodes) {
  const Result<Mp200> sizes = empty();
  double entries = kEntriesOfNode;
  int highest = -1;
  for (int o = 0; o <= order_; ++o) {
    if (declines(o)) continue;
    highest = o;
    entries += static_cast<double>(sizes.of(o).size());
  }
  if (highest < 0 || (static_cast<double>(nodes_) + nodes) * entries <= kMostWork) return false;
  log10_norms_[highest] = kDeclined;
  return true;
}

}  // namespace cageproof::quadrature_ref
