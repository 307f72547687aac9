// SPDX-License-Identifier: MIT
// Ends the program by the signal that arrived, and removes unfinished files.
#pragma once

namespace cageproof::reports {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE first remove what this process has written aside and not yet put in
/// its place, then end it as they would have. Those that are ignored stay so (nohup). SIGXFSZ is ignored: a file beyond
/// `ulimit -f` is an error of its write.
void end_cleanly_on_signals();

/// Does not return when such a signal has arrived: errors after it are its effects, and are not reported.
void wait_if_ending();

}  // namespace cageproof::reports
