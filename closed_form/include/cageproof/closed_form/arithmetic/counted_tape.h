// SPDX-License-Identifier: MIT
// The record of every operation on Counted numbers, and what each line of it costs a result.
#pragma once

#include "cageproof/closed_form/arithmetic/counted.h"

#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

namespace cageproof::closed_form {

/// Errors that operations of one kind at one source line add to one result. Sizes are absolute errors in the result.
struct CountedLine {
  std::string file;       ///< relative to the project
  unsigned line = 0;      ///< 0 where a number was taken over as a whole
  std::string operation;  ///< "+", "sqrt", "* in add_raised", "frame d"
  /// Errors of the operations beyond the relative errors of their operands and one rounding, as far as they reach the
  /// result; the sum of the sizes. Cancellation makes it large.
  double lost = 0;
  /// The operations' own roundings as far as they reach the result: the sum of their sizes, and the sum.
  double rounded = 0, net = 0;
  /// The most bits that one of the operations cancelled: exponent of the larger operand less that of the sum.
  int bits = 0;
  /// Relative errors of the operation that lost most: of its worse operand, and of its result, in units of 2^-53.
  double before = 0, after = 0;
  std::size_t count = 0;  ///< of operations that the result depends on
};

/// Records the operations on Counted numbers of this thread while it lives. A thread has one at a time.
class CountedTape {
 public:
  CountedTape();
  ~CountedTape();
  CountedTape(const CountedTape&) = delete;
  CountedTape& operator=(const CountedTape&) = delete;

  /// The thread's tape, or null.
  static CountedTape* current();

  std::size_t size() const { return nodes_.size(); }
  /// Returns each line's errors in the result, times `scale`, sorted by the larger of `lost` and `rounded`, the largest
  /// first. Lines without errors are left out.
  std::vector<CountedLine> lines(const Counted& result, double scale = 1) const;

 private:
  friend struct Recorder;
  friend class AttributedTo;

  /// An operation: the numbers that results depending on it need.
  struct Node {
    std::array<std::uint32_t, 2> from{};  // the operands' nodes; 0: none
    std::array<double, 2> slope{};        // derivatives with respect to them
    double rounding = 0;                  // of the operation itself
    double lost = 0;                      // CountedLine::lost, at the operation's own result
    double before = 0, after = 0;
    std::int16_t bits = 0;
    std::uint32_t site = 0;
  };
  struct Site {
    const char* file;
    unsigned line;
    const char* operation;
    const char* helper;
    bool operator==(const Site&) const = default;
  };
  struct SiteHash {
    std::size_t operator()(const Site& s) const {
      const std::hash<const void*> of;
      return of(s.file) ^ (of(s.operation) << 1) ^ (of(s.helper) << 2) ^ (static_cast<std::size_t>(s.line) << 7);
    }
  };

  std::uint32_t site(const Site& s);
  Site site_of(const std::source_location& where, const char* operation);

  std::deque<Node> nodes_;
  std::vector<Site> sites_;
  std::unordered_map<Site, std::uint32_t, SiteHash> numbers_;
  // Where a helper was called, and its name; null outside of one.
  const char *helper_ = nullptr, *caller_file_ = nullptr;
  unsigned caller_line_ = 0;
  // The last line outside of Eigen, whose own operations stand behind it.
  const char* last_file_ = "";
  unsigned last_line_ = 0;
};

}  // namespace cageproof::closed_form
