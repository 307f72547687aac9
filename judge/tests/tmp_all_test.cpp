#include "cageproof/judge/verdict.h"
#include <gtest/gtest.h>
#include <chrono>
namespace cageproof::judge {
TEST(tmp, all) {
  for (const Formula& f : catalogue())
    if (std::getenv("F") == nullptr || f.name.find(std::getenv("F")) == 0)
      for (const char* name : {"plain", "closed_form", "hybrid", "accurate", "line_form", "published", "gauss-8",
                               "gauss-64", "near-singular-8", "three-quad-8"}) {
        const auto e = EvaluationRegister::instance().find(f.name, name);
        if (!e || !e->supports<double>()) continue;
        const auto t0 = std::chrono::steady_clock::now();
        const Verdict v = judge(*e, {.max_order = f.element == ElementKind::Quad ? 0 : 1});
        std::cout << f.name << ' ' << name << ' '
                  << std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count()
                  << " s: " << v.convention_sentence << " |";
        for (const auto& x : v.findings) {
          std::cout << "\n     " << x.defect->key << " order " << x.order << " cases " << x.cases << " " << x.evidence
                    << "\n       ";
          for (const auto& c : x.input.corners) std::cout << " [" << c.transpose() << ']';
          std::cout << " at " << x.input.point.transpose() << " ours " << (x.ours.empty() ? 0 : x.ours[0]) << " theirs "
                    << (x.theirs.empty() ? 0 : x.theirs[0]);
        }
        std::cout << std::endl;
      }
}
}  // namespace cageproof::judge
