// SPDX-License-Identifier: MIT
#include "judge_option.h"

#include <fmt/format.h>

#include <cstdio>

namespace cageproof::cli {

std::string text_of(const judge::Incident& incident) {
  std::string text = incident.kind;
  if (!incident.formula.empty()) text += fmt::format(", {}, order {}", incident.formula, incident.order);
  text += ": " + incident.text;
  if (incident.count > 1) text += fmt::format(" ({} times)", incident.count);
  if (!incident.input.empty()) text += fmt::format("; first at {}", incident.input);
  return text;
}

void JudgeOption::add_to(Command command) {
  command
      .option("--judge", given_,
              "somebody else's code as the evaluation NAME: a library (./libmine.so) or a command ('./my_program') "
              "that answers lines of eval; it runs in processes of its own")
      .taking("NAME=WHAT")
      .one_at_a_time();
}

void JudgeOption::begin(const std::string& formulas) {
  for (const std::string& one : given_) {
    const auto [name, what] = judge::name_and_what(one);
    const auto code = std::make_shared<judge::ForeignCode>(what);
    judge::register_foreign_code(code, name, formulas);
    codes_.emplace_back(name, code);
  }
}

JudgeOption::~JudgeOption() {
  for (const auto& [name, code] : codes_) {
    code->finish();
    for (const judge::Incident& incident : code->incidents())
      std::fputs(fmt::format("warning: {}: {}\n", name, text_of(incident)).c_str(), stderr);
    if (code->skipped() > 0)
      std::fputs(fmt::format("warning: {}: {} inputs were not asked, because it hung or died too often\n", name,
                             code->skipped())
                     .c_str(),
                 stderr);
  }
}

}  // namespace cageproof::cli
