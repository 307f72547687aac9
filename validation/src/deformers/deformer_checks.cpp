// SPDX-License-Identifier: MIT
#include "deformer_checks.h"

#include "deformers/deformer_route.h"
#include "deformers/rounded_pose.h"
#include "sampling/generic_direction.h"

#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/deformation/stretch.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using deformation::Deformer;
using deformation::Images;
using deformation::Posed;

// A system with a condition up to this leaves images all their digits but three.
constexpr double harmless_condition = 1e3;

// No condition excuses more: a deformer states its own.
constexpr double most_excused = 1e8;

// Four roundings of a coordinate of this size, as keeps_offset allows them, are the 1e-13 sizes that images are made
// to.
constexpr double harmless_rounding = 2.5e-14;

// Images that are promised to 1e-13 sizes keep their first seven digits whatever the condition, and five whatever
// coordinates are rounded by, so that no promise is kept without a right digit.
constexpr double largest_factor = 1e6, largest_of_rounding = 1e8;

// The worst condition of the systems solved for the cage or the pose; one where none was. A singular system has none:
// its least-norm solution is as good as others. The cost of rounding posed vertices, which a deformer states within a
// factor of ten, counts as the condition that would cost as much.
template <class R>
double condition_of(const Deformer<R>& deformer, const Posed<R>& posed) {
  constexpr double rounding = 1e-16, stated_within = 10;
  double worst = std::max(1., stated_within * posed.report().pose_rounding / rounding);
  for (const auto& systems : {deformer.prepared().systems, posed.report().systems})
    for (const SolvedSystem& system : systems)
      if (!system.is_singular() && std::isfinite(system.condition)) worst = std::max(worst, system.condition);
  return worst;
}

// Made when first asked for, by a question that may be copied.
template <class Make>
auto lazily(Make make) {
  return std::make_shared<const Lazy<std::invoke_result_t<Make>>>(std::move(make));
}

Vec3<double> image_at(const Deformer<double>& deformer, const Posed<double>& posed, const Vec3<double>& point, int d) {
  const Images<double> images = images_at(deformer, posed, point, 0);
  Vec3<double> image = Vec3<double>::Zero();
  for (int c = 0; c < d; ++c) image[c] = images.tensors[0][c];
  return image;
}

}  // namespace

double Excuses::factor() const {
  const double of_rounding = std::clamp(rounding / harmless_rounding, 1.0, largest_of_rounding),
               of_condition = std::max(1.0, std::min(condition, most_excused) / harmless_condition);
  // Vertices, points and images a billion sizes off are doubles of six digits, whatever is computed with them.
  return std::max(of_rounding, std::min(largest_factor, of_condition * of_rounding));
}

DeformerError excused(double plain, const Excuses& excuses) { return {plain / excuses.factor(), plain}; }

double rounding_of_coordinates(const Cage& cage, const std::vector<Vec3<double>>& posed) {
  const double largest = std::max(largest_coordinate(cage.vertices()), largest_coordinate(posed));
  return unit_roundoff<double>() * largest / cage.size();
}

std::vector<DeformerVariant> variants_of(const deformation::DeformMethod& method) {
  const std::vector<KindParameter> parameters = deformation::parameters_of(method);
  std::vector<double> presets;
  presets.reserve(parameters.size());
  for (const KindParameter& p : parameters) presets.push_back(p.preset);
  // The method's own come first.
  const auto& own = method.parameters;
  std::vector<DeformerVariant> variants;
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t value = 0; value < own[i].names.size(); ++value) {
      const auto chosen = static_cast<double>(value);
      const bool is_default = chosen == own[i].preset;
      // The defaults go by the name of the first.
      if (is_default && std::ranges::any_of(variants, &DeformerVariant::is_default)) continue;
      variants.push_back({&method, fmt::format("{}={}", own[i].name, own[i].names[value]), presets, is_default});
      variants.back().parameters[i] = chosen;
    }
  if (variants.empty()) return {{&method, "", presets}};
  return variants;
}

DeformerVariant variant_named(const deformation::DeformMethod& method, std::string_view name) {
  for (DeformerVariant& variant : variants_of(method))
    if (variant.name == name) return std::move(variant);
  throw unknown_name(fmt::format("variant of {}", method.name), name);
}

