// SPDX-License-Identifier: MIT
#include "figure.h"
#include "page_data.h"

#include "cageproof/core/whole_file.h"

#include <fmt/format.h>
#include <vtksys/Base64.h>

namespace cageproof::reports {
namespace {

// Steps of the colour scale, in conditioned units: what is promised, then four, eight, twelve digits lost.
const char* conditioned_class(double max) {
  return max <= 64 ? "e0" : max <= 1e4 ? "e1" : max <= 1e8 ? "e2" : max <= 1e12 ? "e3" : "e4";
}

}  // namespace

Data error_cell(const ResultRow* row) {
  Data data;
  if (!row) {
    data.set("text", "");
    data.set("class", "none");
    data.set("title", "");
    return data;
  }
  const bool broken = row->verdict == Verdict::Broken;
  std::string css = row->unit == "conditioned"      ? conditioned_class(row->max)
                    : row->verdict == Verdict::Kept ? "e0"
                                                    : "plain";
  if (broken) css += " broken";
  data.set("text", short_error(row->max) + (broken ? " ✗" : ""));
  data.set("class", css);
  std::string title = fmt::format("{}, {}, {}, {}, {}: largest found {} {} of {} samples, {}", row->subject,
                                  row->evaluation, row->scalar, row->regime, order_name(row->order),
                                  short_error(row->max), row->unit, grouped(row->samples), name_of(row->verdict));
  if (row->bound) title += fmt::format(", bound {}", short_number(*row->bound));
  if (row->nonfinite) title += fmt::format(", {} not finite", grouped(row->nonfinite));
  data.set("title", title);
  return data;
}

void set_list(Data& data, const std::string& name, Data list) {
  data.set("has_" + name, list.is_non_empty_list());
  data.set(name, std::move(list));
}

std::string embedded_png(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  std::string text(bytes.size() / 3 * 4 + 8, '\0');
  text.resize(vtksysBase64_Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                  reinterpret_cast<unsigned char*>(text.data()), 0));
  return "data:image/png;base64," + text;
}

std::string anchor(std::string_view kind, std::string_view name) { return fmt::format("{}-{}", kind, file_name(name)); }

}  // namespace cageproof::reports
