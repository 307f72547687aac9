// SPDX-License-Identifier: MIT
// The files that `deform` writes: their names, checked before anything is computed, and their texts.
#pragma once

#include "commands.h"
#include "coordinate_table.h"
#include "posing.h"
#include "stress_table.h"

#include <filesystem>
#include <set>

namespace cageproof::cli {

/// Options of `deform`, as the user gave them.
struct DeformArguments {
  CageArguments cage;
  std::string points, method, evaluation, out, derivatives, constraints, energies, solved, outside = "error";
  std::vector<std::string> posed, parameters;
  DataFiles data;
  StressArguments stress;
  int order = 0, jobs = 0;
  int digits = 0;           ///< of images; 0 for all
  double on = 0;            ///< a share of the cage's size
  double frame_rate = 0;    ///< frames per second; 0 where the user gave none
  std::string collection;   ///< a .pvd file that names those of out; by split_collection
  bool strict = false;      ///< a posed cage with other faces is an error
  bool keep_quads = false;  ///< in place of the method, the one that does the same on quads

  /// The highest derivative that is computed: stress needs the first.
  int computed_order() const { return stress.asked() && order == 0 ? 1 : order; }
};

inline constexpr std::string_view deformation_schema = "cageproof-deformation";

/// Schema of the report on several maps.
inline constexpr std::string_view deformations_schema = "cageproof-deformations";
/// Frames per second where the user gave none.
inline constexpr double usual_rate = 24;

/// Whether a file of that name holds all maps as frames: .pc2, .mdd.
bool is_point_cache(const std::string& file);

/// Takes --out NAME.pvd for the collection of NAME_001.vtp and so on. \throws InputError where the name has a number
void split_collection(DeformArguments& a);

/// Options that name data of poses other than vertices, without dashes, with their files; only those that are given.
std::vector<std::pair<std::string, std::string>> given_data(const DeformArguments& a);

/// \param maps that are written, their number \throws InputError for a file whose format cannot hold what is to be
/// written, whose folder does not exist, or that is read or written, too
void check_names(const DeformArguments& a, std::size_t maps);

/// The file of the report: beside --out, without the maps' numbers where there are several.
std::filesystem::path report_file(const DeformArguments& a, std::size_t maps);

/// \throws InputError where --out is of a format that cannot hold such points
void check_shapes(const DeformArguments& a, const Mesh& mesh, int dimension);

/// The file of --points. Images take along its data that do not depend on places; the others are named once on standard
/// error.
class MeshSource {
 public:
  explicit MeshSource(const std::string& points);

  /// Whether files of that extension can hold all of the source's data.
  bool is_carried_to(std::string_view extension) const;
  /// Its text with other vertices; VTP with arrays of the images, too. \pre is_carried_to its own extension
  std::string with_images(const Mesh& mesh, const CoordinateColumns& images);
  /// STL or SVG, by the file's extension, which hold parts of a mesh.
  std::string text_of(const std::filesystem::path& file, const Mesh& mesh);
  /// Names the data that files of that extension cannot hold. \param also of the mesh
  void say_left_out_of(std::string_view extension, const std::vector<std::string>& also = {});

 private:
  void say_left_out(const std::vector<std::string>& what, std::string_view why);
  void say(const std::string& warning);

  std::string file_, extension_, text_;  // text_ of OBJ and PLY
  std::set<std::string> said_;
};

/// A file's whole text, in the format of its extension.
std::string text_for(const std::filesystem::path& file, const Mesh& mesh, const CoordinateColumns& images,
                     MeshSource& source);

/// The file of --energies: CSV, or a picture with that title.
std::string energies_text(const DeformArguments& a, const std::string& title, const std::vector<double>& energies);

}  // namespace cageproof::cli
