// EdgeScan+'s last step: decides which cells are edges, and of which class.
#include "core/base/bands.h"
#include "core/base/simd.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/method_traits.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <vector>

namespace edgescan::edges {
namespace {

// State of a cell before chains are linked.
constexpr std::uint8_t kWaits = 1; // strong enough for a chain
constexpr std::uint8_t kStrong = 2;
constexpr std::uint8_t kJump = 4;
constexpr std::uint8_t kConvex = 8;

// 1 for a requested class, otherwise 0.
struct Wanted {
    float jumps, convex, concave;
    explicit Wanted(const Settings& settings)
        : jumps(wants(settings, kClassJump) ? 1.0F : 0.0F), convex(wants(settings, kClassConvex) ? 1.0F : 0.0F),
          concave(wants(settings, kClassConcave) ? 1.0F : 0.0F) {}

    [[nodiscard]] float strengthOf(float jump, float crease) const {
        return std::max(std::max(jumps * jump, convex * crease), -concave * crease);
    }
};

EDGESCAN_INLINE void strengthsOfCells(const float* jump, const float* crease, std::size_t cells, const Wanted& wanted,
                                      float* __restrict strength) {
    for (std::size_t k = 0; k < cells; ++k) strength[k] = wanted.strengthOf(jump[k], crease[k]);
}

EDGESCAN_INLINE void markAbove(const float* strength, std::size_t cells, float high, float low, std::uint8_t* __restrict state) {
    for (std::size_t k = 0; k < cells; ++k)
        state[k] = static_cast<std::uint8_t>((strength[k] > low ? kWaits : 0) | (strength[k] > high ? kStrong : 0));
}

// The same from the responses, and the class.
EDGESCAN_INLINE void markClasses(const float* jump, const float* crease, std::size_t cells, const Wanted& wanted, float high, float low,
                                 std::uint8_t* __restrict state) {
    for (std::size_t k = 0; k < cells; ++k) {
        const float strength = wanted.strengthOf(jump[k], crease[k]);
        const int strong = (strength > low ? kWaits : 0) | (strength > high ? kStrong : 0);
        const int kind = (wanted.jumps > 0 && jump[k] >= strength ? kJump : 0) | (crease[k] > 0 ? kConvex : 0);
        state[k] = static_cast<std::uint8_t>(strength > low ? strong | kind : 0);
    }
}

// A growing chain: its cells and their states.
class Chain {
public:
    explicit Chain(Grid<std::uint8_t>& state)
        : state_(state.cells.data()), lines_(static_cast<std::uint32_t>(state.lines)), beams_(static_cast<std::uint32_t>(state.beams)) {}

    [[nodiscard]] std::span<const std::uint32_t> cells() const { return {cells_.data(), size_}; }
    [[nodiscard]] std::span<const std::uint8_t> known() const { return {known_.data(), size_}; }

    /// Collects all waiting cells connected with the seed and clears their state. Returns whether one of them is strong.
    bool grow(std::uint32_t seed) {
        size_ = 0;
        if (cells_.empty()) makeRoom();
        addCell(seed);
        std::uint8_t any = 0;
        for (std::size_t at = 0; at < size_; ++at) {
            any |= known_[at];
            if (size_ + kAround > cells_.size()) makeRoom();
            addNeighbours(cells_[at]);
        }
        return (any & kStrong) != 0;
    }

private:
    static constexpr std::size_t kAround = 8;

    void makeRoom() {
        cells_.resize(2 * cells_.size() + 64);
        known_.resize(cells_.size());
    }
    void addCell(std::uint32_t k) {
        cells_[size_] = k;
        known_[size_++] = state_[k];
        state_[k] = 0;
    }
    // Takes the waiting neighbours of a cell. Inside the grid the three cells of a line are checked together.
    void addNeighbours(std::uint32_t k) {
        const std::uint32_t line = k / beams_;
        const std::uint32_t beam = k % beams_;
        if (line > 0 && line + 1 < lines_ && beam > 0 && beam + 2 < beams_) {
            for (std::uint32_t first = k - beams_ - 1; first <= k + beams_ - 1; first += beams_) {
                for (std::uint32_t waits = waitingOfThree(first); waits != 0; waits &= waits - 1)
                    addCell(first + static_cast<std::uint32_t>(std::countr_zero(waits)) / 8);
            }
            return;
        }
        for (std::uint32_t i = line - (line > 0 ? 1 : 0); i <= std::min(line + 1, lines_ - 1); ++i) {
            for (std::uint32_t j = beam - (beam > 0 ? 1 : 0); j <= std::min(beam + 1, beams_ - 1); ++j) {
                if (state_[i * beams_ + j] != 0) addCell(i * beams_ + j);
            }
        }
    }
    // The bits of three cells, each in its own byte.
    [[nodiscard]] std::uint32_t waitingOfThree(std::uint32_t first) const {
        std::uint32_t four = 0;
        std::memcpy(&four, state_ + first, sizeof four);
        return four & 0x00010101U;
    }

