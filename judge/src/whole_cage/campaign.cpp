// SPDX-License-Identifier: MIT
// Coordinates of whole cages by foreign code, measured against the truth.
#include "certificate/rows.h"
#include "whole_cage/cage_places.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/parallel.h"
#include "cageproof/judge/whole_cage.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace cageproof::judge {
namespace {

constexpr double kRoundoff = 0x1p-53;

// A cage in one place and unit, ready to give the truth.
class JudgedCage {
 public:
  JudgedCage(const CageRequest& question, const CoordinateKind& kind)
      : cage_(question.cage()), coordinates_(cage_, kind, CoordinateOptions{}) {
    for (const Formula* formula : formulas_of(kind, cage_)) {
      const FaceJump& jump = formula->face_jump;
      continuous_.push_back(kind.normalised || (jump.number == 0 && jump.pi_multiple == 0 && !jump.diverges));
    }
    if (!kind.is_sum()) continuous_.assign(coordinates_.blocks().size(), kind.normalised);
    for (const Vec3<double>& vertex : question.vertices) reach_ = std::max(reach_, vertex.lpNorm<Eigen::Infinity>());
  }

  std::size_t count() const {
    std::size_t sum = 0;
    for (const CoordinateBlock& block : coordinates_.blocks()) sum += static_cast<std::size_t>(block.size);
    return sum;
  }

  /// \param on whether the point is on the cage
  Measured measure(const Vec3<double>& point, const std::vector<double>& theirs, bool on) const {
    Measured found;
    const auto truth = coordinates_.at<Mp50>(convert<Mp50>(point), 0);
    const auto slopes = coordinates_.at<double>(point, 1);
    std::size_t begin = 0;
    for (std::size_t b = 0; b < truth.size(); begin += truth[b++].value.size())
      add(truth[b], slopes[b], theirs, begin, on && continuous_[b], found);
    return found;
  }

 private:
  void add(const Result<Mp50>& truth, const Result<double>& slopes, const std::vector<double>& theirs,
           std::size_t begin, bool is_continuous, Measured& found) const {
    double off = 0, size = 0, slope = 0;
    for (std::size_t i = 0; i < truth.value.size(); ++i) {
      if (!isfinite(truth.value[i])) return;
      const double x = theirs[begin + i];
      found.is_finite = found.is_finite && std::isfinite(x);
      const Mp50 difference = Mp50(x) - truth.value[i];
      off = std::isfinite(x) ? std::max(off, std::abs(static_cast<double>(difference)))
                             : std::numeric_limits<double>::infinity();
      size = std::max(size, std::abs(static_cast<double>(truth.value[i])));
    }
    // Where the kind has no gradient, moving the point is not counted.
    for (const double x : slopes.gradient)
      if (std::isfinite(x)) slope = std::max(slope, std::abs(x));
    found.status = Measured::Status::Error;
    found.absolute = std::max(found.absolute, off);
    if (size > 0) found.relative = std::max(found.relative, off / size);
    const double conditioned = off / (kRoundoff * (size + reach_ * slope));
    found.conditioned = std::max(found.conditioned, conditioned);
    found.beside = found.conditioned;
    if (is_continuous) found.continuous = std::max(found.continuous, conditioned);
  }

  Cage cage_;
  CageCoordinates coordinates_;   // in 50 digits the closed forms
  std::vector<bool> continuous_;  // of each block, across the cage
  double reach_ = 0;              // largest coordinate, whose rounding moves vertices and points
};

// The time for a point and a triangle or segment, of the code and of the suite's own evaluations.
std::vector<PairTime> cage_times(ForeignCode& code, std::string_view kind, const std::string& name, int dimension) {
  constexpr int repeats = 5, point_count = 200;
  const CoordinateKind& row = coordinate_kind_named(kind);
  const std::string_view cage = dimension == 2 ? "figure" : row.keeps_quads ? "spiky-box" : "icosphere";
  const CagePlaces places(cage, {.keeps_quads = row.keeps_quads});
  CageRequest question = places.question();
  for (int i = 0; i < point_count; ++i)
    if (const auto point = places.point("inside", 1, static_cast<std::uint64_t>(i))) question.points.push_back(*point);
  const double pairs = static_cast<double>(question.points.size() * question.faces.size());
  Asked asked = asked_of(question);
  asked.coordinates = JudgedCage(question, row).count();
  std::vector<PairTime> times;
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    double nanoseconds = 0;
    if (code.ask({.kind = kind}, {&asked, 1}, &nanoseconds).front().status != Answer::Status::Given) return times;
    least = std::min(least, nanoseconds);
  }
  times.push_back({name, 0, least / pairs});
  for (const std::string_view evaluation : {std::string_view(), quickest}) {
    const CageCoordinates own(question.cage(), row, CoordinateOptions{std::string(evaluation)});
    std::vector<CoordinateTable<double>> tables;
    least = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < repeats; ++repeat) {
      const auto start = std::chrono::steady_clock::now();
      own.at(question.points, 0, tables);
      const auto time = std::chrono::steady_clock::now() - start;
      least = std::min(least, std::chrono::duration<double, std::nano>(time).count());
    }
    times.push_back({own.evaluation(), 0, least / pairs});
  }
  return times;
}

