// SPDX-License-Identifier: MIT
#include "solved_file.h"

#include "npz.h"

#include <filesystem>

namespace cageproof::cli {

using deformation::NamedMatrix;
namespace {

// Row by row.
void append(std::string& bytes, const Matrix<double>& values) {
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      const double number = values(i, k);
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
}

std::vector<std::size_t> shape_of(const Matrix<double>& values) {
  return {static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())};
}

}  // namespace

bool holds_matrices(const std::string& file) { return std::filesystem::path(file).extension() == ".npz"; }

std::string matrices_text(const std::vector<NamedMatrix>& matrices) {
  std::vector<std::pair<std::string, std::string>> members;
  for (const auto& [name, values] : matrices) {
    members.emplace_back(name + ".npy", npy_header("<f8", shape_of(values)));
    append(members.back().second, values);
  }
  return zip_text(members);
}

std::string matrices_text(const std::vector<std::vector<NamedMatrix>>& maps) {
  std::vector<std::pair<std::string, std::string>> members;
  for (std::size_t m = 0; m < maps.front().size(); ++m) {
    std::vector<std::size_t> shape = shape_of(maps.front()[m].values);
    shape.insert(shape.begin(), maps.size());
    members.emplace_back(maps.front()[m].name + ".npy", npy_header("<f8", shape));
    for (const std::vector<NamedMatrix>& map : maps) append(members.back().second, map[m].values);
  }
  return zip_text(members);
}

}  // namespace cageproof::cli
