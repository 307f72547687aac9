// SPDX-License-Identifier: MIT
#include "deformation_report.h"

#include <Eigen/SVD>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::cli {

using namespace deformation;
namespace {

// Six times the volume within faces, or twice the area within segments, in that unit of length.
double content(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces,
               const std::vector<std::array<int, 2>>& segments, double unit) {
  double sum = 0;
  if (vertices.empty()) return sum;
  const auto from = [&](int v) -> Vec3<double> { return (vertices[v] - vertices.front()) / unit; };
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) sum += from(face[0]).dot(from(face[k - 1]).cross(from(face[k])));
  for (const auto& [a, b] : segments) {
    const Vec3<double> u = from(a), v = from(b);
    sum += u[0] * v[1] - u[1] * v[0];
  }
  return sum;
}

double cage_content(const CageElements& elements, const std::vector<Vec3<double>>& vertices, double unit) {
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 2>> segments;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    if (corners.size() == 2) segments.push_back({corners[0], corners[1]});
    else faces.emplace_back(corners.begin(), corners.end());
  }
  return content(vertices, faces, segments, unit);
}

// Whether each edge of a face is that of another the other way round, and each end of a segment the beginning of one.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k) ++edges[{face[k], face[(k + 1) % face.size()]}];
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other == edges.end() || other->second != count) return false;
  }
  std::map<int, int> ends;
  for (const auto& [a, b] : mesh.segments) {
    ++ends[a];
    --ends[b];
  }
  return std::ranges::all_of(ends, [](const auto& end) { return end.second == 0; });
}

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

nlohmann::ordered_json deformation_json(const CageCoordinates& coordinates, const Cage& cage, const Mesh& rest,
                                        const std::vector<Vec3<double>>& posed, const PointImages& images,
                                        std::size_t map, int order, const DeformationReport& prepared,
                                        const DeformationReport& pose, bool found_itself) {
  using Json = nlohmann::ordered_json;
  const CageElements& elements = coordinates.elements();
  const int d = elements.dimension();
  const double unit = cage.size();
  const std::vector<Vec3<double>> moved = vertices_of(images.maps[map], d);
  double largest = 0, sum = 0;
  std::size_t found = 0;
  const auto lost = static_cast<std::size_t>(std::ranges::count(images.missing, 1));
  for (std::size_t p = 0; p < rest.vertices.size(); ++p) {
    if (images.missing[p]) continue;
    const double step = (moved[p] - rest.vertices[p]).stableNorm();
    largest = std::max(largest, step);
    sum += step;
    ++found;
  }
  Json json = {{"points", rest.vertices.size()}, {"points_without_image", lost}};
  std::vector<std::string> warnings;
  if (lost > 0) warnings.push_back(fmt::format("{} of {} points have no image", lost, rest.vertices.size()));
  json["displacement"] = {{"largest", largest},
                          {"mean", found > 0 ? Json(sum / static_cast<double>(found)) : Json(nullptr)},
                          {"largest_over_cage_size", largest / cage.size()}};
  json["cage_volume_ratio"] =
      posed.empty() ? Json(nullptr)
                    : number(cage_content(elements, posed, unit) / cage_content(elements, elements.vertices(), unit));
  // An open mesh holds no volume.
  const double before = is_closed(rest) ? content(rest.vertices, rest.faces, rest.segments, unit) : 0;
  json["mesh_volume_ratio"] =
      before != 0 ? number(content(moved, rest.faces, rest.segments, unit) / before) : Json(nullptr);
  if (order >= 1) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    std::size_t turned = 0, without = 0;
    for (std::size_t p = 0; p < rest.vertices.size(); ++p) {
      const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
          &images.maps[map].tensors[1][p * d * d], d, d);
      if (images.missing[p]) continue;
      if (!jacobian.allFinite()) {
        ++without;
        continue;
      }
      const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
      least = std::min(least, values[d - 1]);
      most = std::max(most, values[0]);
      turned += jacobian.determinant() < 0 ? 1 : 0;
    }
    json["jacobians"] = {{"least_singular_value", number(least)},
                         {"largest_singular_value", number(most)},
                         {"points_turned_inside_out", turned},
                         {"points_without_jacobian", without}};
    if (without > 0) warnings.push_back(fmt::format("{} points on the cage have images and no Jacobians", without));
  }
  json["prepared"] = systems_json(prepared.systems);
  json["posed"] = systems_json(pose.systems);
  json["figures"] = Json::object();
  for (const auto& figures : {prepared.figures, pose.figures})
    for (const auto& [name, value] : figures) json["figures"][name] = number(value);
  if (found_itself) {
    json["posed_vertices"] = Json::array();
    for (const Vec3<double>& v : posed)
      json["posed_vertices"].push_back(d == 2 ? Json{v[0], v[1]} : Json{v[0], v[1], v[2]});
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
