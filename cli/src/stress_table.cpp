// SPDX-License-Identifier: MIT
#include "stress_table.h"

#include "commands.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cageproof::cli {

using namespace deformation;
namespace {

constexpr std::array axes{"x", "y", "z"};

// Entries of symmetric tensors in VTK's order; the plane has the first four.
constexpr std::array<std::pair<int, int>, 6> entries{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

std::size_t entry_count(int dimension) { return dimension == 2 ? 4 : 6; }

const KindParameter* ratio_among(const std::vector<KindParameter>& known) {
  const auto found = std::ranges::find(known, "nu", &KindParameter::name);
  return found == known.end() ? nullptr : &*found;
}

CoordinateColumns headed(int dimension, bool with_tractions) {
  CoordinateColumns table;
  for (const std::string label : {"strain", "stress"}) {
    for (std::size_t e = 0; e < entry_count(dimension); ++e)
      table.names.push_back(fmt::format("{}_{}{}", label, axes[entries[e].first], axes[entries[e].second]));
    table.groups.push_back({label, entry_count(dimension)});
  }
  table.names.emplace_back("von_mises");
  table.groups.push_back({"von Mises stress", 1});
  if (!with_tractions) return table;
  for (int c = 0; c < dimension; ++c) table.names.push_back(fmt::format("traction_{}", axes[c]));
  table.groups.push_back({"traction", static_cast<std::size_t>(dimension)});
  return table;
}

// A point's Jacobian; across the plane the identity.
Mat3<double> jacobian_of(const Images<double>& images, std::size_t point, int dimension) {
  Mat3<double> jacobian = Mat3<double>::Identity();
  for (int c = 0; c < dimension; ++c)
    for (int i = 0; i < dimension; ++i) jacobian(c, i) = images.tensors[1][(point * dimension + c) * dimension + i];
  return jacobian;
}

}  // namespace

void add_stress(Command& command, StressArguments& a) {
  Option stress = command.option(
      "--stress", a.file,
      ".csv, .npy or .vtp: strain and stress of the displacement by linear elasticity, in the plane by plane strain");
  stress.taking("FILE");
  command
      .option("--normals", a.normals,
              "normals, with which --stress adds the traction on the plane with that normal: text with three numbers "
              "per line, for polygons two; one line per point")
      .taking("FILE")
      .needs(stress);
  command.option("--shear-modulus", a.shear_modulus, "mu of --stress; stresses have its unit")
      .in_range(1e-100, 1e100)
      .showing_default("1")
      .needs(stress);
  command
      .option("--poisson-ratio", a.poisson_ratio,
              "nu of --stress, between -1 and 1/2, for methods without the parameter nu")
      .taking("NU")
      .needs(stress);
}

void check_stress(const StressArguments& a, std::string_view method, const std::vector<KindParameter>& known) {
  if (!a.asked()) return;
  if (ratio_among(known)) {
    if (!std::isnan(a.poisson_ratio))
      throw InputError(fmt::format("--poisson-ratio: {} has Poisson's ratio; use --parameter nu=VALUE", method));
    return;
  }
  if (std::isnan(a.poisson_ratio))
    throw InputError(fmt::format("--stress: {} has no Poisson's ratio; give it by --poisson-ratio NU", method));
  if (std::isinf(a.poisson_ratio) || !has_stress(a.poisson_ratio))
    throw InputError(fmt::format("--poisson-ratio {}: must be between -1 and 1/2, both excluded", a.poisson_ratio));
}

Material material_of(const StressArguments& a, const std::vector<KindParameter>& known,
                     const std::vector<double>& parameters) {
  const KindParameter* ratio = ratio_among(known);
  return {.shear_modulus = std::isnan(a.shear_modulus) ? 1 : a.shear_modulus,
          .poisson_ratio = ratio ? parameters[ratio - known.data()] : a.poisson_ratio};
}

std::vector<Vec3<double>> unit_normals(const StressArguments& a, std::size_t points, int dimension) {
  if (a.normals.empty()) return {};
  std::vector<Vec3<double>> normals = load_points(a.normals, dimension).vertices;
  if (normals.size() != points)
    throw InputError(fmt::format("{}: {} normals, there are {} points", a.normals, normals.size(), points));
  for (std::size_t p = 0; p < points; ++p) {
    const double length = normals[p].stableNorm();
    if (!(length > 0) || !std::isfinite(length))
      throw InputError(fmt::format("{}: normal number {} has no direction: its length is {}", a.normals, p, length));
    normals[p] /= length;
  }
  return normals;
}

CoordinateColumns stress_columns(const Images<double>& images, int dimension, const Material& material,
                                 const std::vector<Vec3<double>>& normals) {
  CoordinateColumns table = headed(dimension, !normals.empty());
  const std::size_t points = images.tensors[0].size() / dimension;
  table.values.reserve(points * table.names.size());
  for (std::size_t p = 0; p < points; ++p) {
    const Stress found = stress_of(jacobian_of(images, p, dimension), material);
    for (const Mat3<double>* tensor : {&found.strain, &found.stress})
      for (std::size_t e = 0; e < entry_count(dimension); ++e)
        table.values.push_back((*tensor)(entries[e].first, entries[e].second));
    table.values.push_back(found.von_mises());
    if (normals.empty()) continue;
    const Vec3<double> traction = found.traction(normals[p]);
    table.values.insert(table.values.end(), traction.data(), traction.data() + dimension);
  }
  return table;
}

nlohmann::ordered_json stress_json(const CoordinateColumns& table, const Material& material) {
  nlohmann::ordered_json json = {{"shear_modulus", material.shear_modulus}};
  if (std::isfinite(material.poisson_ratio)) json["poisson_ratio"] = material.poisson_ratio;
  else json["poisson_ratio"] = fmt::format("{}", material.poisson_ratio);
  const auto column = static_cast<std::size_t>(std::ranges::find(table.names, "von_mises") - table.names.begin());
  double largest = -1;
  for (std::size_t k = column; k < table.values.size(); k += table.names.size())
    if (std::isfinite(table.values[k])) largest = std::max(largest, table.values[k]);
  json["largest_von_mises"] = largest < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(largest);
  return json;
}

}  // namespace cageproof::cli
