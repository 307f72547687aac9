// SPDX-License-Identifier: MIT
// Pictures through the program gnuplot (Debian: gnuplot-nox): needs no display.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// A picture to draw: the commands that follow `set output`, and its size in pixels.
struct Picture {
  std::string file;  ///< relative to the report's folder: "pictures/....png"
  int width = 0;
  int height = 0;
  std::string commands;
};

/// Draws all pictures into the folder, as many at a time as there are cores. In place of one that gnuplot does not draw
/// there is a picture that says so. Gives one line for each of these.
/// \throws InputError when gnuplot is missing or draws nothing at all, or a picture is not whole (a full disk)
[[nodiscard]] std::vector<std::string> draw(const std::vector<Picture>& pictures, const std::filesystem::path& folder);

/// Text as a gnuplot string literal, taken as it is (no escapes, no markup when drawn `noenhanced`).
std::string gnuplot_text(std::string_view text);

/// A number that gnuplot reads; NaN for numbers that are not finite.
std::string gnuplot_number(double x);

}  // namespace cageproof::reports
