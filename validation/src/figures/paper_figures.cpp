// SPDX-License-Identifier: MIT
#include "cageproof/validation/paper_figures.h"

#include "embedded_figures.h"

#include <fmt/format.h>

namespace cageproof::validation {
namespace {

class FigureMeasurement final : public Measurement {
 public:
  explicit FigureMeasurement(std::unique_ptr<const PaperFigure> figure) : figure_(std::move(figure)) {}
  std::string name() const override { return "figure " + figure_->name(); }
  int blocks() const override { return figure_->parts(); }
  PartialResult measure(int block) const override {
    PartialResult gathered;
    gathered.meshes = figure_->part(block, 1);
    return gathered;
  }

 private:
  std::unique_ptr<const PaperFigure> figure_;
};

}  // namespace

PaperFigures embedded_figures() {
  PaperFigures figures;
  for (const auto make : {bar_figure,
                          pressed_figure,
                          kernel_figure,
                          symmetry_figure,
                          plane_bar_figure,
                          trousers_figure,
                          square_figure,
                          star_figure,
                          neck_figure,
                          seam_figure,
                          star_variants_figure,
                          infinite_ratio_figure,
                          bar_variants_figure,
                          hexagon_figure,
                          l_figure,
                          biharmonic_choices_figure,
                          variational_figure,
                          spikes_figure,
                          valid_quads_figure,
                          projection_figure,
                          tessellation_figure,
                          norm_correction_figure,
                          twisted_box_figure,
                          spherical_figure,
                          triquad_figure,
                          fork_figure})
    figures.push_back(make());
  return figures;
}

std::vector<reports::FigureSheet> figure_sheets(const PaperFigures& figures, int jobs,
                                                const std::function<void(const std::string&)>& said) {
  std::vector<reports::FigureSheet> all;
  for (const auto& figure : figures) {
    if (said) said(figure->name());
    FigureFindings found;
    for (int part = 0; part < figure->parts(); ++part) found.merge(figure->part(part, jobs));
    for (reports::FigureSheet& sheet : figure->sheets(found)) all.push_back(std::move(sheet));
  }
  return all;
}

Measurements figure_measurements(bool all) {
  constexpr std::size_t few = 5;
  PaperFigures figures = embedded_figures();
  if (!all) figures.resize(few);
  Measurements measurements;
  for (auto& figure : figures) measurements.push_back(std::make_unique<FigureMeasurement>(std::move(figure)));
  return measurements;
}

std::vector<reports::FigureSheet> sheets_of_run(const FigureFindings& meshes) {
  std::vector<reports::FigureSheet> all;
  for (const auto& figure : embedded_figures())
    if (figure->is_in(meshes))
      for (reports::FigureSheet& sheet : figure->sheets(meshes)) all.push_back(std::move(sheet));
  return all;
}

}  // namespace cageproof::validation
