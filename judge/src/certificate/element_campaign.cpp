// SPDX-License-Identifier: MIT
#include "cageproof/judge/element_campaign.h"

#include "certificate/pair_times.h"
#include "certificate/rows.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace cageproof::judge {
namespace {

using validation::Sample;
using validation::Truth;

// A regime's samples with their answers.
struct Asking {
  const validation::Regime* regime;
  std::vector<Sample> samples;
  std::vector<Asked> asked;
  std::vector<Answer> answers;
  std::vector<std::array<Measured, 3>> measured;
};

Asked asked_of(const Sample& sample, int dim) {
  Asked asked;
  for (const auto& corner : sample.corners)
    for (int c = 0; c < dim; ++c) asked.corners.push_back(corner[c]);
  for (int c = 0; c < dim; ++c) asked.points.push_back(sample.point[c]);
  asked.parameters = sample.parameters;
  return asked;
}

// Proven where it is, the closed form keeps all the digits that are asked for, and double's errors need no hundred.
validation::TruthSource quick_truth_source(const Formula& formula) {
  using Digits = validation::TruthSource::Digits;
  validation::TruthSource source = validation::truth_source(formula);
  if (source.digits == Digits::Hundred && !source.rough_yardstick) source.digits = Digits::Fifty;
  return source;
}

template <Scalar R>
void measure(const Truth& truth, const Answer& answer, int order, std::array<Measured, 3>& found) {
  Result<R> f;
  for (int o = 0; o <= order; ++o)
    for (const double x : answer.tensors[o]) f.of(o).push_back(static_cast<R>(x));
  const Mp100 u = unit_roundoff<R>();
  for (int o = 0; o <= order; ++o) {
    Measured& one = found[o];
    if (!truth.exists[o]) continue;
    one.status = Measured::Status::Error;
    one.is_finite = std::ranges::all_of(answer.tensors[o], [](double x) { return std::isfinite(x); });
    one.conditioned = validation::conditioned_error(f, truth, o, u);
    (truth.on_element ? one.on : one.beside) = one.conditioned;
    const double size = std::max(1., static_cast<double>(truth.norm[o]));
    one.absolute = validation::relative_error(f, truth, o, Mp100(1)) * size;
    if (truth.norm[o] != 0) one.relative = validation::relative_error(f, truth, o);
  }
}

void judge_sample(const validation::TruthSource& source, const Sample& sample, const Answer& answer, int order,
                  bool single, std::array<Measured, 3>& found) {
  if (answer.status != Answer::Status::Given) {
    for (Measured& one : found)
      one.status = answer.status == Answer::Status::Declined ? Measured::Status::Declined : Measured::Status::Failed;
    return;
  }
  if (!validation::is_finite(sample)) return;
  const Truth truth = validation::truth_from(source, sample, order);
  if (single) measure<float>(truth, answer, order, found);
  else measure<double>(truth, answer, order, found);
}

CampaignRow row_of(const Asking& asking, const Formula& formula, int order) {
  std::vector<Measured> measured;
  measured.reserve(asking.measured.size());
  for (const auto& orders : asking.measured) measured.push_back(orders[order]);
  return row_of(std::string(asking.regime->name), order, measured,
                [&](std::size_t i) { return exact_line(formula, asking.asked[i], 0); });
}

// The code's answer for a sample, in our convention.
Answer answer_of(const Evaluation& ours, const Sample& sample, int order) {
  Result<double> result;
  ours(Query<double>{.corners = sample.corners, .point = sample.point, .order = order, .parameters = sample.parameters},
       result);
  Answer answer{result.converged ? Answer::Status::Given : Answer::Status::Declined, {}};
  for (int o = 0; o <= order; ++o) answer.tensors[o] = result.of(o);
  return answer;
}

std::vector<Asking> ask_all(ForeignCode& code, const Request& request, const ElementCampaignOptions& options,
                            int samples) {
  const Formula& formula = options.ours ? options.ours->formula() : *request.formula;
  std::vector<Asking> all;
  for (const validation::Regime& regime : validation::regimes()) {
    if (!matches(options.regimes, regime.name) || !validation::exists_for(regime, formula.element)) continue;
    Asking asking{&regime, {}, {}, {}, {}};
    for (int i = 0; i < samples; ++i) {
      Sample sample = make_sample(formula, regime, options.seed, static_cast<std::uint64_t>(i));
      if (options.single) sample = validation::rounded_to(ScalarKind::Float, std::move(sample));
      asking.asked.push_back(asked_of(sample, formula.dim()));
      asking.samples.push_back(std::move(sample));
    }
    if (options.ours)
      for (const Sample& sample : asking.samples)
        asking.answers.push_back(answer_of(*options.ours, sample, request.order));
    else asking.answers = code.ask(request, asking.asked);
    asking.measured.resize(asking.samples.size());
    all.push_back(std::move(asking));
  }
  return all;
}

}  // namespace

SubjectCampaign run_element_campaign(ForeignCode& code, const Formula& formula, const std::string& name,
                                     const ElementCampaignOptions& options) {
  const Formula& computed = options.ours ? options.ours->formula() : formula;
  SubjectCampaign campaign{std::string(computed.name), false, code.order_of(formula, options.single), {}, {}};
  if (options.ours) campaign.order = std::min(campaign.order, options.ours->max_order());
  const validation::TruthSource source = quick_truth_source(computed);
  constexpr int costly = 8, least = 10;
  const int samples =
      source.is_costly() ? std::max(std::min(least, options.samples), options.samples / costly) : options.samples;
  const Request request{&formula, campaign.order, options.single};
  std::vector<Asking> all = ask_all(code, request, options, samples);
  const auto per_regime = static_cast<std::size_t>(samples);
  std::atomic<std::size_t> done{0};
  for_each_parallel(all.size() * per_regime, options.jobs, [&](std::size_t i) {
    Asking& asking = all[i / per_regime];
    const std::size_t s = i % per_regime;
    judge_sample(source, asking.samples[s], asking.answers[s], campaign.order, options.single, asking.measured[s]);
    if (options.progress) options.progress(++done, all.size() * per_regime);
  });
  for (const Asking& asking : all)
    for (int order = 0; order <= campaign.order; ++order) campaign.rows.push_back(row_of(asking, computed, order));
  campaign.times = pair_times(code, request, name);
  return campaign;
}

}  // namespace cageproof::judge
