// SPDX-License-Identifier: MIT
// These tests look at figures with several panels: places of points, what hides what, and files on the disk.
#include "cageproof/reports/figure_sheet.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/mesh_thinning.h"
#include "figure_layout.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cageproof::reports::figure_sheet_test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::vector<int>> box_faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

std::vector<Vec3<double>> box(const Vec3<double>& half, const Vec3<double>& at = Vec3<double>::Zero()) {
  std::vector<Vec3<double>> found;
  found.reserve(8);
  for (int i = 0; i < 8; ++i)
    found.emplace_back(at + half.cwiseProduct(Vec3<double>((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1)));
  return found;
}

FigurePanel box_panel(const Vec3<double>& half, const std::string& file) {
  FigurePanel panel;
  panel.title = panel.file = file;
  panel.data.vertices = box(half);
  panel.data.faces = box_faces;
  panel.cage = box({1, 1, 1});
  panel.cage_faces = box_faces;
  panel.facts = {{"method", "none"}};
  panel.measured = {{"volume ratio", 0.5}};
  return panel;
}

FigureSheet boxes() {
  FigureSheet sheet{.name = "boxes",
                    .heading = "Boxes",
                    .source = "nobody",
                    .text = "Boxes.",
                    .columns = 2,
                    .view = {{0.4, -1, 0.5}, {0, 0, 1}},
                    .panels = {}};
  for (const double width : {0.5, 0.9, 1.1})
    sheet.panels.push_back(box_panel({width, 0.5, 0.5}, "w" + std::to_string(sheet.panels.size())));
  return sheet;
}

// The colour of a pixel, x to the right and y down.
class Picture {
 public:
  explicit Picture(const std::string& png) {
    const fs::path file = fs::temp_directory_path() / ("figure-" + std::to_string(::getpid()) + ".png");
    write_file(file, png);
    reader_->SetFileName(file.c_str());
    reader_->Update();
    fs::remove(file);
  }
  std::array<double, 3> at(const std::array<double, 2>& place) const {
    vtkImageData* image = reader_->GetOutput();
    std::array<double, 3> colour{};
    for (int c = 0; c < 3; ++c)
      colour[c] = image->GetScalarComponentAsDouble(static_cast<int>(place[0]),
                                                    image->GetDimensions()[1] - 1 - static_cast<int>(place[1]), 0, c);
    return colour;
  }
  int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
  int height() const { return reader_->GetOutput()->GetDimensions()[1]; }

 private:
  vtkNew<vtkPNGReader> reader_;
};

bool is_inside(const FigureFrame& frame, const std::array<double, 2>& place) {
  return place[0] >= frame.left && place[0] <= frame.left + frame.width && place[1] >= frame.top &&
         place[1] <= frame.top + frame.height;
}

void expect_inside(const FigureSheet& sheet) {
  const FigureLayout layout = layout_of(sheet);
  ASSERT_EQ(layout.frames.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const FigureFrame& frame = layout.frames[i];
    EXPECT_GE(frame.left, 0);
    EXPECT_LE(frame.left + frame.width, layout.width);
    EXPECT_LE(frame.top + frame.height, layout.height);
    for (const auto* points : {&sheet.panels[i].data.vertices, &sheet.panels[i].cage, &sheet.panels[i].marks})
      for (const Vec3<double>& point : *points) EXPECT_TRUE(is_inside(frame, frame.at(point))) << i;
  }
  // Panels do not overlap.
  EXPECT_LT(layout.frames[0].left + layout.frames[0].width, layout.frames[1].left);
  EXPECT_LT(layout.frames[0].top + layout.frames[0].height, layout.frames[2].top);
}

TEST(FigureSheet, every_point_is_inside_its_panel) {
  FigureSheet sheet = boxes();
  expect_inside(sheet);
  sheet.panels[1].data.vertices = box({9, 0.5, 3}, {4, 1, -2});  // far beyond its cage
  sheet.panels[2].marks = {{0, 0, 1.2}};
  expect_inside(sheet);
}

TEST(FigureSheet, panels_have_one_scale_unless_they_are_too_large) {
  FigureSheet sheet = boxes();
  const FigureLayout before = layout_of(sheet);
  for (const FigureFrame& frame : before.frames) {
    EXPECT_EQ(frame.share, 1);
    EXPECT_EQ(frame.scale, before.frames[0].scale);
  }
  sheet.panels[1].data.vertices = box({9, 0.5, 3});
  const FigureLayout after = layout_of(sheet);
  EXPECT_LT(after.frames[1].share, 0.5);
  EXPECT_EQ(after.frames[0].share, 1);
  EXPECT_EQ(after.frames[0].scale, after.frames[2].scale);
  // Along any axis of space a unit has the length that its view gives it, x and y alike.
  const FigureFrame& frame = before.frames[0];
  const Vec3<double> towards = sheet.view.towards.normalized();
  for (const auto& [step, axis] : {std::pair{frame.x, 0}, {frame.y, 1}, {frame.z, 2}})
    EXPECT_NEAR(std::hypot(step[0], step[1]), frame.scale * std::sqrt(1 - towards[axis] * towards[axis]), 1e-9);
  EXPECT_EQ(frame.z[0], 0) << "up is up";
  EXPECT_LT(frame.z[1], 0);
}

// A figure with one cage per panel, seen from above, as wide and as high as the box.
FigureSheet seen_from_above(const Vec3<double>& half, int columns, int panels) {
  FigureSheet sheet = boxes();
  sheet.columns = columns;
  sheet.view = {{0, 0, 1}, {0, 1, 0}};
  sheet.panels.assign(panels, box_panel(half, "box"));
  for (FigurePanel& panel : sheet.panels) panel.cage = box(half);
  return sheet;
}

TEST(FigureSheet, panels_fill_the_page) {
  double third = 0;
  for (const int columns : {3, 1, 2, 4, 5}) {
    const FigureLayout layout = layout_of(seen_from_above({2, 1, 1}, columns, 5));
    const FigureFrame &first = layout.frames[0], &last = layout.frames[columns - 1];
    if (columns == 3) third = first.width;
    EXPECT_LE(layout.width, 1360) << columns;
    if (columns >= 3) EXPECT_GT(layout.width, 1360 - columns - 1) << columns;
    else EXPECT_TRUE(first.width >= third && first.width <= 1360 / 3.0) << "few panels take a third each";
    EXPECT_EQ(last.top, first.top);
    EXPECT_EQ(first.left, layout.width - (last.left + last.width)) << "margins are alike";
    EXPECT_EQ(first.top - title_height, layout.height - (layout.frames[4].top + layout.frames[4].height));
    if (columns > 1) EXPECT_GT(layout.frames[1].left, first.left + first.width);
    if (columns < 5) EXPECT_GE(layout.frames[columns].top - title_height, first.top + first.height);
  }
  // Columns that no panel is in take no place.
  EXPECT_EQ(layout_of(seen_from_above({2, 1, 1}, 9, 2)).width, layout_of(seen_from_above({2, 1, 1}, 2, 2)).width);
}

TEST(FigureSheet, a_panel_is_as_high_as_what_it_shows_within_limits) {
  const auto shape = [](const Vec3<double>& half) {
    const FigureFrame frame = layout_of(seen_from_above(half, 3, 3)).frames[0];
    const auto low = frame.at(-half), high = frame.at(half);
    // In the middle, and as large as lines and dots at the border let it be.
    EXPECT_NEAR((low[0] + high[0]) / 2, frame.left + frame.width / 2, 1e-9);
    EXPECT_NEAR((low[1] + high[1]) / 2, frame.top + frame.height / 2, 1e-9);
    const double beside = frame.width - (high[0] - low[0]), above = frame.height - (low[1] - high[1]);
    EXPECT_NEAR(std::min(beside, above), 16, 1e-6);
    return frame.height / frame.width;
  };
  EXPECT_NEAR(shape({2, 1, 1}), 0.5, 1 / 400.0);
  EXPECT_NEAR(shape({1, 0.8, 1}), 0.8, 1 / 400.0);
  EXPECT_EQ(shape({1, 0, 1}), shape({1, 0.1, 1})) << "the least height";
  EXPECT_EQ(shape({0, 1, 1}), shape({1, 5, 1})) << "the most";
  // Figures have no unit of length.
  for (const double unit : {1e-100, 1e100}) EXPECT_EQ(shape(unit * Vec3<double>(2, 1, 1)), shape({2, 1, 1}));
}

TEST(FigureSheet, images_beyond_their_cage_shrink_all_panels_a_little_and_themselves_if_they_must) {
  const auto layout_with = [](double width) {
    FigureSheet sheet = seen_from_above({1, 0.5, 1}, 3, 3);
    sheet.panels[2].data.vertices = box({width, 0.5, 1});
    return layout_of(sheet);
  };
  const double alone = layout_with(1).frames[0].scale;
  const FigureLayout near = layout_with(1.2), far = layout_with(4);
  EXPECT_LT(near.frames[0].scale, alone);
  EXPECT_EQ(near.frames[2].share, 1);
  EXPECT_LT(far.frames[2].share, 1);
  EXPECT_EQ(far.frames[0].share, 1);
  EXPECT_EQ(far.frames[0].scale, layout_with(9).frames[0].scale) << "no image shrinks the others more";
  EXPECT_GT(far.frames[0].scale, alone / 1.5);
}

TEST(FigureSheet, a_point_is_in_the_middle_of_its_panel) {
  FigureSheet sheet = seen_from_above({0, 0, 0}, 1, 1);
  const Vec3<double> point(0.3, -0.7, 0.1);
  sheet.panels[0].cage = sheet.panels[0].data.vertices = {point};
  const FigureFrame frame = layout_of(sheet).frames[0];
  EXPECT_NEAR(frame.at(point)[0], frame.left + frame.width / 2, 1e-9);
  EXPECT_NEAR(frame.at(point)[1], frame.top + frame.height / 2, 1e-9);
}

TEST(FigureSheet, near_faces_hide_far_ones_in_whatever_order_they_come) {
  for (const bool near_first : {false, true}) {
    FigureSheet sheet{.name = "two", .heading = {}, .source = {}, .text = {}, .columns = 1, .view = {}, .panels = {}};
    FigurePanel panel;
    panel.file = "two";
    // Two squares that overlap around the origin; both face the viewer, on the axis z.
    panel.data.vertices = {{-1, -1, 0},     {0.5, -1, 0}, {0.5, 0.5, 0}, {-1, 0.5, 0},
                           {-0.5, -0.5, 1}, {1, -0.5, 1}, {1, 1, 1},     {-0.5, 1, 1}};
    panel.data.faces = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    panel.tones = {0, 1};
    if (near_first) {
      std::ranges::reverse(panel.data.faces);
      std::ranges::reverse(panel.tones);
    }
    sheet.panels.push_back(panel);
    const FigureFrame frame = layout_of(sheet).frames[0];
    const Picture picture(figure_png(sheet));
    const auto both = picture.at(frame.at({0, 0, 1})), near = picture.at(frame.at({0.8, 0.8, 1})),
               far = picture.at(frame.at({-0.8, -0.8, 0}));
    EXPECT_EQ(both, near) << near_first;
    EXPECT_NE(both, far);
    EXPECT_EQ(picture.at(frame.at({0.9, -0.9, 0})), (std::array<double, 3>{255, 255, 255})) << "nothing is there";
  }
}

TEST(FigureSheet, a_long_face_hides_what_is_behind_it_and_nothing_else) {
  FigureSheet sheet{
      .name = "long", .heading = {}, .source = {}, .text = {}, .columns = 1, .view = {}, .panels = {FigurePanel()}};
  FigurePanel& panel = sheet.panels[0];
  panel.file = "long";
  // A face that comes nearer to the right, and small squares along it, in front of it and behind in turn.
  panel.data.vertices = {{-10, -2, -10}, {10, -2, 10}, {10, 2, 10}, {-10, 2, -10}};
  panel.data.faces = {{0, 1, 2, 3}};
  panel.tones = {0};
  for (int k = 0; k < 6; ++k) {
    const double x = 3 * k - 7.5, z = x + (k % 2 == 0 ? 2 : -2);
    const int first = static_cast<int>(panel.data.vertices.size());
    for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      panel.data.vertices.emplace_back(x + 0.5 * dx, 0.5 * dy, z);
    panel.data.faces.push_back({first, first + 1, first + 2, first + 3});
    panel.tones.push_back(1);
  }
  const FigureFrame frame = layout_of(sheet).frames[0];
  const Picture picture(figure_png(sheet));
  const auto alone = picture.at(frame.at({-9.5, 1.5, 0}));
  for (int k = 0; k < 6; ++k) {
    const auto seen = picture.at(frame.at({3 * k - 7.5, 0, 0}));
    if (k % 2 == 0) EXPECT_NE(seen, alone) << k;
    else EXPECT_EQ(seen, alone) << k;
  }
}

TEST(FigureSheet, inner_sides_have_a_hue_of_their_own) {
  FigureSheet sheet{.name = "one", .heading = {}, .source = {}, .text = {}, .columns = 1, .view = {}, .panels = {}};
  FigurePanel panel;
  panel.file = "one";
  panel.data.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  panel.data.faces = {{3, 2, 1, 0}};
  sheet.panels.push_back(panel);
  const auto inner = Picture(figure_png(sheet)).at(layout_of(sheet).frames[0].at({0, 0, 0}));
  sheet.panels[0].data.faces = {{0, 1, 2, 3}};
  const auto outer = Picture(figure_png(sheet)).at(layout_of(sheet).frames[0].at({0, 0, 0}));
  EXPECT_GT(inner[0], 1.8 * inner[1]);
  EXPECT_LT(outer[0], 1.5 * outer[1]);
}

TEST(FigureSheet, a_cage_is_drawn_over_its_mesh_where_it_is_nearer) {
  FigureSheet sheet = boxes();
  sheet.panels.resize(1);
  sheet.panels[0].data.vertices = box({0.99, 0.99, 0.99});
  const FigureFrame frame = layout_of(sheet).frames[0];
  const Picture picture(figure_png(sheet));
  const auto near = picture.at(frame.at({1, -1, 0.3})), far = picture.at(frame.at({-1, 1, 0.3}));
  EXPECT_GT(near[2], near[0]) << "blue, of the edge";
  EXPECT_GT(far[0], far[2]) << "the mesh, which hides the edge";
}

TEST(FigureSheet, nothing_to_draw_is_refused) {
  FigureSheet sheet = boxes();
  sheet.panels[1].cage.clear();
  sheet.panels[1].data = {};
  EXPECT_THROW(layout_of(sheet), std::invalid_argument);
  sheet.panels.clear();
  EXPECT_THROW(figure_png(sheet), std::invalid_argument);
}

class FigureFolder : public testing::Test {
 protected:
  FigureFolder() : root_(fs::temp_directory_path() / ("figures-" + std::to_string(::getpid()))) {
    fs::create_directory(root_);
  }
  ~FigureFolder() override { fs::remove_all(root_); }
  fs::path root_;
};

TEST_F(FigureFolder, has_pictures_data_and_captions) {
  write_figures(root_ / "out", {boxes()});
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root_ / "out/figures")) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  EXPECT_EQ(names,
            (std::vector<std::string>{"boxes.png", "boxes.w0.vtp", "boxes.w1.vtp", "boxes.w2.vtp", "figures.json"}));
  const Mesh read = read_mesh(root_ / "out/figures/boxes.w1.vtp");
  EXPECT_EQ(read.vertices, boxes().panels[1].data.vertices);
  EXPECT_EQ(read.faces, box_faces);
  const auto json = nlohmann::json::parse(read_file(root_ / "out/figures/figures.json"));
  EXPECT_EQ(json["schema"], "cageproof-figures");
  EXPECT_EQ(json["figures"][0]["picture"], "figures/boxes.png");
  EXPECT_EQ(json["figures"][0]["panels"][1]["data"], "figures/boxes.w1.vtp");
  EXPECT_EQ(json["figures"][0]["panels"][1]["volume ratio"], 0.5);
  const Picture picture(read_file(root_ / "out/figures/boxes.png"));
  EXPECT_EQ(picture.width(), layout_of(boxes()).width);
  EXPECT_EQ(picture.height(), layout_of(boxes()).height);
  // It replaces figures, with the same bytes, and nothing else.
  const std::string before = read_file(root_ / "out/figures/boxes.png");
  write_figures(root_ / "out", {boxes()});
  EXPECT_EQ(read_file(root_ / "out/figures/boxes.png"), before);
}

