// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/mesh_io.h"

#include "support.h"

#include <fmt/format.h>

#include <chrono>

namespace cageproof::mesh_svg_test {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;
using testing_support::TemporaryFolder;

using Vertices = std::vector<Vec3<double>>;
using Segments = std::vector<std::array<int, 2>>;

const Segments kTriangle{{0, 1}, {1, 2}, {2, 0}};

Mesh mesh_of(std::string_view text) {
  const TemporaryFolder folder;
  return read_mesh(folder.write("case.svg", text));
}

std::string svg(std::string_view body) {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{}\n</svg>\n", body);
}

Mesh path_of(std::string_view data, std::string_view transform = "") {
  return mesh_of(svg(fmt::format("<path transform=\"{}\" d=\"{}\"/>", transform, data)));
}

std::string error_of(std::string_view text) {
  return input_error_of([&] { mesh_of(text); });
}

std::string path_error(std::string_view data, std::string_view transform = "") {
  return error_of(svg(fmt::format("<path id=\"leaf\" d=\"{}\" transform=\"{}\"/>", data, transform)));
}

TEST(svg_reads, paths_with_y_turned_up) {
  for (const char* data : {"M 1 2 L 4 2 L 4 6 Z", "M1,2 4,2 4,6z", "M1 2H4V6Z", "m1 2 3 0 0 4z", "m1 2h3v4z",
                           "m1,2l3,0 0,4z", "M1 2h3v4L1 2Z", "M1 2h3v4L1 2", "M1e0 2.0H.4e+1V60e-1Z",
                           "\n\tM\r1 \t2 L +4 2 , 4 6\nZ \n", "M9 9M1 2H4V6ZM7 7"}) {
    const Mesh mesh = path_of(data);
    EXPECT_EQ(mesh.vertices, (Vertices{{1, -2, 0}, {4, -2, 0}, {4, -6, 0}})) << data;
    EXPECT_EQ(mesh.segments, kTriangle) << data;
    // An element's line is that of the end of its tag.
    if (data[0] != '\n') {
      EXPECT_EQ(mesh.segment_lines, (std::vector<std::size_t>{2, 2, 2})) << data;
    }
  }
}

TEST(svg_reads, commands_with_several_arguments) {
  const Vertices expected{{1, -2, 0}, {2, -2, 0}, {4, -2, 0}, {4, -3, 0}, {4, -6, 0}};
  for (const char* data : {"M1 2H2 4V3 6z", "m1 2h1,2v1 3z", "M1 2 2 2 4 2L4 3 4 6z", "m1 2 1 0 2 0l0 1 0 3z"})
    EXPECT_EQ(path_of(data).vertices, expected) << data;
}

TEST(svg_reads, numbers_without_blanks) {
  EXPECT_EQ(path_of("M1e-3.5-2-.25L.5.5-.5.5z").vertices,
            (Vertices{{1e-3, -0.5, 0}, {-2, 0.25, 0}, {0.5, -0.5, 0}, {-0.5, -0.5, 0}}));
  EXPECT_EQ(path_of("M0-1L+2+3-4-5z").vertices, (Vertices{{0, 1, 0}, {2, -3, 0}, {-4, 5, 0}}));
  EXPECT_EQ(path_of("M0 0L010 08 1. 09z").vertices, (Vertices{{0, 0, 0}, {10, -8, 0}, {1, -9, 0}}));
  EXPECT_EQ(path_of("M0 0L5e-324 1e-400 1e308 1.7976931348623157e308z").vertices,
            (Vertices{{0, 0, 0}, {5e-324, 0, 0}, {1e308, -1.7976931348623157e308, 0}}));
  EXPECT_EQ(path_of("M0 0L1e-999999999999 1 0e99999999999 2z").vertices, (Vertices{{0, 0, 0}, {0, -1, 0}, {0, -2, 0}}));
  EXPECT_FALSE(std::signbit(path_of("M0 0L1 0 0 1z").vertices[0][1]));
}

TEST(svg_reads, several_subpaths) {
  // After Z without a moveto, the next one begins where the last one began.
  const Mesh mesh = path_of("M0 0H4V4H0Zm1 1h1v1zL-2 -1 -1 -2z");
  ASSERT_EQ(mesh.vertices.size(), 10u);
  EXPECT_EQ(mesh.vertices[4], Vec3<double>(1, -1, 0));
  EXPECT_EQ(mesh.vertices[7], Vec3<double>(1, -1, 0));
  EXPECT_EQ(mesh.vertices[8], Vec3<double>(-2, 1, 0));
  EXPECT_EQ(mesh.segments[6], (std::array{6, 4}));
  EXPECT_EQ(mesh.segments[9], (std::array{9, 7}));
}

// In doubles 0.2 + 0.3 - 0.3 + ... is some ulps off, and the path would end beside its beginning.
TEST(svg_reads, relative_paths_that_close_exactly) {
  const Mesh mesh = path_of("m0.1 0.2l0.3 0 0 0.3 -0.3 0 0 -0.3z");
  EXPECT_EQ(mesh.vertices, (Vertices{{0.1, -0.2, 0}, {0.4, -0.2, 0}, {0.4, -0.5, 0}, {0.1, -0.5, 0}}));
  std::string steps = "m.7 .1";
  for (int k = 0; k < 30; ++k) steps += "h.1";
  EXPECT_EQ(path_of(steps + "v1z").vertices[30], Vec3<double>(3.7, -0.1, 0));
}

TEST(svg_reads, polygons_polylines_and_rectangles) {
  const Vertices expected{{0, 0, 0}, {2, 0, 0}, {2, -2, 0}};
  EXPECT_EQ(mesh_of(svg("<polygon points=\"0,0 2,0 2,2\"/>")).vertices, expected);
  EXPECT_EQ(mesh_of(svg("<polygon points='0 0 2 0 2 2 0 0'/>")).segments, kTriangle);
  EXPECT_EQ(mesh_of(svg("<polyline points='0-0,2,0,2,2,0,0'/>")).segments, kTriangle);
  EXPECT_EQ(mesh_of(svg("<polyline points='0 0 2 0 2 2'/>")).segments, (Segments{{0, 1}, {1, 2}}));
  // Counter-clockwise, as cages run.
  EXPECT_EQ(mesh_of(svg("<rect x='1' y='2' width='3' height='4' rx='0'/>")).vertices,
            (Vertices{{1, -2, 0}, {1, -6, 0}, {4, -6, 0}, {4, -2, 0}}));
}

TEST(svg_reads, transforms_exactly) {
  const auto first = [](std::string_view transform) { return path_of("M1 2H4V6Z", transform).vertices[0]; };
  EXPECT_EQ(first("translate(10)"), Vec3<double>(11, -2, 0));
  EXPECT_EQ(first("translate(10,-2)"), Vec3<double>(11, 0, 0));
  EXPECT_EQ(first(" scale( 2 ) "), Vec3<double>(2, -4, 0));
  EXPECT_EQ(first("scale(1 -1)"), Vec3<double>(1, 2, 0));
  EXPECT_EQ(first("rotate(90)"), Vec3<double>(-2, -1, 0));
  EXPECT_EQ(first("rotate(-90 2 1)"), Vec3<double>(3, -2, 0));
  EXPECT_EQ(first("rotate(30)")[0], -0.13397459621556135) << "sqrt(3/4) - 1, rounded once";
  EXPECT_EQ(first("skewX(45)"), Vec3<double>(3, -2, 0));
  EXPECT_EQ(first("skewY(-45)"), Vec3<double>(1, -1, 0));
  EXPECT_EQ(first("matrix(1 2 3 4 5 6)"), Vec3<double>(12, -16, 0));
  // The last one is the innermost; decimals are those that are written.
  EXPECT_EQ(first("translate(10 0),scale(2)translate(1)"), Vec3<double>(14, -4, 0));
  EXPECT_EQ(first("translate(.1)translate(.2)scale(.1)"), Vec3<double>(0.4, -0.2, 0));
  EXPECT_EQ(mesh_of("<svg transform='scale(10)' viewBox='0 0 5 5' width='3cm'><g transform='translate(1 1)'><a><g "
                    "transform='scale(2)'><path d='M1 2H4V6Z'/></g></a></g><path d='M1 2H4V6Z'/></svg>")
                .vertices,
            (Vertices{{30, -50, 0}, {90, -50, 0}, {90, -130, 0}, {10, -20, 0}, {40, -20, 0}, {40, -60, 0}}));
}

TEST(svg_reads, what_programs_write) {
  const std::string inkscape =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n<!-- Created with Inkscape -->\n"
      "<svg width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\" version=\"1.1\" id=\"svg5\"\n"
      "   xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
      "   xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" xmlns=\"http://www.w3.org/2000/svg\">\n"
      "  <sodipodi:namedview id=\"namedview7\" transform=\"no\"><inkscape:page x=\"0\"/></sodipodi:namedview>\n"
      "  <defs id=\"defs2\"><path d=\"M0 0A1 1 0 0 0 1 1\"/></defs>\n"
      "  <g inkscape:label=\"Layer 1\" id=\"layer1\" transform=\"translate(-1,-2)\">\n"
      "    <path\n       style=\"fill:none;stroke-width:0.26\"\n       d=\"m 1,2 h 3 v 4 z\"\n"
      "       id=\"path111\" sodipodi:nodetypes=\"cccc\" />\n  </g>\n</svg>\n";
  const std::string illustrator =
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\" [\n"
      "<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n]>\n"
      "<svg version='1.1' xmlns='&ns_svg;'><style type='text/css'>.st0{fill:#FF0000;}</style>"
      "<path class='st0' d='M0,0h3v4L0,0z'/></svg>";
  const std::string prefixed =
      "<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:title>x</s:title><s:path d='M0 0H3V4Z'/></s:svg>";
  std::string windows = "\xEF\xBB\xBF", wide = "\xFF\xFE";
  for (const char c : prefixed) wide += {c, '\0'};
  for (const char c : inkscape) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& text : {inkscape, illustrator, prefixed, windows, wide}) {
    const Mesh mesh = mesh_of(text);
    EXPECT_EQ(mesh.vertices, (Vertices{{0, 0, 0}, {3, 0, 0}, {3, -4, 0}}));
    EXPECT_EQ(mesh.segments, kTriangle);
  }
}

