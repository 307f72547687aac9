// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/arithmetic/counted_tape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

namespace cageproof::closed_form {
namespace {

thread_local CountedTape* the_tape = nullptr;

bool is_of_eigen(std::string_view file) { return file.find("/Eigen/") != std::string_view::npos; }

// Relative to the project: this file's own name says how the compiler was given it.
std::string within_project(std::string_view file) {
  constexpr std::string_view own = "closed_form/src/explain/counted_tape.cpp", here = __FILE__;
  const std::string_view root = here.ends_with(own) ? here.substr(0, here.size() - own.size()) : "";
  if (file.starts_with(root)) file.remove_prefix(root.size());
  return std::string(file);
}

}  // namespace

CountedTape::CountedTape() : sites_{{"", 0, "", nullptr}} { the_tape = this; }
CountedTape::~CountedTape() { the_tape = nullptr; }
CountedTape* CountedTape::current() { return the_tape; }

AttributedTo::AttributedTo(const char* helper, const std::source_location& caller) {
  CountedTape* const tape = the_tape;
  outermost_ = tape != nullptr && tape->helper_ == nullptr;
  if (!outermost_) return;
  tape->helper_ = helper;
  tape->caller_file_ = caller.file_name();
  tape->caller_line_ = caller.line();
}
AttributedTo::AttributedTo(const char* helper) {
  CountedTape* const tape = the_tape;
  outermost_ = tape != nullptr && tape->helper_ == nullptr;
  if (!outermost_) return;
  tape->helper_ = helper;
  tape->caller_file_ = tape->last_file_;
  tape->caller_line_ = tape->last_line_;
}
AttributedTo::~AttributedTo() {
  if (outermost_) the_tape->helper_ = nullptr;
}

CountedTape::Site CountedTape::site_of(const std::source_location& where, const char* operation) {
  if (helper_ != nullptr) return {caller_file_, caller_line_, operation, helper_};
  if (is_of_eigen(where.file_name())) return {last_file_, last_line_, operation, "Eigen"};
  last_file_ = where.file_name();
  last_line_ = where.line();
  return {last_file_, last_line_, operation, nullptr};
}

std::uint32_t CountedTape::site(const Site& s) {
  const auto [at, is_new] = numbers_.try_emplace(s, static_cast<std::uint32_t>(sites_.size()));
  if (is_new) sites_.push_back(s);
  return at->second;
}

std::vector<CountedLine> CountedTape::lines(const Counted& result, double scale) const {
  // The result's derivative by each number, from the last operation back to the first.
  std::vector<double> answer(result.node + 1, 0.);
  std::vector<bool> reached(result.node + 1, false);
  if (result.node != 0) {
    answer[result.node] = scale;
    reached[result.node] = true;
  }
  std::map<std::tuple<std::string, unsigned, std::string>, CountedLine> found;
  std::map<const CountedLine*, double> most;
  for (std::uint32_t i = result.node; i > 0; --i) {
    if (!reached[i]) continue;
    const Node& node = nodes_[i - 1];
    for (int k = 0; k < 2; ++k)
      if (node.from[k] != 0) {
        reached[node.from[k]] = true;
        const double passed = answer[i] * node.slope[k];
        if (std::isfinite(passed)) answer[node.from[k]] += passed;
      }
    const Site& site = sites_[node.site];
    const std::string operation =
        site.helper != nullptr ? std::string(site.operation) + " in " + site.helper : site.operation;
    const std::string file = within_project(site.file);
    CountedLine& line = found[{file, site.line, operation}];
    line.file = file;
    line.line = site.line;
    line.operation = operation;
    ++line.count;
    const double lost = std::abs(answer[i]) * node.lost, rounded = answer[i] * node.rounding;
    if (std::isfinite(lost)) line.lost += lost;
    if (std::isfinite(rounded)) {
      line.rounded += std::abs(rounded);
      line.net += rounded;
    }
    line.bits = std::max<int>(line.bits, node.bits);
    double& largest = most.try_emplace(&line, -1.).first->second;
    const double cost = std::max(lost, std::abs(rounded));
    if (cost > largest) {
      largest = cost;
      line.before = node.before;
      line.after = node.after;
    }
  }
  std::vector<CountedLine> lines;
  lines.reserve(found.size());
  for (auto& [key, line] : found)
    if (line.lost > 0 || line.rounded > 0) lines.push_back(std::move(line));
  std::ranges::stable_sort(lines, std::greater<>(),
                           [](const CountedLine& line) { return std::max(line.lost, line.rounded); });
  return lines;
}

}  // namespace cageproof::closed_form
