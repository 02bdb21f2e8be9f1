// Cuts segments along lines of cells.
#include "core/rocks/segmentation/cuts.h"

#include "core/rocks/segmentation/basins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace edgescan::rocks {
namespace {

constexpr int kSideReach = 2;        // distance to the line of the cells that decide which segments are on its sides
constexpr std::uint32_t kMostly = 3; // a segment is on one side if it has this many times as many cells there as on the other

struct LineCell {
    int line, beam;
    int overLine, overBeam; // direction of the stroke at this cell
};

// Cells of the stroke, 8-connected, so that no path along the sides of cells crosses it.
std::vector<LineCell> cellsOf(const CutLine& cut, int lines, int beams) {
    std::vector<LineCell> corners;
    for (const std::uint32_t k : cut) {
        if (k < static_cast<std::uint64_t>(lines) * static_cast<std::uint64_t>(beams))
            corners.push_back(
                {static_cast<int>(k / static_cast<std::uint32_t>(beams)), static_cast<int>(k % static_cast<std::uint32_t>(beams)), 0, 0});
    }
    std::vector<LineCell> cells;
    for (std::size_t n = 1; n < corners.size(); ++n) {
        const LineCell& from = corners[n - 1];
        const int overLine = corners[n].line - from.line;
        const int overBeam = corners[n].beam - from.beam;
        const int steps = std::max(std::abs(overLine), std::abs(overBeam));
        for (int s = 0; s <= steps; ++s) {
            const double share = steps == 0 ? 0.0 : static_cast<double>(s) / steps;
            cells.push_back({from.line + static_cast<int>(std::lround(share * overLine)),
                             from.beam + static_cast<int>(std::lround(share * overBeam)), overLine, overBeam});
        }
    }
    return cells;
}

// Assigns the removed cells to the nearest piece, growing from all pieces at the same time.
void giveBack(const CellLinks& links, const std::vector<std::size_t>& taken, const Grid<std::uint32_t>& before,
              Grid<std::uint32_t>& piece) {
    const auto beams = static_cast<std::size_t>(piece.beams);
    for (bool any = true; any;) {
        any = false;
        std::vector<std::pair<std::size_t, std::uint32_t>> given;
        for (const std::size_t k : taken) {
            if (piece[k] != kNoSegment) continue;
            const auto line = k / beams;
            const auto beam = k % beams;
            const auto look = [&](bool exists, std::size_t there, bool linked) {
                if (!exists || !linked || piece[there] == kNoSegment || before[there] != before[k]) return false;
                given.emplace_back(k, piece[there]);
                return true;
            };
            if (look(line > 0, k - beams, line > 0 && links.toNextLine(k - beams))) continue;
            if (look(beam > 0, k - 1, beam > 0 && links.toNextBeam(k - 1))) continue;
            if (look(beam + 1 < beams, k + 1, beam + 1 < beams && links.toNextBeam(k))) continue;
            look(k + beams < piece.size(), k + beams, k + beams < piece.size() && links.toNextLine(k));
        }
        for (const auto& [k, to] : given) piece[k] = to;
        any = !given.empty();
    }
}

// Cuts the basins like the segments that were made of them; a cell that went to another segment follows its neighbours.
void cutBasins(const CellLinks& links, const std::vector<std::uint8_t>& isCut, const Grid<std::uint32_t>& before,
               const Grid<std::uint32_t>& after, Grid<std::uint32_t>& basins) {
    Grid<std::uint32_t> piece(basins.lines, basins.beams);
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < basins.size(); ++k) {
        if (isCut[basins[k]] == 0) continue;
        if (before[k] == basins[k])
            piece[k] = after[k];
        else
            moved.push_back(k);
    }
    giveBack(links, moved, basins, piece);
    for (std::size_t k = 0; k < basins.size(); ++k) {
        if (piece[k] != kNoSegment) basins[k] = piece[k];
    }
}

} // namespace

std::vector<std::uint32_t> strokeCells(const CutLine& line, int lines, int beams) {
    std::vector<std::uint32_t> cells;
    for (const LineCell& cell : cellsOf(line, lines, beams)) {
        const std::uint32_t k =
            static_cast<std::uint32_t>(cell.line) * static_cast<std::uint32_t>(beams) + static_cast<std::uint32_t>(cell.beam);
        if (cells.empty() || cells.back() != k) cells.push_back(k);
    }
    return cells;
}

