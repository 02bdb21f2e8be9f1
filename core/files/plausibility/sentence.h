// A sentence with its numbers apart, so that a window can say it in another language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// `pattern` with %1 to %9 replaced by `values`; what has no value stays. UTF-8.
[[nodiscard]] std::string filledIn(std::string_view pattern, const std::vector<std::string>& values);

struct Sentence {
    const char* pattern = "";          ///< English, with %1 for the first value; empty: nothing is said
    std::vector<std::string> values{}; ///< numbers, or what a file says of itself: never translated

    [[nodiscard]] bool empty() const { return *pattern == '\0'; }
    [[nodiscard]] std::string text() const { return filledIn(pattern, values); }
};

} // namespace edgescan::files
