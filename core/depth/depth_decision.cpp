// EdgeScan+'s last step: which cells are edges, and of which class.
#include "core/base/simd.h"
#include "core/depth/depth_edges.h"
#include "core/scan/marked_cells.h"

#include <algorithm>
#include <vector>

namespace edgescan {
namespace {

// 1 for a class that is wanted, else 0.
struct Wanted {
    float jumps, convex, concave;
    explicit Wanted(const DepthEdgeSettings& settings)
        : jumps(settings.jumps ? 1.0F : 0.0F), convex(settings.convex ? 1.0F : 0.0F), concave(settings.concave ? 1.0F : 0.0F) {}

    [[nodiscard]] float strengthOf(float jump, float crease) const {
        return std::max(std::max(jumps * jump, convex * crease), -concave * crease);
    }
};

EDGESCAN_SIMD void strengthsOfCells(const float* jump, const float* crease, std::size_t cells, const Wanted& wanted,
                                    float* __restrict strength) {
    for (std::size_t k = 0; k < cells; ++k) strength[k] = wanted.strengthOf(jump[k], crease[k]);
}

EDGESCAN_SIMD void markAbove(const float* strength, std::size_t cells, float low, std::uint8_t* __restrict marked) {
    for (std::size_t k = 0; k < cells; ++k) marked[k] = strength[k] > low ? 1 : 0;
}

// Cells of `state`: 1 waits, 2 is in the chain that grows, 255 was kept, 0 is none. All that are 1 become 255 or 0.
// Calls keep(cells of the chain) for each chain that is kept.
template <class StrengthAt, class Keep>
void linkChains(Grid<std::uint8_t>& state, float high, int minimum, StrengthAt strengthAt, Keep keep) {
    const auto beams = static_cast<std::uint32_t>(state.beams);
    std::vector<std::uint32_t> chain;
    forEachMarked(state.cells, [&](std::size_t seed) {
        chain.assign(1, static_cast<std::uint32_t>(seed));
        state[seed] = 2;
        bool strong = false;
        for (std::size_t at = 0; at < chain.size(); ++at) {
            strong = strong || strengthAt(chain[at]) > high;
            const int line = static_cast<int>(chain[at] / beams);
            const int beam = static_cast<int>(chain[at] % beams);
            for (int i = std::max(line - 1, 0); i <= std::min(line + 1, state.lines - 1); ++i) {
                for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, state.beams - 1); ++j) {
                    if (state.at(i, j) != 1) continue;
                    state.at(i, j) = 2;
                    chain.push_back(static_cast<std::uint32_t>(state.index(i, j)));
                }
            }
        }
        const bool kept = strong && static_cast<int>(chain.size()) >= minimum;
        for (const std::uint32_t k : chain) state[k] = kept ? 255 : 0;
        if (kept) keep(chain);
    });
}

} // namespace

Grid<std::uint8_t> linkedChains(const Grid<float>& strength, float high, float low, int minimum) {
    Grid<std::uint8_t> state(strength.lines, strength.beams);
    markAbove(strength.cells.data(), strength.size(), low, state.cells.data());
    linkChains(
        state, high, minimum, [&](std::uint32_t k) { return strength[k]; }, [](const auto&) {});
    return state;
}

std::vector<std::uint32_t> longSilhouettes(const DepthResponses& responses, int minimum) {
    constexpr int kReach = 2; // the cells of an outline may be joined by a corner that is void
    std::vector<std::uint32_t> kept, chain;
    if (responses.silhouettes.empty()) return kept;
    Grid<std::uint8_t> waits(responses.jump.lines, responses.jump.beams);
    for (const std::uint32_t k : responses.silhouettes) waits[k] = 1;
    const auto beams = static_cast<std::uint32_t>(waits.beams);
    for (const std::uint32_t seed : responses.silhouettes) {
        if (waits[seed] == 0) continue;
        chain.assign(1, seed);
        waits[seed] = 0;
        for (std::size_t n = 0; n < chain.size(); ++n) {
            const int line = static_cast<int>(chain[n] / beams);
            const int beam = static_cast<int>(chain[n] % beams);
            for (int i = std::max(line - kReach, 0); i <= std::min(line + kReach, waits.lines - 1); ++i) {
                for (int j = std::max(beam - kReach, 0); j <= std::min(beam + kReach, waits.beams - 1); ++j) {
                    if (waits.at(i, j) == 0) continue;
                    waits.at(i, j) = 0;
                    chain.push_back(static_cast<std::uint32_t>(waits.index(i, j)));
                }
            }
        }
        if (static_cast<int>(chain.size()) >= minimum) kept.insert(kept.end(), chain.begin(), chain.end());
    }
    std::ranges::sort(kept);
    return kept;
}

Grid<float> depthStrength(const DepthResponses& responses, const DepthEdgeSettings& settings) {
    Grid<float> strength(responses.jump.lines, responses.jump.beams);
    strengthsOfCells(responses.jump.cells.data(), responses.crease.cells.data(), strength.size(), Wanted(settings), strength.cells.data());
    return strength;
}

DepthEdges decideDepthEdges(const DepthResponses& responses, const DepthEdgeSettings& settings) {
    const int lines = responses.jump.lines;
    const int beams = responses.jump.beams;
    DepthEdges result{Grid<std::uint8_t>(lines, beams), Grid<DepthEdge>(lines, beams, DepthEdge::None), responses.noise};
    const Wanted wanted(settings);
    const auto high = static_cast<float>(settings.sensitivity);
    const float low = high * static_cast<float>(settings.hysteresisLow);
    std::vector<float> strength(static_cast<std::size_t>(beams));
    for (int i = 0; i < lines; ++i) {
        strengthsOfCells(responses.jump.line(i), responses.crease.line(i), strength.size(), wanted, strength.data());
        markAbove(strength.data(), strength.size(), low, result.mask.line(i));
    }
    const auto strengthAt = [&](std::uint32_t k) { return wanted.strengthOf(responses.jump[k], responses.crease[k]); };
    linkChains(result.mask, high, settings.minimumLength, strengthAt, [&](const std::vector<std::uint32_t>& chain) {
        for (const std::uint32_t k : chain) {
            const bool jump = settings.jumps && responses.jump[k] >= strengthAt(k);
            result.kind[k] = jump ? DepthEdge::Jump : responses.crease[k] > 0 ? DepthEdge::Convex : DepthEdge::Concave;
        }
    });
    const auto add = [&result](const std::vector<std::uint32_t>& cells, DepthEdge kind) {
        for (const std::uint32_t k : cells) {
            if (result.mask[k] != 0) continue;
            result.mask[k] = 255;
            result.kind[k] = kind;
        }
    };
    if (settings.silhouettes) add(longSilhouettes(responses, settings.minimumLength), DepthEdge::Silhouette);
    if (settings.border) add(responses.border, DepthEdge::Border);
    return result;
}

} // namespace edgescan
