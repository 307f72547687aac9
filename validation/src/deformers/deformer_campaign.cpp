// SPDX-License-Identifier: MIT
#include "deformer_campaign.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/random_stream.h"
#include "constrained_checks.h"
#include "cageproof/validation/promise.h"
#include "promises/verdicts.h"
#include "run/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

// How far inside points lie, in cage sizes: next to the cage second derivatives of layers grow without bound.
constexpr double depth = 2e-2;

bool is_small(const Cage& cage, Triangulation rule) { return cage.parts(false, rule).elements.size() <= few_elements; }

// The name of a measurement. Most methods have one variant, which has no name.
template <class Variant>
std::string name_on(const Cage& cage, const Variant& variant) {
  return fmt::format("{}, deformer {}{}{}", cage.name(), variant.method->name, variant.name.empty() ? "" : ", ",
                     variant.name);
}

// Asks questions of a measurement. Whoever has a user's cage also wants to know of what a method refuses, and of the
// rest of its questions.
class Asker {
 public:
  Asker(std::string name, bool tells_refusals, PartialResult& gathered)
      : name_(std::move(name)), tells_refusals_(tells_refusals), gathered_(gathered) {}

  /// Asks a part of a measurement, up to where it is refused.
  void ask(const std::string& part, const std::function<void()>& questions) const {
    if (!tells_refusals_) return questions();
    try {
      questions();
    } catch (const InputError& error) {
      gathered_.refused[error.what()].insert(part.empty() ? name_ : fmt::format("{}, {}", name_, part));
    }
  }
  void ask(const Question<PointAt>& question, const std::vector<Vec3<double>>& points, std::size_t count) const {
    ask(fmt::format("{}, {}", question.key.check, question.key.place), [&] {
      for (std::size_t p = 0; p < count; ++p) record(question, {points[p], p}, gathered_.rows);
    });
  }

 private:
  std::string name_;
  bool tells_refusals_;
  PartialResult& gathered_;
};

// A method prepared with its defaults, which its variants share.
using Prepared = Lazy<std::shared_ptr<const deformation::Deformer<double>>>;

class DeformerMeasurement final : public Measurement {
 public:
  DeformerMeasurement(std::shared_ptr<const Cage> cage, DeformerVariant variant, const DeformerCampaignOptions& options,
                      std::shared_ptr<const Prepared> prepared, bool tells_refusals)
      : cage_(std::move(cage)),
        variant_(std::move(variant)),
        options_(options),
        prepared_(std::move(prepared)),
        tells_refusals_(tells_refusals) {}

  std::string name() const override { return name_on(*cage_, variant_); }
  int blocks() const override { return 1; }

  std::vector<RowKey> rows() const override {
    const DeformerChecks checks(cage_, variant_, options_.triangulation, prepared_->get().get());
    std::vector<RowKey> rows;
    for (const Question<PointAt>& question : checks.questions()) add_rows_of(question, rows);
    return rows;
  }

  PartialResult measure(int) const override {
    PartialResult gathered;
    const Asker asker(name(), tells_refusals_, gathered);
    asker.ask("", [&] {
      const DeformerChecks checks(cage_, variant_, options_.triangulation, prepared_->get().get());
      const auto points = interior_points(*cage_, options_.triangulation, options_.seed, options_.points);
      for (const Question<PointAt>& question : checks.questions()) {
        if (!is_asked(question.key)) continue;
        const bool costly = question.key.place == bent_pose || question.key.check == "keeps_offset";
        asker.ask(question, points, std::min<std::size_t>(points.size(), costly ? few() : points.size()));
      }
    });
    return gathered;
  }

 private:
  bool is_asked(const RowKey& key) const {
    if (options_.proves_methods || cage_->dimension() == 2) return true;
    if (key.check == "second_route" || key.check == "deformer_by_quadrature") return false;
    const CoordinateKind& kind = coordinate_kind_named(variant_.method->kind);
    const bool is_slow_in_50_digits =
        kind.solves_on_samples || (kind.keeps_quads && !prepared_->get()->prepared().systems.empty());
    return !is_slow_in_50_digits || (key.check != "deformer_truth" && key.scalar != name_of(ScalarKind::Digits50) &&
                                     key.check != "pose_derivative");
  }
  int few() const { return is_small(*cage_, options_.triangulation) ? options_.few_points : 1; }

  std::shared_ptr<const Cage> cage_;
  DeformerVariant variant_;
  DeformerCampaignOptions options_;
  std::shared_ptr<const Prepared> prepared_;
  bool tells_refusals_;
};

// A method that takes constraints.
class ConstrainedMeasurement final : public Measurement {
 public:
  ConstrainedMeasurement(std::shared_ptr<const Cage> cage, ConstrainedVariant variant,
                         const DeformerCampaignOptions& options, bool tells_refusals)
      : cage_(std::move(cage)), variant_(std::move(variant)), options_(options), tells_refusals_(tells_refusals) {}

  std::string name() const override { return name_on(*cage_, variant_); }
  int blocks() const override { return 1; }

  std::vector<RowKey> rows() const override {
    const ConstrainedChecks checks(cage_, variant_, options_.triangulation);
    std::vector<RowKey> rows;
    for (const Question<PointAt>& question : checks.questions()) add_rows_of(question, rows);
    return rows;
  }

  PartialResult measure(int) const override {
    PartialResult gathered;
    const Asker asker(name(), tells_refusals_, gathered);
    asker.ask("", [&] {
      const ConstrainedChecks checks(cage_, variant_, options_.triangulation);
      const auto points = interior_points(*cage_, options_.triangulation, options_.seed, options_.points);
      for (const Question<PointAt>& question : checks.questions())
        asker.ask(question, points, question.once ? 1 : points.size());
    });
    return gathered;
  }

