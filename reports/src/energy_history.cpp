// SPDX-License-Identifier: MIT
#include "cageproof/reports/energy_history.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "gnuplot.h"
#include "temporary_folder.h"

#include <fmt/format.h>

namespace cageproof::reports {
std::string energies_csv(std::span<const double> energies) {
  std::string text = "number,energy\n";
  for (std::size_t i = 0; i < energies.size(); ++i) text += fmt::format("{},{}\n", i + 1, energies[i]);
  return text;
}

std::string energies_png(std::span<const double> energies, std::string_view title) {
  std::string data;
  for (std::size_t i = 0; i < energies.size(); ++i)
    data += fmt::format("{} {}\n", i + 1, energies[i] > 0 ? gnuplot_number(energies[i]) : "NaN");
  const TemporaryFolder folder;
  const auto undrawn =
      draw({{.file = "energies.png",
             .width = 640,
             .height = 400,
             .commands =
                 fmt::format("$d << EOD\n{}EOD\nset logscale y\nset format y '10^{{%L}}'\nset border 3 linecolor rgb "
                             "'#666666'\nset tics nomirror scale 0.5\nset grid linetype 1 linecolor rgb '#e0e0e0'\n"
                             "set xrange [0:{}]\nset title {} noenhanced\nset xlabel 'number'\n"
                             "set ylabel 'energy'\nunset key\nplot $d with linespoints linecolor rgb '#3366aa' "
                             "pointtype 7 pointsize 0.5\n",
                             data, energies.size() + 1, gnuplot_text(title))}},
           folder.path());
  if (!undrawn.empty()) throw InputError(fmt::format("cannot draw {}", undrawn.front()));
  return read_file(folder.path() / "energies.png");
}

}  // namespace cageproof::reports