const std::string kShown = "<path d='M1 2H4V6Z'/>", kHidden = "<path d='M9 9H8V7Z'/>";

void expect_shown_alone(const std::string& body) {
  const Mesh mesh = mesh_of(svg(body));
  EXPECT_EQ(mesh.vertices, (Vertices{{1, -2, 0}, {4, -2, 0}, {4, -6, 0}})) << body;
}

TEST(svg_leaves_out, what_is_not_displayed) {
  for (const char* hides :
       {"display='none'", "style='display:none'", "style='fill:red; DISPLAY : None !important'", "visibility='hidden'",
        "visibility='collapse'", "style='visibility:hidden'", "display='inline' style='display:none'"}) {
    expect_shown_alone(fmt::format("<g {}>{}</g>{}", hides, kHidden, kShown));
    expect_shown_alone(fmt::format("<path {} d='M9 9C1 1 2 2 3 3'/><circle {} r='1'/>{}", hides, hides, kShown));
  }
  // An element that is not displayed may be anything, and its children stay away; a child of a hidden one may be shown.
  expect_shown_alone(kShown + "<g display='none' transform='none'><use/><g display='inline'>" + kHidden + "</g></g>");
  expect_shown_alone(
      "<g visibility='hidden' transform='scale(2)'><path visibility='visible' transform='scale(.5)' "
      "d='M1 2H4V6Z'/>" +
      kHidden + "</g>");
  expect_shown_alone("<g display='none' style='display:inline'>" + kShown + "</g>");
  for (const char* element : {"defs", "symbol", "clipPath", "mask", "marker", "pattern"})
    expect_shown_alone(fmt::format("<{}>{}</{}>{}", element, kHidden, element, kShown));
}

