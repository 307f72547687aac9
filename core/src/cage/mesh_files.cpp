// SPDX-License-Identifier: MIT
#include "mesh_files.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::mesh_files {

void FileLine::fail(const std::string& reason) const {
  throw InputError(line == 0 ? fmt::format("{}: {}", file.string(), reason)
                             : fmt::format("{}:{}: {}", file.string(), line, reason));
}

std::string read_mesh_file(const std::filesystem::path& named) {
  const std::filesystem::path path = named == "-" ? "/dev/stdin" : named;
  const FileLine at{path};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) at.fail("no such file");
  if (std::filesystem::is_directory(status)) at.fail("is a directory");
  std::string text = read_file(path);
  if (text.empty()) at.fail("the file is empty");
  if (text.starts_with("version https://git-lfs"))
    at.fail("a Git LFS pointer, not the file; `git lfs pull` fetches it");
  return text;
}

std::string shown(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text(token.substr(0, longest));
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return fmt::format("\"{}{}\"", text, token.size() > longest ? "..." : "");
}

bool take_line(std::string_view& rest, std::string_view& line) {
  if (rest.empty()) return false;
  const std::size_t end = rest.find_first_of("\r\n");
  line = rest.substr(0, end);
  if (end == std::string_view::npos) rest = {};
  else rest.remove_prefix(end + (rest.substr(end, 2) == "\r\n" ? 2 : 1));
  return true;
}

std::string_view take_token(std::string_view& rest) {
  constexpr std::string_view blanks = " \t\v\f";
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::string_view token = rest.substr(0, rest.find_first_of(blanks));
  rest.remove_prefix(token.size());
  return token;
}

std::string_view without_comment(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != std::string_view::npos && at > 0 && line[at - 1] == '.') at = line.find('#', at + 1);
  return line.substr(0, at);
}

std::string_view Tokens::take() {
  for (;;) {
    if (const std::string_view token = take_token(line); !token.empty()) return token;
    if (!take_line(rest, line)) return {};
    ++at.line;
    if (has_comments) line = without_comment(line);
  }
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

double finite_number(std::string_view token, const FileLine& at) {
  const std::optional<double> x = parse_scalar<double>(token);
  if (!x || !std::isfinite(*x)) at.fail(shown(token) + " is not a finite number");
  return *x;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return lower;
}

void leave_out_heights(Mesh& mesh, const std::filesystem::path& path) {
  if (mesh.first_height == 0) return;
  for (Vec3<double>& p : mesh.vertices) p[2] = 0;
  mesh.warnings.push_back(fmt::format("{}:{}: positions have third numbers, heights, from here on; they are left out",
                                      path.string(), mesh.first_height));
}

}  // namespace cageproof::mesh_files
