// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"
#include "support.h"

#include <fmt/format.h>

#include <chrono>

namespace cageproof::mesh_obj_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::vector<std::vector<int>> kTetrahedronFaces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

std::string error_of(std::string_view text) {
  const TemporaryFolder folder;
  const auto path = folder.write("case.obj", text);
  return input_error_of([&] { read_mesh(path); });
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(obj_rejects, files_that_are_none) {
  const TemporaryFolder folder;
  expect_parts(input_error_of([&] { read_mesh(folder.path() / "missing.obj"); }), {"missing.obj: no such file"});
  std::filesystem::create_directory(folder.path() / "folder.obj");
  expect_parts(input_error_of([&] { read_mesh(folder.path() / "folder.obj"); }), {"folder.obj: is a directory"});
  expect_parts(error_of(""), {"case.obj: the file is empty"});
  expect_parts(error_of("# nothing\n"), {"case.obj: no vertices"});
  expect_parts(input_error_of([&] { read_mesh(folder.write("cage.blend", "OFF")); }),
               {"cage.blend", "\".blend\"", ".obj, .ply, .stl, .off or .vtp", ".svg, .geojson"});
}

TEST(obj_rejects, truncated_lines) {
  expect_parts(error_of("v 0 0 0\nv 1 2\n"), {"case.obj:2: ", "three coordinates", "2"});
  expect_parts(error_of("v\n"), {"case.obj:1: ", "three coordinates"});
  expect_parts(error_of(kTetrahedron + "f 1 2\n"), {"case.obj:9: ", "three corners", "2"});
  expect_parts(error_of(kTetrahedron + "f"), {"case.obj:9: ", "three corners", "0"});
}

TEST(obj_rejects, text_where_numbers_belong) {
  expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", "v 1 abc 2")), {"case.obj:2: ", "\"abc\"", "number"});
  expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", "v 1 0 0x")), {"case.obj:2: ", "\"0x\""});
  expect_parts(error_of(replaced(kTetrahedron, "f 1 2 4", "f 1 two 4")), {"case.obj:6: ", "\"two\"", "corner"});
  expect_parts(error_of(replaced(kTetrahedron, "f 1 2 4", "f 1 2.5 4")), {"case.obj:6: ", "\"2.5\""});
  expect_parts(error_of(replaced(kTetrahedron, "f 1 2 4", "f 1/a 2 4")), {"case.obj:6: ", "\"1/a\""});
  expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", "1 0 0")), {"case.obj:2: ", "\"1\"", "keyword"});
  expect_parts(error_of(std::string("v 0 0 0\nv 1 \0001 2\n", 17)), {"case.obj:2: ", "number"});
}

TEST(obj_rejects, lines_that_it_does_not_know) {
  expect_parts(error_of("# a\nmtllib a\nsolid b\nfacet c\n"), {"case.obj:3: \"solid\"", "v x y z"});
  expect_parts(error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nface 1 2 3\n"), {"case.obj:4: \"face\"", "f 1 2 3"});
  expect_parts(error_of("V 0 0 0\n"), {"case.obj:1: \"V\"", "write \"v\""});
  expect_parts(error_of(replaced(kTetrahedron, "f 1 2 4", "F 1 2 4")), {"case.obj:6: \"F\"", "write \"f\""});
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("own.obj", kTetrahedron + "word_of_its_own 1\n")).faces, kTetrahedronFaces);
  EXPECT_EQ(read_mesh(folder.write("points.obj", "g a\nv 0 0 0\np 1\n")).vertices.size(), 1U);
}

TEST(obj_rejects, weights_that_make_no_point) {
  for (const char* w : {"0", "-0", "nan", "inf"})
    expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", fmt::format("v 1 0 0 {}", w))), {"case.obj:2: "});
  expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", "v 1 0 0 0")), {"weight w is 0"});
  expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", "v 1e300 0 0 1e-300")), {"case.obj:2: ", "not finite"});
  for (const char* more : {"1 1", "1 1 1 1 1"})
    expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", fmt::format("v 1 0 0 {}", more))),
                 {"case.obj:2: ", "numbers in a vertex", "colour"});
}

TEST(obj_reads, weights_and_colours) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(
      folder.write("w.obj", "v 1 2 3 2\nv 1 2 3 -0.5\nv 1 2 3 1\nv 1 2 3 0 0.5 0.5\nv 1 2 3 0 0.5 0.5 0.25\n"));
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3<double>>{{0.5, 1, 1.5}, {-2, -4, -6}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
}

