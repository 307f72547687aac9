// SPDX-License-Identifier: MIT
// What `deform` has made of its maps, before anything is written: a file each, or all of them in one, and a report.
#pragma once

#include "deform_files.h"

#include "cageproof/reports/point_cache.h"

#include <nlohmann/json.hpp>

namespace cageproof::cli {

class PoseFiles {
 public:
  /// \param a that check_names has taken, and which lives as long as this
  explicit PoseFiles(const DeformArguments& a) : a_(a), source_(a.points) {}

  /// Name, in messages, of the output for the k-th map, from 1 on: a file, or a frame of one.
  std::string name_of(std::size_t k) const;

  /// The next map. \param pose the file that describes it \param images of the mesh's vertices, with derivatives
  void add(const std::string& pose, const Mesh& deformed, const CoordinateColumns& images,
           const nlohmann::ordered_json& report);
  /// A table of the map that was added last. \param file with a mark for the map's number, where there are several
  void add_table(const std::string& file, const Mesh& deformed, const CoordinateColumns& table);
  /// Another file.
  void add(const std::filesystem::path& file, std::string text) { files_.emplace_back(file, std::move(text)); }

  /// Writes all files, or none. \throws InputError where one cannot be written, or cannot hold what it should
  void write();

 private:
  void add_cache();
  void add_collection();
  void add_report(const nlohmann::ordered_json& report);

  const DeformArguments& a_;
  MeshSource source_;
  std::size_t maps_ = 0;
  std::vector<std::pair<std::filesystem::path, std::string>> files_;
  std::vector<reports::CacheFrame> frames_;      // of a point cache
  std::vector<nlohmann::ordered_json> reports_;  // of each map
};

}  // namespace cageproof::cli