DeformerChecks::DeformerChecks(std::shared_ptr<const Cage> cage, DeformerVariant variant, Triangulation rule,
                               const Deformer<double>* like)
    : cage_(std::move(cage)),
      variant_(std::move(variant)),
      rule_(rule),
      deformer_(like != nullptr ? like->with_parameters(variant_.parameters) : nullptr),
      in_50_digits_([this] { return prepared<Mp50>(""); }),
      bent_(cage_, [this] { return deformer_; }),
      bent_in_50_digits_(cage_, [this] { return in_50_digits_.get(); }),
      products_(
          cage_, *variant_.method, [this] { return deformer_; }, [this] { return in_50_digits_.get(); }),
      seen_from_(bent(*cage_).front()),
      prior_() {
  if (!deformer_) deformer_ = prepared<double>("");
  prior_ = prior_of(*cage_, deformer_->coordinates().kind(), rule);
}

template <class R>
DeformerChecks::Prepared<R> DeformerChecks::prepared(const std::string& evaluation) const {
  return deformation::prepare_deformer<R>(
      *variant_.method, *cage_, {.evaluation = evaluation, .triangulation = rule_, .parameters = variant_.parameters});
}

bool DeformerChecks::has_few_elements() const {
  const CageElements& elements = deformer_->coordinates().elements();
  return elements.count() <= few_elements && elements.count(Owner::Normal) <= 2 * few_elements;
}

bool DeformerChecks::has_50_digits() const {
  const CageCoordinates& coordinates = deformer_->coordinates();
  return coordinates.is_exact_in(ScalarKind::Digits50) && coordinates.is_prompt_in(ScalarKind::Digits50);
}

bool DeformerChecks::is_prompt_in_50_digits() const {
  // On quads a point takes a tenth of a second, and variants share the coordinates and all that is made of them.
  if (deformer_->coordinates().kind().keeps_quads && !variant_.is_default) return false;
  if (!has_50_digits()) return false;
  return deformer_->prepared().systems.empty() || (variant_.is_default && has_few_elements());
}

std::optional<std::string> DeformerChecks::quadrature() const {
  const CoordinateKind& kind = deformer_->coordinates().kind();
  if (!kind.is_sum() || !has_few_elements() || !variant_.is_default || variant_.method->takes_derivatives_on_cage)
    return std::nullopt;
  const auto& evaluations = EvaluationRegister::instance();
  const std::vector<const Formula*> formulas = formulas_of(kind, *cage_);
  for (const EvaluationFamily* family : evaluations.families(formulas.front()->name)) {
    if (family->role != Role::Rule) continue;
    const Evaluation example = family->example();
    if (example.cost() != CostClass::Adaptive) continue;
    const auto has = [&](const Formula* formula) {
      return evaluations.find(formula->name, example.name()).has_value();
    };
    if (std::ranges::all_of(formulas, has)) return example.name();
  }
  return std::nullopt;
}

Question<PointAt> DeformerChecks::question(std::string_view check, std::string_view pose, ScalarKind scalar, int lowest,
                                           int highest, Ask ask) const {
  Question<PointAt> question;
  question.key = {RowKey::Section::Deformer,
                  std::string(variant_.method->name),
                  variant_.name,
                  std::string(name_of(scalar)),
                  cage_->name(),
                  std::string(check),
                  std::string(pose),
                  0};
  question.unit = "cage sizes";
  question.orders = {lowest, highest};
  question.ask = [this, lowest, highest, ask = std::move(ask)](const PointAt& at) {
    const Errors errors = ask(at.point);
    std::array<Finding, 3> found;
    for (int o = lowest; o <= highest; ++o) {
      if (!std::isnan(errors[o].error)) found[o] = {Finding::Status::Measured, errors[o].error, errors[o].plain};
      else found[o].status = may_be_missing(prior_, at.point) ? Finding::Status::NoTruth : Finding::Status::Unreached;
    }
    return found;
  };
  return question;
}

