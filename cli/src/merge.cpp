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

void add_merge(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("merge", "one report of all shards of a run");
  auto a = std::make_shared<Arguments>();
  command->add_option("parts", a->parts, "the shards' folders, as `verify --shard` made them")->required();
  command->add_option("--out", a->out, "the report's folder")->required();
  command->callback([&action, a] { action = [a] { return run(*a); }; });
}

}  // namespace cageproof::cli
