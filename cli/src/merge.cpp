// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/validation/verify.h"

namespace cageproof::cli {
namespace {

struct Arguments {
  std::vector<std::string> parts;
  std::string out;
};

int run(const Arguments& a) {
  return print_verdict(validation::merge_shards({a.parts.begin(), a.parts.end()}, a.out), a.out);
}

}  // namespace

void add_merge(CommandLine& line) {
  Command command = line.command("merge", "make one report of all shards of a run");
  auto a = std::make_shared<Arguments>();
  command.option("parts", a->parts, "the shards' folders, as `verify --shard` made them").taking("FOLDER").required();
  command.option("--out", a->out, "the report's folder").taking("FOLDER").required();
  command.example("cageproof merge part-0 part-1 part-2 --out report");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
