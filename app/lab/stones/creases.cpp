// Finds creases.
#include "app/lab/stones/creases.h"

#include "core/base/angles.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace edgescan::lab {
namespace {

constexpr float kSharpDeg = 35.0F, kWeakDeg = 26.0F;
constexpr float kLocal = 0.65F; // a corner turns by at least this share within half of the cells; a round back turns evenly
constexpr int kSpan = 3;        // cells on each side, along lines and beams
constexpr std::size_t kFewestCells = 6;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

struct Direction {
    int line, beam, span;
};

/// Degrees by which the normal turns from `reach` cells before to as many behind.
float turnDeg(const Grid<Eigen::Vector3f>& normals, int line, int beam, const Direction& along, int reach) {
    const int i = reach * along.line, j = reach * along.beam;
    if (!normals.contains(line - i, beam - j) || !normals.contains(line + i, beam + j)) return kUnknown;
    const Eigen::Vector3f& before = normals.at(line - i, beam - j);
    const Eigen::Vector3f& behind = normals.at(line + i, beam + j);
    if (before.isZero() || behind.isZero()) return kUnknown;
    return static_cast<float>(degrees(std::acos(std::clamp(static_cast<double>(before.dot(behind)), -1.0, 1.0))));
}

bool isFree(const Grid<std::uint8_t>& blocked, int line, int beam, const Direction& along) {
    for (int k = -along.span; k <= along.span; ++k) {
        const int i = line + k * along.line, j = beam + k * along.beam;
        if (!blocked.contains(i, j) || blocked.at(i, j) != 0) return false;
    }
    return true;
}

void findAlong(const Direction& along, const Grid<Eigen::Vector3f>& normals, const Grid<std::uint8_t>& blocked, int finer,
               Creases& creases) {
    Grid<float> turns(normals.lines, normals.beams, kUnknown);
    for (int i = 0; i < turns.lines; ++i) {
        for (int j = 0; j < turns.beams; ++j) {
            if (isFree(blocked, i, j, along)) turns.at(i, j) = turnDeg(normals, i, j, along, along.span);
        }
    }
    for (int i = 0; i < turns.lines; ++i) {
        for (int j = 0; j < turns.beams; ++j) {
            const float turn = turns.at(i, j);
            bool largest = turn > kWeakDeg;
            for (int k = -2 * finer; k <= 2 * finer && largest; ++k) {
                const int m = i + k * along.line, n = j + k * along.beam;
                if (turns.contains(m, n) && turns.at(m, n) > turn) largest = false;
            }
            if (!largest) continue;
            creases.weak.at(i, j) = 1;
            const bool local = !(turn < kLocal * turnDeg(normals, i, j, along, 2 * along.span));
            if (turn > kSharpDeg && local) creases.sharp.at(i, j) = 1;
        }
    }
}

/// Removes groups of a few cells.
void removeShort(Grid<std::uint8_t>& mask) {
    Grid<std::uint8_t> seen(mask.lines, mask.beams);
    for (std::size_t first = 0; first < mask.size(); ++first) {
        if (mask[first] == 0 || seen[first] != 0) continue;
        std::vector<std::size_t> group{first};
        seen[first] = 1;
        for (std::size_t n = 0; n < group.size(); ++n) {
            const int line = static_cast<int>(group[n] / static_cast<std::size_t>(mask.beams));
            const int beam = static_cast<int>(group[n] % static_cast<std::size_t>(mask.beams));
            for (int i = line - 1; i <= line + 1; ++i) {
                for (int j = beam - 1; j <= beam + 1; ++j) {
                    if (!mask.contains(i, j) || mask.at(i, j) == 0 || seen.at(i, j) != 0) continue;
                    seen.at(i, j) = 1;
                    group.push_back(mask.index(i, j));
                }
            }
        }
        if (group.size() >= kFewestCells) continue;
        for (const std::size_t k : group) mask[k] = 0;
    }
}

} // namespace

Grid<std::uint8_t> grown(Grid<std::uint8_t> mask, int reach) {
    for (int round = 0; round < reach; ++round) {
        const Grid<std::uint8_t> before = mask;
        for (int i = 0; i < mask.lines; ++i) {
            for (int j = 0; j < mask.beams; ++j) {
                const auto marked = [&](int line, int beam) { return before.contains(line, beam) && before.at(line, beam) != 0; };
                if (marked(i - 1, j) || marked(i + 1, j) || marked(i, j - 1) || marked(i, j + 1)) mask.at(i, j) = 1;
            }
        }
    }
    return mask;
}

Creases creasesOf(const TrueCells& cells, const Grid<Eigen::Vector3f>& normals, const Grid<std::uint8_t>& blocked) {
    Creases creases{{normals.lines, normals.beams}, {normals.lines, normals.beams}};
    const int span = kSpan * cells.finer;
    const int across = std::max(2, static_cast<int>(std::lround(span / 1.4)));
    for (const Direction& along : {Direction{0, 1, span}, Direction{1, 0, span}, Direction{1, 1, across}, Direction{1, -1, across}})
        findAlong(along, normals, blocked, cells.finer, creases);
    removeShort(creases.sharp);
    return creases;
}

} // namespace edgescan::lab