TEST(svg_leaves_out, what_style_sheets_hide) {
  const auto hidden_by = [&](const std::string& sheet) {
    expect_shown_alone("<defs><style>" + sheet + "</style></defs><g id='i' class='a b'>" + kHidden + "</g>" +
                       "<a><path d='M1 2H4V6Z' id='shown'/></a>");
  };
  for (const char* sheet :
       {"g{display:none}", ".b{display:none}", "#i { visibility : hidden; }", "rect, g.a.b{display:none}",
        "/* g{} */ @charset 'x'; #i{fill:url(a;b)}\n*#i{display:none}", "<![CDATA[g{display:none}]]>",
        "g{display:inline}.a{display:none}g{display:inline}", "#i{display:none}.a{display:inline}",
        "g{display:none!important}#i{display:inline}", "@font-face{font-display:swap}.a{display:none}"})
    hidden_by(sheet);
  expect_parts(error_of(svg("\n<style>g > path{display:none}</style>" + kShown)),
               {":3: <style>", "display", "\"g > path\""});
  expect_parts(error_of(svg("<style>@media print{path{display:none}}</style>" + kShown)), {"display", "@media print"});
  EXPECT_NO_THROW(mesh_of(svg("<style>a:hover{fill:red} g > path{stroke:red}</style>" + kShown)));
}

