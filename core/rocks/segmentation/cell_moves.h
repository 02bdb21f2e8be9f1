// Cells that move to other segments, all at once after a pass that read the segments before it.
#pragma once

#include "core/base/bands.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::rocks {

struct CellMove {
    int line, beam;
    std::uint32_t segment; ///< the one that it moves to
};
/// What madeOfParts() made of the lines.
using CellMoves = std::vector<std::vector<CellMove>>;

/// Calls apply(move) for each move, where apply writes no line that is more than `reach` lines away: never on two threads for neighbouring
/// parts of the lines.
template <class Apply>
void eachMove(const CellMoves& moves, int lines, int reach, int threads, const Apply& apply) {
    const auto ofPart = [&](int part) {
        for (const CellMove& move : moves[static_cast<std::size_t>(part)]) apply(move);
    };
    const auto parts = static_cast<int>(moves.size());
    if (threads <= 1 || lines / std::max(1, parts) <= 2 * reach) {
        for (int part = 0; part < parts; ++part) ofPart(part);
        return;
    }
    runInParallel((parts + 1) / 2, [&](int n) { ofPart(2 * n); });
    runInParallel(parts / 2, [&](int n) { ofPart(2 * n + 1); });
}

} // namespace edgescan::rocks
