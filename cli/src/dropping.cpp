// SPDX-License-Identifier: MIT
#include "dropping.h"

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cageproof::cli {
namespace {

using deformation::WeightFormat;

const std::vector<std::string>& store_names() {
  static const std::vector<std::string> names{"double", "float", "half"};
  return names;
}

WeightFormat format_of(const Dropping& dropping) {
  return static_cast<WeightFormat>(std::ranges::find(store_names(), dropping.store) - store_names().begin());
}

// Rounded up, so that it stays a bound.
std::string bound_text(double bound) {
  if (!(bound > 0)) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 2);
  return fmt::format("{:.3g}", std::ceil(bound / unit * (1 - 1e-12)) * unit);
}

}  // namespace

void add_dropping(Command& command, Dropping& dropping, const Option& data) {
  const Option drop =
      command
          .option("--drop", dropping.tolerance,
                  "drop small weights, and write an .npz of sparse rows for SciPy's load_npz: `weights @ posed` is off "
                  "by at most this share of the cage's size, the diagonal of its bounding box")
          .taking("TOLERANCE")
          .in_range(0.0, 1.0)
          .excludes(data);
  command
      .option("--budget", dropping.budget,
              "the bound of --drop holds for poses that move each vertex by at most this many cage sizes")
      .taking("SIZE")
      .in_range(0.0, 1000.0)
      .showing_default()
      .needs(drop);
  command.option("--store", dropping.store, "number type of the weights; the tolerance includes their rounding")
      .one_of(store_names())
      .showing_default()
      .needs(drop);
}

void check_dropping(const Dropping& dropping, const std::string& out, int order) {
  if (!dropping.is_asked()) return;
  if (out.empty() || extension_of(out) != ".npz")
    throw InputError(fmt::format("--drop: {}; sparse rows are written as .npz",
                                 out.empty() ? std::string("needs an --out") : fmt::format("not as {}", out)));
  if (order > 0)
    throw InputError("--drop: drops weights of values, whose bound says nothing of derivatives; leave --order out");
}

deformation::SparseWeights weights_of(const Dropping& dropping, const CageCoordinates& coordinates, double size) {
  if (const std::string why = deformation::why_without_reach(coordinates); !why.empty())
    throw InputError(fmt::format("--drop: {}: {}, and without a bound nothing is dropped; kinds with one: {}",
                                 coordinates.kind().name, why,
                                 fmt::join(deformation::kinds_with_reach(coordinates.dimension()), ", ")));
  return {deformation::pose_reach(coordinates, dropping.budget * size, size), dropping.tolerance * size,
          format_of(dropping)};
}

void require_within(const Dropping& dropping, const SparseTotals& totals, double size) {
  if (totals.over == 0) return;
  const bool in_double = format_of(dropping) == WeightFormat::Double;
  throw InputError(fmt::format(
      "--drop {}: weights rounded to {} move {} of {} points by up to {} of the cage's size, point {} the farthest; "
      "{} a larger --drop, or a smaller --budget",
      dropping.tolerance, dropping.store, totals.over, totals.rows, bound_text(totals.bound / size), totals.worst,
      in_double ? "give" : "store double, or give"));
}

nlohmann::ordered_json json_of(const Dropping& dropping, const SparseTotals& totals, double size) {
  return {{"tolerance", dropping.tolerance},
          {"budget", dropping.budget},
          {"stored_as", dropping.store},
          {"cage_size", size},
          {"bound", totals.bound / size},
          {"sum_change", totals.sum_change},
          {"kept", totals.kept},
          {"apply", "points = W @ rows, the blocks' rows one below the other, in their order"}};
}

std::vector<std::string> lines_of(const Dropping& dropping, const SparseTotals& totals, double size, std::size_t bytes,
                                  std::size_t columns) {
  const double all = static_cast<double>(totals.rows) * static_cast<double>(columns);
  const double rows = std::max(1.0, static_cast<double>(totals.rows)), whole = all * bytes_of(format_of(dropping));
  std::vector<std::string> lines{
      fmt::format("kept {} of {:.0f} weights, {:.1f} a point, as {}: {}; all have {}{}", totals.kept, all,
                  static_cast<double>(totals.kept) / rows, dropping.store, size_text(static_cast<double>(bytes)),
                  size_text(whole),
                  format_of(dropping) == WeightFormat::Double
                      ? ""
                      : fmt::format(", and {} in double", size_text(all * sizeof(double)))),
      fmt::format("no point is off by more than {} of the cage's size, {:.6g}, in poses that move vertices by at most "
                  "{} of it; point {} has the largest bound; sums of weights change by at most {}",
                  bound_text(totals.bound / size), size, dropping.budget, totals.worst, bound_text(totals.sum_change))};
  if (static_cast<double>(totals.bytes) > whole)
    lines.push_back(
        "sparse rows are larger than the whole table would be: a larger --drop or a smaller --budget leaves fewer");
  return lines;
}

}  // namespace cageproof::cli
