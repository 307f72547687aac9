// SPDX-License-Identifier: MIT
// Processes that descend from this one, and their end.
#pragma once

#include <sys/types.h>

#include <functional>

namespace cageproof::judge {

/// Stops, then kills, all descendants of this process of which `doomed` is true, and whatever descends from those,
/// until there are none. Stopping comes first, so that what forks without end does not outrun it. \return how many it
/// killed
int kill_descendants(const std::function<bool(pid_t)>& doomed);

/// Processes and threads that this user has now; 0 where that cannot be told.
int tasks_of_user();

/// Takes all descendants, for a process that started nothing else.
int kill_all_descendants();

}  // namespace cageproof::judge
