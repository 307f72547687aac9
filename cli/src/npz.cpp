// SPDX-License-Identifier: MIT
#include "npz.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
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

la_ssize_t append(struct archive*, void* text, const void* bytes, std::size_t count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

}  // namespace

std::string zip_text(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string text;
  const std::unique_ptr<struct archive, decltype(&archive_write_free)> zip(archive_write_new(), &archive_write_free);
  check(zip.get(), archive_write_set_format_zip(zip.get()));
  // Doubles hardly shrink, and whoever reads an array may map it.
  check(zip.get(), archive_write_zip_set_compression_store(zip.get()));
  check(zip.get(), archive_write_set_bytes_in_last_block(zip.get(), 1));
  check(zip.get(), archive_write_open(zip.get(), &text, nullptr, append, nullptr));
  for (const auto& [name, bytes] : members) {
    const std::unique_ptr<struct archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                                     &archive_entry_free);
    // Without a time of its own it gets the earliest that ZIP knows.
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    check(zip.get(), archive_write_header(zip.get(), entry.get()));
    // Large members are taken in parts.
    for (std::size_t done = 0; done < bytes.size();) {
      const la_ssize_t taken = archive_write_data(zip.get(), bytes.data() + done, bytes.size() - done);
      if (taken <= 0) fail(zip.get());
      done += static_cast<std::size_t>(taken);
    }
  }
  check(zip.get(), archive_write_close(zip.get()));
  return text;
}

}  // namespace cageproof::cli