TEST(svg_leaves_out, and_says_how_much) {
  EXPECT_TRUE(mesh_of(svg("<defs>" + kHidden + "</defs>" + kShown)).warnings.empty());
  const Mesh mesh = mesh_of(svg(kShown + "\n<g id='layer' display='none'>" + kHidden + kHidden + "</g>"));
  ASSERT_EQ(mesh.warnings.size(), 1u);
  expect_parts(mesh.warnings[0], {"case.svg: left out 2 shapes", "<g id=\"layer\"> in line 3"});
  expect_parts(
      error_of(svg("<defs>" + kHidden + "</defs><g display='none'>" + kHidden + "<circle/></g>")),
      {"case.svg: no path, polygon, polyline or rect in it that is drawn", "2 shapes", "<g> in line 2", "1 in"});
}

TEST(svg_reads, lengths_with_units) {
  const auto width = [](const std::string& text, const std::string& drawing = "") {
    return mesh_of(fmt::format("<svg {}><rect width='{}' height='1'/></svg>", drawing, text)).vertices[2][0];
  };
  EXPECT_EQ(width("8px"), 8);
  EXPECT_EQ(width("1in"), 96);
  EXPECT_EQ(width("2.54 cm"), 96);
  EXPECT_EQ(width("25.4mm"), 96);
  EXPECT_EQ(width("101.6Q"), 96);
  EXPECT_EQ(width("72pt"), 96);
  EXPECT_EQ(width("6PC"), 96);
  EXPECT_EQ(width("1e1px"), 10);
  EXPECT_EQ(width("50%", "viewBox='0 0 30,40' width='7'"), 15);
  EXPECT_EQ(width("50%", "width='7px'"), 3.5);
  for (const char* text : {"1em", "2ex", "1rem", "1px px", "1 2"})
    expect_parts(error_of(svg(fmt::format("<rect width='{}' height='1'/>", text))), {"attribute width", "user units"});
  expect_parts(error_of(svg("<rect width='50%' height='1'/>")), {"attribute width", "percentage", "viewBox"});
}

TEST(svg_rejects, curves_by_name) {
  for (const auto& [data, name] : {std::pair{"M0 0C1 1 2 2 3 3", "a cubic Bezier curve (command C)"},
                                   {"M0 0L1 1c1 1 2 2 3 3", "a cubic Bezier curve (command c)"},
                                   {"M0 0S1 1 2 2", "a smooth cubic Bezier curve (command S)"},
                                   {"M0 0q1 1 2 2", "a quadratic Bezier curve (command q)"},
                                   {"M0 0T2 2", "a smooth quadratic Bezier curve (command T)"},
                                   {"M0 0a1 1 0 00 1 1", "an elliptical arc (command a)"}})
    expect_parts(path_error(data), {"case.svg:2: <path id=\"leaf\">: attribute d: ", name, "straight"});
  expect_parts(error_of(svg("<rect width='2' height='1' rx='.1'/>")), {"<rect>", "round (rx)"});
}

TEST(svg_rejects, elements_that_it_does_not_read_by_name) {
  for (const char* name :
       {"circle", "ellipse", "line", "text", "use", "image", "foreignObject", "switch", "svg", "zzz"})
    expect_parts(error_of(svg(fmt::format("<path d='M0 0H1V1Z'/>\n<g><{}/></g>", name))),
                 {fmt::format("case.svg:3: <{}>: is not read", name), "path, polygon"});
}

TEST(svg_rejects, transforms_that_it_does_not_read) {
  for (const char* transform : {"rotate3d(1)", "rotate(45deg)", "translate", "translate()", "scale(1 2 3)",
                                "matrix(1 2 3)", "translate(1", "1 2", "skewX(90)", "translate(1e999)"})
    expect_parts(path_error("M0 0H1V1Z", transform), {"case.svg:2: ", "attribute transform: "});
  expect_parts(error_of(svg("<g style='fill:red;transform:scale(2)'/>")),
               {":2: <g>", "a style with transform", "attribute"});
  expect_parts(error_of(svg("<defs/><style>path { transform: scale(2) }</style>")), {"<style>", "transform"});
  expect_parts(error_of(svg("<path style='fill:none; d : path(none)'/>")), {"<path>", "a style with d is not read"});
  expect_parts(error_of(svg("<rect width='1' height='1' style='width:2px'/>")), {"<rect>", "a style with width"});
  EXPECT_NO_THROW(
      mesh_of(svg("<style>.d:hover{fill:url(#rotate);text-transform:none}</style>"
                  "<path style='width:3px;text-transform:none' d='M0 0H1V1Z'/>")));
  expect_parts(error_of(svg("<path d='M0 0H1V1Z'><title>x</title>\n<animateTransform/></path>")),
               {":3: <animateTransform>: is not read in a path"});
  expect_parts(error_of(svg("<g transform-origin='1 1'/>")), {"<g>", "transform-origin"});
}

