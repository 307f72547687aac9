// SPDX-License-Identifier: MIT
// Defects that show on whole cages.
#include "cageproof/judge/whole_cage.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "whole_cage/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cageproof::judge {
namespace {

constexpr double kFewDigits = 1e-5;  // single precision's errors are below
constexpr double kWrong = 1e-9;      // of coordinates of size one: what is less is no defect of these
// Far below every threshold that is meant for a unit cage.
constexpr double kOtherUnit = 0x1p-40;

struct CageCase {
  CageSample sample;
  std::vector<double> theirs;
  double off = 0;
};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  double off = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    off = std::isfinite(a[i]) ? std::max(off, std::abs(a[i] - b[i])) : INFINITY;
    size = std::max(size, std::abs(b[i]));
  }
  return off / size;
}

// The difference of one part, relative to the largest number of the part.
double part_off(const CageCase& c, std::size_t begin, std::size_t end) {
  const auto part = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                               all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  return difference(part(c.theirs), part(c.sample.truth));
}

// The largest difference of all blocks, which have units of their own.
double blocks_off(const CageCase& c) {
  if (c.sample.sizes.empty() || c.theirs.size() != c.sample.truth.size()) return difference(c.theirs, c.sample.truth);
  double off = 0;
  std::size_t begin = 0;
  for (const std::size_t size : c.sample.sizes) {
    off = std::max(off, part_off(c, begin, begin + size));
    begin += size;
  }
  return off;
}

bool is_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

bool is_bad(const CageCase& c) { return !(c.off <= kWrong); }

std::vector<CageCase> asked(const WholeCageFunction& theirs, std::string_view kind, double unit, int dimension) {
  std::vector<CageCase> cases;
  for (CageSample& sample : cage_samples(kind, unit, dimension)) {
    std::vector<double> answer = theirs(sample.question);
    // Where no answer was given there is nothing to find.
    cases.push_back({std::move(sample), std::move(answer), 0});
    if (!cases.back().theirs.empty()) cases.back().off = blocks_off(cases.back());
  }
  return cases;
}

double vertices_off(const CageCase& c) { return part_off(c, 0, c.sample.question.vertices.size()); }

std::string off_text(const CageCase& c) {
  const std::size_t vertices = c.sample.question.vertices.size(), all = c.sample.truth.size();
  if (c.theirs.size() != all || vertices == all) return fmt::format("off by {:.3g}", c.off);
  const double first = vertices_off(c), others = part_off(c, vertices, all);
  const auto text = [](double off) { return off <= kWrong ? std::string("right") : fmt::format("off by {:.3g}", off); };
  return fmt::format("the first coordinates, of all vertices, are {}, the others {}", text(first), text(others));
}

bool has_wrong_size(const CageCase& c) { return c.theirs.size() != c.sample.truth.size(); }

bool in_proportion(const CageCase& c) {
  double tt = 0, ft = 0;
  for (std::size_t i = 0; i < c.theirs.size(); ++i) {
    tt += c.sample.truth[i] * c.sample.truth[i];
    ft += c.theirs[i] * c.sample.truth[i];
  }
  CageCase scaled = c;
  for (double& x : scaled.theirs) x *= tt / ft;
  return blocks_off(scaled) < 1e-3 * c.off;
}

bool has_right_sum(const CageCase& c) {
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < c.sample.question.vertices.size(); ++i) {
    sum += c.theirs[i] - c.sample.truth[i];
    size = std::max(size, std::abs(c.sample.truth[i]));
  }
  const double off = vertices_off(c);
  return off > kWrong && std::abs(sum) < 1e-3 * off * size;
}

bool has_chords(const CageCase& c) {
  if (c.sample.face < 0 || c.sample.question.dimension != 3) return false;
  const Face& face = c.sample.question.faces[static_cast<std::size_t>(c.sample.face)];
  if (face.size() != 3) return false;
  const auto weights = chord_weights(c.sample);
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(c.theirs[static_cast<std::size_t>(face.vertices[k])] - weights[k]) < kWrong)) return false;
  return true;
}

// Patterns over all cases of one unit of length.
struct Seen {
  bool everywhere = false;  // more than half of those inside are wrong
  bool inside = false;      // some are
  double largest = 0;       // error inside
};

std::string_view cause_of(const CageCase& c, const Seen& seen, bool right_in_other_unit) {
  if (has_wrong_size(c)) return "wrong_size";
  if (seen.everywhere && seen.largest < kFewDigits) return "few_digits";
  if (seen.everywhere && in_proportion(c)) return "right_after_normalising";
  if (seen.everywhere && has_right_sum(c)) return "sum_made_right";
  if (right_in_other_unit) return "absolute_threshold";
  if (has_chords(c)) return "chord_for_distance";
  if (c.sample.face >= 0 && !seen.inside) return "wrong_on_cage";
  return "wrong_values";
}

