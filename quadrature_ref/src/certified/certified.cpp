// SPDX-License-Identifier: MIT
#include "certified.h"

#include "assemble.h"
#include "quad/enclose.h"
#include "segment/moments.h"

#include <algorithm>

namespace cageproof::quadrature_ref {
namespace {

using namespace certified;

constexpr int guard_bits = 64;  // of the working precision beyond the truncation error aimed at
constexpr int kBitsOfSegments = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Square root of the sum of squares of midpoints or of radii.
Real norm_of(const std::vector<Real>& tensor, bool radii) {
  const WorkingBits rough(64);
  Real sum;
  for (const Real& x : tensor) {
    Real part;
    if (radii) arb_get_rad_arb(part.raw(), x.raw());
    else arb_get_mid_arb(part.raw(), x.raw());
    sum += part * part;
  }
  return sqrt(sum);
}

// Returns how many bits of the tensor are proven: infinity for an exact one, minus infinity if it may be zero.
double bits_of(const std::vector<Real>& tensor) {
  if (!std::ranges::all_of(tensor, &Real::is_finite)) return -infinity;
  const Real radius = norm_of(tensor, true);
  if (radius.is_zero()) return infinity;
  const WorkingBits rough(64);
  const Real left = norm_of(tensor, false) - radius;
  if (!arb_is_positive(left.raw())) return -infinity;
  return -Real(radius / left).log2_size();
}

// Rounded up.
template <Scalar R>
R upwards(const arf_t x) {
  if constexpr (is_multiprecision<R>) {
    R y;
    arf_get_mpfr(y.data(), x, MPFR_RNDU);
    return y;
  } else {
    const double wide = arf_get_d(x, ARF_RND_CEIL);
    if constexpr (std::same_as<R, double>) return wide;
    else {
      const auto narrow = static_cast<float>(wide);
      return narrow < wide ? std::nextafter(narrow, std::numeric_limits<float>::infinity()) : narrow;
    }
  }
}

// The nearest R to the midpoint, and a radius about it that holds the ball.
template <Scalar R>
void round_to(const Real& ball, R& middle, R& radius) {
  using std::isfinite;
  if constexpr (is_multiprecision<R>) arf_get_mpfr(middle.data(), arb_midref(ball.raw()), MPFR_RNDN);
  else middle = static_cast<R>(ball.approximate());
  if (!ball.is_finite() || !isfinite(middle)) {
    middle = std::numeric_limits<R>::quiet_NaN();
    radius = std::numeric_limits<R>::infinity();
    return;
  }
  Real off;
  arb_sub(off.raw(), ball.raw(), Real::exactly(middle).raw(), ARF_PREC_EXACT);
  radius = upwards<R>(arb_midref(upper_bound(off).raw()));
}

// FLINT keeps caches for each thread, and leaves it to the thread to free them.
struct ThreadCaches {
  ~ThreadCaches() { flint_cleanup(); }
};

struct Attempt {
  std::array<std::vector<Real>, 3> tensors;  // empty: not enclosed
  double bits = infinity;                    // of the worst order that can be enclosed
  bool all_orders = true;
  std::size_t nodes = 0;
};

// Tensors of the orders that can be enclosed.
void assemble(const DifferentiatedKernel& kernel, const SeenElement& element, bool on_element, int order,
              const std::vector<Real>& parameters, Attempt& found) {
  for (int o = 0; o <= order; ++o) {
    if (on_element && !kernel.weakly_singular(o, parameters)) {
      found.all_orders = false;
      continue;
    }
    found.tensors[o] = kernel.tensor(o, element, parameters);
    found.bits = std::min(found.bits, bits_of(found.tensors[o]));
  }
}

template <Scalar R>
std::optional<Attempt> attempt(const DifferentiatedKernel& kernel, const Query<R>& query, int bits, double& work_left) {
  const WorkingBits working(bits);
  std::vector<Real> parameters;
  for (const R& p : query.parameters) parameters.push_back(Real::exactly(p));
  Attempt found;
  if (kernel.formula().element == ElementKind::Segment) {
    auto frame = segment_frame_of(query);
    if (!frame) return std::nullopt;
    const SegmentMoments moments(std::move(*frame));
    assemble(kernel, moments, moments.frame().on_segment, query.order, parameters, found);
    return found;
  }
  const auto frame = frame_of(query);
  if (!frame) return std::nullopt;
  const auto moments =
      integrate_moments(*frame, kernel.moments(query.order), bits - guard_bits, work_left, found.nodes);
  if (!moments) return std::nullopt;
  assemble(kernel, SeenTriangle(*frame, *moments), frame->on_triangle, query.order, parameters, found);
  return found;
}

template <Scalar R>
std::optional<Attempt> attempt_quad(const Formula& formula, const Query<R>& query, int bits, double& work_left) {
  const WorkingBits working(bits);
  auto enclosure = enclose_quad(formula.name, query, bits - guard_bits, work_left);
  if (!enclosure) return std::nullopt;
  Attempt found;
  found.nodes = enclosure->nodes;
  found.tensors = std::move(enclosure->tensors);
  for (int o = 0; o <= query.order; ++o) found.bits = std::min(found.bits, bits_of(found.tensors[o]));
  return found;
}

// The enclosure on an element that has a definition.
template <Scalar R>
std::optional<Attempt> attempt(const Formula& formula, const Query<R>& query, int bits, double& work_left) {
  if (formula.element == ElementKind::Quad) return attempt_quad(formula, query, bits, work_left);
  return attempt(kernel_of(formula.name), query, bits, work_left);
}

int next_bits(int bits, double reached, int wanted) {
  if (reached == -infinity) return 2 * bits;
  const int missing = wanted + 8 - static_cast<int>(std::max(reached, 0.0));
  return (bits + std::max(missing, bits / 4) + 63) / 64 * 64;
}

}  // namespace

template <Scalar R>
void integrate_certified(std::string_view formula, const Query<R>& query, Result<R>& result,
                         const CertifiedEffort& effort) {
  [[maybe_unused]] static thread_local const ThreadCaches caches;
  const Formula& row = formula_named(formula);
  result.reset(row.components(), row.dim(), query.order);
  // A segment's moments take microseconds, and cancel next to its line, so they may take more bits.
  const int most_bits = row.element == ElementKind::Segment ? effort.most_bits * kBitsOfSegments : effort.most_bits;
  std::optional<Attempt> best;
  std::size_t nodes = 0;
  double work_left = effort.most_work;
  for (int bits = effort.first_bits; bits <= most_bits;) {
    auto found = attempt(row, query, bits, work_left);
    if (!found) break;
    nodes += found->nodes;
    const double reached = found->bits;
    if (!best || !(reached < best->bits)) best = std::move(found);
    if (reached >= effort.bits_wanted) break;
    bits = next_bits(bits, reached, effort.bits_wanted);
  }
  result.nodes = nodes;
  for (int order = 0; order <= query.order; ++order) {
    auto& middles = result.of(order);
    auto& radii = result.radius_of(order);
    radii.assign(middles.size(), std::numeric_limits<R>::infinity());
    if (!best || best->tensors[order].empty()) std::ranges::fill(middles, std::numeric_limits<R>::quiet_NaN());
    else
      for (std::size_t i = 0; i < middles.size(); ++i) round_to(best->tensors[order][i], middles[i], radii[i]);
  }
  result.converged = best && best->all_orders && best->bits >= effort.bits_wanted;
  if (!best || std::ranges::all_of(best->tensors, &std::vector<Real>::empty)) return;
  constexpr double digits_a_bit = 0.30102999566398119521;
  // The proven bits of the numbers returned: rounding to R leaves no more bits than R has.
  const double given_bits = is_multiprecision<R> ? most_bits : std::min(most_bits, std::numeric_limits<R>::digits);
  result.stated_digits = std::clamp(best->bits, 0.0, given_bits) * digits_a_bit;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void integrate_certified<R>(std::string_view, const Query<R>&, Result<R>&, const CertifiedEffort&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

namespace {

// One family per definition. None is standard: the check `enclosure` asks for as many enclosures as a campaign can
// afford.
[[maybe_unused]] const bool registered = [] {
  std::vector<std::string> enclosed = formulas_enclosed_on_quads();
  for (const Definition& definition : definitions()) enclosed.emplace_back(definition.formula);
  for (const std::string& formula : enclosed)
    EvaluationRegister::instance().add(
        single_family(formula, "certified",
                      {.description = "a ball that contains the integral, by ball arithmetic",
                       .role = Role::Enclosure,
                       .cost = CostClass::Multiprecision},
                      false, [formula](Evaluation& evaluation) {
                        for (const ScalarKind kind : scalar_kinds)
                          with_scalar(kind, [&]<Scalar R>() {
                            evaluation.set_point<R>([formula](const Query<R>& query, Result<R>& result) {
                              integrate_certified(formula, query, result);
                            });
                          });
                      }));
  return true;
}();

}  // namespace

}  // namespace cageproof::quadrature_ref
