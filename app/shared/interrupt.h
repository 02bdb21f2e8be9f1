// Handles Ctrl+C without ending the program at once, so that a command can finish its files.
#pragma once

namespace edgescan::cli {

/// After this call a file beyond the system's limit (ulimit -f) is a write error; it no longer ends the program.
void surviveFileLimit();

/// After this call Ctrl+C, SIGTERM and the end of the terminal (SIGHUP, unless it is ignored as with nohup) only set the flag that
/// interrupted() returns.
void catchInterrupt();
[[nodiscard]] bool interrupted();

} // namespace edgescan::cli