    std::uint8_t* state_;
    std::uint32_t lines_, beams_;
    std::size_t size_ = 0;
    std::vector<std::uint32_t> cells_;
    std::vector<std::uint8_t> known_;
};
static_assert(std::endian::native == std::endian::little && kWaits == 1);

// The first cell from `k` on that is not 0, or the end.
std::size_t nextWaiting(const std::vector<std::uint8_t>& cells, std::size_t k) {
    std::uint64_t eight = 0;
    for (; k + sizeof eight <= cells.size(); k += sizeof eight) {
        std::memcpy(&eight, cells.data() + k, sizeof eight);
        if (eight != 0) break;
    }
    while (k < cells.size() && cells[k] == 0) ++k;
    return k;
}

// Calls keep(chain) for each chain of cells that is long enough and has a strong cell. All cells become 0.
template <class Keep>
void linkChains(Grid<std::uint8_t>& state, int minimum, Keep keep) {
    Chain chain(state);
    for (std::size_t seed = nextWaiting(state.cells, 0); seed < state.size(); seed = nextWaiting(state.cells, seed)) {
        const bool strong = chain.grow(static_cast<std::uint32_t>(seed));
        if (strong && static_cast<int>(chain.cells().size()) >= minimum) keep(chain);
    }
}

// The cells in chains of at least `minimum` cells, ascending. Two cells at most two cells apart are linked: an edge may be connected over
// the corner of a void.
std::vector<std::uint32_t> longChains(const std::vector<std::uint32_t>& cells, int lines, int beams, int minimum) {
    constexpr int kReach = 2;
    std::vector<std::uint32_t> kept, chain;
    if (cells.empty()) return kept;
    Grid<std::uint8_t> waits(lines, beams);
    for (const std::uint32_t k : cells) waits[k] = 1;
    for (const std::uint32_t seed : cells) {
        if (waits[seed] == 0) continue;
        chain.assign(1, seed);
        waits[seed] = 0;
        for (std::size_t n = 0; n < chain.size(); ++n) {
            const int line = static_cast<int>(chain[n]) / beams;
            const int beam = static_cast<int>(chain[n]) % beams;
            for (int i = std::max(line - kReach, 0); i <= std::min(line + kReach, lines - 1); ++i) {
                for (int j = std::max(beam - kReach, 0); j <= std::min(beam + kReach, beams - 1); ++j) {
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

} // namespace

Grid<std::uint8_t> linkedChains(const Grid<float>& strength, float high, float low, int minimum) {
    Grid<std::uint8_t> state(strength.lines, strength.beams);
    vectorised<markAbove>(strength.cells.data(), strength.size(), high, low, state.cells.data());
    std::vector<std::uint32_t> kept;
    linkChains(state, minimum, [&](const Chain& chain) { kept.insert(kept.end(), chain.cells().begin(), chain.cells().end()); });
    for (const std::uint32_t k : kept) state[k] = 255;
    return state;
}

std::vector<ClassCells> edgesAtVoids(const DepthResponses& responses, const Settings& settings) {
    const auto chains = [&](const std::vector<std::uint32_t>& cells) {
        return longChains(cells, responses.jump->lines, responses.jump->beams, settings.minimumLength);
    };
    std::vector<ClassCells> edges;
    if (wants(settings, kClassSilhouette)) edges.push_back({DepthEdge::Silhouette, chains(responses.silhouettes)});
    if (wants(settings, kClassVoidRim)) edges.push_back({DepthEdge::VoidRim, chains(responses.rim)});
    if (wants(settings, kClassBorder)) edges.push_back({DepthEdge::Border, responses.border});
    return edges;
}

Grid<float> requestedStrength(const DepthResponses& responses, const Settings& settings) {
    Grid<float> strength(responses.jump->lines, responses.jump->beams);
    vectorised<strengthsOfCells>(responses.jump->cells.data(), responses.crease.cells.data(), strength.size(), Wanted(settings),
                                 strength.cells.data());
    return strength;
}

void requestedStrengthsOfLine(const DepthResponses& responses, const Settings& settings, int line, float* strengths) {
    vectorised<strengthsOfCells>(responses.jump->line(line), responses.crease.line(line), static_cast<std::size_t>(responses.jump->beams),
                                 Wanted(settings), strengths);
}

float requestedStrengthAt(const DepthResponses& responses, const Settings& settings, std::size_t k) {
    float strength = 0;
    strengthsOfCells(&(*responses.jump)[k], &responses.crease[k], 1, Wanted(settings), &strength);
    return strength;
}

DepthEdges decideDepthEdges(const DepthResponses& responses, const Settings& settings, int threads) {
    const int lines = responses.jump->lines;
    const int beams = responses.jump->beams;
    const int bands = bandsFor(responses.jump->size(), threads);
    DepthEdges result{Grid<std::uint8_t>(lines, beams), Grid<DepthEdge>(lines, beams, DepthEdge::None), responses.noise};
    const Wanted wanted(settings);
    const auto high = static_cast<float>(settings.sensitivity);
    const float low = high * static_cast<float>(settings.hysteresisPercent / 100.0);
    runInBands(lines, bands, [&](int first, int last) {
        const std::size_t from = result.mask.index(first, 0);
        vectorised<markClasses>(responses.jump->cells.data() + from, responses.crease.cells.data() + from,
                                result.mask.index(last, 0) - from, wanted, high, low, result.mask.cells.data() + from);
    });
    std::vector<std::uint32_t> kept;
    std::vector<ClassCells> atVoids;
    const auto link = [&] {
        linkChains(result.mask, settings.minimumLength, [&](const Chain& chain) {
            kept.insert(kept.end(), chain.cells().begin(), chain.cells().end());
            for (std::size_t n = 0; n < chain.cells().size(); ++n) {
                const std::uint8_t known = chain.known()[n];
                const DepthEdge crease = (known & kConvex) != 0 ? DepthEdge::Convex : DepthEdge::Concave;
                result.kind[chain.cells()[n]] = (known & kJump) != 0 ? DepthEdge::Jump : crease;
            }
        });
    };
    runParts(bands, {link, [&] { atVoids = edgesAtVoids(responses, settings); }});
    for (const std::uint32_t k : kept) result.mask[k] = 255;
    for (const ClassCells& edges : atVoids) {
        for (const std::uint32_t k : edges.cells) {
            if (result.mask[k] != 0) continue;
            result.mask[k] = 255;
            result.kind[k] = edges.kind;
        }
    }
    return result;
}

} // namespace edgescan::edges
