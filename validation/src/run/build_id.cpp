// SPDX-License-Identifier: MIT
#include "run/build_id.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstring>

namespace cageproof::validation {
namespace {

// The program comes first; its notes may hold what the linker hashed it to.
int read_notes(dl_phdr_info* program, std::size_t, void* text) {
  for (int i = 0; i < program->dlpi_phnum; ++i) {
    const auto& part = program->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const auto* at = reinterpret_cast<const unsigned char*>(program->dlpi_addr + part.p_vaddr);
    const auto* end = at + part.p_memsz;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
      const unsigned char* content = at + sizeof note + padded(note.n_namesz);
      if (note.n_type == NT_GNU_BUILD_ID && content + note.n_descsz <= end)
        for (std::size_t k = 0; k < note.n_descsz; ++k)
          static_cast<std::string*>(text)->append(fmt::format("{:02x}", content[k]));
      at = content + padded(note.n_descsz);
    }
  }
  return 1;
}

}  // namespace

std::string build_id() {
  std::string text;
  dl_iterate_phdr(read_notes, &text);
  return text.empty() ? "unknown" : text;
}

}  // namespace cageproof::validation
