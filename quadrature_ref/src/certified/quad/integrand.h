// SPDX-License-Identifier: MIT
// The integrand across a quad's lines: per order the kernel's derivatives, integrated along the line v.
#pragma once

#include "kernel.h"
#include "line_moments.h"
#include "seen_quad.h"

namespace cageproof::quadrature_ref::certified {

/// The bounds for a line's integrals: how far the line's points are from the point, over a whole disc of complex v.
struct LineBounds {
  Real nearest;   ///< lower bound of |x| on the line in the disc's middle
  Real farthest;  ///< upper bound there
  Real length;    ///< lower bound of its length; zero where there is none
  Real normal;    ///< upper bound of |N|, in the disc
  Real kappa;     ///< below one: in the disc |r| and |x| are within (1 -+ kappa) |x| in its middle
};

class QuadIntegrand {
 public:
  QuadIntegrand(const QuadKernel& kernel, int order, const std::vector<Real>& parameters, bool flat);

  int orders() const { return static_cast<int>(orders_.size()); }
  /// Integrals along a line: of an order's entries, [entry * weights() + weight], weights 1 - u and u, or one that
  /// is 1.
  std::size_t size(int order) const { return orders_[order].size() * weights(); }
  std::size_t weights() const { return weights_; }
  bool vanishes(int order) const;        ///< all entries are exactly zero
  double cost() const { return cost_; }  ///< of an evaluation in a word, in CertifiedEffort::most_work's unit

  /// At middle + t of the stretch; [order][...].
  const std::vector<std::vector<Real>>& operator()(const QuadStretch& stretch, const SeenQuad& quad, const Real& t);
  /// An upper bound of each entry of an order in the disc, without the weights of v.
  Real bound(int order, const LineBounds& line) const;

 private:
  struct Term {
    int x;       // place of its product of coordinates
    int q, y;    // place of the other factor of the integrand
    int degree;  // of the product of coordinates
    int factor, constant;
    QuadFactor with;
  };
  using Entry = std::vector<Term>;
  // A product of coordinates: one less, times a coordinate. As a polynomial of (1-u), u of its degree.
  struct Product {
    std::array<int, 3> powers;
    int without, coordinate;
  };
  struct Weighted {
    int q;
    QuadFactor with;
    int degree;
  };
  // Terms of an order whose bounds differ only in their factors.
  struct Alike {
    int of_x, q;  // powers of |x| and 1/r
    bool normal;  // times |N|
    friend auto operator<=>(const Alike&, const Alike&) = default;
  };
  void note_alike(const Entry& entry, std::map<Alike, Real>& alike) const;
  int product(const std::array<int, 3>& powers);
  int weighted(int q, QuadFactor with, int degree);

  std::size_t weights_;
  std::vector<Real> constants_;
  std::vector<std::vector<Entry>> orders_;
  std::vector<std::map<Alike, Real>> alike_;  // per order, with the largest sum of factors in an entry
  std::vector<Product> products_;
  std::vector<Weighted> weighted_;
  std::vector<LineMoments> moments_;  // one
  std::vector<std::vector<Real>> x_, y_, values_;
  double cost_ = 0;
};

}  // namespace cageproof::quadrature_ref::certified
