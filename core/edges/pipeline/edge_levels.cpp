// Counts the edges at all thresholds in one pass: the cells join their chains in descending order of their levels.
#include "core/edges/pipeline/edge_levels.h"

namespace edgescan::edges {
namespace {

struct WeakCell {
    std::uint32_t cell;
    std::uint8_t weak, strong;
    bool counted;
};

// The cells that are weak somewhere, highest level first.
std::vector<WeakCell> weakCells(const EdgeLevels& levels) {
    std::array<std::uint32_t, kMostLevels + 1> next{}; // by level: first its number of cells, then the place of its next cell
    for (const std::uint8_t level : levels.weak.cells) ++next[level];
    std::uint32_t above = 0;
    for (std::size_t n = kMostLevels; n > 0; --n) above += std::exchange(next[n], above);
    std::vector<WeakCell> cells(above);
    auto apart = levels.apart.begin();
    for (std::uint32_t k = 0; k < levels.weak.size(); ++k) {
        const bool isApart = apart != levels.apart.end() && *apart == k;
        if (isApart) ++apart;
        const std::uint8_t weak = levels.weak[k];
        if (weak != 0) cells[next[weak]++] = {k, weak, levels.strong[k], !isApart};
    }
    return cells;
}

struct Chain {
    std::uint32_t in; // itself, or the chain that it was joined to
    std::uint32_t length = 0, counted = 0;
    std::uint8_t strongest = 0;
};

std::uint32_t wholeOf(std::vector<Chain>& chains, std::uint32_t n) {
    while (chains[n].in != n) n = chains[n].in = chains[chains[n].in].in;
    return n;
}

} // namespace

LevelScale::LevelScale(std::vector<double> limits) : limits_(std::move(limits)), perUnit_(0.0) {
    if (limits_.back() > 0) perUnit_ = static_cast<double>(kPlaces) / limits_.back();
    for (const double limit : limits_) {
        for (std::size_t place = placeOf(limit) + 1; place <= kPlaces; ++place) ++before_[place];
    }
}

std::vector<std::size_t> edgeCounts(const EdgeLevels& levels, std::size_t thresholds) {
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    const int lines = levels.weak.lines, beams = levels.weak.beams;
    std::vector<Chain> chains;
    Grid<std::uint32_t> chainOf(lines, beams, kNone);
    // By level: how many more edges there are from it down. A chain that grows is taken out and put in again.
    std::vector<std::int64_t> more(thresholds + 1, 0);
    const auto change = [&](const Chain& chain, std::uint8_t level, std::int64_t sign) {
        if (chain.length >= static_cast<std::uint32_t>(std::max(levels.minimumLength, 1)))
            more[std::min(chain.strongest, level)] += sign * chain.counted;
    };
    for (const WeakCell& next : weakCells(levels)) {
        const int line = static_cast<int>(next.cell / static_cast<std::uint32_t>(beams));
        const int beam = static_cast<int>(next.cell % static_cast<std::uint32_t>(beams));
        std::uint32_t own = kNone;
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, lines - 1); ++i) {
            for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, beams - 1); ++j) {
                std::uint32_t other = chainOf.at(i, j);
                if (other == kNone || other == own) continue;
                other = wholeOf(chains, other);
                if (other == own) continue;
                change(chains[other], next.weak, -1);
                if (own == kNone) {
                    own = other;
                    continue;
                }
                if (chains[own].length < chains[other].length) std::swap(own, other);
                chains[other].in = own;
                chains[own].length += chains[other].length;
                chains[own].counted += chains[other].counted;
                chains[own].strongest = std::max(chains[own].strongest, chains[other].strongest);
            }
        }
        if (own == kNone) {
            own = static_cast<std::uint32_t>(chains.size());
            chains.push_back({own});
        }
        chainOf[next.cell] = own;
        ++chains[own].length;
        chains[own].counted += next.counted ? 1 : 0;
        chains[own].strongest = std::max(chains[own].strongest, next.strong);
        change(chains[own], next.weak, 1);
    }
    std::vector<std::size_t> counts(thresholds);
    auto edges = static_cast<std::int64_t>(levels.atEach);
    for (std::size_t n = thresholds; n > 0; --n) counts[n - 1] = static_cast<std::size_t>(edges += more[n]);
    return counts;
}

} // namespace edgescan::edges
