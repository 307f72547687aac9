// SPDX-License-Identifier: MIT
#include "defects/desk.h"

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

constexpr std::size_t kGuard = 16;
constexpr std::size_t kLargestBlock = 64;
constexpr double kUntouched = 7.25e77;

// Room for the numbers of one order, with guards on both sides.
class Guarded {
 public:
  Guarded(std::size_t count, double filled) : numbers_(count + 2 * kGuard, kUntouched) {
    std::fill_n(data(), count, filled);
  }
  double* data() { return numbers_.data() + kGuard; }
  std::size_t size() const { return numbers_.size() - 2 * kGuard; }
  bool intact() const {
    const auto untouched = [](double x) { return x == kUntouched; };
    return std::all_of(numbers_.begin(), numbers_.begin() + kGuard, untouched) &&
           std::all_of(numbers_.end() - kGuard, numbers_.end(), untouched);
  }

 private:
  std::vector<double> numbers_;
};

// Puts `content` at the front of a buffer that never moves, and `beyond` behind it.
template <class T>
std::span<const T> placed(std::vector<T>& buffer, const std::vector<T>& content, const T& beyond) {
  buffer.resize(kLargestBlock + kGuard);
  std::ranges::copy(content, buffer.begin());
  std::fill(buffer.begin() + static_cast<std::ptrdiff_t>(content.size()), buffer.end(), beyond);
  return {buffer.data(), content.size()};
}

}  // namespace

std::vector<double> Desk::ask(const Block& block, double output, double beyond) {
  const Formula& formula = theirs_->formula();
  const auto components = static_cast<std::size_t>(formula.components()), dim = static_cast<std::size_t>(formula.dim());
  const std::size_t count = block.points.size();
  Guarded values(count * components, output), gradients(order_ > 0 ? count * components * dim : 0, output);
  const Vec3<double> behind = Vec3<double>::Constant(beyond);
  const Batch<double> batch{placed(corners_, block.corners, behind), placed(points_, block.points, behind), order_,
                            placed(parameters_, block.parameters, beyond)};
  std::vector<Statement> statements(count);
  const BatchOutput<double> to{.tensors = {values.data(), gradients.data(), nullptr},
                               .stride = {components, components * dim, 0},
                               .entries = static_cast<std::size_t>(formula.shape.entries()),
                               .dim = formula.dim(),
                               .statements = statements.data()};
  (*theirs_)(batch, to);
  wrote_past_ = !values.intact() || !gradients.intact();
  std::vector<double> numbers(values.data(), values.data() + values.size());
  numbers.insert(numbers.end(), gradients.data(), gradients.data() + gradients.size());
  return numbers;
}

bool same(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  double largest = 0;
  for (const double x : a)
    if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
    if (!(std::abs(a[i] - b[i]) <= tolerance * largest)) return false;
  }
  return a.size() == b.size();
}

}  // namespace cageproof::judge
