// SPDX-License-Identifier: MIT
#include "rows_file.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/memory.h"

#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <system_error>

namespace cageproof::cli {
namespace {

namespace fs = std::filesystem;

void require_room(const fs::path& file, std::size_t points, std::size_t columns) {
  const double bytes = static_cast<double>(points) * static_cast<double>(columns) * sizeof(double);
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, error);
  if (error || bytes <= static_cast<double>(space.available)) return;
  throw InputError(fmt::format(
      "cannot write {}: {} points with {} numbers each take {}, and its disk has {} left; ask for fewer points, or let "
      "`deform` apply coordinates without keeping them",
      file.string(), points, columns, size_text(bytes), size_text(static_cast<double>(space.available))));
}

}  // namespace

bool is_written_by_rows(const fs::path& file) {
  return file.empty() || extension_of(file) == ".npy" || extension_of(file) == ".csv";
}

RowsFile::RowsFile(const fs::path& file, const CoordinateColumns& table, std::size_t points)
    : name_(file), is_npy_(extension_of(file) == ".npy"), columns_(table.names.size()) {
  if (!file.empty()) file_.emplace(file);
  const std::string header = is_npy_ ? npy_header(points, columns_) : csv_header(table);
  if (is_npy_ && file_->takes_any_order()) require_room(file, points, columns_);
  begin_ = header.size();
  write(header);
}

void RowsFile::write(std::string_view bytes) {
  if (file_) file_->append(bytes);
  else std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void RowsFile::put(std::size_t part, std::size_t first, std::span<const double> rows) {
  const std::string_view bytes(reinterpret_cast<const char*>(rows.data()), rows.size_bytes());
  if (is_npy_ && file_->takes_any_order()) file_->write_at(begin_ + first * columns_ * sizeof(double), bytes);
  else if (is_npy_) texts_[part] = bytes;
  else add_csv_rows(texts_[part], rows, columns_);
}

void RowsFile::flush() {
  for (std::string& text : texts_) {
    write(text);
    text.clear();
  }
}

void RowsFile::finish(const std::vector<std::pair<fs::path, std::string>>& others) {
  flush();
  if (file_) reports::replace_files(*file_, others);
}

}  // namespace cageproof::cli
