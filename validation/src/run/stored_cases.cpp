// SPDX-License-Identifier: MIT
#include "cageproof/validation/stored_cases.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/replay.h"
#include "promises/verdicts.h"

#include <fmt/format.h>

#include <set>

namespace cageproof::validation {
namespace {

using reports::WorstLine;

// The row that a case belongs to.
RowKey key_of(const WorstLine& line) {
  RowKey key = line;
  key.setting = hunted_regime;
  // Stored cases may use another name that the evaluation's family has.
  if (const auto evaluation = EvaluationRegister::instance().find(line.subject, line.evaluation))
    key.evaluation = evaluation->name();
  return key;
}

// A stored input, which stays as it was stored.
struct StoredAt {
  const WorstLine& line;

  std::uint64_t number() const { return line.worst.sample; }
  WorstCase case_of(const Finding&, int) const { return line.worst; }
};

// The case's question, asked only at the order of its row.
Question<StoredAt> question_of(const StoredAt& stored) {
  const WorstLine& line = stored.line;
  const int order = line.order;
  Question<StoredAt> question{
      key_of(line), std::string(find_check(line.check)->unit()), {order, order}, {}, line.worst.asked};
  question.ask = [key = question.key](const StoredAt& at) {
    std::array<Finding, 3> found;
    found[key.order] = replay(key, at.line.worst, Triangulation::Shortest);
    // Inputs that were searched for say nothing of how well-posed others are.
    found[key.order].total_loss = -1;
    return found;
  };
  return question;
}

class StoredMeasurement final : public Measurement {
 public:
  explicit StoredMeasurement(std::vector<WorstLine> lines) : lines_(std::move(lines)) {}

  std::string name() const override { return "stored worst cases"; }
  int blocks() const override { return block_count(lines_.size(), 8); }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const WorstLine& line : lines_) add_rows_of(question_of(StoredAt{line}), rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    PartialResult gathered;
    // By turns: the cases of one formula cost alike and stand together.
    for (std::size_t i = block; i < lines_.size(); i += blocks()) {
      const StoredAt at{lines_[i]};
      record(question_of(at), at, gathered.rows);
    }
    return gathered;
  }

 private:
  std::vector<WorstLine> lines_;
};

// Inputs that the algebra found hard are also asked of the evaluation that commands take.
void add_recommended(std::vector<WorstLine>& lines) {
  const std::size_t stored = lines.size();
  for (std::size_t i = 0; i < stored; ++i) {
    const auto& known = EvaluationRegister::instance();
    const auto recommended = known.with_role(lines[i].subject, Role::Recommended);
    const auto algebra = known.with_role(lines[i].subject, Role::ClosedForm);
    if (!recommended || !algebra || lines[i].scalar != "double") continue;
    if (evaluation_named(lines[i].subject, lines[i].evaluation).name() != algebra->name()) continue;
    WorstLine line = lines[i];
    line.evaluation = recommended->name();
    lines.push_back(std::move(line));
  }
}

}  // namespace

std::string origin_of(const RowKey& row, const WorstCase& input) {
  if (row.setting != hunted_regime) return "";
  for (const WorstLine& line : reports::parse_worst(stored_worst_cases(), stored_cases_file))
    if (line.subject == row.subject && line.worst.corners == input.corners && line.worst.point == input.point &&
        line.worst.parameters == input.parameters)
      return fmt::format("{} ({}:{})", fmt::join(line.flags, ", "), stored_cases_file, line.number);
  return "";
}

StoredCases stored_measurement(std::string_view text, std::string_view name, const std::string& formulas,
                               const std::string& evaluations) {
  std::vector<WorstLine> lines = reports::parse_worst(text, name);
  for (const WorstLine& line : lines) {
    const std::string at = fmt::format("{}:{}: ", name, line.number);
    if (line.section != RowKey::Section::Element) throw InputError(at + "a case of a cage");
    // Cases that are left out today must still name something that exists.
    try {
      require_replayable(key_of(line), line.worst);
    } catch (const InputError& e) {
      throw InputError(at + e.what());
    }
  }
  add_recommended(lines);
  std::erase_if(lines, [&](const WorstLine& line) {
    return !matches(formulas, line.subject) ||
           !matches_evaluation(evaluations, evaluation_named(line.subject, line.evaluation));
  });
  // A case counts once, whatever evaluations it is asked of.
  std::set<std::size_t> numbers;
  for (const WorstLine& line : lines) numbers.insert(static_cast<std::size_t>(line.number));
  const std::size_t count = numbers.size();
  return {count == 0 ? nullptr : std::make_unique<StoredMeasurement>(std::move(lines)), count};
}

std::vector<ResultRow> replay_stored(std::string_view text, std::string_view name, const std::string& formulas,
                                     const std::string& evaluations, int jobs) {
  Measurements measurements;
  measurements.push_back(stored_measurement(text, name, formulas, evaluations).measurement);
  if (!measurements.front()) return {};
  return judged(measure_all(measurements, jobs).rows).rows;
}

}  // namespace cageproof::validation