std::uint32_t cutSegments(const CellLinks& links, const CutLine& cut, std::uint32_t count, Grid<std::uint32_t>& segment,
                          Grid<std::uint32_t>* basins, std::vector<std::uint32_t>* cutFrom) {
    std::vector<std::size_t> taken;
    Grid<std::uint8_t> isTaken(segment.lines, segment.beams);
    std::vector<std::uint8_t> isCut(static_cast<std::size_t>(count) + 1);
    for (const std::uint32_t k : strokeCells(cut, segment.lines, segment.beams)) {
        if (segment[k] == kNoSegment || std::exchange(isTaken[k], std::uint8_t{1}) != 0) continue;
        taken.push_back(k);
        isCut[segment[k]] = 1;
    }
    if (taken.empty()) return count;
    const auto beams = static_cast<std::size_t>(segment.beams);
    JoinedGroups groups(segment.size());
    const auto join = [&](std::size_t k, std::size_t next, bool linked) {
        if (linked && segment[k] == segment[next] && isTaken[k] == 0 && isTaken[next] == 0)
            groups.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(next));
    };
    std::vector<std::size_t> crossed; // the cells of the segments that are cut
    for (std::size_t k = 0; k < segment.size(); ++k) {
        if (isCut[segment[k]] == 0) continue;
        crossed.push_back(k);
        if (k % beams + 1 < beams) join(k, k + 1, links.toNextBeam(k));
        if (k + beams < segment.size()) join(k, k + beams, links.toNextLine(k));
    }
    Grid<std::uint32_t> piece(segment.lines, segment.beams);
    for (const std::size_t k : crossed) piece[k] = isTaken[k] != 0 ? kNoSegment : groups.of(static_cast<std::uint32_t>(k)) + 1;
    giveBack(links, taken, segment, piece);
    std::vector<std::uint32_t> name(segment.size() + 1, kNoSegment), kept(isCut.size(), kNoSegment);
    Grid<std::uint32_t> after = segment;
    for (const std::size_t k : crossed) {
        if (piece[k] == kNoSegment) piece[k] = static_cast<std::uint32_t>(k) + 1; // a part that consists only of stroke cells
        std::uint32_t& of = name[piece[k]];
        if (of == kNoSegment && std::exchange(kept[segment[k]], 1) == kNoSegment) {
            of = segment[k];
        } else if (of == kNoSegment) {
            of = ++count;
            if (cutFrom != nullptr) cutFrom->push_back((*cutFrom)[segment[k]]);
        }
        after[k] = of;
    }
    if (basins != nullptr) cutBasins(links, isCut, segment, after, *basins);
    segment = std::move(after);
    return count;
}

std::vector<SegmentPair> segmentsAcross(const Grid<std::uint32_t>& segment, std::span<const SegmentBorder> borders,
                                        std::span<const CutLine> cuts) {
    std::vector<SegmentPair> pairs;
    for (const CutLine& cut : cuts) {
        std::map<std::uint32_t, std::array<std::uint32_t, 2>> sides; // number of cells on each side of the stroke, by segment
        for (const LineCell& cell : cellsOf(cut, segment.lines, segment.beams)) {
            for (int i = cell.line - kSideReach; i <= cell.line + kSideReach; ++i) {
                for (int j = cell.beam - kSideReach; j <= cell.beam + kSideReach; ++j) {
                    const int side = (i - cell.line) * cell.overBeam - (j - cell.beam) * cell.overLine;
                    if (side != 0 && segment.contains(i, j) && segment.at(i, j) != kNoSegment) ++sides[segment.at(i, j)][side > 0 ? 1 : 0];
                }
            }
        }
        const auto sideOf = [&](std::uint32_t l) {
            const auto found = sides.find(l);
            if (found == sides.end()) return -1;
            const auto [one, other] = found->second;
            return one > kMostly * other ? 0 : other > kMostly * one ? 1 : -1;
        };
        for (const SegmentBorder& border : borders) {
            const int a = sideOf(border.a);
            const int b = sideOf(border.b);
            if (a >= 0 && b >= 0 && a != b) pairs.push_back({border.a, border.b, false});
        }
    }
    return pairs;
}

} // namespace edgescan::rocks
