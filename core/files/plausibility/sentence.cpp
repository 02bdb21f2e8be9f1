// Values into their places.
#include "core/files/plausibility/sentence.h"

namespace edgescan::files {

std::string filledIn(std::string_view pattern, const std::vector<std::string>& values) {
    std::string text;
    for (std::size_t n = 0; n < pattern.size(); ++n) {
        const bool named = pattern[n] == '%' && n + 1 < pattern.size() && pattern[n + 1] >= '1' && pattern[n + 1] <= '9';
        const std::size_t which = named ? static_cast<std::size_t>(pattern[n + 1] - '1') : 0;
        if (!named || which >= values.size()) {
            text += pattern[n];
            continue;
        }
        text += values[which];
        ++n;
    }
    return text;
}

} // namespace edgescan::files
