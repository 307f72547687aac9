// SPDX-License-Identifier: MIT
// Asks calls that Python asked (write_calls.py) through cageproof.hpp, and compares results to the bit; formulas and
// places, which that header does not have, are left to C. Usage: calls FILE
#include <cageproof.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace cageproof::shared;

std::vector<double> numbers(std::istream& from) {
  std::size_t size = 0;
  from >> size;
  std::vector<double> found(size);
  for (std::string word; double& x : found) {
    from >> word;
    x = std::strtod(word.c_str(), nullptr);
  }
  return found;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

}  // namespace

int main(int argc, char** argv) {
  std::ifstream file(argc > 1 ? argv[1] : "");
  int line = 0, calls = 0;
  for (std::string text; std::getline(file, text);) {
    ++line;
    std::istringstream from(text);
    std::string what, name, of;
    int order = 0;
    from >> what >> name >> of >> order;
    if (what != "coordinates" && what != "images") continue;
    const std::vector<double> posed = numbers(from), points = numbers(from), expected = numbers(from);
    std::vector<double> found(expected.size());
    const std::size_t first = expected.size() / (order == 0 ? 1 : 4);
    const auto values = std::span(found).first(first), derivatives = std::span(found).subspan(first);
    const Cage cage = Cage::embedded(of);
    if (what == "coordinates") {
      Coordinates(cage, name).evaluate(points, values, derivatives);
    } else {
      Deformer deformer(cage, name);
      deformer.pose(posed);
      deformer.images(points, values, derivatives);
    }
    for (std::size_t i = 0; i < found.size(); ++i)
      if (!same(found[i], expected[i])) {
        std::cout << "FAILED: line " << line << ", " << what << ' ' << name << ' ' << of
                  << ": not the bits that Python got\n";
        return 1;
      }
    ++calls;
  }
  std::cout << "C++: " << calls << " calls, the bits that Python got\n";
  return calls == 1000 ? 0 : 1;
}
