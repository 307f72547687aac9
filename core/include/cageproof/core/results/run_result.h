// SPDX-License-Identifier: MIT
// The result of a verification run: what validation hands to reports.
#pragma once

#include "cageproof/core/results/tally.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cageproof {

/// Undecided: a row that confirms others measured nothing, since the run has fewer samples than its suite.
enum class Verdict { Kept, Broken, NotPromised, Undecided };

/// "kept", "BROKEN", "not promised", "undecided".
std::string_view name_of(Verdict verdict);

/// One line of the results: a row key and the figures of its tally, judged.
struct ResultRow : RowKey, RowFigures {
  std::uint64_t samples = 0;    ///< that were measured
  std::uint64_t nonfinite = 0;  ///< results that are not finite where the truth is
  double max = 0;               ///< this and what follows in the row's unit
  double p999 = 0;
  double median = 0;
  std::optional<double> bound;
  std::string reason;  ///< why the bound is what it is, or why nothing is promised
  Verdict verdict = Verdict::NotPromised;
  bool is_foundation = false;  ///< other rows rest on this one: if it is broken, their verdicts count for little
  std::vector<WorstCase> worst;
  std::vector<std::uint64_t> histogram;  ///< ErrorHistogram::counts()

  /// Whether the problem itself is so ill-posed at every sample that a result without one right digit keeps the bound.
  bool is_ill_posed() const { return bound && total_loss >= 0 && total_loss <= *bound; }
};

/// Largest relative error against the regime's parameter: one curve of a picture.
struct ResultCurve : RowKey {
  std::string parameter_name;      ///< "distance / size", "aspect" ...
  std::vector<double> parameters;  ///< rising or falling, one per decade
  std::vector<double> errors;      ///< largest relative one, in roundings of the scalar; infinite: not finite
  std::string role = {};           ///< of the evaluation, as in RowFigures
};

/// Where the run's files about one field lie, relative to the report's folder.
struct FieldEntry {
  std::string title;       ///< what is shown, of which cage and evaluation
  std::string unit;        ///< of the colours
  std::string data;        ///< fields/....vti
  std::string picture;     ///< pictures/....png, or empty
  double largest = 0;      ///< of the field, finite samples only
  std::string page = {};   ///< field.html, where the field can be turned with the mouse there, or empty
  std::string state = {};  ///< fields/....pvsm, which opens it in ParaView beside others, or empty
};

/// One place where a paper is wrong, with one formula and order that it changes, and by how much.
struct ErratumRow {
  std::string source;      ///< paper key and equation
  std::string printed;     ///< what is printed
  std::string correct;     ///< what is right
  std::string formula;     ///< empty: no formula of the catalogue shows it, and nothing was measured
  std::string evaluation;  ///< the one that keeps the misprint
  std::string regime;
  int order = 0;
  std::uint64_t samples = 0;
  std::uint64_t nonfinite = 0;  ///< samples where the printed form is not finite
  double printed_error = 0;     ///< largest relative error, norm-wise, of the finite ones
  double corrected_error = 0;   ///< and of the corrected form
};

/// How long an evaluation in double takes for one pair of an element and a point at generic distance, on one thread.
struct EvaluationTime {
  std::string formula, evaluation;
  int order = 0;
  double nanoseconds = 0;  ///< median over the pairs
};

/// One process that measured for a run. Two runs with the same findings may differ in their sessions and in nothing
/// else.
struct Session {
  std::string started;  ///< ISO 8601, UTC
  double seconds = 0;   ///< until its last unit of work was done
  std::string command_line;
  std::map<std::string, std::string> machine;  ///< processor, threads, compiler, library versions
  std::vector<EvaluationTime> times = {};      ///< of what the run looks at; empty where none were taken
};

/// A whole run.
struct RunResult {
  std::string version;
  std::string suite;
  std::uint64_t seed = 0;
  std::map<std::string, std::string> settings;  ///< triangulation, cage file ...: what the figures depend on
  std::vector<Session> sessions;
  /// Notes about the sessions, for example that their processors compute logarithms differently.
  std::vector<std::string> session_notes;
  std::vector<ResultRow> rows;
  std::vector<ResultCurve> curves;
  std::vector<FieldEntry> fields;
  std::vector<ErratumRow> errata;
  /// Findings that are no row: "regime far: the integral reached 24 digits on 3 of 8 samples" ...
  std::vector<std::string> notes;

  bool all_kept() const;
};

/// Facts that a field's file states as VTK field data: "kind" or "formula", "evaluation", "cage", "seed", "version",
/// "unit of length" ...
using FieldFacts = std::map<std::string, std::string>;

/// Samples on a regular grid (a slice has one cell layer): written as .vti.
struct ImageField {
  std::string name;  ///< file name without extension
  std::array<int, 3> points{1, 1, 1};
  Vec3<double> origin = Vec3<double>::Zero();
  Vec3<double> spacing = Vec3<double>::Ones();
  struct Array {
    std::string name;
    std::string unit;
    int components = 1;
    std::vector<double> values;  ///< x fastest; NaN where masked
    bool linear = false;         ///< its picture shows the values themselves, with their signs: they are no errors
  };
  std::vector<Array> arrays;
  FieldFacts facts = {};
};

/// Samples on a mesh's vertices, which are written as .vtp.
struct MeshField {
  std::string name;
  std::vector<Vec3<double>> vertices;
  std::vector<std::vector<int>> faces;  ///< where there are neither these nor segments: a point cloud
  std::vector<ImageField::Array> arrays;
  std::vector<std::array<int, 2>> segments = {};  ///< of polylines
  FieldFacts facts = {};
};

}  // namespace cageproof
