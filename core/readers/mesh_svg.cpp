// SPDX-License-Identifier: MIT
// Polygons of SVG files, through libxml2. Shapes are read as they are drawn, whatever their style: paths of straight
// edges, polygons, polylines and rectangles, moved by the transforms of all elements that they stand in, with y turned
// up. Coordinates are user units of the outermost element, whose viewBox changes none. Every other element that draws
// something, or may, is refused by name.
#include "cage/mesh_files.h"
#include "outline.h"
#include "svg_text.h"

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace cageproof::mesh_files {
namespace {

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";
constexpr std::array<std::string_view, 2> kContainers{"g", "a"};
// These draw nothing where they stand.
constexpr std::array<std::string_view, 15> kSilent{"defs",   "title",          "desc",           "metadata", "style",
                                                   "script", "symbol",         "clipPath",       "mask",     "marker",
                                                   "filter", "linearGradient", "radialGradient", "view",     "pattern"};

// Properties of styles that would change what is read.
constexpr std::array<std::string_view, 7> kMoving{"transform", "-webkit-transform", "translate", "rotate",
                                                  "scale",     "offset-path",       "d"};
constexpr std::array<std::string_view, 6> kSides{"x", "y", "width", "height", "rx", "ry"};

// The property whose name ends there, but for blanks; empty for other words, as selectors have.
std::string property_before(const std::string& text, std::size_t end) {
  const auto is_part = [](char c) { return c == '-' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  while (end > 0 && !is_part(text[end - 1]) && text[end - 1] <= ' ') --end;
  std::size_t begin = end;
  while (begin > 0 && is_part(text[begin - 1])) --begin;
  const bool property =
      begin == 0 || text[begin - 1] <= ' ' || std::string_view(";{/").find(text[begin - 1]) != std::string_view::npos;
  return property ? text.substr(begin, end - begin) : "";
}

std::string_view text_of(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

bool is_svg(const xmlNode& node) {
  if (!node.ns) return true;
  std::string_view name = text_of(node.ns->href);
  // libxml2 leaves entities as they are written here; Illustrator writes one.
  if (name.starts_with('&') && name.ends_with(';')) {
    const std::string entity(name.substr(1, name.size() - 2));
    const xmlEntity* found = xmlGetDocEntity(node.doc, reinterpret_cast<const xmlChar*>(entity.c_str()));
    name = found ? text_of(found->content) : "";
  }
  return name == kSvgNamespace;
}

std::optional<std::string> attribute(xmlNode& node, const char* name) {
  const std::unique_ptr<xmlChar, void (*)(void*)> value(xmlGetNoNsProp(&node, reinterpret_cast<const xmlChar*>(name)),
                                                        xmlFree);
  if (!value) return std::nullopt;
  return std::string(text_of(value.get()));
}

class SvgReader {
 public:
  SvgReader(const std::filesystem::path& path, Mesh& mesh) : path_(path), mesh_(mesh) {}

  void read(xmlNode& root) {
    if (!is_svg(root) || text_of(root.name) != "svg") fail(root, "the outermost element is not <svg>");
    read_children(root, transform_of(root, {}));
  }

 private:
  // An attribute's value, as `parse` reads it.
  template <class Parse>
  auto parsed(xmlNode& node, const char* name, const char* preset, Parse parse) {
    try {
      return parse(attribute(node, name).value_or(preset));
    } catch (const svg::Fault& fault) {
      fail(node, fmt::format("attribute {}: {}", name, fault.reason));
    }
  }

  void read_children(xmlNode& parent, const svg::Transform& outer) {
    for (xmlNode* node = parent.children; node; node = node->next) {
      if (node->type == XML_ENTITY_REF_NODE) fail(*node, "an entity in place of elements is not read");
      if (node->type == XML_ELEMENT_NODE && is_svg(*node)) read_element(*node, outer);
    }
  }

  void read_element(xmlNode& node, const svg::Transform& outer) {
    const std::string_view name = text_of(node.name);
    if (std::ranges::find(kSilent, name) != kSilent.end()) return check_style(node);
    const bool container = std::ranges::find(kContainers, name) != kContainers.end();
    const auto read_shape = shape_named(name);
    if (!container && !read_shape)
      fail(node, "is not read; polygons are path, polygon, polyline and rect, in svg, g and a");
    const svg::Transform transform = transform_of(node, outer);
    if (container) return read_children(node, transform);
    check_children(node);
    (this->*read_shape)(node, transform);
  }
  // Descriptions, but no animations.
  void check_children(xmlNode& shape) {
    for (xmlNode* node = shape.children; node; node = node->next)
      if (node->type == XML_ELEMENT_NODE && is_svg(*node) &&
          std::ranges::find(kSilent, text_of(node->name)) == kSilent.end())
        fail(*node, fmt::format("is not read in a {}", text_of(shape.name)));
  }

  using Shape = void (SvgReader::*)(xmlNode&, const svg::Transform&);
  static Shape shape_named(std::string_view name) {
    if (name == "path") return &SvgReader::read_path;
    if (name == "polygon") return &SvgReader::read_polygon;
    if (name == "polyline") return &SvgReader::read_polyline;
    if (name == "rect") return &SvgReader::read_rectangle;
    return nullptr;
  }

  void read_path(xmlNode& node, const svg::Transform& transform) {
    for (const auto& subpath : parsed(node, "d", "", svg::parse_path))
      add(node, subpath.points, subpath.closed, transform);
  }
  void read_polygon(xmlNode& node, const svg::Transform& transform) {
    add(node, parsed(node, "points", "", svg::parse_points), true, transform);
  }
  void read_polyline(xmlNode& node, const svg::Transform& transform) {
    add(node, parsed(node, "points", "", svg::parse_points), false, transform);
  }
  void read_rectangle(xmlNode& node, const svg::Transform& transform) {
    for (const char* rounded : {"rx", "ry"})
      if (attribute(node, rounded) && parsed(node, rounded, "0", svg::parse_number) != 0)
        fail(node, fmt::format("its corners are round ({}): a polygon's edges are straight", rounded));
    const auto number = [&](const char* name) { return parsed(node, name, "0", svg::parse_number); };
    const svg::Rational left = number("x"), top = number("y");
    const svg::Rational right = left + number("width"), bottom = top + number("height");
    add(node, {{left, top}, {left, bottom}, {right, bottom}, {right, top}}, true, transform);
  }

  void add(xmlNode& node, const std::vector<svg::Point>& points, bool closed, const svg::Transform& transform) {
    std::vector<OutlineVertex> outline;
    outline.reserve(points.size());
    for (const svg::Point& p : points) {
      const svg::Point moved = transform(p);
      // SVG's y points down. A sum, so that no zero is negative.
      const Vec3<double> at(exact::rounded(moved.x) + 0.0, exact::rounded(svg::Rational(-moved.y)) + 0.0, 0);
      if (!at.allFinite()) fail(node, "a coordinate is beyond the range of double");
      outline.push_back({at, line_of(node)});
    }
    add_outline(std::move(outline), closed, mesh_);
  }

  svg::Transform transform_of(xmlNode& node, const svg::Transform& outer) {
    check_style(node);
    if (attribute(node, "transform-origin")) fail(node, "transform-origin is not read; use a rotation about a point");
    return outer.after(parsed(node, "transform", "", svg::parse_transform));
  }
  // Shapes and transforms of a style would be lost.
  void check_style(xmlNode& node) {
    std::string style = attribute(node, "style").value_or("");
    if (text_of(node.name) == "style") {
      const std::unique_ptr<xmlChar, void (*)(void*)> sheet(xmlNodeGetContent(&node), xmlFree);
      style += text_of(sheet.get());
    }
    for (std::size_t colon = style.find(':'); colon != std::string::npos; colon = style.find(':', colon + 1)) {
      const std::string property = property_before(style, colon);
      const bool moves = std::ranges::find(kMoving, property) != kMoving.end();
      const bool shapes = text_of(node.name) == "rect" && std::ranges::find(kSides, property) != kSides.end();
      if (moves || shapes) fail(node, fmt::format("a style with {} is not read; write it as an attribute", property));
    }
  }

  static std::size_t line_of(const xmlNode& node) {
    return static_cast<std::size_t>(std::max(0L, xmlGetLineNo(&node)));
  }

  [[noreturn]] void fail(xmlNode& node, const std::string& reason) const {
    const std::optional<std::string> id = node.type == XML_ELEMENT_NODE ? attribute(node, "id") : std::nullopt;
    const std::string element = fmt::format("<{}{}>", text_of(node.name), id ? " id=" + shown(*id) : "");
    FileLine{path_, line_of(node)}.fail(fmt::format("{}: {}", element, reason));
  }

  const std::filesystem::path& path_;
  Mesh& mesh_;
};

Mesh read_svg(const std::filesystem::path& path) {
  const std::string text = read_mesh_file(path);
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    FileLine{path}.fail("the file is too large");
  const std::unique_ptr<xmlParserCtxt, void (*)(xmlParserCtxtPtr)> parser(xmlNewParserCtxt(), xmlFreeParserCtxt);
  const std::unique_ptr<xmlDoc, void (*)(xmlDocPtr)> document(
      xmlCtxtReadMemory(parser.get(), text.data(), static_cast<int>(text.size()), nullptr, nullptr,
                        XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_BIG_LINES),
      xmlFreeDoc);
  if (!document) {
    const xmlError* error = xmlCtxtGetLastError(parser.get());
    std::string_view rest = error && error->message ? error->message : "", message = "not XML";
    take_line(rest, message);
    FileLine{path, error ? static_cast<std::size_t>(std::max(0, error->line)) : 0}.fail(
        fmt::format("libxml2 cannot read it: {}", message));
  }
  Mesh mesh;
  if (xmlNode* root = xmlDocGetRootElement(document.get())) SvgReader(path, mesh).read(*root);
  if (mesh.vertices.empty()) FileLine{path}.fail("no path, polygon, polyline or rect in it");
  return mesh;
}

const RegisterMeshReader svg_reader{".svg", read_svg};

}  // namespace
}  // namespace cageproof::mesh_files