TEST(svg_rejects, path_data_that_is_none) {
  for (const auto& [data, reason] : {std::pair{"L1 1", "begins with L"},
                                     {"1 1", "\"1 1\" is not a path command"},
                                     {"M1", "a number is missing at the end"},
                                     {"M1 2 3", "a number is missing at the end"},
                                     {"M1 2 L", "a number is missing at the end"},
                                     {"M1 2 L x", "a number is missing at \"x\""},
                                     {"M1 2 L 3,,4", "a number is missing at \",4\""},
                                     {"M1 2 L 3 4,Z", "a number is missing at \"Z\""},
                                     {"M1 2 3 4 Z 5 6", "\"5 6\" is not a path command"},
                                     {"M1 2 L nan 3", "a number is missing at \"nan 3\""},
                                     {"M1 2 L inf 3", "a number is missing"},
                                     {"M1 2 L 1e999 3", "\"1e999\" is beyond the range"},
                                     {"M1 2 L . 3", "a number is missing"},
                                     {"M1 2 L - 3", "a number is missing"},
                                     {"M1 2 L 0x10 3", "\"x10 3\""},
                                     {"M1 2 L 3px 4", "\"px 4\""},
                                     {"M1 2 @", "\"@\" is not a path command"},
                                     {"none L", "not a path command"}})
    expect_parts(path_error(data), {"case.svg:2: <path id=\"leaf\">: attribute d: ", reason});
  expect_parts(error_of(svg("<polygon points='1 2 3'/>")), {"attribute points", "missing"});
  expect_parts(path_error("M0 0H9e307V1Z", "scale(9)"), {"beyond the range of double"});
}

TEST(svg_rejects, files_that_are_none) {
  expect_parts(error_of(""), {"case.svg: the file is empty"});
  expect_parts(error_of("nonsense"), {"case.svg:1: libxml2 cannot read it: "});
  expect_parts(error_of("<svg>\n<path d='M0 0'"), {"case.svg:2: ", "libxml2"});
  expect_parts(error_of("<svg>\n<g>\n</svg>"), {"case.svg:3: ", "libxml2"});
  expect_parts(error_of("<html/>"), {"case.svg:1: <html>: the outermost element is not <svg>"});
  expect_parts(error_of("<svg xmlns='http://www.w3.org/1999/xhtml'/>"), {"not <svg>"});
  for (const char* body : {"", "<path/>", "<path d=''/>", "<path d='none'/>", "<path d='M1 1'/>", "<g/>", "text"})
    expect_parts(error_of(svg(body)), {"case.svg: no path, polygon, polyline or rect in it"});
  expect_parts(error_of("<!DOCTYPE svg [<!ENTITY e '<path d=\"M0 0H1V1Z\"/>'>]>\n<svg>&e;</svg>"), {"entity"});
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 'M0 0'>";
  for (int k = 1; k < 30; ++k) bomb += fmt::format("<!ENTITY a{} '&a{};&a{};'>", k, k - 1, k - 1);
  EXPECT_THROW(mesh_of(bomb + "]><svg><path d='&a29;'/></svg>"), InputError);
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<g>";
  EXPECT_THROW(mesh_of("<svg>" + deep), InputError);
}

TEST(svg_reads, big_paths_in_about_a_second) {
  constexpr int count = 100000;
  std::string data = "m0 0";
  for (int k = 1; k < count; ++k) data += fmt::format("l0.{:03} {}", k % 1000, k % 2 == 0 ? "-.1" : ".1");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(path_of(data + "v9z").vertices.size(), count + 1u);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 20) << "linear in the file's size, also under sanitizers on a busy machine";
}

}  // namespace
}  // namespace cageproof::mesh_svg_test
