// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/quad/mean_value/scheme_errata.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/random_stream.h"
#include "quad/bilinear_basis.h"
#include "quad/mean_value/riemann/misprints.h"

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc {
namespace {

constexpr int kSamples = 200;

Vec3<double> random_vector(RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

// A valid quad of size 1 around a random point, because one printed sum depends on where the origin is.
Quad<double> random_quad(RandomStream& random) {
  const Vec3<double> middle = random_vector(random, 1);
  for (;;) {
    Quad<double> q{Vec3<double>(-.5, -.5, 0), Vec3<double>(.5, -.5, 0), Vec3<double>(.5, .5, 0),
                   Vec3<double>(-.5, .5, 0)};
    for (auto& corner : q) corner += random_vector(random, .25);
    if (invalid_because(q)) continue;
    for (auto& corner : q) corner += middle;
    return q;
  }
}

void note(ErratumRow& row, double printed, double corrected) {
  ++row.samples;
  if (std::isfinite(printed)) row.printed_error = std::max(row.printed_error, printed);
  else ++row.nonfinite;
  row.corrected_error = std::max(row.corrected_error, corrected);
}

Vec3<double> point_at(const Quad<double>& q, double u, double v) {
  const Basis<double> b = bilinear_basis(u, v);
  return b[0] * q[0] + b[1] * q[1] + b[2] * q[2] + b[3] * q[3];
}

// A point one to two sizes from the quad's middle.
Vec3<double> outer_point(RandomStream& random, const Quad<double>& q) {
  return point_at(q, .5, .5) + random.uniform(1, 2) * random_vector(random, 1).normalized();
}

// The integral's own weights of the hull's face 013 in proportion, against those of triangles (Eq 14).
void measure_hull_kernel(ErratumRow& row) {
  const auto& rule = gauss_legendre<double>(40);
  for (int i = 0; i < kSamples / 4; ++i) {
    RandomStream random(1, "hull kernel", i);
    const Quad<double> q = random_quad(random);
    const Vec3<double> eta = outer_point(random, q);
    const PairFrame<double> s(q, eta);
    const Vec3<double> m = face_mean_vectors(s)[0];
    const Vec3<double> closed = Vec3<double>(m.dot(s.cross[k13]), -m.dot(s.cross[k03]), m.dot(s.cross[k01])).cwiseAbs();
    const auto off = [&](int exponent) {
      const Vec3<double> w = as_printed::face_weights<double>({q[0], q[1], q[3]}, eta, exponent, rule);
      return (w / w.sum() - closed / closed.sum()).norm() / (closed / closed.sum()).norm();
    };
    note(row, off(3), off(4));
  }
}

// The projection to the hull, in sizes off the means of its surface: Eq 25 by absolute weights.
void measure_hull_sum(ErratumRow& row) {
  const auto& rule = gauss_legendre<double>(40);
  constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 3, 2}}};
  for (int i = 0; i < kSamples / 4; ++i) {
    RandomStream random(1, "hull sum", i);
    const Quad<double> q = random_quad(random);
    const Vec3<double> eta = outer_point(random, q);
    const PairFrame<double> s(q, eta);
    Vec3<double> mean = Vec3<double>::Zero();
    double sum = 0;
    for (const auto& f : faces) {
      const Vec3<double> w = as_printed::face_weights<double>({q[f[0]], q[f[1]], q[f[2]]}, eta, 4, rule);
      for (int c = 0; c < 3; ++c) mean += w[c] * q[f[c]];
      sum += w.sum();
    }
    mean /= sum;
    const Vec3<double> found = eta + s.unit * to_hull(s, null_vector(s));
    note(row, (as_printed::to_hull(s, q) - mean).norm(), (found - mean).norm());
  }
}

// Eq 15, which Eq 28 solves.
void measure_minimal_norm(ErratumRow& row) {
  for (int i = 0; i < kSamples; ++i) {
    RandomStream random(1, "minimal norm", i);
    const Quad<double> q = random_quad(random);
    const PairFrame<double> s(q, outer_point(random, q));
    const Vec3<double> m = mean_vector(s);
    const Vec4<double> kappa = null_vector(s);
    const auto off = [&](const Vec4<double>& w) { return (apply(s, w) - m).norm() / m.norm(); };
    note(row, off(as_printed::minimal_norm_solution(s, kappa, m)), off(minimal_norm_solution(s, kappa, m)));
  }
}

// u of a point of the quad.
void measure_row_parameter(ErratumRow& row) {
  for (int i = 0; i < kSamples; ++i) {
    RandomStream random(1, "row", i);
    const Quad<double> q = random_quad(random);
    const double u = random.uniform(.1, .9), v = random.uniform(.1, .9);
    const PairFrame<double> s(q, point_at(q, u, v));
    const Vec3<double> along = ((s.p[1] + v * s.along[k12]) - (s.p[0] + v * s.along[k03])) * s.unit;
    const double bare = as_printed::row_parameter(s, v, Vec3<double>(Vec3<double>::Zero()));
    note(row, std::abs(bare - u) / u, std::abs(bare / along.squaredNorm() - u) / u);
  }
}

