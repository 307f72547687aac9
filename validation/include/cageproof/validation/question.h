// SPDX-License-Identifier: MIT
// A question: one thing that is asked of a subject (an element, a cage, a deformer) at an input. A measurement is
// inputs times questions, recorded here; `replay` and `hunt` take the same question from the subject's factory.
#pragma once

#include "cageproof/core/results/tally.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

namespace cageproof::validation {

/// The answer to a question at one order.
struct Finding {
  enum class Status {
    Measured,
    NoTruth,    ///< no limit exists, or the sample is no input in this scalar
    Unreached,  ///< a limit exists, and its truth was not reached
    Declined,   ///< the evaluation said that it could not meet its tolerance
    Unasked,    ///< the question says nothing of this order
  } status = Status::Unasked;
  double error = 0;     ///< in the question's unit
  double relative = 0;  ///< plain relative error, for the check `truth`
  /// For the check `truth`: the error that a result without one right digit would have had; negative: not known.
  double total_loss = -1;
  int entry = -1;    ///< for the check `truth`: which entry of the tensor is furthest from the truth
  double found = 0;  ///< the evaluation's value of that entry
};

/// Orders of derivatives, from the lowest to the highest; none where the highest is below the lowest.
struct Orders {
  int lowest = 0, highest = 2;
  bool operator==(const Orders&) const = default;
};

/// Counts a sample that was put to a row. \pre it was asked \return whether it was measured, so that its error is to be
/// added
inline bool counted(Finding::Status status, Tally& tally) {
  ++tally.asked;
  tally.without_truth += status == Finding::Status::NoTruth;
  tally.unreached += status == Finding::Status::Unreached;
  tally.declined += status == Finding::Status::Declined;
  return status == Finding::Status::Measured;
}

/// \tparam At an input, with what several questions share there, which is computed when first asked for:
///   `number()` is the sample's, `case_of(finding, order)` the input as it is stored. An At whose inputs cannot be run
///   again has `is_stored = false` in its place.
template <class At>
struct Question {
  RowKey key;                                            ///< of its rows, except the order
  std::string unit;                                      ///< of its errors
  Orders orders;                                         ///< that it may answer
  std::function<std::array<Finding, 3>(const At&)> ask;  ///< by order; safe from any thread
  /// The highest derivative that results are computed with, as cases store it; 2 where results have no higher one.
  int asked = 2;
  /// Whether the answer is the same at every input, so that only the first is asked.
  bool once = false;
};

/// Adds what a question finds at an input to its rows, and to a curve of that many points, if any.
template <class At>
void record(const Question<At>& question, const At& at, std::map<RowKey, Tally>& rows, std::size_t curve = 0) {
  const std::array<Finding, 3> found = question.ask(at);
  RowKey key = question.key;
  for (int o = 0; o < 3; ++o) {
    if (found[o].status == Finding::Status::Unasked) continue;
    // Or add_rows_of() would miss a row.
    if (o < question.orders.lowest || o > question.orders.highest)
      throw std::logic_error("the check " + key.check + " of " + key.subject +
                             " answers an order that it does not name");
    key.order = o;
    Tally& tally = rows[key];
    tally.unit = question.unit;
    if (!counted(found[o].status, tally)) continue;
    tally.total_loss = std::max(tally.total_loss, found[o].total_loss);
    if constexpr (!requires { At::is_stored; })
      tally.add(found[o].error, found[o].relative, at.number(), [&](double error) {
        WorstCase worst = at.case_of(found[o], o);
        worst.error = error;
        worst.asked = question.asked;
        return worst;
      });
    else tally.add(found[o].error, found[o].relative);
    if (curve > 0)
      tally.add_to_curve(at.number() % curve, curve, std::ldexp(found[o].relative, key.scalar == "float" ? 24 : 53));
  }
}

/// Adds the keys of all rows that a question may fill.
template <class At>
void add_rows_of(const Question<At>& question, std::vector<RowKey>& rows) {
  for (int o = question.orders.lowest; o <= question.orders.highest; ++o) {
    rows.push_back(question.key);
    rows.back().order = o;
  }
}

/// The question that a row's figures answer, or null. \param questions those of the row's subject and evaluation; the
/// evaluation may have another name there
template <class Q>
const Q* find_question(const std::vector<Q>& questions, RowKey row) {
  for (const Q& question : questions) {
    row.order = question.key.order;
    row.evaluation = question.key.evaluation;
    if (question.key == row) return &question;
  }
  return nullptr;
}

/// An input that consists only of a point in space.
struct PointAt {
  Vec3<double> point;
  std::uint64_t index = 0;

  std::uint64_t number() const { return index; }
  WorstCase case_of(const Finding& finding, int /*order*/) const { return {finding.error, 0, index, {}, point, {}}; }
};

}  // namespace cageproof::validation
