// SPDX-License-Identifier: MIT
#include "converging_sum.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
// Orders whose limits agree to fewer digits than that have none; logarithms differ by a tenth.
constexpr double kLimitDigits = 20;

}  // namespace

double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most) {
  Mp200 square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  if (square == 0) return most;
  return std::min(most, log10_norm(b) - log10_magnitude(square) / 2);
}

Answer converge(ConvergingSum& sum, double digits, int order) {
  Answer answer;
  const double most = digits + 8;
  double aim = digits + 2;
  Result<Mp200> rough = sum.at(aim);
  for (int attempt = 0; attempt < 4; ++attempt) {
    aim += 6;
    answer.sums = sum.at(aim);
    double least = most;
    for (int o = 0; o <= order; ++o) {
      answer.digits[o] = agreement(rough.of(o), answer.sums.of(o), most);
      least = std::min(least, answer.digits[o]);
    }
    if (least >= digits) break;
    aim += std::max(0.0, digits - least);
    rough = std::move(answer.sums);
    answer.sums = rough;
  }
  answer.sums.nodes = sum.nodes();
  return answer;
}

Answer limit_from_inside(const Inside& inside, double digits, int order) {
  const Answer near = converge(*inside.moved(inside.inward[0]), digits, order);
  Answer answer = converge(*inside.moved(inside.inward[1]), digits, order);
  for (int o = 0; o <= order; ++o) {
    auto& tensor = answer.sums.of(o);
    const double tiny = inside.log10_natural[o] - digits - 4;
    if (log10_norm(near.sums.of(o)) < tiny && log10_norm(tensor) < tiny) {
      std::ranges::fill(tensor, Mp200(0));
      answer.digits[o] = digits + 8;
      continue;
    }
    const double limit = agreement(near.sums.of(o), tensor, digits + 8);
    answer.digits[o] = std::min({answer.digits[o], near.digits[o], limit});
    if (limit >= kLimitDigits) continue;
    std::ranges::fill(tensor, std::numeric_limits<Mp200>::quiet_NaN());
    answer.digits[o] = std::numeric_limits<double>::quiet_NaN();
  }
  answer.sums.nodes += near.sums.nodes;
  return answer;
}

std::array<double, 3> ConvergingSum::norms(const std::array<double, 3>& mass, const SumWithError& with_error) const {
  // Rising digits relative to the mass until something is left of every order.
  std::array<double, 3> error, norm{};
  std::array<bool, 3> known{};
  for (const double digits : {10.0, 42.0, 92.0, 180.0}) {
    for (int o = 0; o <= order_; ++o) error[o] = known[o] ? norm[o] - 1 : mass[o] - digits;
    const Result<Mp200> sums = with_error(error);
    bool all_known = true;
    for (int o = 0; o <= order_; ++o) {
      if (known[o]) continue;
      norm[o] = std::max(log10_norm(sums.of(o)), error[o]);
      known[o] = mass[o] == kNone || norm[o] > error[o] + 2;
      all_known = all_known && known[o];
    }
    if (all_known) break;
  }
  return norm;
}

}  // namespace cageproof::quadrature_ref
