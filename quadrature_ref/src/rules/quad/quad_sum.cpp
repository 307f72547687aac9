// SPDX-License-Identifier: MIT
#include "quad_sum.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

// A quarter of the distance away from c where it is inside, and inside still.
Mp200 moved(const Mp200& x, const Mp200& step) {
  if (x == 0 || x == 1) return x;
  return x * 2 < 1 ? Mp200(x + std::min<Mp200>(step, (1 - x) / 4)) : Mp200(x - std::min<Mp200>(step, x / 4));
}

}  // namespace

QuadSum::QuadSum(const Integrand& integrand, const QuadFrame<Mp200>& q, const ClosestPoint& c,
                 const Query<Mp200>& query, double digits, double budget)
    : ConvergingSum(integrand, query), budget_(budget) {
  const PolarQuadFrame<Mp200> frame = polar_quad_frame(q, c.u, c.v);
  const Mp200 u = moved(c.u, Mp200(frame.distance / length(frame.at.along_u) / 4));
  const Mp200 v = moved(c.v, Mp200(frame.distance / length(frame.at.along_v) / 4));
  // The longer a cell, the fewer points it takes per unit of length. From these lengths on more would gain little, and
  // cells that no cut makes shorter would be the same in both.
  cuts_[0] = cut(frame, digits, 6);
  cuts_[1] = cut(polar_quad_frame(q, u, v), digits, 5);
  std::array<double, 3> mass;
  mass.fill(kNoMass);
  for (const auto& of_cell : cuts_[0].mass)
    for (int o = 0; o <= order_; ++o) mass[o] = std::max(mass[o], of_cell[o]);
  find_log10_norms(mass, [&](const auto& error) { return with_error(cuts_[0], error); });
  // Thrown here, before half of the work is spent.
  std::vector<Rule> rules;
  if (plan(cuts_[0], error_of(digits), rules) + plan(cuts_[1], error_of(digits), rules) > budget_) throw TooCostly{};
}

QuadSum::Cut QuadSum::cut(PolarQuadFrame<Mp200> frame, double digits, double longest) {
  Cut c{std::move(frame), {}, {}, {}, {}};
  c.frame50 = convert<Mp50>(c.frame200);
  c.frame100 = convert<Mp100>(c.frame200);
  // A cell has at least about this many points per direction and digit.
  constexpr double kPointsADigit = 0.7;
  const double of_cell = (1 + order_) * std::pow(kPointsADigit * digits, 2);
  const auto most = static_cast<std::size_t>(budget_ / of_cell);
  c.cells = quad_cells(c.frame50, digits, longest, most);
  if (c.cells.size() > most) throw TooCostly{};
  QuadCaster<Mp50> caster(c.frame50, integrand_, task<Mp50>());
  for (const PlannedCell& cell : c.cells) c.mass.push_back(caster.log10_mass(cell.cell));
  return c;
}

template <Scalar W>
void QuadSum::add_cell(const PolarQuadFrame<W>& frame, const QuadCell& cell, QuadPoints points, Result<Mp200>& total) {
  Result<W> sums = empty<W>();
  QuadCaster<W>(frame, integrand_, task<W>()).add_cell(cell, points, sums);
  add(sums, total);
}

double QuadSum::plan(const Cut& cut, const std::array<double, 3>& log10_error, std::vector<Rule>& rules) const {
  rules.resize(cut.cells.size());
  double cost = 0;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    Rule& rule = rules[i];
    rule.digits = 0;
    for (int o = 0; o <= order_; ++o)
      if (cut.mass[i][o] > kNoMass) rule.digits = std::max(rule.digits, cut.mass[i][o] - log10_error[o]);
    rule.digits = std::min(rule.digits, kDigitsIn200);
    // Points in multiprecision cost more than rules.
    rule.points = points_for(cut.cells[i], rule.digits, 1);
    // Far away both cuts have the same cells: rules that share their nodes would agree in any case.
    if (&cut == &cuts_[1]) {
      ++rule.points.t;
      ++rule.points.w;
    }
    if (!rule.points.enough) throw TooCostly{};
    // A point's time, as measured: in more digits, and with derivatives.
    const double in_50 = rule.digits <= kDigitsIn50 ? 1 : rule.digits <= kDigitsIn100 ? 1.5 : 3;
    cost += in_50 * (1 + order_) * rule.points.t * rule.points.w;
  }
  if (!(cost <= budget_)) throw TooCostly{};
  return cost;
}

Result<Mp200> QuadSum::with_error(const Cut& cut, const std::array<double, 3>& log10_error) {
  std::vector<Rule> rules;
  budget_ -= plan(cut, log10_error, rules);
  Result<Mp200> total = empty();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const QuadCell& cell = cut.cells[i].cell;
    if (rules[i].digits <= kDigitsIn50) add_cell(cut.frame50, cell, rules[i].points, total);
    else if (rules[i].digits <= kDigitsIn100) add_cell(cut.frame100, cell, rules[i].points, total);
    else add_cell(cut.frame200, cell, rules[i].points, total);
  }
  return total;
}

Result<Mp200> QuadSum::at(double digits) {
  Result<Mp200> sums = with_error(cuts_[next_], error_of(digits));
  next_ = 1 - next_;
  return sums;
}

}  // namespace cageproof::quadrature_ref
