// SPDX-License-Identifier: MIT
#include "posing.h"

#include "commands.h"
#include "constraints.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

namespace cageproof::cli {

using namespace deformation;
namespace {

// What a pose has beside vertices.
Pose<double> pose_with(const DataFiles& files, const DeformMethod& method, int dimension) {
  Pose<double> pose;
  const auto take = [&](std::vector<Vec3<double>>& rows, const std::string& file, const char* option, bool is_taken) {
    if (file.empty()) return;
    if (!is_taken) throw InputError(fmt::format("{}: {} takes none", option, method.name));
    rows = load_points(file, dimension).vertices;
  };
  take(pose.normal_derivatives, files.normal_derivatives, "--normal-derivatives", method.takes_normal_derivatives);
  take(pose.laplacians, files.laplacians, "--laplacians", method.takes_laplacians);
  take(pose.laplacian_derivatives, files.laplacian_derivatives, "--laplacian-derivatives", method.takes_laplacians);
  return pose;
}

// As many rows as the cage has elements or vertices, in a message that names their file.
void check_rows(const DataFiles& files, const Pose<double>& pose, const CageElements& elements) {
  const auto check = [](const std::string& file, std::size_t rows, std::size_t wanted, const char* of) {
    if (!file.empty() && rows != wanted)
      throw InputError(fmt::format("{}: {} rows, the cage has {} {}", file, rows, wanted, of));
  };
  check(files.normal_derivatives, pose.normal_derivatives.size(), elements.count(), "elements");
  check(files.laplacians, pose.laplacians.size(), elements.vertices().size(), "vertices");
  check(files.laplacian_derivatives, pose.laplacian_derivatives.size(), elements.count(), "elements");
}

}  // namespace

Posing posed_by_cages(const DeformMethod& method, const Cage& cage, const DeformOptions& options,
                      const std::vector<std::string>& files, const DataFiles& data) {
  Posing found;
  Pose<double> pose = pose_with(data, method, cage.dimension());
  for (const std::string& file : files)
    found.vertices.push_back(is_embedded_cage(file) ? embedded_cage(file).vertices()
                                                    : load_points(file, cage.dimension()).vertices);
  found.names = files;
  const auto deformer = prepare_deformer<double>(method, cage, options);
  found.owner = deformer;
  found.coordinates = &deformer->coordinates();
  found.max_order = deformer->max_order();
  found.prepared = deformer->prepared();
  check_rows(data, pose, found.coordinates->elements());
  for (std::size_t k = 0; k < files.size(); ++k) {
    try {
      pose.vertices = found.vertices[k];
      found.maps.push_back(deformer->pose(pose));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", files[k], error.what()));
    }
  }
  return found;
}

Posing posed_by_constraints(const ConstraintMethod& method, const Cage& cage, const DeformOptions& options,
                            const std::string& file, const StepWatcher& watch) {
  Posing found;
  const Constraints constraints = read_constraints(file, cage.dimension());
  try {
    const auto deformer = prepare_constrained(method, cage, constraints, options);
    found.owner = deformer;
    found.coordinates = &deformer->coordinates();
    found.max_order = deformer->coordinates().max_order();
    found.prepared = deformer->prepared();
    found.maps.push_back(deformer->pose(watch));
  } catch (const ConstraintError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  found.names = {file};
  found.vertices.push_back(found.maps[0]->vertices());
  return found;
}

}  // namespace cageproof::cli