// Algorithm 2 asks for the parameters of planar quads off their planes, too; Eq 19 is asked only in the plane.
void measure_membership(ErratumRow& row) {
  const Quad<double> q{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, 0), Vec3<double>(0, 1, 0)};
  for (int i = 0; i < kSamples; ++i) {
    RandomStream random(1, "membership", i);
    // Dyadic, so that what cancels does so exactly.
    const auto dyadic = [&] { return std::round(random.uniform(-64, 64)) / 32; };
    const Vec3<double> eta(dyadic(), dyadic(), std::abs(dyadic()) + 1);
    note(row, as_printed::parameters_of_kernel(null_vector(PairFrame<double>(q, eta))).first, 0);
  }
}

// Weights next to extended diagonals.
void measure_poles(ErratumRow& row) {
  const Evaluation printed = evaluation_named("quad.mean_value", "riemann-4-unguarded"),
                   guarded = evaluation_named("quad.mean_value", "riemann-4"),
                   truth = evaluation_named("quad.mean_value", "line_form");
  for (int i = 0; i < kSamples; ++i) {
    RandomStream random(1, "poles", i);
    const Quad<double> q = random_quad(random);
    const Vec3<double> eta =
        q[0] + random.uniform(1.3, 2) * (q[2] - q[0]) + random_vector(random, std::pow(10, -random.uniform(0.5, 4)));
    const auto weights = [&](const Evaluation& evaluation) {
      Result<double> found;
      evaluation(Query<double>{q, eta}, found);
      return Vec4<double>(found.value.data());
    };
    const Vec4<double> right = weights(truth);
    note(row, (weights(printed) - right).norm() / right.norm(), (weights(guarded) - right).norm() / right.norm());
  }
}

SchemeErratum measured(std::string source, std::string printed, std::string correct, std::string what,
                       std::string where, void (*measure)(ErratumRow&)) {
  SchemeErratum erratum;
  erratum.row = {.source = std::move(source),
                 .printed = std::move(printed),
                 .correct = std::move(correct),
                 .formula = "quad.mean_value",
                 .evaluation = std::move(what),
                 .regime = std::move(where)};
  erratum.measure = measure;
  return erratum;
}

}  // namespace

const std::vector<SchemeErratum>& scheme_errata() {
  static const std::vector<SchemeErratum> all = [] {
    std::vector<SchemeErratum> rows;
    SchemeErratum& figure = rows.emplace_back();
    figure.row.source = "[T18] Eq 19";
    figure.row.printed = "A_i and E_i stand only in a figure, which has no formula";
    figure.row.correct =
        "A_i and B_i the signed areas of (eta, q_i, q_i+1) and (eta, q_i-1, q_i+1), D = B_0^2 + B_1^2 + 2 A_0 A_2 + "
        "2 A_1 A_3, E_i = 2 A_i - B_i - B_i+1 + sqrt(D)";
    rows.push_back(measured("[T18] Section 3.3", "u = (k_1 + k_2)/sum k tells whether a point is on the quad",
                            "sum k is zero for planar quads, which Algorithm 2 asks, too", "u off the quad",
                            "planar quad", &measure_membership));
    rows.push_back(measured("[T18] Eq 24", "||wbar||^2/(Omega.wbar)",
                            "the same, with poles around the quad's extended diagonals: blended into 1 there",
                            "riemann-4-unguarded", "extended diagonals", &measure_poles));
    rows.push_back(measured("[T18] Eq 25", "|(xi - eta).n|/|xi - eta|^3",
                            "exponent 4: absolute mean value weights, as the next sentence says",
                            "a face's weights in proportion", "1 to 2 sizes", &measure_hull_kernel));
    rows.push_back(measured("[T18] Algorithm 1, lines 5 to 9", "sum |w_i| t_i", "that over sum |w_i|",
                            "point of the hull, in sizes", "1 to 2 sizes", &measure_hull_sum));
    rows.push_back(measured("[T18] Eq 28", "D = |kappa|^2", "D = -|kappa|^2 with Eq 26's kappa", "residual of Eq 15",
                            "1 to 2 sizes", &measure_minimal_norm));
    rows.push_back(measured("[T18] Eq 29", "u = (eta' - a).(b - a)", "that over |b - a|^2", "u on the quad",
                            "on the quad", &measure_row_parameter));
    return rows;
  }();
  return all;
}

}  // namespace cageproof::adaptive_qmvc
