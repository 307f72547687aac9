// SPDX-License-Identifier: MIT
// The results of a unit of work are tallies by row, samples of fields, and errata. They are merged, and the order of
// merging does not matter.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <map>
#include <set>
#include <string>

namespace cageproof {

/// Consecutive samples of a field, and what the field shows. Parts of one field agree in all but `first` and the
/// values.
struct FieldPart {
  std::string title;        ///< what is shown, of which cage and evaluation
  std::string shown;        ///< the array that its picture shows
  std::string mesh;         ///< the mesh whose vertices are the samples; empty where they are the image's points
  std::size_t samples = 0;  ///< of the whole field
  std::size_t first = 0;    ///< the first sample of this part
  ImageField image;         ///< values from `first` on; for a mesh the grid means nothing
  std::string cage = {};    ///< the mesh whose outline is drawn over it: the cage, or the element; empty for none
  /// Fields of one scene are opened together, and in each of them these arrays, one per evaluation, are shown side by
  /// side on one scale of colours. Empty for fields by themselves.
  std::string scene = {};
  std::vector<std::string> compared = {};
};

/// The result of one unit of work, or of several merged. Each unit is merged once.
struct PartialResult {
  std::map<RowKey, Tally> rows;
  std::map<std::pair<int, std::size_t>, FieldPart>
      fields;                               ///< by the field's place in the report and the part's first sample
  std::map<std::string, MeshField> meshes;  ///< vertices and faces, by name
  std::map<int, ErratumRow> errata;         ///< by place in the report
  /// Questions about a user's cage that are not judged, because a method refuses a moved copy or a pose, by the reason.
  std::map<std::string, std::set<std::string>> refused;

  /// \throws std::invalid_argument when units of tallies do not agree
  void merge(PartialResult other);
  /// Drops worst cases that cannot be among those of `so_far` and these together.
  void drop_unwanted(const PartialResult& so_far);
};

/// The fields that parts make up, by place in the report; NaN where no part has a sample.
/// \throws std::invalid_argument when parts of a field do not agree
std::map<int, FieldPart> whole_fields(const PartialResult& gathered);

}  // namespace cageproof
