// SPDX-License-Identifier: MIT
// The derivative of H(int r) r for a fixed tangent r: [T24] Eq 18.
#pragma once

#include "cageproof/closed_form/published/misprint.h"
#include "published/triangle/engine/frame.h"

namespace cageproof::closed_form::published {

/// U^r_{e_i}, the derivative of U_{e_i} r with respect to the point ([T24] Eq 18); not finite at e_i.
template <Scalar R>
Mat3<R> turned_U(const Edge<R>& e, int i, const Vec3<R>& r) {
  const Vec3<R> u = e.unit(i);
  const R l = e.l[i], ur = u.dot(r);
  return -tensor<R>(r, u) / (l * l) - ur / l * e.U(i) + 2 * ur / (l * l) * (u * u.transpose());
}

/// M^r_{e_i}, the derivative of M_{e_i} r ([T24] Eq 18); not finite where m_{e_i} is not.
template <Scalar R>
Mat3<R> turned_M(const Edge<R>& e, int i, const Vec3<R>& r) {
  const Vec3<R> v = e.unit(i) - e.u;
  const R b = e.l[i] - e.zeta[i], vr = v.dot(r);
  return turned_U(e, i, r) / b - matrix_tensor<R>(v * r.transpose(), e.U(i)) / (b * b) - vr / (b * b) * e.U(i) +
         vr / (b * b * b) * tensor<R>(v, v);
}

/// An edge's term of A = grad omega_t.r/d_t ([T24] Eq 18): value, gradient, Hessian. Not finite on the edge.
template <Scalar R>
Jet<R, 1> edge_of_A(const Edge<R>& e, const Vec3<R>& r) {
  Jet<R, 1> A;
  const R l0 = e.l[0], l1 = e.l[1], sum = l0 + l1, q = e.q(), lambda = q * l0 * l1, c = 2 * e.length * e.r.dot(r);
  const Vec3<R> u = e.unit(0) + e.unit(1), v = l1 * e.unit(0) + l0 * e.unit(1);
  const Vec3<R> Lambda = 2 * sum * l0 * l1 * u + q * v;
  const Mat3<R> H = 2 * l0 * l1 * u * u.transpose() + 2 * sum * tensor<R>(u, v) +
                    q * (l1 * e.U(0) + l0 * e.U(1) + tensor<R>(e.unit(0), e.unit(1))) +
                    2 * sum * l0 * l1 * (e.U(0) + e.U(1));
  A.value[0] = -c * sum / lambda;
  A.gradient[0] = -c / lambda * u + c * sum / (lambda * lambda) * Lambda;
  A.hessian[0] = -c / lambda * (e.U(0) + e.U(1)) + c / (lambda * lambda) * tensor<R>(u, Lambda) -
                 2 * c * sum / (lambda * lambda * lambda) * Lambda * Lambda.transpose() +
                 c * sum / (lambda * lambda) * H;
  return A;
}

/// [T24] Eq 18, without the factor -lambda_2: unitless for a unit vector r. Not finite on the edges' lines, which have
/// no blue terms here. \pre r.n = 0
template <Scalar R>
Mat3<R> third_derivative(const Frame<R>& s, const Vec3<R>& r, Misprint misprint) {
  const R d = s.d, d2 = d * d;
  const Vec3<R>& n = s.n;
  Mat3<R> sum = Mat3<R>::Zero();
  for (const Edge<R>& e : s.edges) {
    const Jet<R, 1> A = edge_of_A(e, r);
    if (!s.in_plane)
      sum += 4 * d2 * A.value[0] * n * n.transpose() + 4 * d2 * d / 3 * tensor<R>(A.gradient[0], n) +
             d2 * d2 / 3 * A.hessian[0];
    const R a = e.a, rr = e.r.dot(r);
    const Vec3<R> dm = e.m(1) - e.m(0);
    const Mat3<R> dM = e.M(1) - e.M(0);
    const Mat3<R> ends = tensor<R>(e.unit(0) - e.unit(1), e.u) + e.zeta[0] * e.U(0) - e.zeta[1] * e.U(1);
    const Mat3<R> turned = a / 6 * (e.zeta[0] * turned_U(e, 0, r) - e.zeta[1] * turned_U(e, 1, r));
    sum += matrix_tensor<R>(e.r * r.transpose(), ends) / 6;
    sum += e.D2 / 2 * matrix_tensor<R>(e.r * r.transpose(), dM) + a * d * matrix_tensor<R>(n * r.transpose(), dM);
    sum += matrix_tensor<R>(e.D * r.transpose(), dm * e.r.transpose()) + d * dm.dot(r) * tensor<R>(n, e.r);
    sum += a / 6 * matrix_tensor<R>(e.u * r.transpose(), e.U(0) - e.U(1));
    sum += a * dm.dot(r) * (e.r * e.r.transpose() + n * n.transpose());
    sum += e.log_ratio() * rr * e.P() + e.D2 / 2 * rr * dM;
    // Printed: the last line's second sum, once more.
    sum +=
        rr / 6 * ends + (misprint == Misprint::Equation18 ? turned : Mat3<R>(a / 6 * e.u.dot(r) * (e.U(0) - e.U(1))));
    sum += a * (2 * d2 + e.D2) / 6 * (turned_M(e, 1, r) - turned_M(e, 0, r)) + turned;
  }
  return sum;
}

}  // namespace cageproof::closed_form::published
