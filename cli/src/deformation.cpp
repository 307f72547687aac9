// SPDX-License-Identifier: MIT
#include "deformation.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/winding_number.h"
#include "cageproof/validation/parallel.h"

#include <Eigen/SVD>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::cli {

using namespace deformation;
namespace {

constexpr std::array axes{"x", "y", "z"};

// Whether points off the cage are inside it.
class Inside {
 public:
  explicit Inside(const CageElements& elements) {
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto c = elements.corners(e);
      if (c.size() == 2) segments_.push_back({c[0], c[1]});
      else triangles_.push_back({c[0], c[1], c[2]});
      if (c.size() == 4) triangles_.push_back({c[0], c[2], c[3]});
    }
  }
  // On the cage counts as inside.
  bool holds(const Vec3<double>& point) const {
    const std::optional<int> winding =
        segments_.empty() ? winding_number(triangles_, point) : winding_number(segments_, point);
    return !winding || *winding != 0;
  }

 private:
  std::vector<Triangle<double>> triangles_;
  std::vector<Segment<double>> segments_;
};

CoordinateColumns columns_of(int dimension, int order) {
  CoordinateColumns table;
  static constexpr std::array labels{"image", "image gradient", "image Hessian"};
  for (int o = 0; o <= order; ++o) {
    const std::size_t before = table.names.size();
    for (int c = 0; c < dimension; ++c) {
      if (o == 0) table.names.emplace_back(axes[c]);
      for (int i = 0; o >= 1 && i < dimension; ++i) {
        if (o == 1) table.names.push_back(fmt::format("{}_d{}", axes[c], axes[i]));
        for (int j = 0; o == 2 && j < dimension; ++j)
          table.names.push_back(fmt::format("{}_d{}{}", axes[c], axes[i], axes[j]));
      }
    }
    table.groups.push_back({labels[o], table.names.size() - before});
  }
  return table;
}

// A point's numbers in a row of the table.
void put_row(const Images<double>& images, std::size_t p, int dimension, int order, std::span<double> row) {
  std::size_t column = 0;
  for (int o = 0; o <= order; ++o) {
    const std::size_t count = dimension * derivative_count(dimension, o);
    std::copy_n(&images.tensors[o][p * count], count, row.begin() + static_cast<std::ptrdiff_t>(column));
    column += count;
  }
}

// The point itself, and the derivatives of the identity.
void put_rest(const Vec3<double>& point, int dimension, int order, std::span<double> row) {
  std::ranges::fill(row, 0.0);
  for (int c = 0; c < dimension; ++c) {
    row[c] = point[c];
    if (order >= 1) row[dimension + c * dimension + c] = 1;
  }
}

// Six times the volume within faces, or twice the area within segments.
double content(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces,
               const std::vector<std::array<int, 2>>& segments) {
  double sum = 0;
  if (vertices.empty()) return sum;
  const Vec3<double>& about = vertices.front();
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k)
      sum += (vertices[face[0]] - about).dot((vertices[face[k - 1]] - about).cross(vertices[face[k]] - about));
  for (const auto& [a, b] : segments) {
    const Vec3<double> u = vertices[a] - about, v = vertices[b] - about;
    sum += u[0] * v[1] - u[1] * v[0];
  }
  return sum;
}

double cage_content(const CageElements& elements, const std::vector<Vec3<double>>& vertices) {
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 2>> segments;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    if (corners.size() == 2) segments.push_back({corners[0], corners[1]});
    else faces.emplace_back(corners.begin(), corners.end());
  }
  return content(vertices, faces, segments);
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