TEST(obj_reads, continued_lines_and_comments_behind_data) {
  const TemporaryFolder folder;
  std::string text =
      "# C:\\not\\continued\\\nv 0 0 0 # here\nv 1 \\\n0\\\n 0\nv 0 1 0#\nv 0 0 1\nf 1 3\\\n 2 # \\\nf 1 2 4\nf 2 3 "
      "4\nf 1 \\\n"
      "\\\n4 3\\";
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& each : {text, windows}) {
    const Mesh mesh = read_mesh(folder.write("continued.obj", each));
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3<double>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(mesh.faces, kTetrahedronFaces);
    EXPECT_EQ(mesh.face_lines, (std::vector<std::size_t>{8, 10, 11, 12}));
  }
  expect_parts(error_of("v 0 0 0\nl 1 \\\n x\n"), {"case.obj:2: ", "\"x\""});
  expect_parts(error_of("v 0 0 \\ \n0\n"), {"case.obj:1: ", "\"\\\""});
}

TEST(obj_rejects, numbers_that_are_not_finite) {
  for (const char* token : {"nan", "NaN", "-nan", "inf", "-inf", "Infinity", "1e999", "1.#IND"})
    expect_parts(error_of(replaced(kTetrahedron, "v 1 0 0", fmt::format("v 1 {} 0", token))),
                 {"case.obj:2: ", token, "not a finite number"});
}

TEST(obj_rejects, indices_out_of_range) {
  for (const char* token : {"5", "0", "-5", "1000000000000", "-1000000000000", "2147483648", "99999999999999999999999"})
    expect_parts(error_of(replaced(kTetrahedron, "f 1 2 4", fmt::format("f 1 {} 4", token))),
                 {"case.obj:6: ", "out of range"});
  expect_parts(error_of("v 0 0 0\nv 1 0 0\nf 1 0 2\nv 0 1 0\n"), {"case.obj:3: ", "index 0", "counts from 1"});
}

TEST(obj_rejects, garbage_shown_in_one_printable_line) {
  const std::string message = error_of("v 0 0 \x01\x1b[31m\xff" + std::string(500, 'z') + "\n");
  expect_parts(message, {"case.obj:1: "});
  EXPECT_LT(message.size(), 400u);
  EXPECT_TRUE(std::ranges::all_of(message, [](unsigned char c) { return c >= 0x20 && c < 0x7f; }));
}

TEST(obj_reads, numbers_correctly_rounded) {
  RandomStream random(1, "obj", 0);
  std::string text;
  std::vector<Vec3<double>> expected;
  for (int i = 0; i < 1000; ++i) {
    const Vec3<double> v(random.uniform(-2, 2), random.uniform(-1e5, 1e5), random.uniform(-1e-9, 1e-9));
    text += fmt::format("v {} {} {}\n", v[0], v[1], v[2]);
    expected.push_back(v);
  }
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("exact.obj", text)).vertices, expected);
}

TEST(obj_reads, quads_polygons_and_order_as_they_are) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.write(
      "mixed.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 3 2 1\ng a\nf 1 2 3 4\nusemtl x\nf 5 4 3 2 1\n"));
  EXPECT_EQ(mesh.faces, (std::vector<std::vector<int>>{{2, 1, 0}, {0, 1, 2, 3}, {4, 3, 2, 1, 0}}));
  EXPECT_EQ(mesh.vertices[2], Vec3<double>(2, 1, 0));
}

TEST(obj_reads, relative_indices) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(
      folder.write("relative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf 2 3 4\nf 1 4 3\n"));
  EXPECT_EQ(mesh.faces, kTetrahedronFaces);
}

TEST(obj_reads, what_modellers_write) {
  const TemporaryFolder folder;
  const std::string blender =
      "# Blender v2.77 (sub 0) OBJ File: ''\n# www.blender.org\nmtllib missing.mtl\no Cage\nv 0.000000 0.000000 "
      "0.000000\n"
      "v 1.000000 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn nan 0 1\ng all\nusemtl None\ns off\nf 1//1 3//1 2//1\nf 1/1 2/1 "
      "4/1\n"
      "f 2/1/1 3/1/1 4/1/1 \ns 1\nf\t1/1/1  4/1/1\t3/1/1\nl 1 2\n";
  const std::string meshlab =
      "####\n#\n# OBJ File Generated by Meshlab\n####\n\nv 0 0 0 0.5 0.5 0.5\nv 1 0 0 1 1 1\nv 0 1 0 1 0 0\nv 0 0 1 "
      "1\n\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n\n# End of File\n";
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : kTetrahedron) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string unended = kTetrahedron;
  unended.pop_back();
  for (const auto& [name, text] : {std::pair{"blender.obj", blender},
                                   {"meshlab.OBJ", meshlab},
                                   {"windows.obj", windows},
                                   {"unended.obj", unended}}) {
    const Mesh mesh = read_mesh(folder.write(name, text));
    EXPECT_EQ(mesh.vertices.size(), 4u) << name;
    EXPECT_EQ(mesh.faces, kTetrahedronFaces) << name;
    if (mesh.segments.empty()) {
      EXPECT_NO_THROW(read_cage(folder.path() / name)) << name;
    } else {
      expect_parts(input_error_of([&] { read_cage(folder.path() / name); }),
                   {"4 faces (the first in line 14)", "1 segments of polylines (the first in line 19)"});
    }
  }
}

