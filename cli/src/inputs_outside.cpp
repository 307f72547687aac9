// SPDX-License-Identifier: MIT
#include "inputs_outside.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace cageproof::cli {

std::filesystem::path place_of(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path place = std::filesystem::weakly_canonical(file, error);
  return error ? file : place;
}

void require_outside(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& inputs) {
  std::error_code ignored;
  const auto place = [&](const std::string& name) {
    std::filesystem::path path = std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
    return path.has_filename() ? path : path.parent_path();
  };
  if (folder.empty()) return;
  const std::filesystem::path out = place(folder);
  for (const auto& [name, option] : inputs) {
    if (name.empty() || !std::filesystem::exists(name, ignored)) continue;
    const std::filesystem::path input = place(name);
    if (std::mismatch(out.begin(), out.end(), input.begin(), input.end()).first == out.end())
      throw InputError(fmt::format("--out {}: the folder holds {}, which {} reads", folder, name, option));
  }
}

void require_one_reader_of_input(const std::vector<std::pair<std::string, std::string>>& inputs) {
  std::string reader;
  for (const auto& [name, option] : inputs) {
    if (name != "-" && name != "/dev/stdin" && name != "/dev/fd/0") continue;
    if (!reader.empty())
      throw InputError(
          fmt::format("{} and {}: standard input can be read once; give one of them a file", reader, option));
    reader = option;
  }
}

}  // namespace cageproof::cli
