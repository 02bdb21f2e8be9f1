// The outputs of a program: stdout and stderr. No other file of app/ writes there (tests/cli/exits_test.cpp), so that text from a file or a
// file name reaches a terminal only with its control characters escaped.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace edgescan::cli {

/// After this call a file beyond the system's limit (ulimit -f) is a write error; it no longer ends the program.
void surviveFileLimit();

/// After this call Ctrl+C, SIGTERM and the end of the terminal (SIGHUP, unless it is ignored as with nohup) only set the flag that
/// interrupted() returns.
void catchInterrupt();
[[nodiscard]] bool interrupted();

// Exit codes of the programs (docs/reference/command-line.md, "Exit codes").
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1;    ///< an input was refused or unreadable, or an output could not be written
inline constexpr int kWrongUsage = 2; ///< the command line itself is wrong
inline constexpr int kDiffers = 3;    ///< a check was made, and what was checked is not as its record or log says
inline constexpr int kPartly = 4;     ///< of several scans some were refused; the others are done

/// The exit code of work on several files.
[[nodiscard]] inline int codeOf(std::size_t done, std::size_t refused) { return refused == 0 ? kDone : done == 0 ? kRefused : kPartly; }

/// Sets the name before each message on stderr; "edgescan-cli" by default.
void setProgramName(const std::string& name);
[[nodiscard]] const std::string& programName();

/// "edgescan-cli: SENTENCE" on stderr.
void printError(const Error& error);
void printError(const std::string& sentence);
/// Prints it too, and returns the exit code.
int failWith(const Error& error, int code = kRefused);

/// True for outputs that are not a named file: standard output ("-", "-.pcd") or a device.
[[nodiscard]] inline bool isStreamOrDevice(const std::string& path) { return path.starts_with("-") || path.starts_with("/dev/"); }

/// The name, the version, the commit and the licence, for --version.
[[nodiscard]] std::string versionText();

/// Prints results on stdout, line by line; control characters of foreign text are escaped.
void printResult(const std::string& text);
/// Prints a report as JSON, on one line or indented.
void printResult(const nlohmann::ordered_json& report, bool indented);

/// Prints a progress line on stderr. The next one overwrites it; the `last` one stays and ends the line.
void showProgress(const std::string& text, bool last = false);

/// Returns the result of `work`. If an exception ends it (out of memory, or an error without its own message), prints a message and returns
/// `failed`.
int guarded(const std::function<int()>& work, int failed);

/// The exit code of a program that prints results: that of `work`, or kRefused if an exception ended it or stdout took not all of them.
int exitCodeOf(const std::function<int()>& work);

} // namespace edgescan::cli
