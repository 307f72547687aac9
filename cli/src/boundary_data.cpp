// SPDX-License-Identifier: MIT
#include "boundary_data.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace cageproof::cli {
namespace {

constexpr std::string_view separators = " \t,;\r";

// The numbers of a line; nothing where something on it is none.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  line = line.substr(0, line.find('#'));
  while (true) {
    const auto begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos) return numbers;
    line.remove_prefix(begin);
    const auto end = std::min(line.find_first_of(separators), line.size());
    const auto number = parse_scalar<double>(line.substr(0, end));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
    line.remove_prefix(end);
  }
}

std::string expected_lines(const CageCoordinates& coordinates) {
  std::string text;
  for (const CoordinateBlock& block : coordinates.blocks())
    text += fmt::format("{}{} of {}", text.empty() ? "" : " and ", block.size, block.label);
  return text;
}

}  // namespace

BoundaryData read_boundary_data(const std::filesystem::path& file, const CageCoordinates& coordinates) {
  std::size_t wanted = 0;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    if (block.entries() != 1)
      throw InputError(
          fmt::format("{}: {} coordinates are matrices, and take no data", file.string(), coordinates.kind().name));
    wanted += block.size;
  }
  const std::string text = read_file(file);
  std::string_view rest = text;
  BoundaryData data;
  std::size_t found = 0;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const auto numbers = numbers_of(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!numbers && number == 1) continue;
    if (!numbers) throw InputError(fmt::format("{}:{}: not a line of finite numbers", file.string(), number));
    if (numbers->empty()) continue;
    if (data.functions == 0) data.functions = numbers->size();
    if (numbers->size() != data.functions)
      throw InputError(fmt::format("{}:{}: {} numbers, where the lines before have {}", file.string(), number,
                                   numbers->size(), data.functions));
    data.numbers.insert(data.numbers.end(), numbers->begin(), numbers->end());
    ++found;
  }
  if (found != wanted)
    throw InputError(
        fmt::format("{}: {} lines of numbers, not {}: {}", file.string(), found, wanted, expected_lines(coordinates)));
  return data;
}

CoordinateColumns function_columns(const CageCoordinates& coordinates, int order, const BoundaryData& data) {
  constexpr std::array titles{"", " gradient", " Hessian"}, words{"", "_gradient", "_hessian"};
  constexpr std::string_view axes = "xyz";
  const int dim = coordinates.dimension();
  CoordinateColumns made;
  for (std::size_t f = 0; f < data.functions; ++f)
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = derivative_count(dim, o);
      for (std::size_t d = 0; d < width; ++d) {
        const std::string second = o == 2 ? std::string{axes[d / dim], axes[d % dim]} : std::string{axes[d]};
        made.names.push_back(fmt::format("f_{}{}", f, o == 0 ? "" : "_d" + second));
      }
      made.groups.push_back({fmt::format("f_{}{}", f, titles[o]), width, fmt::format("f_{}{}", f, words[o]),
                             std::vector<std::size_t>(o, dim)});
    }
  return made;
}

std::vector<double> functions_of(std::span<const double> rows, const CageCoordinates& coordinates, int order,
                                 const BoundaryData& data) {
  const int dim = coordinates.dimension();
  std::size_t columns = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o) columns += block.size * derivative_count(dim, o);
  const std::size_t points = rows.size() / columns;
  std::vector<double> sums;
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t f = 0; f < data.functions; ++f)
      for (int o = 0; o <= order; ++o)
        for (std::size_t d = 0; d < derivative_count(dim, o); ++d) {
          double sum = 0;
          std::size_t block_begin = p * columns, coordinate = 0;
          for (const CoordinateBlock& block : coordinates.blocks()) {
            std::size_t begin = block_begin;
            for (int lower = 0; lower < o; ++lower) begin += block.size * derivative_count(dim, lower);
            for (int i = 0; i < block.size; ++i, ++coordinate)
              sum += rows[begin + i * derivative_count(dim, o) + d] * data.numbers[coordinate * data.functions + f];
            for (int any = 0; any <= order; ++any) block_begin += block.size * derivative_count(dim, any);
          }
          sums.push_back(sum);
        }
  return sums;
}

}  // namespace cageproof::cli
