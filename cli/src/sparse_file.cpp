// SPDX-License-Identifier: MIT
#include "sparse_file.h"

#include "npz.h"

#include "cageproof/core/memory.h"

#include <fmt/format.h>

#include <bit>
#include <limits>

namespace cageproof::cli {
namespace {

using deformation::SparseRow;
using deformation::WeightFormat;

static_assert(std::endian::native == std::endian::little);

template <class T>
void append(std::string& bytes, T number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append(std::string& bytes, WeightFormat format, double weight) {
  if (format == WeightFormat::Double) append(bytes, weight);
  else if (format == WeightFormat::Float) append(bytes, static_cast<float>(weight));
  else append(bytes, deformation::half_bits(weight));
}

// Numbers of columns take one or two bytes where these are enough: SciPy widens them.
int bytes_of_column(std::size_t columns) {
  if (columns <= std::numeric_limits<std::uint8_t>::max() + 1U) return 1;
  return columns <= std::numeric_limits<std::uint16_t>::max() + 1U ? 2 : 4;
}

std::string_view type_of_columns(int bytes) { return bytes == 1 ? "|u1" : bytes == 2 ? "<u2" : "<i4"; }

void merge(SparseTotals& into, const SparseTotals& more) {
  if (more.bound > into.bound || into.rows == into.missing) into.worst = more.worst;
  into.bound = std::max(into.bound, more.bound);
  into.sum_change = std::max(into.sum_change, more.sum_change);
  into.rows += more.rows;
  into.missing += more.missing;
  into.kept += more.kept;
  into.over += more.over;
}

// Where each row begins: as short numbers as hold the last.
std::string row_begins(const std::vector<std::size_t>& counts, std::size_t all) {
  const bool is_short = all <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  std::string bytes = npy_header(is_short ? "<i4" : "<i8", {counts.size() + 1});
  std::int64_t begin = 0;
  const auto add = [&] {
    if (is_short) append(bytes, static_cast<std::int32_t>(begin));
    else append(bytes, begin);
  };
  add();
  for (const std::size_t count : counts) {
    begin += static_cast<std::int64_t>(count);
    add();
  }
  return bytes;
}

}  // namespace

SparseFile::SparseFile(const std::filesystem::path& file, deformation::SparseWeights weights)
    : name_(file.string()), weights_(std::move(weights)), file_(file) {}

void SparseFile::add(const SparseRow& row, std::size_t number, Part& part) const {
  for (const double weight : row.weights) append(part.data, weights_.format(), weight);
  const int bytes = bytes_of_column(weights_.columns());
  for (const int column : row.columns) {
    if (bytes == 1) append(part.indices, static_cast<std::uint8_t>(column));
    else if (bytes == 2) append(part.indices, static_cast<std::uint16_t>(column));
    else append(part.indices, static_cast<std::int32_t>(column));
  }
  part.counts.push_back(row.columns.size());
  const std::size_t missing = row.finite ? 0 : 1, over = row.bound > weights_.tolerance() ? 1 : 0;
  merge(part.totals, {1, missing, row.columns.size(), row.bound, row.sum_change, number, over});
}

void SparseFile::put(std::size_t part, std::size_t first, std::span<const double> rows) {
  const std::size_t columns = weights_.columns();
  for (std::size_t i = 0; i * columns < rows.size(); ++i)
    add(weights_.row(rows.subspan(i * columns, columns)), first + i, parts_[part]);
}

void SparseFile::flush() {
  for (Part& part : parts_) {
    if (part.counts.empty()) continue;
    totals_.bytes += part.data.size() + part.indices.size() + part.counts.size() * sizeof(std::int32_t);
    merge(totals_, part.totals);
    done_.push_back(std::move(part));
    part = {};
  }
  require_memory(static_cast<double>(totals_.bytes + totals_.rows * sizeof(std::size_t)),
                 fmt::format("{}: what is kept of the first {} points", name_, totals_.rows),
                 "ask for fewer points, or for a larger --drop");
}

std::size_t SparseFile::finish(const std::vector<std::pair<std::string, std::string>>& others) {
  constexpr std::string_view types[]{"<f8", "<f4", "<f2"};
  const std::string format = npy_header("|S3", {}) + "csr";
  std::string shape = npy_header("<i8", {2});
  append(shape, static_cast<std::int64_t>(totals_.rows));
  append(shape, static_cast<std::int64_t>(weights_.columns()));
  const std::string data = npy_header(types[static_cast<std::size_t>(weights_.format())], {totals_.kept});
  const std::string indices = npy_header(type_of_columns(bytes_of_column(weights_.columns())), {totals_.kept});
  std::vector<ZipMember> members{
      {"format.npy", {format}}, {"shape.npy", {shape}}, {"data.npy", {data}}, {"indices.npy", {indices}}};
  std::vector<std::size_t> counts;
  counts.reserve(totals_.rows);
  for (const Part& part : done_) {
    members[2].pieces.push_back(part.data);
    members[3].pieces.push_back(part.indices);
    counts.insert(counts.end(), part.counts.begin(), part.counts.end());
  }
  const std::string begins = row_begins(counts, totals_.kept);
  members.push_back({"indptr.npy", {begins}});
  for (const auto& [name, bytes] : others) members.push_back({name, {bytes}});
  std::size_t written = 0;
  write_zip(members, [&](std::string_view bytes) {
    file_.append(bytes);
    written += bytes.size();
  });
  reports::replace_files(file_, {});
  return written;
}

}  // namespace cageproof::cli
