// SPDX-License-Identifier: MIT
// [W12] Figure 10: a square made an L, whole and as two triangles with and without one derivative across their seam.
#include "embedded_figures.h"
#include "plane_measures.h"
#include "plane_shapes.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/geometry/winding_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::validation {
namespace {

using SeamPoints = std::vector<Vec3<double>>;

constexpr int seam_cells = 20;
constexpr double seam_stretch = 1;  // of the seam's normal derivative, a multiple of its unit normal

// The square with the middles of two edges, and the L. The seam runs from vertex 0 to vertex 3.
const SeamPoints seam_square{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}, {0.5, 1, 0}, {0, 1, 0}};
const SeamPoints seam_l{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0.5, 0.5, 0}, {0.5, 1, 0}, {0, 1, 0}};

// A polygon of some of the vertices, in their order.
struct SeamPart {
  Cage cage;
  SeamPoints posed, normal_derivatives;
};

Vec3<double> outward_unit(const Vec3<double>& from, const Vec3<double>& to) {
  return Vec3<double>(to[1] - from[1], from[0] - to[0], 0).normalized();
}

SeamPart seam_part(const std::string& name, const std::vector<int>& vertices) {
  SeamPoints rest, posed, normals;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const int from = vertices[k], to = vertices[(k + 1) % vertices.size()];
    rest.push_back(seam_square[from]);
    posed.push_back(seam_l[from]);
    const bool on_seam = (from == 0 && to == 3) || (from == 3 && to == 0);
    normals.emplace_back((on_seam ? seam_stretch : 1) * outward_unit(seam_l[from], seam_l[to]));
  }
  return {polygon_of(name, std::move(rest)), std::move(posed), std::move(normals)};
}

// How the square is mapped.
struct SeamMap {
  const char *title, *file, *kind;
  bool whole;
};
constexpr std::array seam_maps{SeamMap{"harmonic, whole", "whole", "harmonic_goursat", true},
                               SeamMap{"harmonic, two triangles", "harmonic", "harmonic_goursat", false},
                               SeamMap{"biharmonic, two triangles", "biharmonic", "biharmonic_goursat", false}};

// Images of points, and derivatives of the map across the seam.
struct SeamImages {
  SeamPoints images, across;
};

// The map's tensors of an order, contracted: values, or derivatives along a direction.
SeamPoints contracted(const SeamPart& part, const std::vector<CoordinateTable<double>>& tables, std::size_t points,
                      int order, const Vec3<double>& along) {
  SeamPoints found(points, Vec3<double>::Zero());
  for (std::size_t block = 0; block < tables.size(); ++block) {
    const SeamPoints& data = block == 0 ? part.posed : part.normal_derivatives;
    for (std::size_t p = 0; p < points; ++p)
      for (std::size_t i = 0; i < data.size(); ++i) {
        const std::size_t numbers = order == 0 ? 1 : 2;
        const double* const at = &tables[block].tensors[order][p * tables[block].stride[order] + i * numbers];
        found[p] += (order == 0 ? at[0] : at[0] * along[0] + at[1] * along[1]) * data[i];
      }
  }
  return found;
}

SeamImages mapped(const SeamPart& part, const char* kind, const SeamPoints& points, const SeamPoints& on_seam) {
  const CageCoordinates coordinates(part.cage, coordinate_kind_named(kind), CoordinateOptions{});
  const Vec3<double> across = outward_unit(seam_square[3], seam_square[0]);
  SeamImages found{contracted(part, coordinates.at<double>(std::span(points), 0), points.size(), 0, across), {}};
  if (!on_seam.empty())
    found.across = contracted(part, coordinates.at<double>(std::span(on_seam), 1), on_seam.size(), 1, across);
  return found;
}

class SeamFigure final : public PaperFigure {
 public:
  std::string name() const override { return "seam"; }
  int parts() const override { return static_cast<int>(seam_maps.size()); }

  FigureFindings part(int part, int /*jobs*/) const override {
    const SeamMap& map = seam_maps[part];
    const SeamPoints& points = mesh_.mesh.vertices;
    MeshField images, jumps;
    images.name = key_of(map);
    if (map.whole) {
      images.vertices = mapped(whole_, map.kind, points, {}).images;
      return {{images.name, std::move(images)}};
    }
    images.vertices.resize(points.size());
    for (const bool upper : {false, true}) {
      const SeamPart& half = upper ? upper_ : lower_;
      SeamPoints own;
      std::vector<std::size_t> places;
      for (std::size_t p = 0; p < points.size(); ++p)
        if ((points[p][1] > points[p][0]) == upper) {
          own.push_back(points[p]);
          places.push_back(p);
        }
      const SeamImages found = mapped(half, map.kind, own, on_seam());
      for (std::size_t p = 0; p < places.size(); ++p) images.vertices[places[p]] = found.images[p];
      jumps.vertices.insert(jumps.vertices.end(), found.across.begin(), found.across.end());
    }
    jumps.name = key_of(map) + ".across";
    FigureFindings found;
    found[jumps.name] = std::move(jumps);
    found[images.name] = std::move(images);
    return found;
  }