TEST_F(FigureFolder, of_something_else_is_left_alone) {
  fs::create_directory(root_ / "mine");
  write_file(root_ / "mine/letter.txt", "dear");
  EXPECT_THROW(write_figures(root_ / "mine", {boxes()}), InputError);
  EXPECT_THROW(require_figure_folder(root_ / "mine"), InputError);
  EXPECT_THROW(require_figure_folder(root_ / "missing/out"), InputError);
  // A figure that cannot be drawn leaves no half folder.
  FigureSheet empty = boxes();
  empty.panels.clear();
  EXPECT_THROW(write_figures(root_ / "out", {boxes(), empty}), std::invalid_argument);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root_)) names.push_back(entry.path().filename());
  EXPECT_EQ(names, std::vector<std::string>{"mine"});
  EXPECT_EQ(read_file(root_ / "mine/letter.txt"), "dear");
}

TEST(Thinned, keeps_the_shape_with_fewer_vertices) {
  Mesh sphere;
  constexpr int around = 60, up = 40;
  for (int i = 0; i <= up; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = std::numbers::pi * (i + 0.5) / (up + 1), b = 2 * std::numbers::pi * j / around;
      sphere.vertices.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  for (int i = 0; i < up; ++i)
    for (int j = 0; j < around; ++j) {
      const int k = (j + 1) % around;
      sphere.faces.push_back({i * around + j, (i + 1) * around + j, (i + 1) * around + k, i * around + k});
    }
  const Mesh thin = thinned(sphere, 800);
  EXPECT_LT(thin.vertices.size(), 900u);
  EXPECT_GT(thin.vertices.size(), 600u);
  for (const Vec3<double>& v : thin.vertices) EXPECT_NEAR(v.norm(), 1, 0.02);
  for (const auto& face : thin.faces) {
    const Vec3<double> a = thin.vertices[face[0]], b = thin.vertices[face[1]], c = thin.vertices[face[2]];
    EXPECT_GT((b - a).cross(c - a).dot(a + b + c), 0) << "still outward";
  }
  EXPECT_EQ(thinned(sphere, 100000).faces, sphere.faces);
}

}  // namespace
}  // namespace cageproof::reports::figure_sheet_test
