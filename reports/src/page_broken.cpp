// SPDX-License-Identifier: MIT
#include "cageproof/core/scalar_text.h"
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace cageproof::reports {
namespace {

// More would be read by nobody, and results.csv has them all.
constexpr std::size_t kMostRows = 60;
constexpr std::size_t kMostCases = 3;
// What is seen without unfolding anything.
constexpr std::size_t kFirstRows = 12;

std::string hex(const Vec3<double>& p) {
  return fmt::format("[\"{}\", \"{}\", \"{}\"]", format_hex(p[0]), format_hex(p[1]), format_hex(p[2]));
}

std::string input_text(const WorstCase& worst) {
  std::string text;
  for (std::size_t k = 0; k < worst.corners.size(); ++k)
    text += fmt::format("corner {}  {}\n", k, hex(worst.corners[k]));
  text += fmt::format("point     {}\n", hex(worst.point));
  for (std::size_t k = 0; k < worst.parameters.size(); ++k)
    text += fmt::format("parameter {}  {}\n", k, format_hex(worst.parameters[k]));
  return text;
}

Data worst_inputs(const ResultRow& row, std::size_t first_line) {
  Data cases{Data::type::list};
  for (std::size_t i = 0; i < std::min(row.worst.size(), kMostCases); ++i) {
    const WorstCase& worst = row.worst[i];
    Data data;
    data.set("error", short_error(worst.error));
    data.set("unit", row.unit);
    data.set("parameter", short_number(worst.parameter));
    data.set("sample", fmt::format("{}", worst.sample));
    data.set("line", fmt::format("{}", first_line + i));
    data.set("input", input_text(worst));
    cases << data;
  }
  return cases;
}

}  // namespace

void set_broken(Data& page, const RunResult& result) {
  std::unordered_map<const ResultRow*, std::size_t> first_line;
  std::size_t line = 1;
  for (const ResultRow& row : result.rows) first_line[&row] = line, line += row.worst.size();
  const Rows rows = broken_rows(result);
  Data list{Data::type::list}, first{Data::type::list}, other{Data::type::list};
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) {
    const ResultRow& row = *rows[i];
    Data data;
    data.set("anchor", fmt::format("worst-{}", i + 1));
    data.set("subject", row.subject);
    data.set("evaluation", row.evaluation);
    data.set("scalar", row.scalar);
    data.set("where", row.place.empty() ? row.regime : row.regime + ", " + row.place);
    data.set("check", row.check);
    data.set("order", std::string(order_name(row.order)));
    // A figure that is kept is not what is broken.
    const bool above = row.bound && row.samples > 0 && !(row.max <= *row.bound);
    data.set("max", above ? short_error(row.max) : "samples lost");
    data.set("bound", row.bound ? short_number(*row.bound) : "");
    data.set("unit", row.unit);
    data.set("samples", grouped(row.samples));
    data.set("nonfinite", grouped(row.nonfinite));
    data.set("any_nonfinite", row.nonfinite > 0);
    data.set("reason", row.reason);
    data.set("has_reason", !row.reason.empty());
    set_list(data, "cases", worst_inputs(row, first_line[&row]));
    (i < kFirstRows ? first : other) << data;
    list << data;
  }
  set_list(page, "broken", list);
  set_list(page, "first_broken", first);
  set_list(page, "other_broken", other);
  page.set("other_broken_count", grouped(std::min(rows.size(), kMostRows) - std::min(rows.size(), kFirstRows)));
  page.set("has_more_broken", rows.size() > kMostRows);
  page.set("more_broken", grouped(rows.size() > kMostRows ? rows.size() - kMostRows : 0));
}

}  // namespace cageproof::reports
