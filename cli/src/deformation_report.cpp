// SPDX-License-Identifier: MIT
#include "deformation_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cageproof::cli {

using namespace deformation;
namespace {

nlohmann::ordered_json number(double x) { return std::isfinite(x) ? nlohmann::ordered_json(x) : nullptr; }

nlohmann::ordered_json systems_json(const std::vector<SolvedSystem>& systems) {
  auto all = nlohmann::ordered_json::array();
  for (const SolvedSystem& s : systems)
    all.push_back({{"name", s.name},
                   {"rows", s.rows},
                   {"columns", s.columns},
                   {"rank", s.rank},
                   {"singular", s.is_singular()},
                   {"condition", number(s.condition)},
                   {"residual", number(s.residual)}});
  return all;
}

}  // namespace

nlohmann::ordered_json deformation_json(const MeshMeasures& measures, std::size_t points, double cage_size,
                                        const std::vector<Vec3<double>>& found, int dimension,
                                        const DeformationReport& prepared, const DeformationReport& pose) {
  using Json = nlohmann::ordered_json;
  Json json = {{"points", points}, {"points_without_image", measures.missing}};
  std::vector<std::string> warnings;
  if (measures.missing > 0) warnings.push_back(fmt::format("{} of {} points have no image", measures.missing, points));
  json["displacement"] = {{"largest", number(measures.largest_displacement)},
                          {"mean", number(measures.mean_displacement)},
                          {"largest_over_cage_size", number(measures.largest_displacement / cage_size)}};
  json["cage_volume_ratio"] = number(measures.cage_ratio);
  json["mesh_volume_ratio"] = number(measures.mesh_ratio);
  if (const auto& jacobians = measures.jacobians) {
    json["jacobians"] = {{"least_singular_value", number(jacobians->least_singular_value)},
                         {"largest_singular_value", number(jacobians->largest_singular_value)},
                         {"points_turned_inside_out", jacobians->turned},
                         {"points_without_jacobian", jacobians->without}};
    if (jacobians->without > 0)
      warnings.push_back(
          fmt::format("{} points have images and no Jacobians: on the cage derivatives may have no limit, and "
                      "elsewhere they leave double's range",
                      jacobians->without));
  }
  json["prepared"] = systems_json(prepared.systems);
  json["posed"] = systems_json(pose.systems);
  json["figures"] = Json::object();
  for (const auto& figures : {prepared.figures, pose.figures})
    for (const auto& [name, value] : figures) json["figures"][name] = number(value);
  if (!found.empty()) {
    json["posed_vertices"] = Json::array();
    for (const Vec3<double>& v : found)
      json["posed_vertices"].push_back(dimension == 2 ? Json{v[0], v[1]} : Json{v[0], v[1], v[2]});
  }
  if (!pose.energies.empty()) {
    json["energies"] = Json::array();
    for (const double energy : pose.energies) json["energies"].push_back(number(energy));
  }
  if (!pose.merits.empty()) {
    json["merits"] = Json::array();
    for (const double merit : pose.merits) json["merits"].push_back(number(merit));
  }
  json["warnings"] = Json::array();
  for (const auto& some : {prepared.warnings, pose.warnings, warnings})
    for (const std::string& warning : some)
      if (std::ranges::find(json["warnings"], Json(warning)) == json["warnings"].end())
        json["warnings"].push_back(warning);
  return json;
}

}  // namespace cageproof::cli
