// SPDX-License-Identifier: MIT
// Pictures of several panels side by side, as papers have them: shaded meshes with a cage's edges over them, or, seen
// from above, grids, outlines and arrows of the plane. Drawn by cairo into memory, without a display.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::reports {

/// The direction of parallel rays in which panels are seen: `towards` the viewer, and `up`. Both are nonzero, and they
/// are not parallel.
struct FigureView {
  Vec3<double> towards = Vec3<double>(0, 0, 1), up = Vec3<double>(0, 1, 0);
};

/// An arrow at a point, of that direction in the view; all have one length. \param strength 0 to 1, its colour
struct FigureArrow {
  Vec3<double> at, along;
  double strength;
};

/// One of several pictures side by side.
struct FigurePanel {
  std::string title;  ///< above it
  std::string note;   ///< below the title, small
  std::string file;   ///< of its data, without extension
  /// Surface written for ParaView. Its faces are shaded by their normals, and in another hue where their inner side
  /// shows; in flat panels only the darker faces are filled. Its segments are drawn over the faces.
  MeshField data;
  std::vector<char> tones;  ///< one per face, 0 or 1: a lighter or a darker colour; empty: all lighter
  bool flat = false;        ///< in the plane: faces are drawn by their edges
  bool with_faces = true;   ///< whether faces are drawn at all
  /// Surface or polygon drawn by its edges over the faces; in space the edges on its far side lie behind them.
  std::vector<Vec3<double>> cage;
  std::vector<std::vector<int>> cage_faces;  ///< of two vertices in the plane
  std::vector<Vec3<double>> marks;           ///< points of interest
  std::vector<FigureArrow> arrows;
  /// Facts by name, for captions: "method", "parameters" ...
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<std::pair<std::string, double>> measured;  ///< figures by name: "volume ratio" ...
};

/// A figure.
struct FigureSheet {
  std::string name;     ///< of its files: "t24-bend"
  std::string heading;  ///< its title
  std::string source;   ///< the paper's figures that it makes again
  std::string text;     ///< how to read it
  int columns = 4;
  FigureView view;
  std::vector<FigurePanel> panels;  ///< row by row
};

/// Where a panel's points come to lie in its picture, in pixels from the upper left corner of the picture.
struct FigureFrame {
  double left, top, width, height;  ///< of the panel's drawing, without its title
  std::array<double, 2> origin;     ///< of space
  std::array<double, 2> x, y, z;    ///< a step along each axis
  double scale;                     ///< pixels a unit of length
  double share;                     ///< of the scale that the figure's other panels have; 1 unless it is too large
  std::array<double, 2> at(const Vec3<double>& point) const;
};

/// The size of the picture in pixels.
struct FigureLayout {
  int width, height;
  std::vector<FigureFrame> frames;  ///< one per panel
};

/// All panels have one scale, which shows all of every cage, and each is in the middle of its place; one whose image
/// reaches far beyond its cage is drawn smaller, by its share, and says so. \throws std::invalid_argument for a sheet
/// without panels or columns, and a panel without any point
FigureLayout layout_of(const FigureSheet& sheet);

/// The figure as PNG. Points must be finite. \throws std::invalid_argument as layout_of
std::string figure_png(const FigureSheet& sheet);

/// A figure in a folder of figures.
struct FigureEntry {
  FigureSheet sheet;              ///< its panels have no data
  std::string picture;            ///< "figures/t24-bend.png"
  std::vector<std::string> data;  ///< "figures/t24-bend.green.vtp", one per panel
};

/// Writes picture and data into the folder's subfolder `figures`, which exists.
/// \throws InputError when a file cannot be written
FigureEntry write_figure(const std::filesystem::path& folder, FigureSheet sheet);

/// figures.json: schema `cageproof-figures`, names, captions, facts and files of all.
std::string figures_json(const std::vector<FigureEntry>& figures);

/// Writes OUT/figures/: pictures, data and figures.json, aside and then renamed into place.
/// \throws InputError when OUT holds anything but such a folder, its parent is missing, or a file cannot be written
void write_figures(const std::filesystem::path& out, std::vector<FigureSheet> sheets);

/// Nothing where figures can be written there, so that nobody waits in vain. \throws InputError as write_figures
void require_figure_folder(const std::filesystem::path& out);

}  // namespace cageproof::reports