std::vector<Question<PointAt>> DeformerChecks::questions() const {
  std::vector<Question<PointAt>> all;
  constexpr ScalarKind in_double = ScalarKind::Double;
  for (const SpaceMap& map : space_maps(cage_->dimension())) {
    all.push_back(question(map.check, map.pose, in_double, 0, 0, kept(map, false)));
    if (variant_.method->takes_normal_derivatives && map.pose == "linear")
      all.push_back(question("keeps_linear_with_normals", map.pose, in_double, 0, 0, kept(map, true)));
  }
  if (variant_.is_default && has_few_elements())
    for (const SpaceMap& offset : offsets(cage_->dimension())) {
      all.push_back(question(offset.check, offset.pose, in_double, 0, 0, kept_far_off(offset)));
      all.back().unit = "roundings";
    }
  const CageElements faces(*cage_, true, rule_);
  for (int axis = 0; axis < cage_->dimension(); ++axis) {
    const auto mirror = mirror_symmetry(cage_->vertices(), axis);
    if (!mirror || !keeps(*mirror, faces)) continue;
    const bool whole = keeps(*mirror, deformer_->coordinates().elements());
    all.push_back(question(whole ? "keeps_symmetry" : "keeps_symmetry_of_quads", symmetric_poses[axis], in_double, 0, 0,
                           mirrored(*mirror)));
  }
  const int highest = deformer_->max_order();
  const bool prompt = is_prompt_in_50_digits();
  if (prompt) all.push_back(question("deformer_truth", bent_pose, in_double, 0, highest, compared_with_truth(highest)));
  if (highest > 0)
    all.push_back(question("deformer_jacobian", bent_pose, prompt ? ScalarKind::Digits50 : in_double, 1, highest,
                           prompt ? differences<Mp50>() : differences<double>()));
  if (quadrature())
    all.push_back(question("deformer_by_quadrature", bent_pose, in_double, 0, 0, compared_with_quadrature()));
  add_products(all);
  if (has_second_route())
    all.push_back(question("second_route", bent_pose, ScalarKind::Digits50, 0, 0, compared_with_second_route()));
  return all;
}

void DeformerChecks::add_products(std::vector<Question<PointAt>>& all) const {
  // By default parameters each method that says so has a derivative: a lost one is no reason not to ask.
  if (!products_.exist() && !(variant_.is_default && variant_.method->has_pose_derivative)) return;
  const auto add = [&](const char* check, auto error) {
    all.push_back(question(check, bent_pose, ScalarKind::Double, 0, 0, [this, error](const Vec3<double>& point) {
      return Errors{excused(error(point), with_condition(condition_of(*deformer_, bent_.posed())))};
    }));
  };
  // One point in 50 digits takes a tenth of a second on a few quads, and all variants are one code.
  const bool on_many_quads = deformer_->coordinates().kind().keeps_quads && !has_few_elements();
  if (is_prompt_in_50_digits() && !on_many_quads)
    add("pose_derivative", [this](const Vec3<double>& point) { return products_.error_of_jvp<Mp50>(point); });
  else
    add("pose_derivative_in_double",
        [this](const Vec3<double>& point) { return products_.error_of_jvp<double>(point); });
  add("pose_derivative_transposed",
      [this](const Vec3<double>& point) { return products_.roundings_of_adjoint(point); });
  all.back().unit = "roundings";
}

DeformerChecks::Ask DeformerChecks::kept(const SpaceMap& map, bool with_normals) const {
  const double size = cage_->size();
  deformation::Pose<double> pose{posed_by(map, *cage_)};
  deformation::Pose<Mp50> exact;
  for (const Vec3<double>& v : cage_->vertices()) exact.vertices.push_back(map.exactly<Mp50>(v, size));
  const CageElements& elements = deformer_->coordinates().elements();
  const Owner owner = deformation::normals_owner(deformer_->coordinates());
  SpaceMap of_normals{.linear = map.linear};
  for (std::size_t i = 0; with_normals && i < elements.count(owner); ++i) {
    pose.normal_derivatives.push_back(map.linear * elements.normal_of(i, owner));
    exact.normal_derivatives.push_back(of_normals.exactly<Mp50>(elements.normal_of(i, owner), size));
  }
  const auto rounded = std::make_shared<const RoundedPose>(
      [this] { return in_50_digits_.get(); },
      deformation::Pose<Mp50>{in<Mp50>(pose.vertices), in<Mp50>(pose.normal_derivatives)}, std::move(exact));
  const auto vertices = std::make_shared<const std::vector<Vec3<double>>>(pose.vertices);
  const auto posed = lazily([this, pose = std::move(pose)] { return deformer_->pose(pose); });
  const std::string_view check = with_normals ? "keeps_linear_with_normals" : map.check;
  const auto promised = promise_for({check, variant_.method->name, variant_.name, "double", cage_->name(), 0}).bound;
  return [this, map, size, vertices, posed, rounded, promised](const Vec3<double>& point) {
    const int d = cage_->dimension();
    const Vec3<double> image = image_at(*deformer_, *posed->get(), point, d);
    const Vec3<long double> expected = map.exactly(point, size);
    Vec3<double> difference = Vec3<double>::Zero();
    for (int c = 0; c < d; ++c) difference[c] = static_cast<double>(image[c] - expected[c]);
    const Excuses excuses = with_condition(condition_of(*deformer_, *posed->get()), *vertices);
    DeformerError found = excused(difference.norm() / size, excuses);
    // 50 digits take seconds, and only next to small elements do roundings of vertices move images so far.
    if (promised && found.error > *promised && has_few_elements() && has_50_digits())
      found.error = excused((difference - rounded->moves(point)).norm() / size, excuses).error;
    return Errors{found};
  };
}

