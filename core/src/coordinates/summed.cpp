// SPDX-License-Identifier: MIT
#include "summed.h"

#include "element_axes.h"
#include "moved_off.h"
#include "next_to_cage.h"
#include "normalise.h"
#include "term_sizes.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/input_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace cageproof {
namespace {

// The evaluations of a kind's blocks on one kind of element; none for kinds of elements that the cage does not have.
using ElementEvaluations = std::vector<Evaluation>;

// The degree that the area element adds to quads' formulas that have none.
int degree_of_measure(const SummedBlock& spec, const Formula& formula) {
  return spec.one_a_normal && formula.by_parameters ? 2 : 0;
}

CoordinateBlock block_of(const CoordinateKind& kind, const SummedBlock& spec, const Formula& formula,
                         const CageElements& elements, std::span<const double> parameters) {
  const Owner owner = spec.one_a_normal           ? Owner::Normal
                      : !formula.shape.per_corner ? Owner::Element
                      : spec.one_a_corner         ? Owner::Corner
                                                  : Owner::Vertex;
  CoordinateBlock block{.label = std::string(spec.label),
                        .owner = owner,
                        .size = static_cast<int>(elements.count(owner)),
                        .shape = {false, formula.shape.rows, formula.shape.columns},
                        .reproduces = spec.reproduces};
  if (spec.normal_factor) block.normal_factor = spec.normal_factor(parameters, elements.dimension());
  // Normalised weights have no unit, and no Laplacian of their own.
  if (kind.normalised) return block;
  const Behaviour behaviour = formula.behaviour(parameters);
  block.degree = behaviour.degree + degree_of_measure(spec, formula);
  block.logarithmic = behaviour.logarithmic;
  if (formula.laplacian.kind == Laplacian::Kind::Zero) block.trace.kind = CoordinateBlock::Trace::Kind::Zero;
  if (formula.laplacian.kind != Laplacian::Kind::Formula) return block;
  for (std::size_t b = 0; b < kind.blocks.size(); ++b)
    if (find_formula(formula.element, kind.blocks[b].kernel)->name == formula.laplacian.formula)
      block.trace = {CoordinateBlock::Trace::Kind::Block, b};
  return block;
}

int largest_exponent(const std::vector<Vec3<double>>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest > 0 ? std::ilogb(largest) : 0;
}

class SummedCoordinates final : public CoordinatesIn<SummedCoordinates>, public HasLimits, public HasTerms {
 public:
  SummedCoordinates(const CoordinateKind& kind, std::shared_ptr<const CageElements> elements,
                    const CoordinateOptions& options)
      : normalised_(kind.normalised),
        elements_(std::move(elements)),
        exponent_(largest_exponent(elements_->vertices())),
        parameters_(options.parameters) {
    for (std::size_t e = 0; e < elements_->count(); ++e)
      add_evaluations(kind, elements_->type(e).kind, options.evaluation);
    const ElementKind first = elements_->type(0).kind;
    for (const SummedBlock& spec : kind.blocks) {
      const Formula& formula = *find_formula(first, spec.kernel);
      blocks_.push_back(block_of(kind, spec, formula, *elements_, parameters_));
      const Behaviour behaviour = formula.behaviour(parameters_);
      degrees_.push_back(behaviour.degree + degree_of_measure(spec, formula));
      homogeneous_ = homogeneous_ && behaviour.logarithmic.factor == 0;
      jumps_.push_back(formula.shape.per_corner ? behaviour.face_jump.number : 0);
      has_area_elements_ = has_area_elements_ || (blocks_.back().owner == Owner::Normal && has_quads());
    }
    if (normalised_ && find_evaluations_of_more_digits()) next_to_.emplace(*elements_, exponent_);
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return max_order_; }
  std::string evaluation() const override {
    std::string name;
    for (const ElementEvaluations& of_kind : evaluations_)
      if (!of_kind.empty()) name = of_kind.front().name();
    return name;
  }
  bool is_exact_in(ScalarKind scalar) const override {
    return std::ranges::all_of(evaluations_, [&](const ElementEvaluations& of_kind) {
      return std::ranges::all_of(of_kind, [&](const Evaluation& e) { return e.supports(scalar); });
    });
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    std::vector<std::vector<Touching>> on(points.size());
    bool any_on = false;
    for (std::size_t p = 0; p < points.size(); ++p) {
      on[p] = touching(points[p]);
      any_on = any_on || !on[p].empty();
    }
    if (!any_on) return sum_off(points, 0, order, tables);
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (on[p].empty()) sum_off<R>(points.subspan(p, 1), p, order, tables);
      else sum_on(points[p], p, order, on[p], tables);
    }
  }

