// Follows the sides of cells around each label.
#include "core/rocks/attributes/outlines.h"

#include "core/rocks/segmentation/basins.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace edgescan::rocks {
namespace {

constexpr std::array<CellCorner, 4> kSideWays{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}}; // east, south, west, north

class RingFollower {
public:
    explicit RingFollower(const Grid<std::uint32_t>& labels) : labels_(labels), followed_(labels.lines, labels.beams) {}

    [[nodiscard]] bool isNew(int line, int beam) const {
        return labels_.at(line, beam) != 0 && labelAt(line - 1, beam) != labels_.at(line, beam) && followed_.at(line, beam) == 0;
    }

    // Starts along the upper side of the cell to the east, with the label on the right, and follows the outline until it returns.
    OutlineRing follow(int line, int beam) {
        const std::uint32_t label = labels_.at(line, beam);
        const CellCorner start{line, beam};
        CellCorner at = start;
        std::size_t way = 0;
        OutlineRing ring;
        std::int64_t area = 0;
        do {
            const CellCorner cell = rightCell(at, way);
            if (way == 0) followed_.at(cell.line, cell.beam) = 1;
            const auto k = static_cast<std::uint32_t>(labels_.index(cell.line, cell.beam));
            if (ring.inside.empty() || ring.inside.back() != k) ring.inside.push_back(k);
            const CellCorner next{at.line + kSideWays[way].line, at.beam + kSideWays[way].beam};
            area += static_cast<std::int64_t>(at.beam) * next.line - static_cast<std::int64_t>(next.beam) * at.line;
            at = next;
            const CellCorner right = rightCell(at, way);
            const CellCorner left = rightCell(at, (way + 3) % 4);
            std::size_t nextWay = way;
            if (labelAt(right.line, right.beam) != label)
                nextWay = (way + 1) % 4;
            else if (labelAt(left.line, left.beam) == label)
                nextWay = (way + 3) % 4;
            if (nextWay != way) ring.corners.push_back(at);
            way = nextWay;
        } while (at != start || way != 0);
        if (ring.inside.size() > 1 && ring.inside.front() == ring.inside.back()) ring.inside.pop_back();
        ring.hole = area < 0;
        return ring;
    }

private:
    // The cell on the right when moving on from the corner.
    static CellCorner rightCell(const CellCorner& corner, std::size_t way) {
        static constexpr std::array<CellCorner, 4> kRight{{{0, 0}, {0, -1}, {-1, -1}, {-1, 0}}};
        return {corner.line + kRight[way].line, corner.beam + kRight[way].beam};
    }
    [[nodiscard]] std::uint32_t labelAt(int line, int beam) const { return labels_.contains(line, beam) ? labels_.at(line, beam) : 0; }

    const Grid<std::uint32_t>& labels_;
    Grid<std::uint8_t> followed_; // 1 where the upper side of the cell was followed
};

// An arbitrary number per connected part (4 neighbours), by cell.
std::vector<std::uint32_t> partsOf(const Grid<std::uint32_t>& labels) {
    JoinedGroups groups(labels.size());
    const auto beams = static_cast<std::size_t>(labels.beams);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (labels[k] == 0) continue;
        if (k % beams + 1 < beams && labels[k + 1] == labels[k])
            groups.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k + 1));
        if (k + beams < labels.size() && labels[k + beams] == labels[k])
            groups.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k + beams));
    }
    std::vector<std::uint32_t> parts(labels.size());
    for (std::uint32_t k = 0; k < parts.size(); ++k) parts[k] = groups.of(k);
    return parts;
}

} // namespace

std::vector<std::vector<OutlineRing>> outlinesOf(const Grid<std::uint32_t>& labels, std::uint32_t most) {
    std::vector<std::vector<OutlineRing>> outlines(static_cast<std::size_t>(most) + 1);
    const std::vector<std::uint32_t> parts = partsOf(labels);
    RingFollower follower(labels);
    for (int i = 0; i < labels.lines; ++i) {
        for (int j = 0; j < labels.beams; ++j) {
            if (!follower.isNew(i, j)) continue;
            OutlineRing ring = follower.follow(i, j);
            ring.part = parts[ring.inside.front()];
            if (labels.at(i, j) <= most) outlines[labels.at(i, j)].push_back(std::move(ring));
        }
    }
    for (std::vector<OutlineRing>& rings : outlines) {
        // The first ring of each part in scan order is its outer ring, so it determines the part's number.
        std::vector<std::uint32_t> names;
        for (OutlineRing& ring : rings) {
            const auto name = std::find(names.begin(), names.end(), ring.part);
            const auto number = static_cast<std::uint32_t>(name - names.begin());
            if (name == names.end()) names.push_back(ring.part);
            ring.part = number;
        }
        std::stable_sort(rings.begin(), rings.end(), [](const OutlineRing& a, const OutlineRing& b) { return a.part < b.part; });
    }
    return outlines;
}

} // namespace edgescan::rocks
