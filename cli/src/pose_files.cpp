// SPDX-License-Identifier: MIT
#include "pose_files.h"

#include "numbered_name.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/pvd_text.h"

#include <fmt/format.h>

namespace cageproof::cli {

std::string PoseFiles::name_of(std::size_t k) const {
  return is_point_cache(a_.out) ? fmt::format("{}, frame {}", a_.out, k) : numbered(a_.out, k);
}

void PoseFiles::add_report(const nlohmann::ordered_json& report) {
  // A file's name may hold bytes that are not UTF-8.
  const std::string text = report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  files_.emplace_back(report_file(a_, maps_), text + '\n');
}

void PoseFiles::add(const std::string& pose, const Mesh& deformed, const CoordinateColumns& images,
                    const nlohmann::ordered_json& report) {
  const std::size_t k = ++maps_;
  reports_.push_back(report);
  if (is_point_cache(a_.out)) {
    frames_.push_back({pose, deformed.vertices});
  } else {
    const std::string out = numbered(a_.out, k);
    files_.emplace_back(out, text_for(out, deformed, images, source_));
  }
  if (!a_.derivatives.empty()) add_table(a_.derivatives, deformed, images);
}

void PoseFiles::add_table(const std::string& file, const Mesh& deformed, const CoordinateColumns& table) {
  const std::string name = numbered(file, maps_);
  files_.emplace_back(name, text_for(name, deformed, table, source_));
}

void PoseFiles::add_cache() {
  reports::PointCache cache;
  try {
    cache = extension_of(a_.out) == ".mdd" ? reports::mdd_of(frames_, a_.frame_rate > 0 ? a_.frame_rate : usual_rate)
                                           : reports::pc2_of(frames_);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", a_.out, error.what()));
  }
  if (cache.rounded)
    fmt::print(stderr, "warning: {}: point caches are single precision: coordinates are rounded to about 7 digits\n",
               a_.out);
  files_.emplace_back(a_.out, std::move(cache.bytes));
}

void PoseFiles::add_collection() {
  std::vector<reports::TimeStep> steps;
  for (std::size_t k = 1; k <= maps_; ++k)
    steps.push_back({static_cast<double>(k), std::filesystem::path(numbered(a_.out, k)).filename().string()});
  files_.emplace_back(a_.collection, reports::pvd_text(steps));
}

void PoseFiles::write() {
  if (is_point_cache(a_.out)) add_cache();
  if (!a_.collection.empty()) add_collection();
  if (!is_point_cache(a_.out) && maps_ > 1)
    for (std::size_t k = 1; k <= maps_; ++k) reports_[k - 1]["file"] = numbered(a_.out, k);
  if (maps_ == 1 && !is_point_cache(a_.out)) add_report(reports_.front());
  else add_report({{"schema", deformations_schema}, {"schema_version", 1}, {"frames", reports_}});
  reports::replace_files(files_);
}

}  // namespace cageproof::cli
