// SPDX-License-Identifier: MIT
// Reference cases: rest cages, poses and points.
#pragma once

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/deformation/deformer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace cageproof::deformation::test {

using Vec = Vec3<double>;

struct Case {
  std::string name;
  Cage cage;
  std::vector<Vec> posed, points;
  double size;
};

inline Case cube() {
  Cage cage = embedded_cage("cube");
  std::vector<Vec> posed = cage.vertices();
  posed[7] += Vec(.3, .2, .4);
  posed[0] += Vec(-.1, 0, -.2);
  posed[3] += Vec(0, -.3, .1);
  const double size = cage.size();
  return {"cube", std::move(cage), posed, {{.1, .2, -.15}, {.3, -.35, .25}, {-.45, .4, .1}}, size};
}

/// Five rings, faces as the embedded twisted bar's, which is the pose.
inline Case bar() {
  Cage twisted = embedded_cage("twisted-bar");
  std::vector<Vec> rest, posed = twisted.vertices();
  // Each ring is turned about the axis: turned back, its corners are at +-1/2.
  for (const Vec& v : posed) rest.emplace_back(v);
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const std::size_t corner = v % 4;
    rest[v] = Vec(corner == 0 || corner == 3 ? -.5 : .5, corner < 2 ? -.5 : .5, posed[v][2]);
  }
  Cage cage = Cage::make("bar", rest, twisted.faces(), {});
  const double size = cage.size();
  return {"bar", std::move(cage), posed, {{.1, -.2, .3}, {-.3, .25, -.8}, {.05, .1, .95}}, size};
}

/// Nothing where the data are not next to the project.
inline std::optional<Case> real(const std::string& name, const std::vector<int>& points) {
  const std::filesystem::path folder = CAGEPROOF_SHARED_DATA;
  if (!std::filesystem::exists(folder / (name + "_Cage.obj"))) return std::nullopt;
  Cage cage = read_cage((folder / (name + "_Cage.obj")).string(), {.flip_inward = true});
  const std::vector<Vec> posed = read_mesh((folder / (name + "_Cage_Deformed.obj")).string()).vertices;
  const Mesh mesh = read_mesh((folder / (name + ".obj")).string());
  std::vector<Vec> at;
  at.reserve(points.size());
  for (const int p : points) at.push_back(mesh.vertices[p]);
  const double size = cage.size();
  return Case{name, std::move(cage), posed, at, size};
}
inline std::optional<Case> spiky_box() { return real("SpikyBox", {0, 20000, 40000}); }

inline Case polygon(const std::string& name, const std::vector<std::array<double, 2>>& corners,
                    const std::vector<std::array<double, 2>>& steps, const Vec& point) {
  std::vector<Vec> vertices, posed;
  std::vector<Face> segments;
  const int n = static_cast<int>(corners.size());
  for (int k = 0; k < n; ++k) {
    vertices.emplace_back(corners[k][0], corners[k][1], 0);
    posed.emplace_back(corners[k][0] + steps[k][0], corners[k][1] + steps[k][1], 0);
    segments.push_back({{k, (k + 1) % n, -1, -1}});
  }
  Cage cage = Cage::make_polygon(name, vertices, segments, {});
  const double size = cage.size();
  return {name, std::move(cage), posed, {point}, size};
}
inline Case square() {
  return polygon("square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 0}, {.4, -.2}, {.1, .3}, {-.2, .1}}, {.3, .6, 0});
}
inline Case l_shape() {
  return polygon("L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                 {{0, 0}, {.3, -.2}, {.4, .1}, {.1, .2}, {-.1, .3}, {-.2, 0}}, {.5, .5, 0});
}
inline Case pentagon() {
  return polygon("pentagon", {{0, 0}, {2, -.3}, {2.6, 1.1}, {1.1, 2.2}, {-.4, 1.2}},
                 {{0, 0}, {.3, -.1}, {.2, .4}, {-.1, .3}, {-.3, -.2}}, {1, .9, 0});
}

/// A figure of that name; NaN where the report has none.
inline double figure(const DeformationReport& report, std::string_view name) {
  const auto found = std::ranges::find(report.figures, name, [](const auto& f) { return std::string_view(f.first); });
  return found == report.figures.end() ? NAN : found->second;
}

inline bool warns_of(const DeformationReport& report, std::string_view words) {
  return std::ranges::any_of(report.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// Takes the larger one; what is no number is larger than any.
inline void keep_larger(double& worst, double found) {
  if (!(found <= worst)) worst = found;
}

/// Images of points under a pose.
template <Scalar R = double>
Images<R> deformed(const Deformer<R>& deformer, const std::vector<Vec3<R>>& posed, const std::vector<Vec3<R>>& points,
                   int order = 0) {
  const auto pose = deformer.pose({posed, {}});
  return deformer.images(*pose, points, order);
}

inline std::shared_ptr<const Deformer<double>> prepared(const Cage& cage, std::string_view method,
                                                        std::vector<double> parameters = {}) {
  return prepare_deformer<double>(deform_method_named(method), cage, {.parameters = std::move(parameters)});
}

inline Vec image(const Images<double>& images, std::size_t p, int d = 3) {
  Vec found = Vec::Zero();
  for (int c = 0; c < d; ++c) found[c] = images.tensors[0][p * d + c];
  return found;
}

}  // namespace cageproof::deformation::test
