// SPDX-License-Identifier: MIT
// Coordinates of a cage by deliberately wrong forms.
#include "vectors/cage_defects.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof::judge {
namespace {

using Numbers = std::vector<double>;

const std::string kNoCase = "no-case-on-cage", kBothSides = "mean-of-sides", kSplitQuads = "split-quads";

std::vector<double> right_of(const Formula& formula, const validation::Sample& sample) {
  const auto evaluation = EvaluationRegister::instance().with_role(formula.name, Role::Recommended);
  return validation::evaluate<double>(*evaluation, sample, 0).value;
}

validation::Sample sample_of(const Face& face, const CageRequest& q, const Vec3<double>& point,
                             const Formula& formula) {
  validation::Sample sample;
  for (int k = 0; k < face.size(); ++k)
    sample.corners.push_back(q.vertices[static_cast<std::size_t>(face.vertices[k])]);
  sample.point = point;
  for (const Parameter& parameter : formula.parameters) sample.parameters.push_back(parameter.preset);
  return sample;
}

ElementKind element_of(const Face& face) {
  return face.size() == 2 ? ElementKind::Segment : face.size() == 3 ? ElementKind::Triangle : ElementKind::Quad;
}

// One block: an element's values are added to its vertices', or follow those of the elements before.
void add_to(Numbers& block, std::size_t& next, const Numbers& values, const Face& face, const CoordinateBlock& of) {
  const auto entries = static_cast<std::size_t>(of.entries());
  if (of.owner != Owner::Vertex) {
    for (const double x : values) block[next++] += x;
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    block[static_cast<std::size_t>(face.vertices[i / entries]) * entries + i % entries] += values[i];
}

/// Sums a kind over the elements of a cage, by a defect of its formulas where there is one, or null for none.
/// \return nothing where the defect acts on no element
std::optional<Numbers> summed(const CageVectorSet& set, const Vec3<double>& point, const KnownDefect* defect) {
  const CageRequest& q = set.question;
  Numbers all;
  bool acts = defect == nullptr;
  for (std::size_t b = 0; b < set.blocks.size(); ++b) {
    Numbers block(static_cast<std::size_t>(set.blocks[b].size) * static_cast<std::size_t>(set.blocks[b].entries()), 0);
    std::size_t next = 0;
    for (const Face& face : q.faces) {
      const Formula& formula = *find_formula(element_of(face), set.kind->blocks[b].kernel);
      const validation::Sample sample = sample_of(face, q, point, formula);
      const auto wrong = defect != nullptr ? defect->result(formula, sample, 0) : std::nullopt;
      acts = acts || wrong;
      add_to(block, next, wrong ? wrong->value : right_of(formula, sample), face, set.blocks[b]);
    }
    all.insert(all.end(), block.begin(), block.end());
  }
  if (!acts) return std::nullopt;
  if (!set.kind->normalised) return all;
  const double sum = std::accumulate(all.begin(), all.end(), 0.0);
  for (double& x : all) x /= sum;
  return all;
}

Numbers numbers_of(const CageRequest& question, std::string_view kind, const Vec3<double>& point) {
  const CageCoordinates coordinates(question.cage(), coordinate_kind_named(kind), CoordinateOptions{});
  Numbers all;
  for (const auto& block : coordinates.at<double>(point, 0))
    all.insert(all.end(), block.value.begin(), block.value.end());
  return all;
}

bool is_off(const Numbers& found, const CageVector& vector, const CageVectorSet& set) {
  std::size_t begin = 0;
  for (std::size_t b = 0; b < set.blocks.size(); ++b) {
    Mp100 squares(0);
    for (int i = 0; i < set.blocks[b].size * set.blocks[b].entries(); ++i, ++begin) {
      if (!std::isfinite(found[begin])) return true;
      const Mp100 off = Mp100(found[begin]) - vector.value[begin];
      squares += off * off;
    }
    if (sqrt(squares) > vector_bound * unit_roundoff<double>() * vector.denominators[b]) return true;
  }
  return false;
}

// Half of what is inside the cage and half of what is outside, next to a point on it.
Numbers mean_of_sides(const CageVector& vector, const CageVectorSet& set) {
  Vec3<double> middle = Vec3<double>::Zero();
  for (const Vec3<double>& vertex : set.question.vertices)
    middle += vertex / static_cast<double>(set.question.vertices.size());
  Numbers all = numbers_of(set.question, set.kind->name, vector.point + 0x1p-40 * (vector.point - middle));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = (all[i] + static_cast<double>(vector.value[i])) / 2;
  return all;
}

// The same coordinates of the cage whose quads are split by their shorter diagonals, for kinds with one number a
// vertex.
std::string_view of_split_quads(const CoordinateKind& kind) {
  return kind.keeps_quads && kind.normalised ? "mean_value" : "";
}

void add_defects_of_sum(CageVector& vector, const CageVectorSet& set, bool is_on) {
  // Where a sum of right values in doubles is off already, nothing is said of wrong ones.
  const bool is_sound = !is_off(*summed(set, vector.point, nullptr), vector, set);
  for (const KnownDefect& defect : known_defects())
    if (is_sound)
      if (const auto found = summed(set, vector.point, &defect); found && is_off(*found, vector, set))
        vector.defects.emplace_back(defect.name);
  if (is_on && set.kind->normalised && !is_sound) vector.defects.push_back(kNoCase);
  if (is_on && !set.kind->normalised && is_off(mean_of_sides(vector, set), vector, set))
    vector.defects.push_back(kBothSides);
}

}  // namespace

std::vector<CageDefect> cage_defects() {
  std::vector<CageDefect> all;
  for (const KnownDefect& defect : known_defects())
    all.push_back({std::string(defect.name), std::string(defect.description)});
  all.push_back({kNoCase, "a point on the cage is taken for one off it"});
  all.push_back({kBothSides, "on the cage the mean of the limits from inside and outside"});
  all.push_back({kSplitQuads, "quads are split into triangles"});
  return all;
}

void add_defects(CageVector& vector, const CageVectorSet& set, bool is_on) {
  if (set.kind->is_sum()) add_defects_of_sum(vector, set, is_on);
  if (const std::string_view split = of_split_quads(*set.kind);
      !split.empty() && is_off(numbers_of(set.question, split, vector.point), vector, set))
    vector.defects.push_back(kSplitQuads);
}

}  // namespace cageproof::judge
