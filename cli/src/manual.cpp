// SPDX-License-Identifier: MIT
#include "manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace cageproof::cli {
namespace {

// Makes text roff: no line is a request, a minus is a minus, and text between backquotes is bold.
std::string roff(std::string_view text) {
  std::string result;
  bool bold = false;
  for (const char c : text) switch (c) {
      case '\\': result += "\\e"; break;
      case '-': result += "\\-"; break;
      case '\'': result += "\\(aq"; break;
      case '^': result += "\\(ha"; break;
      case '~': result += "\\(ti"; break;
      case '`':
        bold = !bold;
        result += bold ? "\\fB" : "\\fR";
        break;
      default: result += c;
    }
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

void add_options(const std::vector<OptionText>& options, std::string& text) {
  const std::vector<OptionGroup> groups = groups_of(options);
  for (const OptionGroup& group : groups) {
    if (groups.size() > 1) text += fmt::format(".PP\n\\fI{}\\fR\n", roff(group.heading));
    for (const OptionText& option : group.options) {
      std::vector<std::string> names;
      names.reserve(option.names.size());
      for (const std::string& name : option.names) names.push_back("\\fB" + roff(name) + "\\fR");
      text += fmt::format(".TP\n{}", fmt::join(names, ", "));
      if (!option.positional && !option.type.empty()) text += " \\fI" + roff(option.type) + "\\fR";
      text += "\n" + roff(whole_description(option)) + "\n";
    }
  }
}

// Columns of a table must not end where a text has a bar, and words in angles are no tags.
std::string cell(std::string_view text) {
  std::string result;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == '|') result += "\\|";
    else if (!code && (c == '*' || c == '_')) result += std::string("\\") + c;
    else if (!code && c == '<') result += "&lt;";
    else result += c;
  }
  return result;
}

void add_table(const std::vector<OptionText>& options, std::string& text) {
  const std::vector<OptionGroup> groups = groups_of(options);
  for (const OptionGroup& group : groups) {
    if (groups.size() > 1) text += fmt::format("**{}**\n\n", cell(group.heading));
    text += "| option | value | what it is |\n|---|---|---|\n";
    for (const OptionText& option : group.options)
      text += fmt::format("| `{}` | {} | {} |\n", fmt::join(option.names, "`, `"), option.type,
                          cell(whole_description(option)));
    text += "\n";
  }
}

std::string paragraph(std::string_view text) { return cell(text) + "\n\n"; }

// For scripts/check_docs, which runs the blocks of other pages.
std::string not_run(const std::string& why) { return fmt::format("<!-- not run: {} -->\n\n", why); }

}  // namespace

std::string manual_page(const ProgramText& program) {
  std::string text = ".\\\" Made by `cageproof man` of the command line's own description.\n";
  text += fmt::format(".TH CAGEPROOF 1 \"\" \"{}\" \"User Commands\"\n", roff(program.version));
  text += fmt::format(".SH NAME\ncageproof \\- trust in cage coordinates: verified, timed, reported on\n");
  text += ".SH SYNOPSIS\n\\fBcageproof\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n.br\n";
  text += "\\fBcageproof\\fR \\fICOMMAND\\fR \\fB\\-\\-help\\fR\n";
  text += ".SH DESCRIPTION\n" + roff(program.description) + "\n";
  add_options(program.options, text);
  text += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands) {
    text += fmt::format(".SS {}\n{}.\n.PP\n.nf\n{}\n.fi\n", command.name, roff(command.description),
                        roff(usage(program, command)));
    add_options(command.options, text);
    if (command.examples.empty()) continue;
    text += ".PP\nExamples:\n.PP\n.nf\n";
    for (const std::string& example : command.examples) text += roff(example) + "\n";
    text += ".fi\n";
  }
  for (const ManualSection& section : manual_sections()) {
    text += ".SH " + upper(section.title) + "\n";
    bool first = true;
    for (const std::string& one : section.paragraphs) {
      text += (first ? "" : ".PP\n") + roff(one) + "\n";
      first = false;
    }
    for (const auto& [term, what] : section.items) text += ".TP\n\\fB" + roff(term) + "\\fR\n" + roff(what) + "\n";
  }
  return text;
}

std::string manual_markdown(const ProgramText& program) {
  std::string text = "# The command line\n\n";
  text += "<!-- Made by `cageproof man --markdown` of the command line's own description: change that. -->\n\n";
  text += paragraph(program.description);
  text += "The same stands in `man cageproof`, and of one command in `cageproof help COMMAND`.\n\n";
  add_table(program.options, text);
  text += "| command | what it does |\n|---|---|\n";
  for (const CommandText& command : program.commands)
    text += fmt::format("| [`{0}`](#{0}) | {1} |\n", command.name, cell(command.description));
  text += "\n";
  for (const ManualSection& section : manual_sections()) {
    text += "## " + section.title + "\n\n";
    for (const std::string& one : section.paragraphs) text += paragraph(one);
    for (const auto& [term, what] : section.items) text += fmt::format("* `{}`: {}\n", term, cell(what));
    if (!section.items.empty()) text += "\n";
  }
  text += "## Commands\n\n";
  for (const CommandText& command : program.commands) {
    text += fmt::format("### {}\n\n{}\n\n{}    {}\n\n", command.name, cell(command.description),
                        not_run("how it is called"), usage(program, command));
    add_table(command.options, text);
    if (command.examples.empty()) continue;
    text += "Examples:\n\n" + not_run("on files of a user, and of any length");
    for (const std::string& example : command.examples) text += "    " + example + "\n";
    text += "\n";
  }
  text.pop_back();
  return text;
}

}  // namespace cageproof::cli
