// SPDX-License-Identifier: MIT
// libFuzzer's target: the readers of one format, CAGEPROOF_FUZZ_FORMAT ("obj"). Readers choose by a file's extension,
// so each input is written to one.
#include "read_input.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <unistd.h>

namespace {

// Removed at the end. scripts/fuzz sets TMPDIR to a folder in memory.
class InputFile {
 public:
  InputFile() {
    const char* format = std::getenv("CAGEPROOF_FUZZ_FORMAT");
    if (!format) {
      std::fputs("CAGEPROOF_FUZZ_FORMAT names the format: obj, ply, ...\n", stderr);
      std::exit(2);
    }
    path = std::filesystem::temp_directory_path() / ("cageproof_fuzz_" + std::to_string(getpid()) + "." + format);
  }
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::filesystem::path path;
};

}  // namespace

// The function that libFuzzer calls, by this name.
extern "C" int LLVMFuzzerTestOneInput(  // NOLINT(readability-identifier-naming)
    const std::uint8_t* data, std::size_t size) {
  static const InputFile file;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.path.c_str(), "wb"), &std::fclose);
    if (!out || std::fwrite(data, 1, size, out.get()) != size) std::abort();
  }
  cageproof::fuzzing::read_input(file.path);
  return 0;
}
