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

const std::string kNoCase = "no-case-on-cage", kBothSides = "mean-of-sides";

std::vector<double> right_of(const Formula& formula, const validation::Sample& sample) {
  const auto evaluation = EvaluationRegister::instance().with_role(formula.name, Role::Recommended);
  return validation::evaluate<double>(*evaluation, sample, 0).value;
}

/// Sums a kind over the elements of a cage, by a defect of its formulas where there is one, or null for none.
/// \return nothing where the defect acts on no element
std::optional<Numbers> summed(const CageVectorSet& set, const Vec3<double>& point, const KnownDefect* defect) {
  const CageQuestion& q = set.question;
  const ElementKind element = q.dimension == 2 ? ElementKind::Segment : ElementKind::Triangle;
  Numbers all;
  bool acts = defect == nullptr;
  for (std::size_t b = 0; b < set.blocks.size(); ++b) {
    const Formula& formula = *find_formula(element, set.kind->blocks[b].kernel);
    Numbers block(static_cast<std::size_t>(set.blocks[b].size), 0);
    for (std::size_t f = 0; f < q.faces.size(); ++f) {
      validation::Sample sample;
      for (int k = 0; k < q.dimension; ++k)
        sample.corners.push_back(q.vertices[static_cast<std::size_t>(q.faces[f].vertices[k])]);
      sample.point = point;
      for (const Parameter& parameter : formula.parameters) sample.parameters.push_back(parameter.preset);
      const auto wrong = defect != nullptr ? defect->result(formula, sample, 0) : std::nullopt;
      acts = acts || wrong;
      const Numbers values = wrong ? wrong->value : right_of(formula, sample);
      if (values.size() == 1) block[f] += values[0];
      else
        for (int k = 0; k < q.dimension; ++k)
          block[static_cast<std::size_t>(q.faces[f].vertices[k])] += values[static_cast<std::size_t>(k)];
    }
    all.insert(all.end(), block.begin(), block.end());
  }
  if (!acts) return std::nullopt;
  if (!set.kind->normalised) return all;
  const double sum = std::accumulate(all.begin(), all.end(), 0.0);
  for (double& x : all) x /= sum;
  return all;
}

bool is_off(const Numbers& found, const CageVector& vector, const CageVectorSet& set) {
  std::size_t begin = 0;
  for (std::size_t b = 0; b < set.blocks.size(); ++b) {
    Mp100 squares(0);
    for (int i = 0; i < set.blocks[b].size; ++i, ++begin) {
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
  const CageCoordinates coordinates(set.question.cage(), *set.kind, CoordinateOptions{});
  Vec3<double> middle = Vec3<double>::Zero();
  for (const Vec3<double>& vertex : set.question.vertices)
    middle += vertex / static_cast<double>(set.question.vertices.size());
  const Vec3<double> outside = vector.point + 0x1p-40 * (vector.point - middle);
  Numbers all;
  for (const auto& block : coordinates.at<double>(outside, 0))
    all.insert(all.end(), block.value.begin(), block.value.end());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = (all[i] + static_cast<double>(vector.value[i])) / 2;
  return all;
}

}  // namespace

std::vector<CageDefect> cage_defects() {
  std::vector<CageDefect> all;
  for (const KnownDefect& defect : known_defects())
    all.push_back({std::string(defect.name), std::string(defect.description)});
  all.push_back({kNoCase, "a point on the cage is taken for one off it"});
  all.push_back({kBothSides, "on the cage the mean of the limits from inside and outside"});
  return all;
}

void add_defects(CageVector& vector, const CageVectorSet& set, bool is_on) {
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

}  // namespace cageproof::judge