  const HasLimits* limits() const override {
    const auto is_number = [](const CoordinateBlock& block) { return block.entries() == 1; };
    return normalised_ || !std::ranges::all_of(blocks_, is_number) ? nullptr : this;
  }
  const HasTerms* terms() const override { return normalised_ ? nullptr : this; }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put_limits<double>(places, order, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put_limits<Mp50>(places, order, tables);
  }

  // There is one term per corner of each element. Numbers that are not finite, such as derivatives at points on the
  // cage, are left out.
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    std::array<Vec3<double>, 4> storage;
    Result<double> part;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      for (std::size_t b = 0; b < blocks_.size(); ++b)
        for (std::size_t p = 0; p < points.size(); ++p) {
          evaluations_[static_cast<std::size_t>(elements_->type(e).kind)][b](
              Query<double>{corners_of(e, storage), points[p], order, parameters_}, part);
          BatchOutput<double> here = output_for(b, p, tables[b]);
          here.slots = elements_->shares_of(e, blocks_[b].owner);
          for (int o = 0; o <= order; ++o) {
            for (double& x : part.of(o)) x = std::isfinite(x) ? std::abs(x) : 0;
            here.put(0, o, part.of(o));
          }
        }
    }
    times_area_elements(points.size(), order, tables);
  }

 private:
  bool has_quads() const {
    for (std::size_t e = 0; e < elements_->count(); ++e)
      if (!elements_->type(e).flat) return true;
    return false;
  }

  void add_evaluations(const CoordinateKind& kind, ElementKind element, const std::string& name) {
    ElementEvaluations& found = evaluations_[static_cast<std::size_t>(element)];
    if (!found.empty()) return;
    auto& known = EvaluationRegister::instance();
    for (const SummedBlock& spec : kind.blocks) {
      const std::string_view formula = find_formula(element, spec.kernel)->name;
      auto evaluation = name.empty() ? known.with_role(formula, Role::Recommended) : known.find(formula, name);
      if (!evaluation && name.empty()) evaluation = known.with_role(formula, Role::Integral);
      // Triangles among quads are computed as the quads are where they can be. A name that quads do not know is no
      // evaluation of the kind, whether the cage has any or not.
      const bool companion = kind.keeps_quads && type_of(element).splits.empty();
      if (!evaluation && companion) {
        evaluation_named(find_formula(ElementKind::Quad, spec.kernel)->name, name);
        evaluation = known.with_role(formula, Role::Recommended);
      }
      found.push_back(evaluation ? std::move(*evaluation) : evaluation_named(formula, name));
      max_order_ = std::min(max_order_, found.back().max_order());
    }
  }

  // Finds evaluations in more digits of a normalised kind: its own if they keep a promise by more digits and have
  // these, and the recommended ones of those that have none. \return false where others show what they lose, or take
  // their time
  bool find_evaluations_of_more_digits() {
    for (std::size_t kind = 0; kind < evaluations_.size(); ++kind) {
      if (evaluations_[kind].empty()) continue;
      const Evaluation& own = evaluations_[kind].front();
      const Role role = own.role();
      if (role != Role::Recommended && role != Role::ClosedForm && role != Role::Stated) return false;
      const auto recommended = EvaluationRegister::instance().with_role(own.formula().name, Role::Recommended);
      more_digits_[kind] = own.supports<Mp200>() || !recommended ? own : *recommended;
      const Evaluation& more = more_digits_[kind];
      if (!more.supports<Mp50>() || !more.supports<Mp100>() || !more.supports<Mp200>()) return false;
    }
    return true;
  }

  // Quads' formulas leave the area element out. One point's, in the unit 2^-exponent.
  template <Scalar R>
  void times_area_elements_at(std::size_t p, int order, int exponent, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (blocks_[b].owner != Owner::Normal) continue;
      for (int o = 0; o <= order; ++o) {
        const std::size_t size = tables[b].stride[o] / blocks_[b].size;
        const std::span<R> row = row_of(tables[b], p, o);
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] *= R(elements_->area_element_in(exponent, i / size, Owner::Normal));
      }
    }
  }
  template <Scalar R>
  void times_area_elements(std::size_t points, int order, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points; ++p) times_area_elements_at(p, order, 0, tables);
  }

  // Points that are no doubles are taken to lie off the cage: nobody can put them on it.
  template <Scalar R>
  std::vector<Touching> touching(const Vec3<R>& point) const {
    const Vec3<double> rounded = convert<double>(point);
    for (int c = 0; c < 3; ++c)
      if (R(rounded[c]) != point[c]) return {};
    return elements_->touching(rounded);
  }

  // In units of 2^-exponent, exactly.
  template <Scalar R>
  std::span<const Vec3<R>> corners_of(std::size_t e, std::array<Vec3<R>, 4>& storage, int exponent = 0) const {
    const auto vertices = elements_->vertices_of(e);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      storage[k] = in_unit(convert<R>(elements_->vertices()[vertices[k]]), exponent);
    return std::span(storage).first(vertices.size());
  }

  template <Scalar R>
  BatchOutput<R> output_for(std::size_t b, std::size_t first, CoordinateTable<R>& table) const {
    BatchOutput<R> output{.stride = table.stride,
                          .entries = static_cast<std::size_t>(blocks_[b].entries()),
                          .dim = elements_->dimension(),
                          .add = true};
    for (std::size_t o = 0; o < 3; ++o)
      if (!table.tensors[o].empty()) output.tensors[o] = table.tensors[o].data() + first * table.stride[o];
    return output;
  }

  template <Scalar R>
  static Vec3<R> in_unit(const Vec3<R>& p, int exponent) {
    using std::ldexp;
    return exponent == 0 ? p : Vec3<R>(ldexp(p[0], exponent), ldexp(p[1], exponent), ldexp(p[2], exponent));
  }

  // Points off the cage, which stand in the tables from point `first` on.
  template <Scalar R>
  void sum_off(std::span<const Vec3<R>> points, std::size_t first, int order,
               std::span<CoordinateTable<R>> tables) const {
    sum_in_range(points, first, order, tables);
    if constexpr (!is_multiprecision<R>)
      for (std::size_t p = 0; p < points.size(); ++p) {
        if (!points[p].allFinite() || sum_next_to_cage(points[p], first + p, order, tables)) continue;
        if (!is_finite(first + p, order, tables)) sum_beyond_range(points[p], first + p, order, tables);
      }
  }

  template <Scalar R>
  void sum_in_range(std::span<const Vec3<R>> points, std::size_t first, int order,
                    std::span<CoordinateTable<R>> tables) const {
    if (is_multiprecision<R> && !has_area_elements_) return sum_in_unit(points, first, order, tables, 0);
    const bool comfortable = std::abs(exponent_) <= kComfortable<R>;
    // Without its area element a quad's layer leaves the range that with it it does not.
    const bool in_own_unit = normalised_ ? !comfortable : has_area_elements_;
    sum_in_unit(points, first, order, tables, in_own_unit ? -exponent_ : 0);
    if (has_area_elements_) {
      for (std::size_t p = 0; p < points.size(); ++p) to_own_unit(first + p, order, tables, -exponent_);
      return;
    }
    // Weights grow like 1/distance, and may leave double's range where coordinates, which have no unit, do not. Other
    // elements' parts have infinities of both signs in cages whose own unit is tiny.
    if (!normalised_ && (comfortable || exponent_ > 0 || !homogeneous_)) return;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (!is_finite(first + p, normalised_ ? 0 : order, tables)) {
        clear(first + p, order, tables);
        const int exponent = (normalised_ ? kSmallUnit<R> : 0) - exponent_;
        sum_in_unit<R>(points.subspan(p, 1), first + p, order, tables, exponent);
        if (!normalised_) to_own_unit(first + p, order, tables, exponent);
      }
  }

  // Next to an edge or a vertex derivatives of elements' integrals leave R's range, where those of the coordinates need
  // not: the elements' infinities have opposite signs. Their terms are summed in Wide's range and digits. Rows stay as
  // they are where an evaluation does not have these.
  template <Scalar R>
  void sum_beyond_range(const Vec3<R>& point, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    if (!goes_beyond_range()) return;
    const int exponent = has_area_elements_ ? -exponent_ : 0;
    auto wide = zero_tables<Wide>(blocks_, elements_->dimension(), 1, order);
    TermSizes sizes(wide);
    const auto part_of = parts_beyond_range(point, order, exponent, wide, sizes);
    Result<Wide> part;
    for (std::size_t e = 0; e < elements_->count(); ++e)
      for (std::size_t b = 0; b < blocks_.size(); ++b) {
        part_of(e, b, false, part);
        BatchOutput<Wide> here = output_for(b, 0, wide[b]);
        here.slots = elements_->shares_of(e, blocks_[b].owner);
        for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
      }
    if (normalised_) {
      const auto sum =
          static_cast<long double>(std::accumulate(wide[0].tensors[0].begin(), wide[0].tensors[0].end(), Wide(0)));
      finish_sums<Wide>(0, order, wide, exponent);
      sizes.normalise(order, elements_->dimension(), std::abs(sum),
                      leading(wide[0].tensors[0].data(), wide[0].tensors[0].size()));
      sizes.drop_roundings(wide);
    } else {
      sizes.drop_roundings(wide);
      finish_sums<Wide>(0, order, wide, exponent);
    }
    if (has_area_elements_) to_own_unit<Wide>(0, order, wide, exponent);
    put_rounded<R>(wide, p, order, tables);
  }

  using Wide = Mp200;
  bool goes_beyond_range() const {
    return std::ranges::all_of(evaluations_, [](const ElementEvaluations& of_kind) {
      return std::ranges::all_of(of_kind, [](const Evaluation& e) { return e.supports<Wide>(); });
    });
  }

  // A function (element, block, Batch::finite_part, result) of the elements' integrals at a point.
  template <Scalar R>
  auto parts_in_range(const Vec3<R>& point, int order, int exponent) const {
    return [this, near = in_unit(point, exponent), order, exponent,
            parameters = std::vector<R>(parameters_.begin(), parameters_.end())](std::size_t e, std::size_t b,
                                                                                 bool finite_part, Result<R>& part) {
      std::array<Vec3<R>, 4> storage;
      evaluations_[static_cast<std::size_t>(elements_->type(e).kind)][b](
          Query<R>{corners_of(e, storage, exponent), near, order, parameters, finite_part}, part);
    };
  }

  // The parts that are finite in R as parts_in_range() gives them, and the others computed in Wide. \param sizes of the
  // terms in `tables`
  template <Scalar R>
  auto parts_beyond_range(const Vec3<R>& point, int order, int exponent, std::vector<CoordinateTable<Wide>>& tables,
                          TermSizes& sizes) const {
    return [this, order, &tables, &sizes, in_range = parts_in_range(point, order, exponent),
            beyond = parts_in_range(convert<Wide>(point), order, exponent)](std::size_t e, std::size_t b,
                                                                            bool finite_part, Result<Wide>& part) {
      Result<R> rounded;
      in_range(e, b, finite_part, rounded);
      bool finite = true;
      for (int o = 0; o <= order; ++o) finite = finite && are_finite<R>(rounded.of(o));
      if (!finite) beyond(e, b, finite_part, part);
      for (int o = 0; finite && o <= order; ++o) part.of(o).assign(rounded.of(o).begin(), rounded.of(o).end());
      BatchOutput<Wide> here = output_for(b, 0, tables[b]);
      here.slots = elements_->shares_of(e, blocks_[b].owner);
      sizes.add(b, order, part, here);
    };
  }

  // Derivatives next to the cage, where the quotient of weights loses digits that they have (NextToCage): elements that
  // the point is next to are computed in as many as that takes, and the quotient is. \return whether the point is one
  // of these
  template <Scalar R>
  bool sum_next_to_cage(const Vec3<R>& point, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    if (!next_to_ || order == 0) return false;
    const Vec3<double> seen = convert<double>(point);
    const NextToCage::Found next_to = next_to_->at(seen, order);
    if (next_to.order > order) return false;
    if constexpr (std::same_as<R, float>) {
      // Double has the digits, or takes more.
      auto in_double = zero_tables<double>(blocks_, elements_->dimension(), 1, order);
      sum_off<double>(std::span(&seen, 1), 0, order, in_double);
      for (int o = 0; o <= order; ++o)
        std::ranges::transform(in_double[0].tensors[o], row_of(tables[0], p, o).begin(),
                               [](double x) { return static_cast<float>(x); });
      return true;
    }
    unsigned left = 0;  // orders that are to be put, a bit each
    for (int o = 0; o <= order; ++o)
      if (o == 0 || o >= next_to.order || !is_finite(p, o, tables)) left |= 1u << o;
    const auto put = [&](int o, std::span<const double> numbers) {
      std::ranges::transform(numbers, row_of(tables[0], p, o).begin(), [](double x) { return static_cast<R>(x); });
    };
    left &= ~put_in_digits<Mp50>(seen, {convert<Mp50>(seen)}, next_to.elements, order, left, put);
    if (left != 0) left &= ~put_in_digits<Mp100>(seen, {convert<Mp100>(seen)}, next_to.elements, order, left, put);
    if (left != 0) left &= ~put_in_digits<Mp200>(seen, {convert<Mp200>(seen)}, next_to.elements, order, left, put);
    if (left != 0 && !has_quads()) {
      const MovedOff moved = moved_off(corners_of_some(next_to.elements), convert<Mp200>(seen));
      left &= ~put_in_digits<Mp200>(seen, {moved.point, moved.further}, next_to.elements, order, left, put);
    }
    // Nobody knows the rest.
    for (int o = 1; o <= order; ++o)
      if ((left >> o & 1u) != 0) std::ranges::fill(row_of(tables[0], p, o), std::numeric_limits<R>::quiet_NaN());
    return true;
  }

  std::vector<std::vector<Vec3<Mp200>>> corners_of_some(const std::vector<char>& which) const {
    std::vector<std::vector<Vec3<Mp200>>> found;
    std::array<Vec3<Mp200>, 4> storage;
    for (std::size_t e = 0; e < which.size(); ++e) {
      if (which[e] == 0) continue;
      const auto corners = corners_of(e, storage);
      found.emplace_back(corners.begin(), corners.end());
    }
    return found;
  }

  // Where elements that a point is next to see it, and how many times the Hessians there those of the point are.
  template <Scalar W>
  struct SeenAt {
    Vec3<W> point;
    W further = 1;
  };

  // Calls put(order, numbers) of coordinates whose weights of some elements are computed in W, of others in double.
  // \param asked orders, a bit each \return those of them that these digits are enough for, which are put
  template <Scalar W, class Put>
  unsigned put_in_digits(const Vec3<double>& point, const SeenAt<W>& at, const std::vector<char>& beside, int order,
                         unsigned asked, const Put& put) const {
    const int exponent = std::abs(exponent_) <= kComfortable<double> ? 0 : -exponent_;
    auto wide = zero_tables<W>(blocks_, elements_->dimension(), 1, order);
    TermSizes sizes(wide);
    const std::vector<W> parameters(parameters_.begin(), parameters_.end());
    const auto in_double = parts_in_range(point, order, exponent);
    std::array<Vec3<W>, 4> storage;
    Result<double> rounded;
    Result<W> part;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      if (beside[e] != 0) {
        more_digits_[static_cast<std::size_t>(elements_->type(e).kind)](
            Query<W>{corners_of(e, storage, exponent), in_unit(at.point, exponent), order, parameters}, part);
      } else {
        in_double(e, 0, false, rounded);
        for (int o = 0; o <= order; ++o) part.of(o).assign(rounded.of(o).begin(), rounded.of(o).end());
      }
      BatchOutput<W> here = output_for(0, 0, wide[0]);
      here.slots = elements_->shares_of(e, blocks_[0].owner);
      for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
      sizes.add(0, order, part, here);
    }
    std::vector<W>& values = wide[0].tensors[0];
    const W sum = std::accumulate(values.begin(), values.end(), W(0));
    std::array<W*, 3> weights{};
    for (int o = 0; o <= order; ++o) weights[o] = wide[0].tensors[o].data();
    normalise(weights, values.size(), elements_->dimension(), order);
    sizes.normalise(order, elements_->dimension(), std::abs(static_cast<long double>(sum)),
                    leading(values.data(), values.size()));
    unsigned found = 0;
    for (int o = 0; o <= order; ++o) {
      const W times = o == 2 ? at.further : W(1);
      if ((asked >> o & 1u) == 0) continue;
      if (!sizes.leave_digits(wide[0], o,
                              std::ldexp(1.0L, -o * (exponent_ + exponent)) / static_cast<long double>(times)))
        continue;
      using std::ldexp;
      std::vector<double> numbers;
      for (const W& x : wide[0].tensors[o]) numbers.push_back(static_cast<double>(W(times * ldexp(x, o * exponent))));
      put(o, numbers);
      found |= 1u << o;
    }
    return found;
  }

  // One point's tables, rounded to a place in others.
  template <Scalar R>
  static void put_rounded(const std::vector<CoordinateTable<Wide>>& wide, std::size_t p, int order,
                          std::span<CoordinateTable<R>> tables) {
    for (std::size_t b = 0; b < wide.size(); ++b)
      for (int o = 0; o <= order; ++o)
        std::ranges::transform(wide[b].tensors[o], row_of(tables[b], p, o).begin(),
                               [](const Wide& x) { return static_cast<R>(x); });
  }

  template <Scalar R>
  static bool are_finite(std::span<const R> numbers) {
    return std::ranges::all_of(numbers, [](const R& x) { return x - x == R(0); });
  }

  // A point's part of a table.
  template <Scalar R>
  static std::span<R> row_of(CoordinateTable<R>& table, std::size_t p, int o) {
    return std::span<R>(table.tensors[o]).subspan(p * table.stride[o], table.stride[o]);
  }

  template <Scalar R>
  static bool is_finite(std::size_t p, int order, std::span<CoordinateTable<R>> tables) {
    for (CoordinateTable<R>& table : tables)
      for (int o = 0; o <= order; ++o)
        if (!are_finite<R>(row_of(table, p, o))) return false;
    return true;
  }

  template <Scalar R>
  static void clear(std::size_t p, int order, std::span<CoordinateTable<R>> tables) {
    for (CoordinateTable<R>& table : tables)
      for (int o = 0; o <= order; ++o) std::ranges::fill(row_of(table, p, o), R(0));
  }

  // Converts the rows of point p from the unit 2^-exponent to the cage's own.
  template <Scalar R>
  void to_own_unit(std::size_t p, int order, std::span<CoordinateTable<R>> tables, int exponent) const {
    using std::ldexp;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (int o = 0; o <= order; ++o)
        for (R& x : row_of(tables[b], p, o)) x = ldexp(x, (o - degrees_[b]) * exponent);
  }

  template <Scalar R>
  void sum_in_unit(std::span<const Vec3<R>> given, std::size_t first, int order, std::span<CoordinateTable<R>> tables,
                   int exponent) const {
    std::vector<Vec3<R>> moved;
    for (std::size_t p = 0; exponent != 0 && p < given.size(); ++p) moved.push_back(in_unit(given[p], exponent));
    const std::span<const Vec3<R>> points = exponent == 0 ? given : moved;
    const std::vector<R> parameters(parameters_.begin(), parameters_.end());
    std::vector<BatchOutput<R>> outputs;
    for (std::size_t b = 0; b < blocks_.size(); ++b) outputs.push_back(output_for(b, first, tables[b]));
    std::vector<const Evaluation*> members(blocks_.size());
    std::array<Vec3<R>, 4> storage;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      const ElementEvaluations& evaluations = evaluations_[static_cast<std::size_t>(elements_->type(e).kind)];
      for (std::size_t b = 0; b < blocks_.size(); ++b) {
        members[b] = &evaluations[b];
        outputs[b].slots = elements_->shares_of(e, blocks_[b].owner);
      }
      Evaluation::together<R>(members, Batch<R>{corners_of(e, storage, exponent), points, order, parameters}, outputs);
    }
    for (std::size_t p = 0; p < points.size(); ++p) finish_sums(first + p, order, tables, exponent);
  }

  // Finishes a point's sums in the unit 2^-exponent: normals are multiplied by their area elements, weights are divided
  // by their sum.
  template <Scalar R>
  void finish_sums(std::size_t p, int order, std::span<CoordinateTable<R>> tables, int exponent) const {
    if (has_area_elements_) times_area_elements_at(p, order, exponent, tables);
    if (!normalised_) return;
    std::array<R*, 3> weights{};
    for (int o = 0; o <= order; ++o) weights[o] = row_of(tables[0], p, o).data();
    normalise(weights, blocks_[0].size, elements_->dimension(), order);
    using std::ldexp;
    for (int o = 1; exponent != 0 && o <= order; ++o)
      for (R& x : row_of(tables[0], p, o)) x = ldexp(x, o * exponent);
  }

  // A point on the cage, which stands in the tables as point `p`. Derivatives have no limit on elements' borders, and
  // none of normalised kinds anywhere on the cage.
  template <Scalar R>
  void sum_on(const Vec3<R>& point, std::size_t p, int order, const std::vector<Touching>& on,
              std::span<CoordinateTable<R>> tables) const {
    const auto part_of = parts_in_range(point, order, 0);
    for (std::size_t b = 0; b < blocks_.size(); ++b) sum_on(b, part_of, p, order, on, tables[b]);
    if (has_area_elements_) times_area_elements_at(p, order, 0, tables);
    if constexpr (!is_multiprecision<R>) {
      if (normalised_ || on.size() > 1 || is_finite(p, order, tables) || !goes_beyond_range()) return;
      auto wide = zero_tables<Wide>(blocks_, elements_->dimension(), 1, order);
      TermSizes sizes(wide);
      const auto wide_part_of = parts_beyond_range(point, order, 0, wide, sizes);
      for (std::size_t b = 0; b < blocks_.size(); ++b) sum_on(b, wide_part_of, 0, order, on, wide[b]);
      sizes.drop_roundings(wide);
      if (has_area_elements_) times_area_elements_at<Wide>(0, order, 0, wide);
      put_rounded<R>(wide, p, order, tables);
    }
  }

  template <Scalar R, class PartOf>
  void sum_on(std::size_t b, const PartOf& part_of, std::size_t p, int order, const std::vector<Touching>& on,
              CoordinateTable<R>& table) const {
    const BatchOutput<R> output = output_for(b, p, table);
    const std::size_t width = output.entries;
    // Adds the matrix (or number) times each basis function at the point to its vertex.
    const auto add_basis = [&](const std::vector<R>& matrix) {
      const auto owners = elements_->shares_of(on.front().element, blocks_[b].owner);
      for (std::size_t c = 0; c < owners.size(); ++c)
        for (std::size_t i = 0; i < width; ++i)
          output.tensors[0][owners[c] * width + i] += static_cast<R>(on.front().basis[c]) * matrix[i];
    };
    if (normalised_) {
      add_basis({R(1)});
      for (int o = 1; o <= order; ++o)
        std::fill_n(output.tensors[o], table.stride[o], std::numeric_limits<R>::quiet_NaN());
      return;
    }
    const bool jumps = jumps_[b] != 0;
    std::vector<R> whole(width, R(0));  // what the elements that the point is not on leave of the whole
    for (std::size_t i = 0; i < width; i += blocks_[b].shape.columns + 1) whole[i] = R(jumps_[b]);
    Result<R> part;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      const auto owners = elements_->shares_of(e, blocks_[b].owner);
      const auto touch = std::ranges::find(on, static_cast<int>(e), &Touching::element);
      const bool touches = jumps && touch != on.end();
      part_of(e, b, touches, part);
      BatchOutput<R> here = output;
      here.slots = owners;
      for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
      if (!jumps) continue;
      // On the cage: the sum over all elements of int (basis - basis at the point) kernel, whose integrals exist, and
      // basis at the point.
      for (std::size_t i = 0; i < width; ++i) {
        R all = 0;
        for (std::size_t k = 0; k < owners.size(); ++k) all += part.value[k * width + i];
        if (!touches) whole[i] -= all;
        else
          for (std::size_t c = 0; c < owners.size(); ++c)
            output.tensors[0][owners[c] * width + i] -= static_cast<R>(touch->basis[c]) * all;
      }
    }
    if (jumps) add_basis(whole);
  }

  template <Scalar R>
  void put_limits(std::span<const Touching> places, int order, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < places.size(); ++p) put_limit<R>(places[p], p, order, tables);
    times_area_elements(places.size(), order, tables);
  }

  // The origin is moved to the element's first corner. The point's rounding is then relative to the element's size,
  // however far the origin is and however small the element is. A point on its own element is also put into that
  // element's plane, where its height is exactly zero.
  template <Scalar R>
  void put_limit(const Touching& place, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    if (!elements_->type(place.element).flat) return put_limit_on_quad(place, p, order, tables);
    const Vec3<R> origin = first_corner_in<R>(place.element);
    const ElementAxes<R> axes(corners_in<R>(place.element, origin));
    const std::vector<Vec3<R>>& flat = axes.corners();
    Vec3<R> in_plane = Vec3<R>::Zero();
    for (std::size_t k = 1; k < flat.size(); ++k) in_plane += R(place.basis[k]) * flat[k];
    const Vec3<R> point = axes.in_space(in_plane);
    const std::vector<R> parameters(parameters_.begin(), parameters_.end());
    Result<R> part;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      const bool own = static_cast<int>(e) == place.element;
      const std::vector<Vec3<R>> corners = own ? flat : corners_in<R>(e, origin);
      for (std::size_t b = 0; b < blocks_.size(); ++b) {
        evaluations_[static_cast<std::size_t>(elements_->type(e).kind)][b](
            Query<R>{corners, own ? in_plane : point, order, parameters}, part);
        if (own) axes.turn_to_space(order, part);
        BatchOutput<R> here = output_for(b, p, tables[b]);
        here.slots = elements_->shares_of(e, blocks_[b].owner);
        for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
      }
    }
  }

  // A bilinear quad has no plane to see the point in: it is seen in more digits, from so near inside that the limit is
  // as good as R. Others see the point from the quad's first corner.
  template <Scalar R>
  void put_limit_on_quad(const Touching& place, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    constexpr bool is_wide = is_multiprecision<R>;
    using W = std::conditional_t<is_wide, Mp100, Mp50>;
    const Vec3<R> origin = first_corner_in<R>(place.element);
    const std::vector<Vec3<W>> quad = corners_in<W>(place.element, first_corner_in<W>(place.element));
    const W u = W(place.basis[1]) + W(place.basis[2]), v = W(place.basis[2]) + W(place.basis[3]);
    const Vec3<W> along_u = (1 - v) * (quad[1] - quad[0]) + v * (quad[2] - quad[3]),
                  along_v = (1 - u) * (quad[3] - quad[0]) + u * (quad[2] - quad[1]);
    const Vec3<W> on = (1 - u) * quad[0] + u * quad[1] + v * along_v, normal = along_u.cross(along_v);
    const W size = sqrt(W(along_u.dot(along_u) + along_v.dot(along_v))), area = sqrt(W(normal.dot(normal)));
    const Vec3<W> inside = on - (size * W(is_wide ? "1e-40" : "1e-25") / area) * normal;
    const Vec3<R> rounded = convert<R>(on);
    const std::vector<R> parameters(parameters_.begin(), parameters_.end());
    const std::vector<W> wide_parameters(parameters_.begin(), parameters_.end());
    Result<R> part;
    Result<W> wide;
    for (std::size_t e = 0; e < elements_->count(); ++e) {
      const bool own = static_cast<int>(e) == place.element;
      for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Evaluation& evaluation = evaluations_[static_cast<std::size_t>(elements_->type(e).kind)][b];
        BatchOutput<R> here = output_for(b, p, tables[b]);
        here.slots = elements_->shares_of(e, blocks_[b].owner);
        if (own) evaluation(Query<W>{quad, inside, order, wide_parameters}, wide);
        else evaluation(Query<R>{corners_in<R>(e, origin), rounded, order, parameters}, part);
        for (int o = 0; o <= order; ++o) {
          if (own) {
            part.of(o).resize(wide.of(o).size());
            std::ranges::transform(wide.of(o), part.of(o).begin(), [](const W& x) { return static_cast<R>(x); });
          }
          here.put(0, o, part.of(o));
        }
      }
    }
  }

  template <Scalar R>
  Vec3<R> first_corner_in(std::size_t e) const {
    return convert<R>(elements_->vertices()[elements_->vertices_of(e)[0]]);
  }

  template <Scalar R>
  std::vector<Vec3<R>> corners_in(std::size_t e, const Vec3<R>& origin) const {
    std::vector<Vec3<R>> corners;
    corners.reserve(4);
    for (const int v : elements_->vertices_of(e)) corners.push_back(convert<R>(elements_->vertices()[v]) - origin);
    return corners;
  }

  // Cages whose largest coordinate has an exponent of at most this magnitude are summed in their own unit.
  template <Scalar R>
  static constexpr int kComfortable = std::same_as<R, float> ? 40 : 300;
  // The exponent of the size to which cages are scaled where weights would overflow: second derivatives at the least
  // distance then do not.
  template <Scalar R>
  static constexpr int kSmallUnit = std::same_as<R, float> ? 100 : 800;

  bool normalised_;
  std::shared_ptr<const CageElements> elements_;
  int exponent_;  // of the largest coordinate
  std::vector<double> parameters_;
  std::array<ElementEvaluations, element_kinds.size()> evaluations_;
  std::array<Evaluation, element_kinds.size()> more_digits_;  // of weights next to the cage
  std::optional<NextToCage> next_to_;                         // of normalised kinds that have more digits there
  std::vector<CoordinateBlock> blocks_;
  std::vector<double> jumps_;  // of blocks, at faces
  std::vector<int> degrees_;   // of blocks
  bool has_area_elements_ = false;
  bool homogeneous_ = true;  // whether no block has a logarithm of the unit
  int max_order_ = 2;
};

}  // namespace

std::shared_ptr<const PreparedCoordinates> prepare_sum(const CoordinateKind& kind,
                                                       std::shared_ptr<const CageElements> elements,
                                                       const CoordinateOptions& options) {
  return std::make_shared<SummedCoordinates>(kind, std::move(elements), options);
}

}  // namespace cageproof
