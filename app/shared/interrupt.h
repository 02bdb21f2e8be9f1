// Ctrl+C as a question, so that a command can end in good order.
#pragma once

namespace edgescan::cli {

/// From now on a file beyond the limit set for files (ulimit -f) is an error of writing, and not the end of the program.
void surviveFileLimit();

/// From now on Ctrl+C and SIGTERM only set what interrupted() tells.
void catchInterrupt();
[[nodiscard]] bool interrupted();

} // namespace edgescan::cli
