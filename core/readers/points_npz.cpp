// SPDX-License-Identifier: MIT
// NumPy's .npz with one array of points, through libarchive.
#include "cage/mesh_files.h"
#include "cage/points_files.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace cageproof::mesh_files {
namespace {

// The arrays' names, and the bytes of the first one.
struct FirstArray {
  std::vector<std::string> names;
  std::string bytes;
};

// libarchive's last message, on one line.
std::string reason_of(struct archive* zip, std::string_view none) {
  const char* message = archive_error_string(zip);
  std::string_view rest = message ? std::string_view(message) : none, line;
  take_line(rest, line);
  return std::string(line);
}

std::string bytes_of(struct archive* zip, std::size_t packed, const std::filesystem::path& path) {
  std::string bytes;
  char buffer[1 << 16];
  la_ssize_t count = 0;
  while ((count = archive_read_data(zip, buffer, sizeof buffer)) > 0) {
    bytes.append(buffer, static_cast<std::size_t>(count));
    if (bytes.size() > most_unpacked(packed))
      FileLine{path}.fail(
          fmt::format("its {} bytes unpack to more than {}; write the points as .npy", packed, most_unpacked(packed)));
  }
  if (count < 0) FileLine{path}.fail("libarchive cannot read it: " + reason_of(zip, "no reason known"));
  return bytes;
}

std::string printable(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return name;
}

FirstArray first_array(const std::string& file, const std::filesystem::path& path) {
  FirstArray found;
  const std::unique_ptr<struct archive, decltype(&archive_read_free)> zip(archive_read_new(), &archive_read_free);
  archive_read_support_format_zip_seekable(zip.get());
  int code = archive_read_open_memory(zip.get(), file.data(), file.size());
  struct archive_entry* entry = nullptr;
  while (code == ARCHIVE_OK && (code = archive_read_next_header(zip.get(), &entry)) == ARCHIVE_OK) {
    const std::string name = archive_entry_pathname(entry) ? archive_entry_pathname(entry) : "";
    if (!name.ends_with(".npy")) continue;
    found.names.push_back(name.substr(0, name.size() - std::string_view(".npy").size()));
    if (found.names.size() == 1) found.bytes = bytes_of(zip.get(), file.size(), path);
  }
  if (code != ARCHIVE_EOF) FileLine{path}.fail("libarchive cannot read it: " + reason_of(zip.get(), "no ZIP file"));
  return found;
}

Mesh read_npz(const std::filesystem::path& path) {
  const FirstArray array = first_array(read_mesh_file(path), path);
  if (array.names.empty()) FileLine{path}.fail("no array in it");
  std::vector<std::string> names;
  names.reserve(array.names.size());
  for (const std::string& name : array.names) names.push_back(printable(name));
  if (array.names.size() > 1)
    FileLine{path}.fail(fmt::format("{} arrays ({}); points are one: numpy.save(\"points.npy\", arrays[NAME])",
                                    array.names.size(), fmt::join(names, ", ")));
  return points_of_array(array.bytes, path, array.names.front());
}

const RegisterMeshReader npz_reader{".npz", read_npz};

}  // namespace
}  // namespace cageproof::mesh_files
