// Walks along the edge map from ends and junctions, then around what is closed.
#include "core/files/formats/edge_chains.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace edgescan::files {
namespace {

constexpr float kJumpShare = 0.03F;
constexpr float kLeastJumpMm = 50.0F;
constexpr std::size_t kNone = ~std::size_t{0};

struct Step {
    int line, beam;
};
/// The opposite of direction d is 7 - d; 1, 3, 4 and 6 are along line and beam.
constexpr std::array<Step, 8> kSteps{{{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};
constexpr std::array<unsigned, 4> kStraight{1, 3, 4, 6};

class EdgeMap {
public:
    explicit EdgeMap(std::span<const EdgeCell> cells) : cells_(cells), links_(cells.size(), 0) {
        places_.reserve(cells.size());
        for (std::size_t n = 0; n < cells.size(); ++n) places_.emplace(key(cells[n].line, cells[n].beam), n);
        for (std::size_t n = 0; n < cells.size(); ++n) links_[n] = straightLinks(n);
        const std::vector<std::uint8_t> straight = links_;
        for (std::size_t n = 0; n < cells.size(); ++n) links_[n] |= diagonalLinks(n, straight);
    }
    [[nodiscard]] std::size_t neighbour(std::size_t n, unsigned direction) const {
        const std::int64_t line = std::int64_t{cells_[n].line} + kSteps[direction].line;
        const std::int64_t beam = std::int64_t{cells_[n].beam} + kSteps[direction].beam;
        if (line < 0 || beam < 0) return kNone;
        const auto found = places_.find(key(static_cast<std::uint64_t>(line), static_cast<std::uint64_t>(beam)));
        return found == places_.end() ? kNone : found->second;
    }
    /// One bit per direction in which a link goes.
    [[nodiscard]] const std::vector<std::uint8_t>& links() const { return links_; }

private:
    static std::uint64_t key(std::uint64_t line, std::uint64_t beam) { return line << 32U | beam; }
    [[nodiscard]] bool joined(std::size_t a, std::size_t b) const {
        const float nearer = std::min(cells_[a].rangeMm, cells_[b].rangeMm);
        return std::abs(cells_[a].rangeMm - cells_[b].rangeMm) <= std::max(kLeastJumpMm, kJumpShare * nearer);
    }
    [[nodiscard]] bool linked(std::size_t n, unsigned direction) const {
        const std::size_t other = neighbour(n, direction);
        return other != kNone && joined(n, other);
    }
    [[nodiscard]] std::uint8_t straightLinks(std::size_t n) const {
        unsigned bits = 0;
        for (const unsigned d : kStraight) bits |= linked(n, d) ? 1U << d : 0U;
        return static_cast<std::uint8_t>(bits);
    }
    /// A diagonal only where no two straight links go the same way: else every corner would be a triangle.
    [[nodiscard]] std::uint8_t diagonalLinks(std::size_t n, const std::vector<std::uint8_t>& straight) const {
        unsigned bits = 0;
        for (const unsigned d : {0U, 2U, 5U, 7U}) {
            if (!linked(n, d)) continue;
            const unsigned alongLine = kSteps[d].line < 0 ? 1U : 6U;
            const unsigned alongBeam = kSteps[d].beam < 0 ? 3U : 4U;
            const auto goesRound = [&](unsigned first, unsigned then) {
                return (straight[n] >> first & 1U) != 0 && (straight[neighbour(n, first)] >> then & 1U) != 0;
            };
            if (!goesRound(alongLine, alongBeam) && !goesRound(alongBeam, alongLine)) bits |= 1U << d;
        }
        return static_cast<std::uint8_t>(bits);
    }

    std::span<const EdgeCell> cells_;
    std::unordered_map<std::uint64_t, std::size_t> places_;
    std::vector<std::uint8_t> links_;
};

/// Takes links out of `left` as they are walked.
std::vector<std::size_t> walk(const EdgeMap& map, std::vector<std::uint8_t>& left, std::size_t from) {
    std::vector<std::size_t> chain{from};
    std::size_t at = from;
    while (left[at] != 0) {
        const auto direction = static_cast<unsigned>(std::countr_zero(left[at])) & 7U;
        const std::size_t next = map.neighbour(at, direction);
        left[at] = static_cast<std::uint8_t>(left[at] & ~(1U << direction));
        left[next] = static_cast<std::uint8_t>(left[next] & ~(1U << (7 - direction)));
        chain.push_back(next);
        at = next;
        if (at == from || std::popcount(map.links()[at]) != 2) break;
    }
    return chain;
}

} // namespace

std::vector<std::vector<std::size_t>> chainsOf(std::span<const EdgeCell> cells) {
    const EdgeMap map(cells);
    std::vector<std::uint8_t> left = map.links();
    std::vector<std::vector<std::size_t>> chains;
    for (const bool closed : {false, true}) {
        for (std::size_t n = 0; n < cells.size(); ++n) {
            if (!closed && std::popcount(map.links()[n]) == 2) continue;
            while (left[n] != 0) chains.push_back(walk(map, left, n));
        }
    }
    return chains;
}

} // namespace edgescan::files
