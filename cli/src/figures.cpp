// SPDX-License-Identifier: MIT
#include "commands.h"
#include "inputs_outside.h"
#include "progress.h"

#include "cageproof/validation/paper_figures.h"

#include <fmt/format.h>

namespace cageproof::cli {
namespace {

struct Arguments {
  std::string data, out = "paper-figures";
  int jobs = 0;
};

int run(const Arguments& a) {
  require_outside(a.out, {{a.data, "--data"}});
  reports::require_figure_folder(a.out);
  const validation::PaperFigures figures =
      a.data.empty() ? validation::embedded_figures() : validation::figures_of_data(a.data);
  Progress progress;
  std::vector<reports::FigureSheet> sheets = validation::figure_sheets(
      figures, a.jobs, [&](const std::string& name) { progress(fmt::format("computing {}", name)); });
  std::vector<std::string> lines;
  lines.reserve(sheets.size());
  for (const reports::FigureSheet& sheet : sheets)
    lines.push_back(fmt::format("{}/figures/{}.png: {}, {} panels; {}", a.out, sheet.name, sheet.heading,
                                sheet.panels.size(), sheet.source));
  reports::write_figures(a.out, std::move(sheets));
  for (const std::string& line : lines) fmt::print("{}\n", line);
  return success;
}

}  // namespace

void add_figures(CommandLine& line) {
  Command command = line.command("figures", "draw the papers' figures: deformers side by side");
  auto a = std::make_shared<Arguments>();
  command
      .option("--data", a->data,
              "a folder with NAME_Cage.obj, NAME_Cage_Deformed.obj and NAME.obj, for any number of names, instead of "
              "the built-in cages")
      .taking("FOLDER");
  command.option("--jobs", a->jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  command.option("--out", a->out, "pictures, data and captions go to its folder figures/")
      .taking("FOLDER")
      .showing_default();
  add_quiet(command);
  command.example("cageproof figures --out paper-figures");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
