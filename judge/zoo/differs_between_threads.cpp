// SPDX-License-Identifier: MIT
// Keeps the corners in memory that all threads share while it computes.
#include "sound.h"

#include <atomic>
#include <thread>

using namespace cageproof::zoo;

extern "C" void zoo_differs_between_threads(const zoo_call* call) {
  static std::array<std::atomic<double>, 9> shared;
  const int count = 3 * corners(*call);
  for (int i = 0; i < count; ++i) shared[static_cast<std::size_t>(i)] = call->corners[i];
  std::this_thread::yield();
  std::array<double, 9> mine{};
  for (int i = 0; i < count; ++i) mine[static_cast<std::size_t>(i)] = shared[static_cast<std::size_t>(i)];
  zoo_call with_shared = *call;
  with_shared.corners = mine.data();
  zoo_sound(&with_shared);
}