 private:
  std::shared_ptr<const Cage> cage_;
  ConstrainedVariant variant_;
  DeformerCampaignOptions options_;
  bool tells_refusals_;
};

// Why a method refuses a cage and constraints inside when it solves; empty where it does not.
std::string why_refused(const std::shared_ptr<const Cage>& cage, const ConstrainedVariant& variant,
                        const DeformerCampaignOptions& options) {
  try {
    const ConstrainedChecks checks(cage, variant, options.triangulation);
    const auto point = interior_points(*cage, options.triangulation, options.seed, 1).front();
    checks.questions().front().ask({point, 0});
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// Adds the methods with constraints on small cages, whose constraints determine their maps.
void add_constrained(const std::shared_ptr<const Cage>& cage, const DeformerCampaignOptions& options,
                     Measurements& measurements, RefusedMethods* refused) {
  if (!is_small(*cage, options.triangulation)) return;
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods()) {
    if (!matches(options.methods, method.name) || !can_be_asked(method, *cage, options.triangulation)) continue;
    for (ConstrainedVariant& variant : variants_of(method)) {
      if (refused != nullptr && options.doing)
        options.doing(fmt::format("{}, preparing deformer {}", cage->name(), method.name));
      std::string reason = refused == nullptr ? "" : why_refused(cage, variant, options);
      if (reason.empty())
        measurements.push_back(
            std::make_unique<ConstrainedMeasurement>(cage, std::move(variant), options, refused != nullptr));
      else (*refused)[std::move(reason)].push_back(fmt::format("{} ({})", method.name, variant.name));
    }
  }
}

}  // namespace

const std::vector<std::string_view>& deformer_cage_names() {
  static const std::vector<std::string_view> names{"cube", "l-block", "twisted-bar", "square", "l-shape"};
  return names;
}

const std::vector<std::string_view>& small_face_cage_names() {
  static const std::vector<std::string_view> names{"bevel-1e-2", "bump-1e-2", "pinch-1e-2", "needles-1e-2"};
  return names;
}

std::vector<Vec3<double>> interior_points(const Cage& cage, Triangulation rule, std::uint64_t seed, int count) {
  const auto [low, high] = box_of(cage.vertices());
  const CageLocator locator(cage, rule);
  const std::string stream = fmt::format("deformer/{}", drawn_by(cage));
  std::vector<Vec3<double>> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, stream, i);
    // Thin cages have no points so deep.
    constexpr int tries = 20000;
    bool found = false;
    for (int t = 0; t < tries && !found; ++t) {
      Vec3<double> p = Vec3<double>::Zero();
      for (int c = 0; c < cage.dimension(); ++c) p[c] = random.uniform(low[c], high[c]);
      found = locator.distance(p) >= depth * cage.size() && locator.inside(p);
      if (found) points.push_back(p);
    }
    if (!found) break;
  }
  return points;
}

Measurements deformer_measurements(const std::shared_ptr<const Cage>& cage, const DeformerCampaignOptions& options,
                                   RefusedMethods* refused) {
  Measurements measurements;
  const bool has_points = !interior_points(*cage, options.triangulation, options.seed, 1).empty();
  const auto refuse = [&](std::string reason, std::string_view method) {
    if (refused != nullptr) (*refused)[std::move(reason)].emplace_back(method);
  };
  for (const deformation::DeformMethod& method : deformation::deform_methods()) {
    if (!matches(options.methods, method.name)) continue;
    const CoordinateKind& kind = coordinate_kind_named(method.kind);
    if (std::string reason = deformation::why_refused(method, *cage); !reason.empty()) {
      // Methods of other dimensions, and those that keep quads, which polygons do not have, are no loss.
      if (exists_on(kind, *cage) && !(kind.keeps_quads && cage->dimension() == 2))
        refuse(std::move(reason), method.name);
      continue;
    }
    const bool solves_in_space = kind.solves_on_samples && cage->dimension() == 3;
    const auto elements = static_cast<int>(cage->parts(false, options.triangulation).elements.size());
    if (!has_points || (solves_in_space && elements > options.solved_elements)) continue;
    std::vector<DeformerVariant> variants = variants_of(method);
    // All variants are asked on small cages; elsewhere every second one and the default. Kinds that keep quads have
    // layers that take several times as long, so all of their variants are asked only on the smallest cages.
    const bool few = kind.keeps_quads ? cage->faces().size() > 6 : !is_small(*cage, options.triangulation);
    if (variants.size() > 2 && few) {
      std::size_t index = 0;
      std::erase_if(variants, [&](const DeformerVariant& v) { return index++ % 2 == 1 && !v.is_default; });
    }
    const auto prepared = std::make_shared<const Prepared>([cage, &method, rule = options.triangulation] {
      return deformation::prepare_deformer<double>(method, *cage, {.evaluation = {}, .triangulation = rule});
    });
    if (refused != nullptr) {
      if (options.doing) options.doing(fmt::format("{}, preparing deformer {}", cage->name(), method.name));
      try {
        prepared->get();
      } catch (const InputError& error) {
        refuse(error.what(), method.name);
        continue;
      }
    }
    for (DeformerVariant& variant : variants)
      measurements.push_back(
          std::make_unique<DeformerMeasurement>(cage, std::move(variant), options, prepared, refused != nullptr));
  }
  if (has_points) add_constrained(cage, options, measurements, refused);
  return measurements;
}

std::vector<ResultRow> run_deformer_campaign(const Cage& cage, const DeformerCampaignOptions& options) {
  return judged(measure_all(deformer_measurements(std::make_shared<const Cage>(cage), options), options.jobs).rows)
      .rows;
}

}  // namespace cageproof::validation
