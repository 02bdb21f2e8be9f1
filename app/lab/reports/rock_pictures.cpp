// Draws the rocks of a scene.
#include "app/lab/reports/rock_pictures.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/edges/gray/gray.h"

#include <algorithm>
#include <array>
#include <set>

namespace edgescan::lab {
namespace {

constexpr int kPartLines = 130;
constexpr int kPartBeams = 170;
constexpr int kPixelsPerCell = 5;
constexpr int kPartStep = 10; // distance between two places that are tried, cells

enum RockMark : std::uint8_t { kFoundRock = 1, kMergedRock, kSplitRock, kWallRock, kOtherRock, kToldRock, kToldNoRock };

// Okabe and Ito's colours, darkened: people with colour blindness can distinguish them; in gray their shapes differ.
std::vector<exports::SheetMark> rockLegend() {
    return {{"true rock, found", {0, 95, 45}, exports::MarkShape::Square},
            {"merged with another", {0, 114, 230}, exports::MarkShape::Ring},
            {"split", {226, 70, 0}, exports::MarkShape::Cross},
            {"lost to the wall", {170, 30, 140}, exports::MarkShape::Plus},
            {"missed otherwise", {160, 110, 0}, exports::MarkShape::Slash},
            {"region reported as a rock", {120, 20, 50}, exports::MarkShape::Square},
            {"region reported as not a rock", {120, 120, 120}, exports::MarkShape::Slash}};
}

RockMark markOf(const RockVerdict& verdict) {
    if (verdict.found) return kFoundRock;
    switch (verdict.miss) {
    case RockMiss::Merged:
        return kMergedRock;
    case RockMiss::Split:
        return kSplitRock;
    case RockMiss::Wall:
    case RockMiss::Dropped:
        return kWallRock;
    default:
        return kOtherRock;
    }
}

/// Cells whose right, lower, left or upper neighbour has another label; they get the mark of their label, 0 = no mark.
Grid<std::uint8_t> outlines(const Grid<std::uint32_t>& label, const std::vector<std::uint8_t>& markOfLabel) {
    Grid<std::uint8_t> marks(label.lines, label.beams);
    for (int i = 0; i < label.lines; ++i) {
        for (int j = 0; j < label.beams; ++j) {
            const auto other = [&](int l, int b) { return !label.contains(l, b) || label.at(l, b) != label.at(i, j); };
            const std::uint32_t own = label.at(i, j);
            if (own < markOfLabel.size() && (other(i - 1, j) || other(i + 1, j) || other(i, j - 1) || other(i, j + 1)))
                marks.at(i, j) = markOfLabel[own];
        }
    }
    return marks;
}

struct Part {
    int line = 0, beam = 0, lines = 0, beams = 0;
};

template <class T>
Grid<T> cut(const Grid<T>& whole, const Part& part) {
    Grid<T> piece(part.lines, part.beams);
    for (int i = 0; i < part.lines; ++i)
        for (int j = 0; j < part.beams; ++j) piece.at(i, j) = whole.at(part.line + i, part.beam + j);
    return piece;
}

/// The part of the scene where `worth` is largest; the first of several.
template <class Worth>
Part bestPart(const Grid<std::uint8_t>& marks, Worth worth) {
    const int lines = std::min(kPartLines, marks.lines);
    const int beams = std::min(kPartBeams, marks.beams);
    Part best{0, 0, lines, beams};
    double most = worth(best);
    for (int i = 0; i + lines <= marks.lines; i += kPartStep) {
        for (int j = 0; j + beams <= marks.beams; j += kPartStep) {
            const Part part{i, j, lines, beams};
            const double here = worth(part);
            if (here > most) {
                most = here;
                best = part;
            }
        }
    }
    return best;
}

/// Number of rocks with an outline in the part: found, missed.
std::array<std::size_t, 2> rocksIn(const Part& part, const Grid<std::uint32_t>& rock, const std::vector<std::uint8_t>& markOfRock) {
    std::set<std::uint32_t> seen;
    for (int i = part.line; i < part.line + part.lines; ++i)
        for (int j = part.beam; j < part.beam + part.beams; ++j) seen.insert(rock.at(i, j));
    std::array<std::size_t, 2> count{};
    for (const std::uint32_t one : seen) {
        if (one != 0 && markOfRock[one] != 0) ++count[markOfRock[one] == kFoundRock ? 0 : 1];
    }
    return count;
}

} // namespace

Grid<Rgb> rockSheet(const Scan& scan, const RockScene& scene, const RockDetection& answer, const RockSceneScore& score) {
    std::vector<std::uint8_t> markOfRock(scene.truth.rocks.size() + 1);
    for (const RockVerdict& rock : score.strict.rocks) markOfRock[rock.rock] = markOf(rock);
    std::vector<std::uint8_t> markOfRegion(answer.isRock.size());
    for (std::size_t n = 1; n < markOfRegion.size(); ++n) markOfRegion[n] = answer.isRock[n] != 0 ? kToldRock : kToldNoRock;
    const Grid<std::uint8_t> truth = outlines(scene.truth.rock, markOfRock);
    const Grid<std::uint8_t> told = outlines(answer.region, markOfRegion);
    const Grid<std::uint8_t> gray = edges::grayImage(scan, edges::Settings{}).levels;
    const auto worth = [&](const Part& part, double found, double missed) {
        const auto [good, bad] = rocksIn(part, scene.truth.rock, markOfRock);
        return found * static_cast<double>(good) + missed * static_cast<double>(bad);
    };
    const std::array<Part, 2> parts{bestPart(truth, [&](const Part& part) { return worth(part, 0.01, 1.0); }),
                                    bestPart(truth, [&](const Part& part) { return worth(part, 1.0, -10.0); })};
    std::vector<exports::SheetTile> tiles;
    for (const bool ofTruth : {true, false}) {
        for (const Part& part : parts) {
            const auto [good, bad] = rocksIn(part, scene.truth.rock, markOfRock);
            const std::string place = "lines " + std::to_string(part.line) + ".., beams " + std::to_string(part.beam) + "..";
            tiles.push_back({cut(gray, part), cut(ofTruth ? truth : told, part),
                             (&part == parts.data() ? "where most is missed: " : "where most is found: ") +
                                 std::string(ofTruth ? "true rocks" : "regions reported"),
                             ofTruth ? place + ": " + std::to_string(good) + " found, " + std::to_string(bad) + " missed" : place});
        }
    }
    const RockCounts& all = score.strict.counts;
    return exports::contactSheet(
        tiles, {2, tiles.front().picture.beams * kPixelsPerCell,
                printable(scene.name, 60) + ": strict PQ " + fixedText(all.pq(), 3) + ", F1 " + fixedText(all.f1(), 3), rockLegend()});
}

} // namespace edgescan::lab
