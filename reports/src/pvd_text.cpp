// SPDX-License-Identifier: MIT
#include "cageproof/reports/pvd_text.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cageproof::reports {
namespace {

bool is_utf8(const std::string& name) {
  try {
    nlohmann::json(name).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

// As the value of an attribute in double quotes.
std::string xml_attribute(const std::string& name) {
  const bool has_control = std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (has_control || !is_utf8(name))
    throw InputError(fmt::format("{}: XML, of which .pvd files are made, cannot hold this name, since it {}; rename it",
                                 name, has_control ? "has control characters" : "is not UTF-8"));
  std::string text;
  for (const char c : name) {
    if (c == '&') text += "&amp;";
    else if (c == '<') text += "&lt;";
    else if (c == '"') text += "&quot;";
    else text += c;
  }
  return text;
}

}  // namespace

std::string pvd_text(const std::vector<TimeStep>& steps) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\">\n"
      "  <Collection>\n";
  for (const TimeStep& step : steps)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", step.time, xml_attribute(step.file));
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace cageproof::reports