// The samples of a regime: cages in turn.
struct Asking {
  std::string_view regime;
  std::vector<const JudgedCage*> cages;
  std::vector<const CageRequest*> questions;  // without points
  std::vector<Asked> asked;
  std::vector<Answer> answers;
  std::vector<Measured> measured;
};

}  // namespace

Asked asked_of(const CageRequest& question) {
  Asked asked;
  asked.count = question.points.size();
  asked.dimension = question.dimension;
  for (const Vec3<double>& vertex : question.vertices)
    asked.corners.insert(asked.corners.end(), vertex.data(), vertex.data() + question.dimension);
  asked.face_corners = question.dimension;
  for (const Face& face : question.faces) asked.face_corners = std::max(asked.face_corners, face.size());
  for (const Face& face : question.faces)
    asked.faces.insert(asked.faces.end(), face.vertices.begin(), face.vertices.begin() + asked.face_corners);
  for (const Vec3<double>& point : question.points)
    asked.points.insert(asked.points.end(), point.data(), point.data() + question.dimension);
  return asked;
}

WholeCageFunction whole_cage_function(ForeignCode& code, std::string_view kind) {
  return [&code, kind](const CageRequest& question) -> std::vector<double> {
    Asked asked = asked_of(question);
    asked.coordinates = JudgedCage(question, coordinate_kind_named(kind)).count();
    Answer answer = code.ask({.kind = kind}, {&asked, 1}).front();
    return answer.status == Answer::Status::Given ? std::move(answer.tensors[0]) : std::vector<double>();
  };
}

SubjectCampaign run_cage_campaign(ForeignCode& code, std::string_view kind, const std::string& name,
                                  const ElementCampaignOptions& options,
                                  const std::optional<CageConvention>& convention, int dimension) {
  SubjectCampaign campaign{std::string(kind), true, 0, {}, {}, dimension};
  const CoordinateKind& row = coordinate_kind_named(kind);
  std::map<const CagePlaces*, std::unique_ptr<JudgedCage>> cages;
  std::vector<Asking> all;
  for (const std::string_view regime : cage_regimes(dimension)) {
    if (!matches(options.regimes, regime)) continue;
    Asking asking{regime, {}, {}, {}, {}, {}};
    const auto& places = places_of(regime, dimension, row.keeps_quads);
    for (int i = 0; i < options.samples; ++i) {
      const CagePlaces& place = places[static_cast<std::size_t>(i) % places.size()];
      const auto point = place.point(regime, options.seed, static_cast<std::uint64_t>(i));
      if (!point) continue;
      CageRequest question = place.question();
      question.points = {*point};
      auto& cage = cages[&place];
      if (!cage) cage = std::make_unique<JudgedCage>(question, row);
      asking.cages.push_back(cage.get());
      asking.questions.push_back(&place.question());
      asking.asked.push_back(asked_of(question));
      asking.asked.back().coordinates = cage->count();
    }
    asking.answers = code.ask({.kind = row.name}, asking.asked);
    asking.measured.resize(asking.asked.size());
    all.push_back(std::move(asking));
  }
  std::vector<std::pair<Asking*, std::size_t>> samples;
  for (Asking& asking : all)
    for (std::size_t i = 0; i < asking.asked.size(); ++i) samples.emplace_back(&asking, i);
  std::atomic<std::size_t> done{0};
  for_each_parallel(samples.size(), options.jobs, [&](std::size_t s) {
    const auto [asking, i] = samples[s];
    const Answer& answer = asking->answers[i];
    Measured& found = asking->measured[i];
    if (answer.status == Answer::Status::Given) {
      const std::vector<double>& p = asking->asked[i].points;
      const std::vector<double>& given = answer.tensors[0];
      found =
          asking->cages[i]->measure({p[0], p[1], dimension == 2 ? 0 : p[2]},
                                    convention ? convention->in_ours(*asking->questions[i], row.name, given) : given,
                                    asking->regime.starts_with("on-"));
    } else {
      found.status = answer.status == Answer::Status::Declined ? Measured::Status::Declined : Measured::Status::Failed;
    }
    if (options.progress) options.progress(++done, samples.size());
  });
  const Request request{.kind = row.name};
  for (const Asking& asking : all)
    campaign.rows.push_back(row_of(std::string(asking.regime), 0, asking.measured,
                                   [&](std::size_t i) { return exact_line(request, asking.asked[i], 0); }));
  campaign.times = cage_times(code, row.name, name, dimension);
  return campaign;
}

}  // namespace cageproof::judge
