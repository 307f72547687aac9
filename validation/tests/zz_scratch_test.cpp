#include "cageproof/core/embedded_cages.h"
#include "cageproof/validation/block_campaign.h"
#include "cageproof/validation/verdicts.h"
#include "stand_in.h"
#include <gtest/gtest.h>
#include <fmt/format.h>
#include <chrono>
#include <ctime>
namespace cageproof::validation {
namespace {
const RegisterWholeEvaluation r{stand_in<nullptr>("scratch")};
struct Plain {};
TEST(scratch, study) {
  const char* cagename = getenv("CAGE") ? getenv("CAGE") : "cube";
  const char* ev = getenv("EV") ? getenv("EV") : "scratch";
  int points = getenv("POINTS") ? atoi(getenv("POINTS")) : 48;
  std::string kinds = getenv("KINDS") ? getenv("KINDS") : "";
  const Cage cage = embedded_cage(cagename);
  for (const CoordinateKind& kind : coordinate_kinds()) {
    if (!kind.is_sum() || !accepts(kind, cage) || kind.name == "biharmonic_affine") continue;
    if (!kinds.empty() && kinds != kind.name) continue;
    BlockErrors errors(cage, kind, ev, Triangulation::Shortest);
    const CageLocator locator(cage, Triangulation::Shortest, kind.keeps_quads);
    auto samples = cage_samples(errors.coordinates(), cage, locator, 1, points);
    const auto t0 = clock();
    std::map<std::string, std::array<double, 3>> worst;
    std::map<std::string, std::array<int, 3>> count;
    std::map<std::string, int> lost;
    for (const auto& s : samples) {
      const auto f = errors.at(s);
      if (!f.truth_reached) {
        ++lost[std::string(s.place)];
        fmt::print("lost {} {} {} {},{},{}\n", kind.name, s.place, s.parameter, s.point[0], s.point[1], s.point[2]);
      }
      if (!f.is_input) fmt::print("no input {} {}\n", s.place, s.parameter);
      for (int o = 0; o < 3; ++o)
        if (!std::isnan(f.errors[o].roundings)) {
          auto& w = worst[std::string(s.place)][o];
          w = std::max(w, f.errors[o].roundings);
          ++count[std::string(s.place)][o];
          if (getenv("V") && f.errors[o].roundings > 8)
            fmt::print("  {} {} {} o{} {:.3g}\n", kind.name, s.place, s.parameter, o, f.errors[o].roundings);
        }
    }
    fmt::print("{} {} {} points, {:.2f} s\n", cagename, kind.name, samples.size(),
               double(clock() - t0) / CLOCKS_PER_SEC);
    for (auto& [place, w] : worst)
      fmt::print("   {:12} {:10.3g} {:10.3g} {:10.3g}   n {} {} {} lost {}\n", place, w[0], w[1], w[2], count[place][0],
                 count[place][1], count[place][2], lost[place]);
  }
}
}  // namespace
}  // namespace cageproof::validation
