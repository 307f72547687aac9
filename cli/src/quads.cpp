// SPDX-License-Identifier: MIT
#include "commands.h"
#include "inputs_outside.h"
#include "progress.h"

#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>

#include <iostream>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string out;
};

int run(const Arguments& a) {
  if (!a.out.empty()) {
    if (extension_of(a.out) != ".csv") throw InputError(fmt::format("--out {}: .csv", a.out));
    reports::require_writable({a.out});
    if (place_of(a.cage.file) == place_of(a.out))
      throw InputError(fmt::format("{}: --out is the file of --cage, too", a.out));
  }
  const Cage cage = a.cage.load();
  std::string text = "face,line,planar,valid,reason\n";
  std::size_t quads = 0, invalid = 0;
  for (std::size_t f = 0; f < cage.faces().size(); ++f) {
    if (cage.faces()[f].kind() != ElementKind::Quad) continue;
    const Quad<double> corners = cage.quad(f);
    const std::optional<std::string> reason = invalid_because(corners);
    const std::string line = f < cage.face_lines().size() ? fmt::format("{}", cage.face_lines()[f]) : "";
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", cage.face_number(f), line,
                   is_planar(corners) ? "yes" : "no", reason ? "no" : "yes", reason ? '"' + *reason + '"' : "");
    ++quads;
    invalid += reason ? 1 : 0;
  }
  if (a.out.empty()) std::cout << text;
  else reports::replace_file(a.out, text);
  remark(fmt::format("{}: {} quads, {} not valid ([T18] Definition 1)", cage.name(), quads, invalid));
  return invalid > 0 ? not_valid : success;
}

}  // namespace

void add_quads(CommandLine& line) {
  Command command = line.command(
      "quads",
      "print which quads of a cage are valid ([T18] Definition 1), and why others are not; exit 1 when any is not");
  auto a = std::make_shared<Arguments>();
  a->cage.allow_invalid_quads = true;
  command.heading("The cage");
  a->cage.add_to(command, true);
  command.heading("Output");
  command
      .option("--out", a->out,
              ".csv with one line per quad: its number, its line in the file, whether it is planar, whether it is "
              "valid, and the reason, with corners counted from 0; on standard output if not given")
      .taking("FILE");
  add_quiet(command);
  command.example("cageproof quads --cage my_cage.obj");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