DeformerChecks::Ask DeformerChecks::kept_far_off(const SpaceMap& offset) const {
  const auto vertices = std::make_shared<const std::vector<Vec3<double>>>(posed_by(offset, *cage_));
  const auto deformer = lazily([this, vertices] {
    return deformation::prepare_deformer<double>(*variant_.method, cage_->with(*vertices, cage_->faces()),
                                                 {.triangulation = rule_, .parameters = variant_.parameters});
  });
  const auto posed = lazily([vertices, deformer] { return deformer->get()->pose({*vertices}); });
  const double rounding = unit_roundoff<double>() * largest_coordinate(*vertices);
  return [this, offset, rounding, deformer, posed](const Vec3<double>& point) {
    const int d = cage_->dimension();
    const Vec3<double> there = offset(point, cage_->size());
    const Vec3<double> image = image_at(*deformer->get(), *posed->get(), there, d);
    return Errors{excused((image - there).norm() / rounding, {condition_of(*deformer->get(), *posed->get())})};
  };
}

DeformerChecks::Ask DeformerChecks::mirrored(const MirrorSymmetry& mirror) const {
  const auto posed = lazily([this, mirror] { return deformer_->pose({made_symmetric(mirror, bent(*cage_))}); });
  return [this, mirror, posed](const Vec3<double>& point) {
    const int d = cage_->dimension();
    const Vec3<double> here = image_at(*deformer_, *posed->get(), point, d),
                       there = image_at(*deformer_, *posed->get(), mirror(point), d);
    return Errors{excused((there - mirror(here)).norm() / cage_->size(),
                          with_condition(condition_of(*deformer_, *posed->get())))};
  };
}

DeformerChecks::Ask DeformerChecks::compared_with_truth(int order) const {
  return [this, order](const Vec3<double>& point) {
    return compared(bent_.at(point, order), bent_in_50_digits_.at(point, order), order,
                    condition_of(*deformer_, bent_.posed()));
  };
}

DeformerChecks::Ask DeformerChecks::compared_with_quadrature() const {
  const auto other = lazily([this] { return prepared<double>(quadrature().value()); });
  const auto other_posed = lazily([this, other] { return other->get()->pose({bent(*cage_)}); });
  return [this, other, other_posed](const Vec3<double>& point) {
    Images<Mp50> expected;
    const Images<double> integrated = images_at(*other->get(), *other_posed->get(), point, 0);
    for (const double x : integrated.tensors[0]) expected.tensors[0].emplace_back(x);
    return compared(bent_.at(point, 0), expected, 0, condition_of(*deformer_, bent_.posed()));
  };
}

DeformerChecks::Errors DeformerChecks::compared(const Images<double>& images, const Images<Mp50>& with, int order,
                                                double condition) const {
  Errors errors;
  for (int o = 0; o <= order; ++o) {
    Mp50 sum = 0;
    for (std::size_t i = 0; i < images.tensors[o].size(); ++i) {
      const Mp50 difference = Mp50(images.tensors[o][i]) - with.tensors[o][i];
      sum += difference * difference;
    }
    const double size = cage_->size(), found = std::sqrt(static_cast<double>(sum)) * std::pow(size, o - 1);
    errors[o] = excused(found, with_condition(condition));
    errors[o].error /= own_size(with.tensors[o], o, size, seen_from_);
  }
  return errors;
}

