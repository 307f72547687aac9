// SPDX-License-Identifier: MIT
// Every method in every one of its settings that decides what it takes of a pose.
#pragma once

#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

namespace cageproof::deformation::test {

struct Setting {
  std::string_view method;
  /// By name, others at their defaults.
  std::vector<std::pair<std::string_view, double>> parameters = {};
  bool uses_normals = false;  ///< the posed unit normals, so that elements without any are refused

  /// A quad two of whose corners coincide, or three of which are in line, has an area.
  bool keeps_quads() const { return coordinate_kind_named(deform_method_named(method).kind).keeps_quads; }
  std::string text() const {
    std::string found(method);
    for (const auto& [name, value] : parameters) found += ' ' + std::string(name) + '=' + std::to_string(value);
    return found;
  }
};

inline const std::vector<Setting>& settings() {
  static const std::vector<Setting> all = [] {
    std::vector<Setting> found;
    for (const char* method : {"mean_value", "quad_mean_value", "spherical_mean_value", "maximum_entropy", "harmonic",
                               "harmonic_goursat", "elastic"})
      found.push_back({method});
    const double area = 2;
    for (const double stretch : {0., 1., 2., 3.}) found.push_back({"green", {{"stretch", stretch}}, stretch != area});
    for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "biharmonic_direct"})
      for (const double stretch : {0., 1., 2., 3.}) found.push_back({method, {{"normals", stretch}}, stretch != area});
    for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "biharmonic_direct"})
      for (const double stretch : {area, 3.}) found.push_back({method, {{"normals", stretch}, {"neumann", 1}}, true});
    const double free = 2;
    for (const char* method : {"ahap", "aaap", "tp"})
      for (const double alignment : {0., 1., 2., 3.})
        found.push_back({method, {{"alignment", alignment}}, alignment != free});
    for (const double variant : {0., 1., 2.})
      for (const double gamma : {0., 1.})
        found.push_back({"somigliana", {{"variant", variant}, {"gamma", gamma}}, variant != 0 || gamma != 0});
    const double product = 4;
    for (const double stretch : {0., 1., 2., 3., 4.}) {
      const bool takes_no_area = stretch == area || stretch == product;
      found.push_back({"quad_green", {{"stretch", stretch}}, !takes_no_area});
      found.push_back({"quad_biharmonic_1_3", {{"normals", stretch}}, !takes_no_area});
    }
    for (const double variant : {0., 1., 2.})
      for (const double gamma : {0., 1.})
        found.push_back({"quad_somigliana", {{"variant", variant}, {"gamma", gamma}}, variant != 0 || gamma != 0});
    found.push_back({"cauchy"});
    for (const double normals : {0., 1., 2.})
      found.push_back({"biharmonic_boundary", {{"normals", normals}}, normals != 1});
    for (const double normals : {0., 1.}) found.push_back({"biharmonic_goursat", {{"normals", normals}}, normals != 1});
    return found;
  }();
  return all;
}

/// The settings of methods that the cage has.
inline std::vector<Setting> settings_on(const Cage& cage) {
  std::vector<Setting> found;
  for (const Setting& s : settings())
    if (why_refused(deform_method_named(s.method), cage).empty()) found.push_back(s);
  return found;
}

/// \throws InputError as prepare_deformer
template <Scalar R = double>
std::shared_ptr<const Deformer<R>> prepared_with(const Cage& cage, const Setting& setting) {
  const DeformMethod& method = deform_method_named(setting.method);
  const std::vector<KindParameter> parameters = parameters_of(method);
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const KindParameter& p : parameters) {
    const auto given = std::ranges::find(setting.parameters, p.name, [](const auto& one) { return one.first; });
    values.push_back(given == setting.parameters.end() ? p.preset : given->second);
  }
  return prepare_deformer<R>(method, cage, {.parameters = std::move(values)});
}

/// The same as prepared_with(), prepared once for all tests of a program.
inline const Deformer<double>& kept_with(const Cage& cage, const Setting& setting) {
  using Key = std::tuple<std::string, std::vector<double>, std::vector<int>>;
  static std::map<Key, std::shared_ptr<const Deformer<double>>> kept;
  Key key{setting.text(), {}, {}};
  for (const Vec& v : cage.vertices()) std::get<1>(key).insert(std::get<1>(key).end(), {v[0], v[1], v[2]});
  for (const Face& f : cage.faces())
    std::get<2>(key).insert(std::get<2>(key).end(), f.vertices.begin(), f.vertices.end());
  auto& found = kept[std::move(key)];
  if (!found) found = prepared_with(cage, setting);
  return *found;
}

/// The text of a refusal; empty if there is none.
template <class Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

inline DeformationReport report_of(const Cage& cage, const Setting& setting, const std::vector<Vec>& posed) {
  return kept_with(cage, setting).pose({posed, {}})->report();
}

inline bool is_finite(const Images<double>& images) {
  return std::ranges::all_of(images.tensors[0], [](double x) { return std::isfinite(x); });
}

/// A turn that no coordinate axis keeps, so that rounding has its part.
inline std::vector<Vec> turned(std::vector<Vec> points, int d) {
  const Eigen::Matrix3d turn = d == 2 ? Eigen::AngleAxisd(0.7, Vec::UnitZ()).toRotationMatrix()
                                      : Eigen::AngleAxisd(1.1, Vec(1, 2, -.5).normalized()).toRotationMatrix();
  for (Vec& p : points) p = turn * p;
  return points;
}

inline std::vector<Vec> scaled(std::vector<Vec> points, const Vec& by) {
  for (Vec& p : points) p = p.cwiseProduct(by);
  return points;
}

}  // namespace cageproof::deformation::test