Seen seen_in(const std::vector<CageCase>& cases) {
  std::size_t all = 0, bad = 0;
  double largest = 0;
  for (const CageCase& c : cases)
    if (c.sample.face < 0) {
      ++all;
      bad += is_bad(c);
      largest = std::max(largest, c.off);
    }
  return {2 * bad > all, bad > 0, largest};
}

CageFinding finding_of(std::string_view key, const CageCase& c, std::size_t cases, std::string evidence) {
  return {&defect_named(key), c.sample.question, c.sample.truth, c.theirs, cases, std::move(evidence)};
}

// Whether two answers are the same numbers; NaN is the same as NaN.
bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

// An answer that depends on the cage that was asked before.
std::optional<CageFinding> find_state(const WholeCageFunction& theirs, std::string_view kind, int dimension) {
  const std::array<CageRequest, 2> cages = alike_cages(dimension);
  std::array<std::vector<double>, 4> answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i] = theirs(cages[i % 2]);
    if (answers[i].empty()) return std::nullopt;
    if (answers[i].size() != answers[0].size())
      return CageFinding{
          &defect_named("wrong_size"),
          cages[i % 2],
          {},
          answers[i],
          1,
          fmt::format("the first call gives {} numbers, a later one {}", answers[0].size(), answers[i].size())};
  }
  const std::array<std::vector<double>, 2> truths{truth_of(cages[0], kind), truth_of(cages[1], kind)};
  const auto finding = [&](std::size_t cage, const std::vector<double>& wrong, std::string evidence) {
    return CageFinding{&defect_named("state_between_calls"), cages[cage], truths[cage], wrong, 1, std::move(evidence)};
  };
  // Equal answers to both cages are the first one's only if they are right there: code may return a constant.
  constexpr double nearly = 1e-3;
  if (are_same(answers[0], answers[1]) && difference(answers[0], truths[0]) < nearly)
    return finding(1, answers[1], "a second cage, which differs by a vertex, gets the first one's coordinates");
  for (std::size_t cage = 0; cage < 2; ++cage) {
    const std::vector<double>&once = answers[cage], &again = answers[cage + 2];
    if (are_same(once, again) || difference(again, once) <= kWrong) continue;
    const bool first_is_wrong = difference(once, truths[cage]) > difference(again, truths[cage]);
    return finding(cage, first_is_wrong ? once : again, "a cage gets other coordinates after a call with another cage");
  }
  return std::nullopt;
}

}  // namespace

void require_judged_kind(std::string_view kind, int dimension) {
  const CoordinateKind& row = coordinate_kind_named(kind);
  const std::string_view elements = dimension == 2 ? "segments" : "triangles";
  // Computed directly, on quads as well as triangles; those of quads that are sums have integrals for truths.
  if (row.normalised && row.keeps_quads && !row.is_sum() && dimension == row.own_dimension) return;
  if (!row.is_sum() || row.keeps_quads)
    throw InputError(fmt::format("{} is no sum over {}, so coordinates of whole cages are not judged", kind, elements));
  for (const SummedBlock& block : row.blocks)
    if (block.kernel.find("kelvin") != std::string_view::npos)
      throw InputError(fmt::format("{} has matrices for coordinates: judge its formulas one by one", kind));
}

CageVerdict judge_whole_cage(const WholeCageFunction& theirs, std::string_view kind, int dimension) {
  require_judged_kind(kind, dimension);
  CageVerdict verdict;
  if (auto state = find_state(theirs, kind, dimension)) {
    verdict.findings.push_back(std::move(*state));
    return verdict;
  }
  verdict.convention = find_cage_convention(theirs, kind, dimension);
  const WholeCageFunction in_ours = [&](const CageRequest& question) {
    return verdict.convention ? verdict.convention->in_ours(question, kind, theirs(question)) : theirs(question);
  };
  const std::array<std::vector<CageCase>, 2> units{asked(in_ours, kind, 1, dimension),
                                                   asked(in_ours, kind, kOtherUnit, dimension)};
  std::map<std::string_view, std::vector<const CageCase*>> causes;
  for (std::size_t u = 0; u < 2; ++u) {
    const Seen seen = seen_in(units[0]);
    verdict.points += units[u].size();
    for (std::size_t i = 0; i < units[u].size(); ++i) {
      const CageCase &one = units[u][i], &other = units[1 - u][i];
      const bool is_left = one.sample.face < 0 && !is_finite(one.theirs) && is_bad(other);
      if (is_bad(one) && !is_left) causes[cause_of(one, seen, !is_bad(other))].push_back(&one);
    }
  }
  for (const Defect& defect : defects())
    if (const auto found = causes.find(defect.key); found != causes.end())
      verdict.findings.push_back(
          finding_of(defect.key, *found->second.front(), found->second.size(), off_text(*found->second.front())));
  return verdict;
}

}  // namespace cageproof::judge