bool DeformerChecks::has_second_route() const {
  // In the plane all variants take a moment, in space each half a second.
  if (!has_few_elements() || (cage_->dimension() == 3 && !variant_.is_default)) return false;
  return layer_method_of(variant_, cage_->size()).has_value();
}

DeformerChecks::Ask DeformerChecks::compared_with_second_route() const {
  // In the plane, where preparing takes a moment, of a turned cage: of axis-parallel edges, which most polygons have,
  // half of the normals' components are zero. In space the deformer is that of deformer_truth.
  const bool is_turned = cage_->dimension() == 2;
  const auto maps = space_maps(cage_->dimension());
  const SpaceMap map = is_turned ? *std::ranges::find(maps, "rotation", &SpaceMap::pose) : SpaceMap{};
  const auto cage = lazily([this, map] { return cage_->with(posed_by(map, *cage_), cage_->faces()); });
  const auto deformer = lazily([this, is_turned, cage] {
    if (!is_turned) return in_50_digits_.get();
    return deformation::prepare_deformer<Mp50>(*variant_.method, cage->get(),
                                               {.triangulation = rule_, .parameters = variant_.parameters});
  });
  const auto posed = lazily([cage, deformer] { return deformer->get()->pose({in<Mp50>(bent(cage->get()))}); });
  const auto route = lazily([this, cage, deformer] {
    return std::make_shared<const second_routes::LayerRoute>(
        deformer->get()->coordinates(), *layer_method_of(variant_, cage_->size()), bent(cage->get()));
  });
  return [this, map, deformer, posed, route](const Vec3<double>& at) {
    const Vec3<double> point = map(at, cage_->size());
    const Images<Mp50> images = images_at(*deformer->get(), *posed->get(), convert<Mp50>(point), 0);
    Vec3<Mp200> difference = route->get()->image_of(point);
    for (int c = 0; c < cage_->dimension(); ++c) difference[c] -= Mp200(images.tensors[0][c]);
    const auto error = static_cast<double>(Mp200(sqrt(Mp200(difference.dot(difference)))));
    return Errors{excused(error / cage_->size(), {})};
  };
}

template <class R>
const BentImages<R>& DeformerChecks::bent_images() const {
  if constexpr (is_multiprecision<R>) return bent_in_50_digits_;
  else return bent_;
}

template <class R>
DeformerChecks::Ask DeformerChecks::differences() const {
  return [this](const Vec3<double>& at) {
    using std::sqrt;
    const int d = cage_->dimension(), highest = deformer_->max_order();
    // The truncation error is the step squared, the rounding error one rounding over the step.
    const R step = R(cage_->size()) * (is_multiprecision<R> ? R(1e-16) : R(0x1p-17));
    // One direction that no symmetry knows tells as much of a tensor as all axes do, from a third of the images.
    const Vec3<R> point = convert<R>(at), direction = generic_direction<R>(at, d);
    const Vec3<R> above = point + step * direction, below = point - step * direction;
    // The step as it was taken: far from the origin points are rounded.
    const Vec3<R> taken = above - below;
    const BentImages<R>& images = bent_images<R>();
    const Images<R> here = images.at(at, highest), up = images.of(above, highest - 1),
                    down = images.of(below, highest - 1);
    Errors errors;
    for (int o = 1; o <= highest; ++o) {
      const std::vector<R> changes = along(taken, here.tensors[o], d);
      R sum = 0;
      for (std::size_t i = 0; i < changes.size(); ++i) {
        const R difference = (changes[i] - (up.tensors[o - 1][i] - down.tensors[o - 1][i])) / (2 * step);
        sum += difference * difference;
      }
      const double size = cage_->size(), found = static_cast<double>(R(sqrt(sum))) * std::pow(size, o - 1);
      // A step's own error grows with the map, as roundings do.
      errors[o] = {found / own_size(here.tensors[o], o, size, seen_from_), found};
    }
    return errors;
  };
}

}  // namespace cageproof::validation
