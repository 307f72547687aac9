// SPDX-License-Identifier: MIT
// Cage coordinates: a kind of coordinates, prepared for one cage, and asked at points. Each kind decides how it
// computes them: by sums over elements, by a system that it solves once per cage, or directly.
#pragma once

#include "cageproof/core/coordinates/prepared_coordinates.h"

#include <cmath>
#include <list>
#include <memory>

namespace cageproof {

/// One block of a kind that is a sum over elements. The kernel is resolved to `<element>.<kernel>` on each element of
/// the cage.
struct SummedBlock {
  std::string_view label;   ///< "phi", "psi" ...
  std::string_view kernel;  ///< "double_layer"
  Reproduces reproduces;
  /// The factor of the normals, from the formula's parameters and the space's dimension; null for one.
  double (*normal_factor)(std::span<const double> parameters, int dimension) = nullptr;
  /// For kernels with one tensor per corner: whether corners keep theirs; otherwise they are added to the vertices'.
  bool one_a_corner = false;
  /// Whether there is one per normal (Owner::Normal). Quads have one per corner, integrated over du dv times the area
  /// element |N_k| there, so that all coordinates multiply unit normals. Triangles have one.
  bool one_a_normal = false;
};

/// A parameter of a kind of coordinates: a number, a whole number, or one of several names, which stand for 0, 1, ...
struct KindParameter : Parameter {
  std::string_view meaning = {};
  std::vector<std::string_view> names = {};

  /// The value that a text stands for: a number ("0.3", "inf"), or one of the names. Nothing for any other text.
  std::optional<double> value_of(std::string_view text) const;
};

/// The options that a kind is prepared with.
struct CoordinateOptions {
  /// An evaluation of its formulas, or of whole coordinates (a WholeEvaluation's name, or `quickest`); empty for each
  /// formula's recommended one.
  std::string evaluation = {};
  Triangulation triangulation = Triangulation::Shortest;
  std::vector<double> parameters = {};  ///< in the order of parameters_of(kind); empty for their defaults
};

/// A kind of cage coordinates.
struct CoordinateKind {
  std::string_view name;
  std::string_view source;
  /// The blocks of a sum over elements; empty for kinds that compute otherwise.
  std::vector<SummedBlock> blocks = {};
  bool normalised = false;   ///< divided by their sum (mean value coordinates), and interpolating on the cage
  bool keeps_quads = false;  ///< the cage's quads stay bilinear surfaces
  /// Cage dimension of a kind that is not a sum over elements; 0 means 2 and 3. `prepare` prepares it for a cage; it
  /// is null for sums.
  int own_dimension = 3;
  std::shared_ptr<const PreparedCoordinates> (*prepare)(const Cage& cage, const CoordinateOptions& options) = nullptr;
  /// Parameters of a kind that is not a sum over elements; a sum has those of its formulas.
  std::vector<KindParameter> parameters = {};
  /// Names of evaluations of a kind that is not a sum, in addition to its formulas', that are measured by themselves.
  std::vector<std::string_view> other_evaluations = {};
  /// The kind, of the same blocks, that is what this one approximates by its scheme; empty for kinds that are no
  /// approximation of another.
  std::string_view approximates = {};
  /// Whether blocks multiply data on the boundary of a polygon that the kind comes near to: values at vertices, then
  /// normal derivatives of edges, then Laplacians at vertices ([W12] Eq 7).
  bool meets_boundary_data = false;
  /// Why there may be points without coordinates; empty for kinds that have them everywhere.
  std::string_view missing_because = {};
  /// Whether preparing solves for densities on samples of all elements, which takes the square of the number of
  /// elements times that of samples: runs ask such kinds of small cages.
  bool solves_on_samples = false;
  /// Whether the points without coordinates are exactly those outside.
  bool inside_alone = false;
  /// Whether functions of these coordinates continue through a flat element, as their inside values plus the element's
  /// affine map (Lipman et al. 2008, for Green coordinates). Blocks are then of vertices and of elements' normals.
  bool extends = false;
  /// Why the kind has no coordinates in a cage of its dimension, with its parameters' defaults; empty where it has.
  /// Null for kinds that refuse none. What other parameters make too large, `prepare` refuses.
  std::string (*refuses)(const Cage& cage) = nullptr;

  /// Whether a kind that is not a sum is made of sums and takes their evaluation, which `quickest` then chooses.
  bool made_of_sums = false;

