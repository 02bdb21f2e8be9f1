// A float in as few digits as distinguish it from all others.
#pragma once

namespace edgescan::files {

/// Writes what std::to_chars(to, end, value) writes, faster where the value is of usual size. Returns the end of the text; there must be
/// room for 64 bytes.
char* writeFloat(char* to, char* end, float value);

} // namespace edgescan::files
