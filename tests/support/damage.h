// Damages a text or binary file as disks, editors and cables do.
#pragma once

#include <algorithm>
#include <random>
#include <string>

namespace edgescan::test {

/// Another byte, a byte that numbers are made of, some bytes gone, some twice: by the round; every second one near the beginning.
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
