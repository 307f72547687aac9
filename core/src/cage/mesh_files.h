// SPDX-License-Identifier: MIT
// Tools that readers of file formats share: whole files, lines, tokens, and messages that name the place.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace cageproof::mesh_files {

/// Where in a file something is wrong. \p line counts from 1; 0 means the whole file.
struct FileLine {
  const std::filesystem::path& file;
  std::size_t line = 0;
  /// \throws InputError "file:line: reason"
  [[noreturn]] void fail(const std::string& reason) const;
};

/// The whole file; of "-" standard input.
/// \throws InputError when it is missing, no file, unreadable, empty, or a pointer of Git LFS
std::string read_mesh_file(const std::filesystem::path& path);

/// A token as messages show it: quoted, printable, at most 40 characters.
std::string shown(std::string_view token);

/// Takes the next line off `rest`, without its end (LF, CRLF or CR); false at the end of the text.
bool take_line(std::string_view& rest, std::string_view& line);

/// Takes the next token off `rest`, empty at the end. Tokens stand between blanks, tabs, vertical tabs and form feeds.
std::string_view take_token(std::string_view& rest);

/// The line up to a comment, which `#` begins, except in "1.#IND" and the like, which are one token and no number.
std::string_view without_comment(std::string_view line);

/// Tokens of a text, in whatever lines they stand.
struct Tokens {
  std::string_view rest;      ///< behind `line`
  FileLine& at;               ///< its line is that of the last token
  bool has_comments = false;  ///< as without_comment has them
  std::string_view line{};    ///< what is left of the line of the last token
  /// The next token; empty at the text's end.
  std::string_view take();
};

/// The text without a UTF-8 byte order mark.
std::string_view without_mark(std::string_view text);

/// The correctly rounded finite number a token states. \throws InputError at `at` when it is none
double finite_number(std::string_view token, const FileLine& at);

/// The text with A to Z in lower case.
std::string lower_case(std::string_view text);

/// How many bytes a packed file of such a size is unpacked to: a hundred times as many, or 16 MB. What unpacks to more
/// is no points, but zeros to fill the memory with.
constexpr std::size_t most_unpacked(std::size_t packed) {
  constexpr std::size_t ratio = 100, at_least = std::size_t{16} << 20;
  return std::max(at_least, ratio * packed);
}

Mesh read_obj(const std::filesystem::path& path);

/// Sets third coordinates that are heights over a map to zero, with a warning.
void leave_out_heights(Mesh& mesh, const std::filesystem::path& path);

/// A PLY file after its check. VTK 9.1's reader crashes on what is not whole, and on legal files too (colours that are
/// not all bytes, lines that end in CR, a last line without end); it takes other elements for faces, knows no point
/// sets and rounds coordinates to float. So it is given a copy with nothing but the faces, and the coordinates come
/// from the check.
struct CheckedPly {
  std::vector<Vec3<double>> vertices;
  std::size_t face_count = 0;
  std::vector<std::string> warnings;  ///< as a mesh's
  std::string for_vtk;                ///< a binary PLY with the same faces, and zeros for coordinates
};
/// \throws InputError for what read_mesh rejects
CheckedPly check_ply(const std::filesystem::path& path, std::string_view text);

}  // namespace cageproof::mesh_files
