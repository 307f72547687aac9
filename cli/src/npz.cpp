// SPDX-License-Identifier: MIT
#include "npz.h"

#include <archive.h>
#include <archive_entry.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <memory>
#include <stdexcept>

namespace cageproof::cli {
namespace {

[[noreturn]] void fail(struct archive* zip) {
  const char* reason = archive_error_string(zip);
  throw std::runtime_error(std::string("cannot make a ZIP file: ") + (reason ? reason : "no reason known"));
}

void check(struct archive* zip, int code) {
  if (code != ARCHIVE_OK) fail(zip);
}

// A function that takes the bytes, and its exception, which may not pass through libarchive.
struct Taker {
  const std::function<void(std::string_view)>& take;
  std::exception_ptr thrown = {};
};

la_ssize_t append(struct archive*, void* taker, const void* bytes, std::size_t count) {
  auto& [take, thrown] = *static_cast<Taker*>(taker);
  try {
    take({static_cast<const char*>(bytes), count});
  } catch (...) {
    thrown = std::current_exception();
    return -1;
  }
  return static_cast<la_ssize_t>(count);
}

void write_members(struct archive* zip, const std::vector<ZipMember>& members) {
  for (const auto& [name, pieces] : members) {
    const std::unique_ptr<struct archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                                     &archive_entry_free);
    la_int64_t size = 0;
    for (const std::string_view piece : pieces) size += static_cast<la_int64_t>(piece.size());
    // Without a time of its own it gets the earliest that ZIP knows.
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), size);
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    check(zip, archive_write_header(zip, entry.get()));
    // Large pieces are taken in parts.
    for (std::string_view piece : pieces)
      while (!piece.empty()) {
        const la_ssize_t taken = archive_write_data(zip, piece.data(), piece.size());
        if (taken <= 0) fail(zip);
        piece.remove_prefix(static_cast<std::size_t>(taken));
      }
  }
}

}  // namespace

std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape) {
  // Python writes a tuple with one entry with a comma.
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", type,
                                   fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  // Its length is two bytes, and numbers begin at a multiple of 64.
  constexpr std::size_t before = 10, unit = 64;
  header.append((unit - (before + header.size() + 1) % unit) % unit, ' ');
  header += '\n';
  std::string start("\x93NUMPY\x01\x00", 8);
  start += static_cast<char>(header.size() % 256);
  start += static_cast<char>(header.size() / 256);
  return start + header;
}

void write_zip(const std::vector<ZipMember>& members, const std::function<void(std::string_view)>& take) {
  Taker taker{take};
  try {
    const std::unique_ptr<struct archive, decltype(&archive_write_free)> zip(archive_write_new(), &archive_write_free);
    check(zip.get(), archive_write_set_format_zip(zip.get()));
    // Doubles hardly shrink, and whoever reads an array may map it.
    check(zip.get(), archive_write_zip_set_compression_store(zip.get()));
    check(zip.get(), archive_write_set_bytes_in_last_block(zip.get(), 1));
    check(zip.get(), archive_write_open(zip.get(), &taker, nullptr, append, nullptr));
    write_members(zip.get(), members);
    check(zip.get(), archive_write_close(zip.get()));
  } catch (const std::runtime_error&) {
    if (!taker.thrown) throw;
  }
  if (taker.thrown) std::rethrow_exception(taker.thrown);
}

std::string zip_text(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string text;
  std::vector<ZipMember> in_pieces;
  in_pieces.reserve(members.size());
  for (const auto& [name, bytes] : members) in_pieces.push_back({name, {bytes}});
  write_zip(in_pieces, [&](std::string_view bytes) { text += bytes; });
  return text;
}

}  // namespace cageproof::cli
