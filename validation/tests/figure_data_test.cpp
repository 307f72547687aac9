// SPDX-License-Identifier: MIT
// Figures of cages and meshes from files, and what is refused.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/validation/paper_figures.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

namespace cageproof::validation {
namespace {

namespace fs = std::filesystem;

FigureFindings all_of(const PaperFigure& figure) {
  FigureFindings found;
  for (int part = 0; part < figure.parts(); ++part) found.merge(figure.part(part, 1));
  return found;
}

class FigureData : public testing::Test {
 protected:
  FigureData() : folder_(fs::temp_directory_path() / ("figure-data-" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
    write("Box_Cage.obj", cube(1));
    write("Box_Cage_Deformed.obj", cube(2));
    write("Box.obj", cube(0.5));
  }
  ~FigureData() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  static std::string cube(double size) {
    std::string text;
    const Cage cage = embedded_cage("cube");
    for (const Vec3<double>& v : cage.vertices())
      text += "v " + std::to_string(size * v[0]) + " " + std::to_string(size * v[1]) + " " +
              std::to_string(size * v[2]) + "\n";
    for (const Face& face : cage.faces()) {
      text += "f";
      for (const int v : face.vertices) text += " " + std::to_string(v + 1);
      text += "\n";
    }
    return text;
  }
  std::string refused() const {
    try {
      figures_of_data(folder_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_;
};

TEST_F(FigureData, of_files_is_what_deformers_make_of_them) {
  const PaperFigures figures = figures_of_data(folder_);
  ASSERT_EQ(figures.size(), 1u);
  const auto sheets = figures[0]->sheets(all_of(*figures[0]));
  ASSERT_EQ(sheets.size(), 3u);
  EXPECT_EQ(sheets[0].name, "t24-Box");
  const auto& rest = sheets[0].panels[0].data.vertices;
  const auto& panel = sheets[0].panels[1];
  ASSERT_EQ(panel.file, "mean_value");
  for (std::size_t p = 0; p < rest.size(); ++p) EXPECT_LT((panel.data.vertices[p] - 2 * rest[p]).norm(), 1e-14);
  EXPECT_EQ(panel.measured[0].first, "volume ratio");
  EXPECT_NEAR(panel.measured[0].second, 8, 1e-12);
}

TEST_F(FigureData, of_polygons_are_of_the_plane) {
  const auto square = [](double size, const std::string& z) {
    std::string text;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      text += "v " + std::to_string(size * x) + " " + std::to_string(size * y) + " " + z + "\n";
    return text;
  };
  const std::string edges = "l 1 2\nl 2 3\nl 3 4\nl 4 1\n";
  write("Box_Cage.obj", square(1, "0") + edges);
  write("Box_Cage_Deformed.obj", square(2, "0") + edges);
  write("Box.obj", square(1, "0") + "f 1 2 3 4\n");
  const auto sheets = figures_of_data(folder_)[0]->sheets(all_of(*figures_of_data(folder_)[0]));
  ASSERT_EQ(sheets.size(), 1u);
  EXPECT_EQ(sheets[0].name, "w12-Box");
  for (const auto& panel : sheets[0].panels) {
    EXPECT_TRUE(panel.flat) << panel.file;
    ASSERT_EQ(panel.data.vertices.size(), 4u);
    if (panel.file == "mean_value" || panel.file == "harmonic" || panel.file == "cauchy")
      for (std::size_t p = 0; p < 4; ++p)
        EXPECT_LT((panel.data.vertices[p] - 2 * sheets[0].panels[0].data.vertices[p]).norm(), 1e-12) << panel.file;
  }
  write("Box.obj", square(0.5, "0.25") + "f 1 2 3 4\n");
  EXPECT_NE(refused().find("Box.obj: vertex 1 has z = 0.25"), std::string::npos) << refused();
}

TEST_F(FigureData, of_open_meshes_states_no_volume) {
  const std::string closed = cube(0.5);
  write("Box.obj", closed.substr(0, closed.rfind('f')));
  const PaperFigures figures = figures_of_data(folder_);
  const auto panel = figures[0]->sheets(all_of(*figures[0]))[0].panels[1];
  EXPECT_EQ(panel.measured[0].first, "largest displacement over cage size");
  EXPECT_EQ(panel.note.find("volume"), std::string::npos) << panel.note;
}

TEST_F(FigureData, that_is_missing_or_does_not_fit_is_named) {
  fs::remove(folder_ / "Box_Cage_Deformed.obj");
  EXPECT_NE(refused().find("Box_Cage_Deformed.obj"), std::string::npos) << refused();
  write("Box_Cage_Deformed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NE(refused().find("Box_Cage_Deformed.obj: 3 vertices"), std::string::npos) << refused();
  write("Box_Cage_Deformed.obj", cube(2));
  write("Box.obj", cube(5));
  EXPECT_NE(refused().find("inside"), std::string::npos) << refused();
  fs::remove(folder_ / "Box.obj");
  EXPECT_NE(refused().find("Box.obj"), std::string::npos) << refused();
  fs::remove(folder_ / "Box_Cage.obj");
  EXPECT_NE(refused().find("no file"), std::string::npos) << refused();
  fs::remove_all(folder_);
  EXPECT_NE(refused().find(folder_.string()), std::string::npos) << refused();
}

}  // namespace
}  // namespace cageproof::validation