  bool is_in(const FigureFindings& found) const override {
    const auto has = [&](const std::string& key, std::size_t count) {
      const auto at = found.find(key);
      return at != found.end() && at->second.vertices.size() == count;
    };
    return std::ranges::all_of(seam_maps, [&](const SeamMap& map) {
      return has(key_of(map), mesh_.mesh.vertices.size()) &&
             (map.whole || has(key_of(map) + ".across", 2 * on_seam().size()));
    });
  }

  std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const override {
    reports::FigureSheet sheet{
        .name = "w12-seam",
        .heading = "Two triangles glued with one derivative",
        .source = "[W12] Figure 10",
        .text =
            "A square made an L (blue). The true harmonic map of the whole square spills out "
            "of the L. Cut along its diagonal (red), each triangle is mapped into its half: "
            "harmonic maps have a kink along the seam, biharmonic ones with the same "
            "derivative across it on both sides have none. Captions state the kink, the "
            "largest jump of that derivative, which is 1 for the identity, at nine places of the seam, "
            "and the share of the mesh's inner vertices that lie outside the L.",
        .columns = 4,
        .view = {},
        .panels = {}};
    sheet.panels.push_back(panel("at rest", "rest", mesh_.mesh.vertices, seam_square));
    for (const SeamMap& map : seam_maps) {
      reports::FigurePanel drawn = panel(map.title, map.file, found.at(key_of(map)).vertices, seam_l);
      drawn.facts.insert(drawn.facts.begin(), {"method", map.kind});
      measure(map, found, drawn);
      sheet.panels.push_back(std::move(drawn));
    }
    return {std::move(sheet)};
  }

 private:
  static std::string key_of(const SeamMap& map) { return fmt::format("figure/w12-seam/{}", map.file); }

  static SeamPoints on_seam() {
    SeamPoints points;
    for (int k = 1; k < 10; ++k) points.emplace_back(k / 10.0, k / 10.0, 0);
    return points;
  }

  // The square in cells, with its diagonal.
  static TonedMesh seam_mesh() {
    TonedMesh found = grid(1, 1, 1.0 / seam_cells);
    found.mesh.segments.clear();
    for (int k = 0; k < seam_cells; ++k)
      found.mesh.segments.push_back({k * (seam_cells + 2), (k + 1) * (seam_cells + 2)});
    return found;
  }

  reports::FigurePanel panel(const std::string& title, const std::string& file, const SeamPoints& vertices,
                             const SeamPoints& cage) const {
    reports::FigurePanel drawn;
    drawn.title = title;
    drawn.file = file;
    drawn.flat = true;
    drawn.tones = mesh_.tones;
    drawn.data.vertices = vertices;
    drawn.data.faces = mesh_.mesh.faces;
    drawn.data.segments = mesh_.mesh.segments;
    drawn.data.name = file;
    drawn.cage = cage;
    for (int k = 0; k < static_cast<int>(cage.size()); ++k)
      drawn.cage_faces.push_back({k, (k + 1) % static_cast<int>(cage.size())});
    drawn.facts = {{"cage", "square"}};
    return drawn;
  }

  void measure(const SeamMap& map, const FigureFindings& found, reports::FigurePanel& drawn) const {
    std::vector<Segment<double>> segments;
    for (std::size_t k = 0; k < seam_l.size(); ++k) segments.push_back({seam_l[k], seam_l[(k + 1) % seam_l.size()]});
    int inner = 0, outside = 0;
    for (std::size_t p = 0; p < mesh_.mesh.vertices.size(); ++p) {
      const Vec3<double>& rest = mesh_.mesh.vertices[p];
      if (rest.head<2>().minCoeff() == 0 || rest.head<2>().maxCoeff() == 1) continue;
      ++inner;
      if (winding_number(segments, drawn.data.vertices[p]).value_or(1) == 0) ++outside;
    }
    const double spilled = static_cast<double>(outside) / inner,
                 folded = folded_share(drawn.data.faces, drawn.data.vertices);
    drawn.measured = {{"share of inner vertices outside the posed cage", spilled},
                      {"share of triangles turned over", folded}};
    drawn.note = fmt::format("{:.1f} % outside, {:.1f} % folded", 100 * spilled, 100 * folded);
    if (map.whole) return;
    const SeamPoints& across = found.at(key_of(map) + ".across").vertices;
    const std::size_t count = across.size() / 2;
    double jump = 0;
    for (std::size_t p = 0; p < count; ++p) jump = std::max(jump, (across[p] - across[count + p]).norm());
    drawn.measured.emplace_back("largest jump of the derivative across the seam", jump);
    drawn.note += fmt::format(", kink {}", jump < 1e-3 ? fmt::format("{:.0e}", jump) : fmt::format("{:.2f}", jump));
  }

  SeamPart whole_ = seam_part("square", {0, 1, 2, 3, 4, 5}), lower_ = seam_part("lower", {0, 1, 2, 3}),
           upper_ = seam_part("upper", {0, 3, 4, 5});
  TonedMesh mesh_ = seam_mesh();
};

}  // namespace

std::unique_ptr<const PaperFigure> seam_figure() { return std::make_unique<SeamFigure>(); }

}  // namespace cageproof::validation
