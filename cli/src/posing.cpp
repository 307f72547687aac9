// SPDX-License-Identifier: MIT
#include "posing.h"

#include "commands.h"
#include "constraints.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/posed_faces.h"
#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

namespace cageproof::cli {

using namespace deformation;
namespace {

// A pose with the data of these files.
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

// As many rows as the cage has of what they belong to, in a message that names their file.
void check_rows(const DataFiles& files, const Pose<double>& pose, const CageCoordinates& coordinates) {
  const auto check = [&](const std::string& file, std::size_t rows, Owner owner, std::string_view of) {
    const std::size_t wanted = coordinates.elements().count(owner);
    if (!file.empty() && rows != wanted)
      throw InputError(fmt::format("{}: {} rows, the cage has {} {}", file, rows, wanted, of));
  };
  const Owner normals = normals_owner(coordinates);
  check(files.normal_derivatives, pose.normal_derivatives.size(), normals, plural_of(normals));
  check(files.laplacians, pose.laplacians.size(), Owner::Vertex, "vertices");
  check(files.laplacian_derivatives, pose.laplacian_derivatives.size(), Owner::Element, "elements");
}

// The vertices of one posed cage, in the rest cage's order.
std::vector<Vec3<double>> posed_vertices(const Cage& cage, const std::string& file, const PosedFiles& files) {
  Mesh posed = is_embedded_cage(file) ? Mesh{embedded_cage(file).vertices(), {}} : load_points(file, cage.dimension());
  if (files.merging && posed.vertices.size() != files.merging->first.size()) {
    std::vector<Vec3<double>> vertices = merged_pose(posed.vertices, *files.merging, files.merge_distance, file);
    posed = merged(std::move(posed), *files.merging, file);
    posed.vertices = std::move(vertices);
  }
  if (const auto foreign = foreign_face(cage, posed)) {
    const std::string said = fmt::format(
        "{}: {}: its vertices seem to be numbered otherwise, and must be in the cage's "
        "order",
        file, *foreign);
    if (files.strict) throw InputError(said);
    fmt::print(stderr, "warning: {}\n", said);
  }
  return std::move(posed.vertices);
}

}  // namespace

Posing posed_by_cages(const DeformMethod& method, const Cage& cage, DeformOptions options,
                      const std::vector<std::vector<double>>& parameters, const PosedFiles& files,
                      const DataFiles& data) {
  Pose<double> pose = pose_with(data, method, cage.dimension());
  std::vector<std::vector<Vec3<double>>> cages;
  cages.reserve(files.names.size());
  for (const std::string& file : files.names) cages.push_back(posed_vertices(cage, file, files));
  options.parameters = parameters.front();
  std::vector<std::shared_ptr<const Deformer<double>>> deformers{prepare_deformer<double>(method, cage, options)};
  Posing found{deformers[0], &deformers[0]->coordinates(), deformers[0]->max_order(), {}};
  check_rows(data, pose, *found.coordinates);
  deformers.reserve(parameters.size());
  for (std::size_t s = 1; s < parameters.size(); ++s)
    deformers.push_back(with_other_parameters<double>(method, *deformers[0], parameters[s]));
  // Once, not per pose: some methods solve their systems again to tell of them.
  std::vector<DeformationReport> prepared;
  prepared.reserve(deformers.size());
  for (const auto& deformer : deformers) prepared.push_back(deformer->prepared());
  for (std::size_t k = 0; k < files.names.size(); ++k)
    for (std::size_t s = 0; s < parameters.size(); ++s) {
      try {
        pose.vertices = cages[k];
        found.maps.push_back({deformers[s]->pose(pose), files.names[k], cages[k], parameters[s], prepared[s]});
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", files.names[k], error.what()));
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
    auto map = deformer->pose(watch);
    if (const std::string& why = map->report().unsolved; !why.empty()) throw ConstraintError(why);
    std::vector<Vec3<double>> vertices = map->vertices();
    found.maps.push_back({std::move(map), file, std::move(vertices), options.parameters, deformer->prepared()});
  } catch (const ConstraintError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  return found;
}

}  // namespace cageproof::cli