std::vector<Deformed> deform(const Deformer<double>& deformer, const Cage& cage, const Mesh& mesh,
                             const std::vector<std::pair<std::string, std::vector<Vec3<double>>>>& poses, int order,
                             OutsidePolicy outside, int jobs) {
  const CageCoordinates& coordinates = deformer.coordinates();
  const int d = coordinates.dimension();
  if (order > deformer.max_order())
    throw InputError(
        fmt::format("{} has derivatives up to order {} alone", coordinates.kind().name, deformer.max_order()));
  std::vector<Deformed> all(poses.size());
  const CoordinateColumns empty = columns_of(d, order);
  const std::size_t columns = empty.names.size(), points = mesh.vertices.size();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    try {
      all[k].posed = deformer.pose({poses[k].second, {}});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", poses[k].first, error.what()));
    }
    all[k].table = empty;
    all[k].table.values.resize(points * columns);
    all[k].mesh = mesh;
  }
  // Normalised coordinates sum to one everywhere.
  const std::optional<Inside> inside =
      coordinates.kind().normalised ? std::nullopt : std::optional<Inside>(coordinates.elements());
  std::vector<char> missing(points);
  constexpr std::size_t together = 128;
  validation::for_each_parallel((points + together - 1) / together, jobs, [&](std::size_t block) {
    const std::size_t first = block * together, count = std::min(together, points - first);
    const auto tables = coordinates.at<double>(std::span(mesh.vertices).subspan(first, count), order);
    for (std::size_t p = 0; p < count; ++p) missing[first + p] = inside && !inside->holds(mesh.vertices[first + p]);
    for (Deformed& one : all) {
      const Images<double> images = one.posed->images(tables, count, order);
      for (std::size_t p = 0; p < count; ++p) {
        const std::span<double> row = std::span(one.table.values).subspan((first + p) * columns, columns);
        put_row(images, p, d, order, row);
        // On the cage derivatives may be nan; values are not.
        const bool lost =
            missing[first + p] || std::ranges::any_of(row.first(d), [](double x) { return std::isnan(x); });
        missing[first + p] = lost;
        if (lost && outside == OutsidePolicy::Rest) put_rest(mesh.vertices[first + p], d, order, row);
        if (lost && outside != OutsidePolicy::Rest) std::ranges::fill(row, std::numeric_limits<double>::quiet_NaN());
        for (int c = 0; c < d; ++c) one.mesh.vertices[first + p][c] = row[c];
      }
    }
  });
  const auto lost = static_cast<std::size_t>(std::ranges::count(missing, 1));
  if (lost > 0 && outside == OutsidePolicy::Error) {
    const auto which = std::ranges::find(missing, 1) - missing.begin();
    throw InputError(
        fmt::format("{} of {} points, the first of them number {}, are outside {} or have no coordinates "
                    "there; --outside rest leaves them where they are, --outside nan writes nan",
                    lost, points, which, cage.name()));
  }
  for (Deformed& one : all) one.without_image = lost;
  return all;
}

nlohmann::ordered_json deformation_json(const Deformer<double>& deformer, const Cage& cage, const Mesh& rest,
                                        const std::vector<Vec3<double>>& posed, const Deformed& deformed, int order) {
  using Json = nlohmann::ordered_json;
  const CageElements& elements = deformer.coordinates().elements();
  const int d = elements.dimension();
  double largest = 0, sum = 0;
  std::size_t moved = 0;
  for (std::size_t p = 0; p < rest.vertices.size(); ++p) {
    const double step = (deformed.mesh.vertices[p] - rest.vertices[p]).norm();
    if (std::isnan(step)) continue;
    largest = std::max(largest, step);
    sum += step;
    ++moved;
  }
  Json json = {{"points", rest.vertices.size()}, {"points_without_image", deformed.without_image}};
  json["displacement"] = {{"largest", largest},
                          {"mean", moved > 0 ? Json(sum / static_cast<double>(moved)) : Json(nullptr)},
                          {"largest_over_cage_size", largest / cage.size()}};
  json["cage_volume_ratio"] = number(cage_content(elements, posed) / cage_content(elements, elements.vertices()));
  const double before = content(rest.vertices, rest.faces, rest.segments);
  json["mesh_volume_ratio"] =
      before != 0 ? number(content(deformed.mesh.vertices, rest.faces, rest.segments) / before) : Json(nullptr);
  if (order >= 1) {
    double least = HUGE_VAL, most = 0, turned = 0;
    const std::size_t columns = deformed.table.names.size();
    for (std::size_t p = 0; p < rest.vertices.size(); ++p) {
      const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
          &deformed.table.values[p * columns + d], d, d);
      if (!jacobian.allFinite()) continue;
      const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues();
      least = std::min(least, values[d - 1]);
      most = std::max(most, values[0]);
      turned += jacobian.determinant() < 0 ? 1 : 0;
    }
    json["jacobians"] = {{"least_singular_value", number(least)},
                         {"largest_singular_value", most},
                         {"points_turned_inside_out", turned}};
  }
  const DeformationReport prepared = deformer.prepared(), &pose = deformed.posed->report();
  json["prepared"] = systems_json(prepared.systems);
  json["posed"] = systems_json(pose.systems);
  json["figures"] = Json::object();
  for (const auto& figures : {prepared.figures, pose.figures})
    for (const auto& [name, value] : figures) json["figures"][name] = number(value);
  json["warnings"] = Json::array();
  for (const auto& warnings : {prepared.warnings, pose.warnings})
    for (const std::string& warning : warnings) json["warnings"].push_back(warning);
  return json;
}

}  // namespace cageproof::cli
