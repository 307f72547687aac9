// SPDX-License-Identifier: MIT
#include "cageproof/validation/deformer_checks.h"

#include "cageproof/core/unknown_name.h"
#include "cageproof/deformation/stretch.h"

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

template <class R>
std::vector<Vec3<R>> in(const std::vector<Vec3<double>>& points) {
  std::vector<Vec3<R>> found;
  found.reserve(points.size());
  for (const Vec3<double>& p : points) found.push_back(convert<R>(p));
  return found;
}

// Of the worst system that was solved for the cage or for the pose; one where none was. A singular system has none: its
// solution of least norm is as good as those of others.
template <class R>
double condition_of(const Deformer<R>& deformer, const Posed<R>& posed) {
  double worst = 1;
  for (const auto& systems : {deformer.prepared().systems, posed.report().systems})
    for (const SolvedSystem& system : systems)
      if (!system.is_singular() && std::isfinite(system.condition)) worst = std::max(worst, system.condition);
  return worst;
}

// Each point by itself, so that a case of one point is what it was among others: products of larger matrices sum in
// another order.
template <class R>
Images<R> images_one_by_one(const Deformer<R>& deformer, const Posed<R>& posed, std::span<const Vec3<R>> points,
                            int order) {
  Images<R> all;
  for (const Vec3<R>& point : points) {
    const Images<R> one = deformer.images(posed, std::span(&point, 1), order);
    for (int o = 0; o <= order; ++o)
      all.tensors[o].insert(all.tensors[o].end(), one.tensors[o].begin(), one.tensors[o].end());
  }
  return all;
}

}  // namespace

