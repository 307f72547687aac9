// SPDX-License-Identifier: MIT
// Everything a person sees of a run: a folder of figures, tables, fields, pictures and one page.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/field_scene.h"
#include "cageproof/reports/figure_sheet.h"
#include "cageproof/reports/journal.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

struct CurvePicture;

/// How a field's values become colours.
enum class ColourScale { Linear, Log10 };

/// Values at the ends of the colours, 0 < low < high on a logarithmic scale; the same limits make pictures of different
/// runs comparable.
struct ColourLimits {
  double low, high;
};

/// A field's entry in the report without its files: title, unit and largest value of the array that would be shown.
/// \throws std::invalid_argument when no array is named `shown`
FieldEntry unwritten_entry(const std::vector<ImageField::Array>& arrays, const std::string& title,
                           const std::string& shown, ColourScale scale);

/// A report folder, written aside (`.NAME.partial-...` next to it) and renamed into place: a run that dies leaves no
/// half report, and an earlier report stays whole until the new one replaces it in one step.
///
/// The folder holds summary.json.gz, summary.md, results.csv.gz, worst.jsonl (inputs of broken promises), worst/
/// (inputs of every row, one file per formula or cage), index.html, pictures.html, one page per formula, cage and
/// deformed cage (formulas/, cages/, deformers/), fields/ and pictures/; also the journal of a verification, and
/// figures/ with figures.json where figures were written. Every byte is a function of the other results, except
/// RunResult::sessions and session_notes (object "environment" of summary.json.gz; section "Environment", the last, of
/// summary.md; sections of the class "environment" of pages).
class ReportWriter {
 public:
  /// The kind of a folder, by which it is known again: one kind never replaces the other.
  enum class Kind { Verification, Field };
  /// \param out the report's folder; its parent must exist. An empty folder or an earlier report there is replaced.
  /// \throws InputError when the parent is missing or cannot be written, or `out` holds anything but a report of that
  /// kind
  explicit ReportWriter(const std::filesystem::path& out, Kind kind = Kind::Verification);
  /// Removes the unfinished folder unless commit() was reached.
  ~ReportWriter();
  ReportWriter(const ReportWriter&) = delete;
  ReportWriter& operator=(const ReportWriter&) = delete;

  /// Writes fields/<name>.vti and, of a slice through the field, pictures/field.<name>.png: one array as colours, with
  /// a legend; masked samples (NaN) grey, infinite ones marked. Of a volume the middle slice along z is shown. \param
  /// title what is shown, of which cage and evaluation \param shown name of the array to show (its magnitude, when it
  /// has several components) \throws InputError when the file cannot be written \throws std::invalid_argument when an
  /// array's size is not points x components, or `shown` is no array's name
  /// \param limits of the colours; without, those of the field's own values
  /// \param outline a cage or element, whose cut is drawn over the picture; null for none
  FieldEntry write_image(const ImageField& field, const std::string& title, const std::string& shown, ColourScale scale,
                         std::optional<ColourLimits> limits = std::nullopt, const MeshField* outline = nullptr);

  /// Writes fields/<name>.vtp and pictures/field.<name>.png: the vertices, coloured by one array, seen from two sides.
  /// \throws as write_image
  FieldEntry write_mesh(const MeshField& field, const std::string& title, const std::string& shown, ColourScale scale);

  /// Writes fields/<name>.vti, <name>.cage.vtp, <name>.mesh.vtp where there is a mesh, and <name>.pvsm, which opens
  /// them side by side in ParaView; of the first scene field.html, which does so in a browser. Gives an entry for the
  /// image, and one for the mesh. \throws as write_image
  std::vector<FieldEntry> write_scene(const FieldScene& scene);

  /// Writes a figure of the papers: figures/<name>.png and a .vtp a panel. The page shows it.
  /// \throws InputError when a file cannot be written \throws std::invalid_argument as figure_png
  void write_figure(FigureSheet sheet);

  /// Writes all files of a run; fields and figures must have been written before. A run may have fields and no rows.
  /// Where gnuplot does not draw a picture, one that says so is in its place. Gives a line for each of these, which the
  /// report has among the notes of its sessions.
  /// \throws InputError when a file cannot be written, or gnuplot is missing or draws nothing at all
  std::vector<std::string> write(const RunResult& result);

  /// Writes the journal that the report was made of. \pre all its units are done
  void write_journal(const Journal& journal);

  /// Puts the report in its place.
  /// \pre write() was called
  /// \throws InputError when the folder cannot be renamed; an earlier report is then still there
  void commit();

 private:
  struct State;
  void write_text(const RunResult& result, const std::vector<CurvePicture>& curves);
  std::unique_ptr<State> state_;
};

}  // namespace cageproof::reports
