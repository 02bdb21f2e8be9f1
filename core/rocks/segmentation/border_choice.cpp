// Asks the network in passes, line by line.
#include "core/rocks/segmentation/border_choice.h"

#include "core/base/bands.h"
#include "core/rocks/segmentation/border_features.h"
#include "core/rocks/segmentation/merge_tree.h"

#include <algorithm>
#include <array>
#include <functional>

namespace edgescan::rocks {
namespace {

constexpr double kSettledLevel = -2.0; // of two segments that are one region from here on, the border is not decided again
constexpr int kNear = 2;               // cells around a move that are asked again

struct Move {
    int line, beam;
    std::uint32_t to;
};

class BorderChoice {
public:
    BorderChoice(const Inputs& inputs, std::span<const std::uint32_t> groups, const BorderNetwork& network, Grid<std::uint32_t>& segment,
                 const BorderWatch& watch)
        : groups_(groups), network_(network), segment_(segment), watch_(watch), cells_(inputs.surface->inverse, segment),
          features_(inputs, cells_), asked_(segment.lines, segment.beams) {
        for (int i = 0; i < segment.lines; ++i) {
            const std::size_t at = cells_.index(i, 0);
            for (std::size_t j = 0; j < static_cast<std::size_t>(segment.beams); ++j)
                asked_.line(i)[j] = static_cast<std::uint8_t>((cells_.inner[at + j] == kNoSegment) & (cells_.solid[at + j] != kVoidCell));
        }
    }

    // False if nothing moved.
    bool pass(int bands) {
        std::vector<std::vector<Move>> moves(static_cast<std::size_t>(bands));
        std::vector<std::function<void()>> parts;
        for (int band = 0; band < bands; ++band)
            parts.emplace_back([&, band] {
                const int last = firstLineOfBand(segment_.lines, bands, band + 1);
                for (int i = firstLineOfBand(segment_.lines, bands, band); i < last; ++i) lookAt(i, moves[static_cast<std::size_t>(band)]);
            });
        runParts(bands, parts);
        std::fill(asked_.cells.begin(), asked_.cells.end(), std::uint8_t{0});
        bool moved = false;
        for (const std::vector<Move>& some : moves) {
            for (const Move& move : some) apply(move);
        }
        for (const std::vector<Move>& some : moves) {
            for (const Move& move : some) cells_.renew(move.line, move.beam, [](int, int, std::uint32_t, std::uint32_t) {});
            moved = moved || !some.empty();
        }
        return moved;
    }

private:
    void lookAt(int line, std::vector<Move>& moves) const {
        const std::uint8_t* const asked = asked_.line(line);
        for (int j = 0; j < segment_.beams; ++j) {
            if (asked[j] == 0) continue;
            const std::size_t at = cells_.index(line, j);
            const std::uint32_t own = cells_.solid[at];
            if (own == kVoidCell || own == kNoSegment || cells_.inner[at] != kNoSegment) continue;
            const std::uint32_t to = choice(line, j, own);
            if (to != own) moves.push_back({line, j, to});
        }
    }
    [[nodiscard]] std::uint32_t choice(int line, int beam, std::uint32_t own) const {
        const std::size_t at = cells_.index(line, beam), beams = cells_.beams();
        std::array<std::uint32_t, 8> others;
        std::size_t count = 0;
        for (const std::size_t q :
             {at - beams - 1, at - beams, at - beams + 1, at - 1, at + 1, at + beams - 1, at + beams, at + beams + 1}) {
            const std::uint32_t there = cells_.solid[q];
            if (there == own || there == kVoidCell || there == kNoSegment || groups_[there] == groups_[own]) continue;
            const auto end = others.begin() + static_cast<std::ptrdiff_t>(count);
            if (std::find(others.begin(), end, there) == end) others[count++] = there;
        }
        std::uint32_t best = own;
        if (count == 0) return best;
        const BorderSide ownSide = features_.side(line, beam, own);
        float most = 0;
        for (std::size_t n = 0; n < count; ++n) {
            const auto features = features_.of(line, beam, ownSide, features_.side(line, beam, others[n]));
            if (watch_) watch_({segment_.index(line, beam), own, others[n], features});
            const float said = network_.says(features);
            if (said > most || (said == most && best != own && others[n] < best)) {
                most = said;
                best = others[n];
            }
        }
        return best;
    }
    void apply(const Move& move) {
        segment_.at(move.line, move.beam) = move.to;
        cells_.assign(move.line, move.beam, move.to);
        for (int i = std::max(move.line - kNear, 0); i <= std::min(move.line + kNear, segment_.lines - 1); ++i)
            std::fill(asked_.line(i) + std::max(move.beam - kNear, 0), asked_.line(i) + std::min(move.beam + kNear, segment_.beams - 1) + 1,
                      std::uint8_t{1});
    }

    std::span<const std::uint32_t> groups_;
    const BorderNetwork& network_;
    Grid<std::uint32_t>& segment_;
    const BorderWatch& watch_;
    InnerCells cells_;
    BorderFeatures features_;
    Grid<std::uint8_t> asked_; // 1: ask in the next pass
};

} // namespace

std::vector<std::uint32_t> settledGroups(const std::vector<SegmentBorder>& borders, std::uint32_t segments) {
    return groupsAt(mergeTree(segments, borders), segments, kSettledLevel);
}

void chooseBorders(const Inputs& inputs, std::span<const std::uint32_t> groups, const BorderNetwork& network, int passes,
                   Grid<std::uint32_t>& segment, int threads, const BorderWatch& watch) {
    const int bands = watch ? 1 : std::clamp(bandsFor(segment.size(), threads), 1, std::max(1, segment.lines));
    BorderChoice choice(inputs, groups, network, segment, watch);
    while (passes-- > 0 && choice.pass(bands)) {
    }
}

} // namespace edgescan::rocks
