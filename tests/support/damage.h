// Damages a text or binary file like faults of disks, editors and cables.
#pragma once

#include <algorithm>
#include <random>
#include <string>

namespace edgescan::test {

/// The round decides: another byte, a byte that numbers consist of, some bytes deleted, some doubled; every second damage is near the
/// beginning.
inline std::string damaged(std::string text, std::mt19937& random, int round) {
    for (auto flips = 1 + random() % 5; flips > 0 && !text.empty(); --flips) {
        const std::size_t at = random() % (round % 2 == 0 ? text.size() : std::min<std::size_t>(text.size(), 500));
        if (round % 4 == 0)
            text[at] = static_cast<char>(random());
        else if (round % 4 == 1)
            text[at] = "0123456789-e. \n\xff\x7f"[random() % 17];
        else if (round % 4 == 2)
            text.erase(at, 1 + random() % 5);
        else
            text.insert(at, text.substr(random() % text.size(), 1 + random() % 9));
    }
    return text;
}

} // namespace edgescan::test
