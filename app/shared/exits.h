// The way out of a program: what is said on stdout and stderr. Nothing else in app/ writes there (tests/cli/exits_test.cpp), so that no
// text of a file or name can reach a terminal as it is.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace edgescan::cli {

// What the programs end with.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1;    ///< an input was refused or unreadable, or an output could not be written
inline constexpr int kWrongUsage = 2; ///< the command line itself is wrong

/// What stands before each sentence on stderr; "edgescan-cli" unless it is said.
void setProgramName(const std::string& name);

/// "edgescan-cli: SENTENCE" on stderr.
void complain(const Error& error);
void complain(const std::string& sentence);

/// Where results go that are no file of their own: standard output ("-", "-.pcd"), or a device.
[[nodiscard]] inline bool goesToNoFile(const std::string& path) { return path.starts_with("-") || path.starts_with("/dev/"); }

/// Results on stdout: lines of our own, in which what comes from outside is made printable.
void say(const std::string& text);
/// A report as one line of JSON, or indented.
void say(const nlohmann::ordered_json& report, bool indented);

/// False when what was said on stdout so far did not get there.
[[nodiscard]] bool everythingWasSaid();

/// A line on stderr that is written over by the next one, or left at its end when it is the `last`.
void tellProgress(const std::string& text, bool last = false);

/// What `work` gives; `failed` and a sentence where an exception ends it: no memory, or something that no message was written for.
int guarded(const std::function<int()>& work, int failed);

} // namespace edgescan::cli