DeformerError error_over_condition(double plain, double condition) {
  return {plain / std::max(1.0, std::min(condition, most_excused) / harmless_condition), plain};
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

bool DeformerChecks::is_prompt_in_50_digits() const {
  const CageCoordinates& coordinates = deformer_->coordinates();
  // On quads a point takes a tenth of a second, and variants share the coordinates and all that is made of them.
  if (coordinates.kind().keeps_quads && !variant_.is_default) return false;
  if (!coordinates.is_exact_in(ScalarKind::Digits50) || !coordinates.is_prompt_in(ScalarKind::Digits50)) return false;
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

std::vector<DeformerChecks::Question> DeformerChecks::questions() const {
  std::vector<Question> all;
  const std::string bent_name(bent_pose);
  for (const SpaceMap& map : space_maps(cage_->dimension()))
    all.push_back({std::string(map.check), std::string(map.pose), ScalarKind::Double, 0, 0});
  if (variant_.method->takes_normal_derivatives)
    all.push_back({"keeps_linear_with_normals", "linear", ScalarKind::Double, 0, 0});
  const CageElements faces(*cage_, true, rule_);
  for (int axis = 0; axis < cage_->dimension(); ++axis) {
    const auto mirror = mirror_symmetry(cage_->vertices(), axis);
    if (!mirror || !keeps(*mirror, faces)) continue;
    const bool whole = keeps(*mirror, deformer_->coordinates().elements());
    all.push_back({whole ? "keeps_symmetry" : "keeps_symmetry_of_quads", std::string(symmetric_poses[axis]),
                   ScalarKind::Double, 0, 0});
  }
  const int highest = deformer_->max_order();
  const bool prompt = is_prompt_in_50_digits();
  if (prompt) all.push_back({"deformer_truth", bent_name, ScalarKind::Double, 0, highest});
  if (highest > 0)
    all.push_back({"deformer_jacobian", bent_name, prompt ? ScalarKind::Digits50 : ScalarKind::Double, 1, highest});
  if (quadrature()) all.push_back({"deformer_by_quadrature", bent_name, ScalarKind::Double, 0, 0});
  return all;
}

std::vector<DeformerChecks::Errors> DeformerChecks::ask(const Question& question,
                                                        std::span<const Vec3<double>> points) const {
  for (const SpaceMap& map : space_maps(cage_->dimension())) {
    if (map.pose != question.pose) continue;
    if (map.check == question.check) return kept(map, false, points);
    if (question.check == "keeps_linear_with_normals") return kept(map, true, points);
  }
  if (const auto pose = std::ranges::find(symmetric_poses, question.pose); pose != symmetric_poses.end())
    return mirrored(mirror_symmetry(cage_->vertices(), static_cast<int>(pose - symmetric_poses.begin())).value(),
                    points);
  if (question.check == "deformer_jacobian")
    return question.scalar == ScalarKind::Double ? differences<double>(*deformer_, points)
                                                 : differences<Mp50>(*in_50_digits_.get(), points);
  const bool truth = question.check == "deformer_truth";
  if (!truth && question.check != "deformer_by_quadrature") throw unknown_name("check", question.check);
  const std::vector<Vec3<double>> vertices = bent(*cage_);
  const auto posed = deformer_->pose({vertices});
  const double condition = condition_of(*deformer_, *posed);
  const int order = question.highest_order;
  const Images<double> found = images_one_by_one(*deformer_, *posed, points, order);
  Images<Mp50> expected;
  if (truth) {
    const Deformer<Mp50>& exact = *in_50_digits_.get();
    expected = exact.images(*exact.pose({in<Mp50>(vertices)}), in<Mp50>({points.begin(), points.end()}), order);
  } else {
    const Prepared<double> other = prepared<double>(quadrature().value());
    const Images<double> images = images_one_by_one(*other, *other->pose({vertices}), points, order);
    for (int o = 0; o <= order; ++o)
      for (const double x : images.tensors[o]) expected.tensors[o].emplace_back(x);
  }
  return compared(found, expected, points.size(), order, condition);
}

bool DeformerChecks::may_be_missing(const Vec3<double>& point) const {
  return validation::may_be_missing(prior_, point);
}

std::vector<DeformerChecks::Errors> DeformerChecks::kept(const SpaceMap& map, bool with_normals,
                                                         std::span<const Vec3<double>> points) const {
  deformation::Pose<double> pose{posed_by(map, *cage_)};
  const CageElements& elements = deformer_->coordinates().elements();
  const Owner owner = deformation::normals_owner(deformer_->coordinates());
  if (with_normals)
    for (std::size_t i = 0; i < elements.count(owner); ++i)
      pose.normal_derivatives.push_back(map.linear * elements.normal_of(i, owner));
  const auto posed = deformer_->pose(pose);
  const double condition = condition_of(*deformer_, *posed), size = cage_->size();
  const Images<double> images = images_one_by_one(*deformer_, *posed, points, 0);
  const int d = cage_->dimension();
  std::vector<Errors> errors(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec3<double> expected = map(points[p], size);
    Vec3<double> difference = Vec3<double>::Zero();
    for (int c = 0; c < d; ++c) difference[c] = images.tensors[0][p * d + c] - expected[c];
    errors[p][0] = error_over_condition(difference.norm() / size, condition);
  }
  return errors;
}

std::vector<DeformerChecks::Errors> DeformerChecks::mirrored(const MirrorSymmetry& mirror,
                                                             std::span<const Vec3<double>> points) const {
  const auto posed = deformer_->pose({made_symmetric(mirror, bent(*cage_))});
  const double condition = condition_of(*deformer_, *posed);
  const int d = cage_->dimension();
  std::vector<Errors> errors(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::array<Vec3<double>, 2> both{points[p], mirror(points[p])};
    const Images<double> images = images_one_by_one<double>(*deformer_, *posed, both, 0);
    std::array<Vec3<double>, 2> at{Vec3<double>::Zero(), Vec3<double>::Zero()};
    for (std::size_t k = 0; k < 2; ++k)
      for (int c = 0; c < d; ++c) at[k][c] = images.tensors[0][k * d + c];
    errors[p][0] = error_over_condition((at[1] - mirror(at[0])).norm() / cage_->size(), condition);
  }
  return errors;
}

std::vector<DeformerChecks::Errors> DeformerChecks::compared(const Images<double>& images, const Images<Mp50>& with,
                                                             std::size_t points, int order, double condition) const {
  std::vector<Errors> errors(points);
  for (int o = 0; o <= order; ++o) {
    const std::size_t width = images.tensors[o].size() / std::max<std::size_t>(1, points);
    for (std::size_t p = 0; p < points; ++p) {
      Mp50 sum = 0;
      for (std::size_t i = p * width; i < (p + 1) * width; ++i) {
        const Mp50 difference = Mp50(images.tensors[o][i]) - with.tensors[o][i];
        sum += difference * difference;
      }
      errors[p][o] =
          error_over_condition(std::sqrt(static_cast<double>(sum)) * std::pow(cage_->size(), o - 1), condition);
    }
  }
  return errors;
}

template <class R>
std::vector<DeformerChecks::Errors> DeformerChecks::differences(const Deformer<R>& deformer,
                                                                std::span<const Vec3<double>> points) const {
  using std::sqrt;
  const int d = cage_->dimension(), highest = deformer_->max_order();
  const auto posed = deformer.pose({in<R>(bent(*cage_))});
  // The truncation error is the step squared, the rounding error one rounding over the step.
  const R step = R(cage_->size()) * (is_multiprecision<R> ? R(1e-16) : R(0x1p-17));
  std::vector<Errors> errors(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec3<R> point = convert<R>(points[p]);
    std::vector<Vec3<R>> asked{point};
    for (int a = 0; a < d; ++a)
      for (const int sign : {1, -1}) {
        asked.push_back(point);
        asked.back()[a] += sign * step;
      }
    const Images<R> images = deformer.images(*posed, asked, highest);
    for (int o = 1; o <= highest; ++o) {
      const std::size_t below = images.tensors[o - 1].size() / asked.size();
      R sum = 0;
      for (std::size_t i = 0; i < below; ++i)
        for (int a = 0; a < d; ++a) {
          const R *up = &images.tensors[o - 1][(1 + 2 * a) * below], *down = up + below;
          const R difference = images.tensors[o][i * d + a] - (up[i] - down[i]) / (2 * step);
          sum += difference * difference;
        }
      errors[p][o] = error_over_condition(static_cast<double>(R(sqrt(sum))) * std::pow(cage_->size(), o - 1), 1);
    }
  }
  return errors;
}

}  // namespace cageproof::validation