TEST(obj_reads, line_numbers_for_every_line_end) {
  expect_parts(error_of("# a\r\n\r\nv 1 2\r\n"), {"case.obj:3: "});
  expect_parts(error_of("# a\r\rv 1 2\r"), {"case.obj:3: "});
}

TEST(obj_reads, big_meshes_in_about_a_second) {
  constexpr int side = 300;
  std::string text;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) text += fmt::format("v {:.6f} {:.6f} 0\n", x * 0.013, y * 0.017);
  for (int i = 0; i + side < side * side; ++i)
    for (int repeat = 0; repeat < 4; ++repeat) text += fmt::format("f {} {} {}\n", i + 1, i + 2, i + side + 1);
  const TemporaryFolder folder;
  const auto path = folder.write("big.obj", text);
  const auto start = std::chrono::steady_clock::now();
  const Mesh mesh = read_mesh(path);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(mesh.vertices.size(), side * side);
  EXPECT_EQ(mesh.faces.size(), 4 * (side * side - side));
  EXPECT_LT(spent.count(), 20) << "linear in the file's size, also under sanitizers on a busy machine";
}

TEST(read_cage, names_file_and_face_of_invalid_cages) {
  const TemporaryFolder folder;
  const auto hole = folder.write("hole.obj", replaced(kTetrahedron, "f 2 3 4\n", ""));
  expect_parts(input_error_of([&] { read_cage(hole); }), {"hole.obj: face 0", "hole"});
  const auto inward =
      folder.write("inward.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n");
  expect_parts(input_error_of([&] { read_cage(inward); }), {"inward.obj: ", "--flip-inward"});
  EXPECT_GT(testing_support::volume(read_cage(inward, {.flip_inward = true})), 0);
  const auto points = folder.write("points.obj", "v 0 0 0\n");
  expect_parts(input_error_of([&] { read_cage(points); }), {"points.obj: no faces"});
}

TEST(read_cage, names_parts_and_crossing_faces_by_their_lines) {
  const TemporaryFolder folder;
  // A tetrahedron, and another of half its size in it, or across one of its faces.
  const auto two = [&](std::string_view shift, bool inward) {
    std::string text = kTetrahedron + "# the other\n";
    for (int i = 0; i < 4; ++i)
      text += fmt::format("v {} {} {}\n", i == 1 ? 0.3 : 0.1, i == 2 ? 0.3 : 0.1,
                          (i == 3 ? 0.2 : 0) + (shift == "across" ? -0.1 : 0.1));
    for (const char* f : {"5 7 6", "5 6 8", "6 7 8", "5 8 7"}) {
      std::string face = f;
      if (inward) std::swap(face[0], face[4]);
      text += "f " + face + "\n";
    }
    return folder.write(fmt::format("two.{}.{}.obj", shift, inward), text);
  };
  expect_parts(input_error_of([&] { read_cage(two("within", false)); }),
               {"two.within.false.obj: ", "4 faces from face 4 (line 14) on", "from face 0 (line 5) on"});
  EXPECT_FALSE(crossing_warning(read_cage(two("within", true))));
  expect_parts(crossing_warning(read_cage(two("across", false))).value_or("none"),
               {"two.across.false.obj: faces 0 and 5 (lines 5 and 15)", "winds around"});
}

TEST(read_cage, gives_back_every_embedded_surface) {
  const TemporaryFolder folder;
  for (const auto name : embedded_cage_names()) {
    const Cage cage = embedded_cage(name);
    if (cage.dimension() != 3) continue;
    std::string text;
    for (const auto& v : cage.vertices()) text += fmt::format("v {} {} {}\n", v[0], v[1], v[2]);
    for (const Face& face : cage.faces()) {
      text += "f";
      for (int k = 0; k < face.size(); ++k) text += fmt::format(" {}", face.vertices[k] + 1);
      text += "\n";
    }
    const Cage again = read_cage(folder.write("cage.obj", text));
    EXPECT_EQ(again.vertices(), cage.vertices()) << name;
    ASSERT_EQ(again.faces().size(), cage.faces().size()) << name;
    for (std::size_t f = 0; f < cage.faces().size(); ++f)
      EXPECT_EQ(again.faces()[f].vertices, cage.faces()[f].vertices) << name;
  }
}

}  // namespace
}  // namespace cageproof::mesh_obj_test
