// Asks the network in passes, line by line.
#include "core/rocks/segmentation/border_choice.h"

#include "core/base/bands.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/rocks/segmentation/border_features.h"
#include "core/rocks/segmentation/cell_moves.h"
#include "core/rocks/segmentation/merge_tree.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace edgescan::rocks {
namespace {

constexpr double kSettledLevel = -2.0; // of two segments that are one region from here on, the border is not decided again
constexpr int kNear = 2;               // cells around a move that are asked again

// The questions of some lines, which are answered kCellsAtOnce at a time.
class BorderQuestions {
public:
    BorderQuestions(const BorderFeatures& features, const BorderNetwork& network, const BorderWatch& watch, int beams)
        : features_(features), network_(network), watch_(watch), beams_(static_cast<std::size_t>(beams)) {}

    /// All questions about a cell follow each other.
    void ask(const BorderPlace& place) {
        places_[count_++] = place;
        features_.readEarly(place);
        if (count_ == places_.size()) answer();
    }
    /// The cells that belong to another segment, in the order of the questions.
    [[nodiscard]] std::vector<CellMove> moves() {
        if (count_ > 0) answer();
        end();
        return std::move(moves_);
    }

private:
    void answer() {
        const BorderFeatureLanes features = features_.of(std::span(places_).first(count_));
        const Lanes<float> said = network_.says(features);
        for (std::size_t n = 0; n < count_; ++n) {
            if (watch_) show(n, features);
            addPlace(places_[n], said[n]);
        }
        count_ = 0;
    }
    void show(std::size_t lane, const BorderFeatureLanes& features) const {
        const BorderPlace& place = places_[lane];
        BorderQuestion question{static_cast<std::size_t>(place.line) * beams_ + static_cast<std::size_t>(place.beam), place.own,
                                place.other};
        for (std::size_t f = 0; f < features.size(); ++f) question.features[f] = features[f][lane];
        watch_(question);
    }
    void addPlace(const BorderPlace& place, float said) {
        if (place.line != best_.line || place.beam != best_.beam) {
            end();
            best_ = {place.line, place.beam, place.own, place.own};
            most_ = 0;
        }
        if (!(said > most_ || (said == most_ && best_.other != best_.own && place.other < best_.other))) return;
        most_ = said;
        best_.other = place.other;
    }
    void end() {
        if (best_.other != best_.own) moves_.push_back({best_.line, best_.beam, best_.other});
        best_ = {-1, -1, 0, 0};
    }

    const BorderFeatures& features_;
    const BorderNetwork& network_;
    const BorderWatch& watch_;
    const std::size_t beams_;
    std::array<BorderPlace, kCellsAtOnce> places_;
    std::size_t count_ = 0;
    BorderPlace best_{-1, -1, 0, 0}; // of the newest cell: the likeliest segment, its own if no other is likely
    float most_ = 0;
    std::vector<CellMove> moves_;
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
                asked_.line(i)[j] = static_cast<std::uint8_t>(cells_.touches(at + j));
        }
    }

    // False if nothing moved.
    bool pass(int threads) {
        const CellMoves moves = madeOfParts(segment_.lines, threads, [this](int first, int last) { return movesOf(first, last); });
        std::fill(asked_.cells.begin(), asked_.cells.end(), std::uint8_t{0});
        eachMove(moves, segment_.lines, kNear, threads, [this](const CellMove& move) { apply(move); });
        const auto unnoticed = [](int, int, std::uint32_t, std::uint32_t) {};
        eachMove(moves, segment_.lines, 1, threads, [&](const CellMove& move) { cells_.renew(move.line, move.beam, unnoticed); });
        return std::ranges::any_of(moves, [](const std::vector<CellMove>& some) { return !some.empty(); });
    }

private:
    // Of these lines.
    [[nodiscard]] std::vector<CellMove> movesOf(int first, int last) const {
        BorderQuestions questions(features_, network_, watch_, segment_.beams);
        for (int i = first; i < last; ++i) {
            const std::uint8_t* const asked = asked_.line(i);
            for (int j = 0; j < segment_.beams; ++j) {
                if (asked[j] != 0) askAbout(i, j, questions);
            }
        }
        return questions.moves();
    }
    void askAbout(int line, int beam, BorderQuestions& questions) const {
        const std::size_t at = cells_.index(line, beam), beams = cells_.beams();
        const std::uint32_t own = cells_.solid[at];
        if (own == kVoidCell || own == kNoSegment || cells_.inner[at] != kNoSegment) return;
        cells_.readBelowEarly(at);
        std::array<std::uint32_t, 8> others;
        std::size_t count = 0;
        for (const std::size_t q :
             {at - beams - 1, at - beams, at - beams + 1, at - 1, at + 1, at + beams - 1, at + beams, at + beams + 1}) {
            const std::uint32_t there = cells_.solid[q];
            if (there == own || there == kVoidCell || there == kNoSegment || groups_[there] == groups_[own]) continue;
            const auto end = others.begin() + static_cast<std::ptrdiff_t>(count);
            if (std::find(others.begin(), end, there) != end) continue;
            others[count++] = there;
            questions.ask({line, beam, own, there});
        }
    }
    void apply(const CellMove& move) {
        segment_.at(move.line, move.beam) = move.segment;
        cells_.assign(move.line, move.beam, move.segment);
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
    threads = watch ? 1 : bandsFor(segment.size(), threads);
    BorderChoice choice(inputs, groups, network, segment, watch);
    while (passes-- > 0 && choice.pass(threads)) {
    }
}

} // namespace edgescan::rocks
