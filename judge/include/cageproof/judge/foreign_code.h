// SPDX-License-Identifier: MIT
// Somebody else's program or library, asked in processes of its own: whatever it does there is found, and loses the
// input it was done at, nothing else.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace cageproof::judge {

class Worker;

/// Limits on what foreign code may use.
struct Limits {
  double seconds = 10;                   ///< without an answer, in a block
  double start_seconds = 30;             ///< to start and say what it has
  std::uint64_t memory = 4ULL << 30U;    ///< address space of a process, in bytes
  std::uint64_t written = 64ULL << 20U;  ///< a file, standard output and standard error included, in bytes
  std::vector<std::string> host = {};    ///< program and arguments that run_host is called by; empty: this program
};

/// An element, or a cage's vertices as corners with its faces, and the points at which it is asked; dim coordinates
/// each.
struct Asked {
  std::vector<double> corners, parameters, points;
  std::size_t count = 1;  ///< points
  /// Cages only: the vertices of faces, counted from 0, `face_corners` numbers each, of which the last is -1 for
  /// triangles among quads; and the number of a point's coordinates.
  std::vector<int> faces = {};
  std::size_t coordinates = 0;
  int dimension = 3, face_corners = 3;  ///< segments in the plane have two corners
};

/// The formula, order and scalar that a block is asked for; or the kind of coordinates that a cage is asked for.
struct Request {
  const Formula* formula = nullptr;
  int order = 0;
  bool single = false;         ///< in float
  std::string_view kind = {};  ///< then there is no formula, only values are asked for, and in double

  std::string_view subject() const { return formula != nullptr ? formula->name : kind; }
};

/// The answer to one Asked.
struct Answer {
  enum class Status { Failed, Declined, Given } status = Status::Failed;
  /// By order: [point][component][i][j]; of a cage, values [point][coordinate]. Sized where given.
  std::array<std::vector<double>, 3> tensors;
};

/// Something that foreign code did and should not have done, beside wrong numbers.
struct Incident {
  std::string kind;     ///< "crash", "hang", "exit", "garbage", "short answer", "standard output" ...
  std::string text;     ///< one sentence
  std::string formula;  ///< where it was asked something
  int order = 0;
  std::string input;        ///< a line of `eval` that it was first found at; empty where none is to blame
  std::uint64_t count = 1;  ///< how often, for that formula
};

/// A file that foreign code consists of, as far as can be told.
struct JudgedFile {
  std::string path, sha256;
};

/// Foreign code. Safe from any thread: each that asks at the same time has a process of its own.
class ForeignCode {
 public:
  /// Starts it once. \param what a library (its name ends with .so, or .so and a version), or else a command for the
  /// shell that answers lines of `eval`
  /// \throws InputError where it cannot be started or loaded
  explicit ForeignCode(std::string what, Limits limits = {});
  ~ForeignCode();
  ForeignCode(const ForeignCode&) = delete;
  ForeignCode& operator=(const ForeignCode&) = delete;

  const std::string& what() const { return what_; }
  bool is_library() const { return is_library_; }
  /// Its description of itself in one line; empty where it has none.
  const std::string& about() const { return about_; }
  const std::vector<JudgedFile>& files() const { return files_; }
  /// Whether it says which formulas it has. Others are tried where a user names the formula.
  bool says_formulas() const { return says_formulas_; }
  /// The highest derivative of the formula that it gives; -1 where it does not have it.
  int order_of(const Formula& formula, bool single = false);
  /// Asks a block. One answer each, in their order; those it could not give are Failed, with an incident.
  /// \param nanoseconds where not null, the time within the foreign code (a library) or until all answers were here
  std::vector<Answer> ask(const Request& request, std::span<const Asked> asked, double* nanoseconds = nullptr);
  /// Ends its processes, and notes what they leave behind.
  void finish();
  std::vector<Incident> incidents() const;
  /// Inputs that were not asked for, because it had hung or died too often.
  std::uint64_t skipped() const;

 private:
  struct Trouble {
    int hangs = 0, others = 0;
  };
  std::unique_ptr<Worker> start();
  std::unique_ptr<Worker> take();
  void give_back(std::unique_ptr<Worker> worker);
  void end(std::unique_ptr<Worker> worker, const Request& request);
  void note(Incident incident);
  bool has_had_enough(std::string_view subject) const;

  std::string what_, about_;
  Limits limits_;
  bool is_library_ = false, says_formulas_ = false;
  std::vector<JudgedFile> files_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> idle_;
  std::vector<Incident> incidents_;
  std::map<std::string_view, Trouble> trouble_;
  std::map<std::pair<std::string_view, bool>, int> orders_;
  std::map<std::string, int> said_;
  std::uint64_t skipped_ = 0;
};

/// Registers foreign code under a name for the formulas of a list of names and globs that it has, each in the scalars
/// that it has. \return their names \throws InputError where it has none of them, or does not say which it has and the
/// list is all ("*")
std::vector<std::string> register_foreign_code(const std::shared_ptr<ForeignCode>& code, const std::string& name,
                                               const std::string& formulas);

/// "mine=./libmine.so" in its two parts. \throws InputError where it is not of that form
std::pair<std::string, std::string> name_and_what(const std::string& text);

/// The line of `eval` that asks for one point, exactly, with hexadecimal strings for numbers.
std::string exact_line(const Formula& formula, const Asked& asked, std::size_t point);
/// The same for what was requested, which may be coordinates of a cage.
std::string exact_line(const Request& request, const Asked& asked, std::size_t point);

}  // namespace cageproof::judge
