// SPDX-License-Identifier: MIT
// The commands of `cageproof`. Each adds its options to the command line and sets what to run.
#pragma once

#include "command_line.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/cage/merged_vertices.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/results/run_result.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::cli {

/// Exit codes, stable.
enum ExitCode { success = 0, promise_broken = 1, not_valid = 1, bad_input = 2 };

void add_list(CommandLine& line);
void add_eval(CommandLine& line);
void add_explain(CommandLine& line);
void add_inside(CommandLine& line);
void add_quads(CommandLine& line);
void add_coordinates(CommandLine& line);
void add_deform(CommandLine& line);
void add_verify(CommandLine& line, const std::string& command_line);
void add_merge(CommandLine& line);
void add_report(CommandLine& line);
void add_compare(CommandLine& line);
void add_field(CommandLine& line, const std::string& command_line);
void add_figures(CommandLine& line);
void add_replay(CommandLine& line);
void add_hunt(CommandLine& line);
void add_bench(CommandLine& line, const std::string& command_line);
void add_judge(CommandLine& line, const std::string& command_line);
void add_vectors(CommandLine& line, const std::string& command_line);
/// `help`, `version`, `man` and `completion`: what the program says of itself. \param line lives as long as the program
void add_descriptions(CommandLine& line);

/// Prints broken promises and the verdict on standard output, and remarks on the run's sessions on standard error.
/// \param out the report's folder
ExitCode print_verdict(const RunResult& result, const std::string& out);

/// Options that every command with a cage shares.
struct CageArguments {
  std::string file;  ///< a mesh file, or the name of an embedded cage
  bool flip_inward = false;
  bool allow_invalid_quads = false;  ///< an option of commands whose coordinates keep quads
  std::string triangulate = "shortest";
  double merge = std::numeric_limits<double>::quiet_NaN();  ///< a distance; NaN where vertices are not to be merged

  /// \return the option --cage
  Option add_to(Command command, bool required);
  /// \throws InputError as read_cage; names of embedded cages are taken first
  Cage load() const { return load_merged().cage; }
  /// The same cage with the vertices that --merge joined; nothing without --merge.
  struct Merged {
    Cage cage;
    std::optional<Merging> merging;
  };
  Merged load_merged() const;
  Triangulation rule() const { return triangulate == "fan" ? Triangulation::Fan : Triangulation::Shortest; }
};

/// Values of `known` from texts of --parameter, as parameter_values. \param owner the formula, kind or method that has
/// them
std::vector<double> parameters_from(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                                    std::string_view owner);
/// All combinations of values, as parameter_sets.
std::vector<std::vector<double>> parameter_sets_from(const std::vector<std::string>& given,
                                                     const std::vector<KindParameter>& known, std::string_view owner);

/// Addition to the help of points: y of polygons.
inline constexpr std::string_view y_of_points =
    "; y points up, so a point for a cage from an SVG has minus the drawing's y";

/// Points, with faces if the file has any: a mesh file, or text.
/// \param dimension of the cage that they are for: in the plane third numbers must be zero
/// \throws InputError as read_mesh and read_points, and naming a point off the plane
Mesh load_points(const std::string& file, int dimension);

}  // namespace cageproof::cli