  bool is_sum() const { return prepare == nullptr; }
};

/// The kinds that are sums over elements (mean_value, quad_mean_value, green, biharmonic, biharmonic_affine,
/// somigliana, quad_green, quad_biharmonic, quad_somigliana), then those that rooms linked into the program add, by
/// name. Kinds stay where they are.
const std::list<CoordinateKind>& coordinate_kinds();

/// Adds a kind at program start: `const RegisterCoordinateKind r{...};` at namespace scope of a .cpp.
struct RegisterCoordinateKind {
  explicit RegisterCoordinateKind(CoordinateKind kind);
};

/// The parameters of a kind: its own, or those of its formulas, which they share; none for most kinds.
std::vector<KindParameter> parameters_of(const CoordinateKind& kind);

/// The formulas that a kind sums on a cage's elements, each once.
std::vector<const Formula*> formulas_of(const CoordinateKind& kind, const Cage& cage);

/// The kind of that name, or null.
const CoordinateKind* find_coordinate_kind(std::string_view name);

/// The kind of that name. \throws InputError where there is none
const CoordinateKind& coordinate_kind_named(std::string_view name);

/// The kind that sums the same on a cage's own quads: the kind itself where it keeps them, or the one of its name with
/// "quad_" before it. \throws InputError where there is none
const CoordinateKind& keeping_quads(const CoordinateKind& kind);

/// Whether the kind exists on a cage like this one: all its kernels have formulas on the cage's elements.
bool exists_on(const CoordinateKind& kind, const Cage& cage);

/// Whether the kind has coordinates in the cage: it exists on it, does not refuse it, and it triangulates quads, or all
/// are valid, or the cage allows others.
bool accepts(const CoordinateKind& kind, const Cage& cage);

/// Why a kind that exists on the cage does not accept it with its parameters' defaults, the first reason; empty where
/// it does.
std::string why_refused(const CoordinateKind& kind, const Cage& cage);

/// Coordinates of points in one cage. Keeps a reference to the kind, copies of the rest; safe from any thread.
class CageCoordinates {
 public:
  /// \throws InputError when a block's formula has no evaluation of that name, a parameter is out of range, the kind
  /// does not exist on the
  ///   cage, or a kind that keeps quads meets an invalid one that the cage does not allow
  CageCoordinates(const Cage& cage, const CoordinateKind& kind, CoordinateOptions options);
  /// \param evaluation of the quads' formulas for kinds that keep quads; triangles then take it where they have it,
  /// else the recommended one
  CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation, Triangulation rule,
                  std::vector<double> parameters = {})
      : CageCoordinates(cage, kind, CoordinateOptions{std::string(evaluation), rule, std::move(parameters)}) {}

  /// A kind's sums over elements that need not make up a cage, by a whole evaluation, which must not rest on relations
  /// that closed surfaces have. \param like a cage in which the evaluation computes the kind
  /// \throws InputError where it computes none, and for a parameter out of range \pre the kind is a sum
  CageCoordinates(std::shared_ptr<const CageElements> elements, const CoordinateKind& kind, CoordinateOptions options,
                  const Cage& like);

  const CoordinateKind& kind() const { return *kind_; }
  /// The cage's elements, quads as triangles unless the kind keeps them.
  const CageElements& elements() const { return *elements_; }
  const std::vector<CoordinateBlock>& blocks() const { return prepared_->blocks(); }
  int dimension() const { return elements_->dimension(); }
  int max_order() const { return prepared_->max_order(); }
  /// The name of the formulas' evaluation; where elements differ, that of quads.
  std::string evaluation() const { return prepared_->evaluation(); }
  bool is_exact_in(ScalarKind scalar) const { return prepared_->is_exact_in(scalar); }
  bool is_prompt_in(ScalarKind scalar) const { return prepared_->is_prompt_in(scalar); }
  bool measures_boundary() const {
    return prepared_->systems() != nullptr && prepared_->systems()->measures_boundary();
  }
  /// The systems that were solved in double; none for kinds that solve none.
  std::vector<SolvedSystem> solved() const {
    return prepared_->systems() != nullptr ? prepared_->systems()->solved() : std::vector<SolvedSystem>();
  }

  /// Coordinates of several points, one table per block of coordinates, as PreparedCoordinates::fill.
  template <Scalar R>
  std::vector<CoordinateTable<R>> at(std::span<const Vec3<R>> points, int order) const;

  /// Coordinates in double, into the tables of an earlier call, whose memory is kept where it is large enough.
  void at(std::span<const Vec3<double>> points, int order, std::vector<CoordinateTable<double>>& tables) const;

  /// Limits from inside at points within elements (HasLimits). R: double or Mp50
  /// \throws InputError for kinds that have none
  template <Scalar R>
  std::vector<CoordinateTable<R>> limits_at(std::span<const Touching> places, int order) const;

  /// The Laplacians at boundary nodes as linear maps from the data (SolvesLaplacians).
  /// R: double or Mp50 \throws InputError for kinds that do not solve for them
  template <Scalar R>
  std::vector<CoordinateTable<R>> boundary_laplacians() const;

  /// The functions that coordinates make of cage data, a block of points at a time: no more than a few thousand
  /// points' coordinates are kept. \pre one list per block, as long as its coordinates, columns and sets ask
  /// \throws InputError where blocks have different numbers of rows
  AppliedTable apply(std::span<const Vec3<double>> points, int order, const CageData& data) const;

  /// The functions of apply(), to a stated error (AppliesData::sum_to); null for coordinates that can only be summed
  /// element by element.
  std::unique_ptr<const StatedSum> sum_to(double error, const CageData& data, std::size_t points) const;

  /// Coordinates of one point, one result per block.
  template <Scalar R>
  std::vector<Result<R>> at(const Vec3<R>& point, int order) const;

  /// The sizes of the terms of one point's coordinates (HasTerms), or those of the coordinates.
  std::vector<Result<double>> terms_at(const Vec3<double>& point, int order) const;

 private:
  const CoordinateKind* kind_;
  std::shared_ptr<const CageElements> elements_;
  std::shared_ptr<const PreparedCoordinates> prepared_;
};

}  // namespace cageproof
