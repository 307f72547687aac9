// SPDX-License-Identifier: MIT
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::reports {
namespace {

// Vertices that segments join, one after the other.
struct Chain {
  std::vector<int> vertices;
  bool closed = false;
};

// The polylines of a mesh, which knows single segments only. They end where not two segments meet.
class Chains {
 public:
  explicit Chains(const Mesh& mesh) : mesh_(mesh), used_(mesh.segments.size(), 0), at_(mesh.vertices.size()) {
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
      const auto& [from, to] = mesh.segments[s];
      if (from == to) continue;
      at_[from].push_back(s);
      at_[to].push_back(s);
    }
  }

  /// Chains of the lowest vertices come first; vertices of no segment are chains, too.
  std::vector<Chain> all() {
    std::vector<Chain> chains;
    for (int v = 0; v < static_cast<int>(at_.size()); ++v) {
      if (at_[v].empty()) chains.push_back({{v}});
      // The segment that leaves the vertex says which way a closed polyline runs.
      std::ranges::stable_sort(at_[v], {}, [&](std::size_t s) { return mesh_.segments[s][0] != v; });
      for (const std::size_t s : at_[v]) {
        if (used_[s]) continue;
        const Step end = end_of({v, s});
        chains.push_back(ends_at(v) || end.vertex == v ? from({v, s}) : from(end));
      }
    }
    return chains;
  }

 private:
  // A vertex, and the segment by which to go on.
  struct Step {
    int vertex;
    std::size_t segment;
  };

  bool ends_at(int v) const { return at_[v].size() != 2; }
  int other_end(const Step& step) const {
    const auto& [from, to] = mesh_.segments[step.segment];
    return step.vertex == from ? to : from;
  }
  std::size_t other_segment(int v, std::size_t s) const { return at_[v][0] == s ? at_[v][1] : at_[v][0]; }
  // Where the chain ends or returns, with the segment by which that was reached.
  Step end_of(const Step& first) const {
    for (Step step = first;;) {
      const int v = other_end(step);
      if (v == first.vertex || ends_at(v)) return {v, step.segment};
      step = {v, other_segment(v, step.segment)};
    }
  }
  Chain from(const Step& first) {
    Chain chain{{first.vertex}};
    for (Step step = first;;) {
      used_[step.segment] = 1;
      const int v = other_end(step);
      chain.closed = v == first.vertex;
      if (!chain.closed) chain.vertices.push_back(v);
      if (chain.closed || ends_at(v)) break;
      step = {v, other_segment(v, step.segment)};
    }
    // As its first segment runs; a closed one begins where it did.
    if (mesh_.segments[first.segment][0] != first.vertex)
      std::reverse(chain.vertices.begin() + (chain.closed ? 1 : 0), chain.vertices.end());
    return chain;
  }

  const Mesh& mesh_;
  std::vector<char> used_;
  std::vector<std::vector<std::size_t>> at_;  // each vertex's segments
};

// SVG's y points down. Differences, so that no zero is negative.
std::string place_text(const Vec3<double>& p) { return fmt::format("{},{}", p[0] + 0.0, 0.0 - p[1]); }

std::string element_text(const Mesh& mesh, const Chain& chain) {
  const auto place = [&](std::size_t k) { return place_text(mesh.vertices[chain.vertices[k]]); };
  // A path that does not go anywhere draws nothing, and readers pass over it.
  if (chain.vertices.size() == 1) return fmt::format("<polyline points=\"{}\"/>\n", place(0));
  std::string text = "<path d=\"M" + place(0);
  for (std::size_t k = 1; k < chain.vertices.size(); ++k) text += " L" + place(k);
  return text + (chain.closed ? " Z\"/>\n" : "\"/>\n");
}

std::string opening_text(const std::vector<Vec3<double>>& vertices) {
  const auto [low, high] = box_of(vertices);
  const Vec3<double> extent = high - low;
  constexpr double share_of_margin = 1.0 / 32, share_of_stroke = 1.0 / 512;
  double size = extent.maxCoeff();
  if (size == 0) size = low.cwiseAbs().maxCoeff();
  if (size == 0) size = 1;
  const double margin = size * share_of_margin, left = low[0] - margin, top = -high[1] - margin;
  const double width = high[0] + margin - left, height = -low[1] + margin - top;
  if (!std::isfinite(width) || !std::isfinite(height))
    throw InputError("the drawing is wider or higher than the largest double");
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n"
      "<g fill=\"none\" stroke=\"black\" stroke-width=\"{}\">\n",
      left, top, width, height, size * share_of_stroke);
}

void note_changes(const Mesh& mesh, const std::vector<Chain>& chains, PartialMeshText& made) {
  std::vector<int> order;
  std::size_t joined = 0;
  for (const Chain& chain : chains) {
    order.insert(order.end(), chain.vertices.begin(), chain.vertices.end());
    if (chain.vertices.size() > 2 && mesh.vertices[chain.vertices.front()] == mesh.vertices[chain.vertices.back()])
      ++joined;
  }
  if (order.size() > mesh.vertices.size())
    made.changed.emplace_back("SVG has no vertices that several polylines share: each polyline has its own");
  else if (!std::ranges::is_sorted(order))
    made.changed.emplace_back("SVG has no numbers of vertices: they are written in the order of their polylines");
  if (joined > 0)
    made.changed.push_back(fmt::format(
        "{} polylines begin and end at one place: the two vertices there are one where the SVG is read", joined));
}

}  // namespace

PartialMeshText svg_text(const Mesh& mesh) {
  if (mesh.segments.empty()) throw InputError("no polylines, and SVG files hold only these");
  const std::vector<Chain> chains = Chains(mesh).all();
  PartialMeshText made{opening_text(mesh.vertices)};
  for (const Chain& chain : chains) made.text += element_text(mesh, chain);
  made.text += "</g>\n</svg>\n";
  if (!mesh.faces.empty()) made.left_out.emplace_back("faces");
  if (std::ranges::any_of(mesh.segments, [](const auto& s) { return s[0] == s[1]; }))
    made.left_out.emplace_back("segments from a vertex to itself");
  note_changes(mesh, chains, made);
  return made;
}

}  // namespace cageproof::reports
