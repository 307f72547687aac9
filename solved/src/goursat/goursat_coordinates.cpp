// SPDX-License-Identifier: MIT
// Registers the true biharmonic and harmonic coordinates of polygons, solved by least squares in a Goursat basis.
#include "dirichlet_solver.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <map>
#include <mutex>

namespace cageproof::solved::goursat {
namespace {

constexpr std::string_view kEvaluation = "least_squares";

// With the normal derivatives of the paper: hat functions have none, and beta's is one on its edge, outward.
BoundaryFunction coordinate_data(const Cage& cage, Equation equation) {
  return [cage, equation](const EdgePoint& at, const BoundaryData& data) {
    const auto& ends = cage.faces()[at.face].vertices;
    data.values[ends[0]] = at.from_end;
    data.values[ends[1]] = at.from_start;
    if (equation == Equation::Harmonic) return;
    const double slope = 1 / (cage.vertices()[ends[1]] - cage.vertices()[ends[0]]).stableNorm();
    data.derivatives_along[ends[0]] = -slope;
    data.derivatives_along[ends[1]] = slope;
    data.normal_derivatives[cage.vertices().size() + at.face] = 1;
  };
}

// Shares the solution of a cage among all that ask for it at a time, as long as anybody keeps it, because solving takes
// longer than all questions to it.
class Solutions {
 public:
  std::shared_ptr<const DirichletSolution> of(const Cage& cage, Equation equation) {
    const std::shared_ptr<Entry> entry = entry_of(cage, equation);
    const std::lock_guard lock(entry->mutex);
    std::shared_ptr<const DirichletSolution> found = entry->solution.lock();
    if (found) return found;
    const std::size_t vertices = cage.vertices().size();
    const std::size_t problems = equation == Equation::Biharmonic ? vertices + cage.faces().size() : vertices;
    found = std::make_shared<const DirichletSolution>(cage, equation, static_cast<int>(problems),
                                                      coordinate_data(cage, equation));
    entry->solution = found;
    return found;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::weak_ptr<const DirichletSolution> solution;
  };

  std::shared_ptr<Entry> entry_of(const Cage& cage, Equation equation) {
    std::vector<double> key{equation == Equation::Harmonic ? 0.0 : 1.0};
    for (const Vec3<double>& v : cage.vertices()) key.insert(key.end(), {v[0], v[1]});
    for (const Face& f : cage.faces()) key.insert(key.end(), {double(f.vertices[0]), double(f.vertices[1])});
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [](const auto& entry) {
      if (entry.second.use_count() > 1) return false;
      const std::lock_guard unused(entry.second->mutex);
      return entry.second->solution.expired();
    });
    std::shared_ptr<Entry>& entry = entries_[key];
    if (!entry) entry = std::make_shared<Entry>();
    return entry;
  }

  std::mutex mutex_;
  std::map<std::vector<double>, std::shared_ptr<Entry>> entries_;  // those that somebody keeps, or is solving
};

Solutions& solutions() {
  static Solutions all;
  return all;
}

class GoursatCoordinates final : public CoordinatesInDouble<GoursatCoordinates>, public SolvesSystems {
 public:
  GoursatCoordinates(const Cage& cage, Equation equation)
      : equation_(equation), elements_(cage, false, {}), solution_(solutions().of(cage, equation)) {
    const bool biharmonic = equation == Equation::Biharmonic;
    using Trace = CoordinateBlock::Trace;
    blocks_.push_back({.label = biharmonic ? "alpha" : "lambda",
                       .owner = Owner::Vertex,
                       .size = static_cast<int>(cage.vertices().size()),
                       .shape = {},
                       .reproduces = Reproduces::Vertices,
                       .trace = {biharmonic ? Trace::Kind::Unknown : Trace::Kind::Zero, 0}});
    if (biharmonic)
      blocks_.push_back({.label = "beta",
                         .owner = Owner::Element,
                         .size = static_cast<int>(cage.faces().size()),
                         .shape = {},
                         .reproduces = Reproduces::Normals,
                         .degree = 1});
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return 2; }
  std::string evaluation() const override { return std::string(kEvaluation); }
  bool is_exact_in(ScalarKind) const override { return false; }
  const SolvesSystems* systems() const override { return this; }
  bool measures_boundary() const override { return true; }
  std::vector<SolvedSystem> solved() const override {
    const DirichletReport& r = solution_->report();
    const bool biharmonic = equation_ == Equation::Biharmonic;
    return {{fmt::format("Goursat basis of degree {}, corners' exponents up to {} pi/angle", r.degree, r.terms),
             r.equations, r.unknowns, r.rank, r.condition, r.residual, r.value_residual,
             biharmonic ? r.gradient_residual : std::numeric_limits<double>::quiet_NaN()}};
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points.size(); ++p) put(points[p], p, order, tables);
  }

 private:
  template <Scalar R>
  void put(const Vec3<R>& point, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    const auto found = solution_->at(point, order);
    for (int o = 0; o <= order; ++o) {
      auto from = found[o].begin();
      for (CoordinateTable<R>& table : tables) {
        const auto width = static_cast<std::ptrdiff_t>(table.stride[o]);
        std::copy(from, from + width, table.tensors[o].begin() + static_cast<std::ptrdiff_t>(p) * width);
        from += width;
      }
    }
    // The data themselves, rather than what least squares make of them.
    const std::vector<Touching> on = elements_.touching(convert<double>(point));
    if (on.empty()) return;
    for (CoordinateTable<R>& table : tables)
      std::fill_n(table.tensors[0].begin() + p * table.stride[0], table.stride[0], R(0));
    const auto vertices = elements_.vertices_of(on.front().element);
    for (std::size_t c = 0; c < vertices.size(); ++c)
      tables[0].tensors[0][p * tables[0].stride[0] + vertices[c]] = R(on.front().basis[c]);
  }

  Equation equation_;
  CageElements elements_;
  std::vector<CoordinateBlock> blocks_;
  std::shared_ptr<const DirichletSolution> solution_;
};

template <Equation Kind>
std::shared_ptr<const PreparedCoordinates> prepare(const Cage& cage, const CoordinateOptions& options) {
  if (!options.evaluation.empty() && options.evaluation != kEvaluation)
    throw InputError(fmt::format("no evaluation is called \"{}\"; Goursat coordinates have only {}", options.evaluation,
                                 kEvaluation));
  return std::make_shared<GoursatCoordinates>(cage, Kind);
}

constexpr std::string_view kMissing = "points outside the cage";

const RegisterCoordinateKind register_biharmonic_goursat{{.name = "biharmonic_goursat",
                                                          .source = "[W12] Eq 4-8",
                                                          .own_dimension = 2,
                                                          .prepare = prepare<Equation::Biharmonic>,
                                                          .missing_because = kMissing,
                                                          .inside_alone = true,
                                                          .refuses = why_no_dirichlet_solution}};
const RegisterCoordinateKind register_harmonic_goursat{{.name = "harmonic_goursat",
                                                        .source = "Joshi et al. 2007",
                                                        .own_dimension = 2,
                                                        .prepare = prepare<Equation::Harmonic>,
                                                        .missing_because = kMissing,
                                                        .inside_alone = true,
                                                        .refuses = why_no_dirichlet_solution}};

}  // namespace
}  // namespace cageproof::solved::goursat
