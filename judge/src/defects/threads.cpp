// SPDX-License-Identifier: MIT
#include "defects/threads.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace cageproof::judge {

std::size_t calls_that_differ(const Evaluation& theirs, const std::vector<Block>& blocks, int order) {
  constexpr int calls = 2000;
  constexpr std::chrono::milliseconds limit{200};
  std::vector<std::vector<double>> alone;
  alone.reserve(blocks.size());
  for (const Block& block : blocks) alone.push_back(Desk(theirs, order).ask(block));
  std::atomic<std::size_t> differ{0};
  const auto end = std::chrono::steady_clock::now() + limit;
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < blocks.size(); ++t)
    threads.emplace_back([&, t] {
      Desk desk(theirs, order);
      for (int call = 0; call < calls && std::chrono::steady_clock::now() < end; ++call)
        if (!same(alone[t], desk.ask(blocks[t]))) ++differ;
    });
  threads.clear();
  return differ;
}

}  // namespace cageproof::judge
