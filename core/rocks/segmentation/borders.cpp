// Measures the evidence on cracks and adds it up for borders.
#include "core/rocks/segmentation/borders.h"

#include "core/base/bands.h"
#include "core/edges/edgescan_plus/range_field.h"
#include "core/rocks/segmentation/barrier.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace edgescan::rocks {
namespace {

// z = log odds "two rocks" (docs/method/rocks.md, "Step 4").
constexpr double kWeightCrack = 7.0;
constexpr double kWeightEdge = 9.0;
constexpr double kWeightValley = 0.5;
constexpr double kWeightWide = 1.5;
constexpr double kOdds = -9.0;
constexpr double kValleyUnitMm = 30.0;
constexpr double kWideUnitMm = 125.0;
constexpr double kMostUnits = 2.0;
constexpr float kValleyM = 0.12F;
constexpr float kWideM = 0.5F;
constexpr float kFewestChord = 2;
constexpr float kMostValley = 12;
constexpr float kMostWide = 40;
constexpr float kContactJump = 0.5F;
constexpr float kContactFold = -0.3F;

constexpr double kLeastStepRad = 1e-6; // of neighbouring cells
constexpr double kFarthestM = 60.0;
constexpr double kMostStep = 20.0;
constexpr double kMostTurn = 2.0;
constexpr double kMostFold = 3.0;
constexpr std::array<double, 3> kTurnRad{0.0174, 0.0465, 0.0931}; // 3, 8 and 16 steps of a third of a degree
constexpr int kMostTurnCells = 64;
constexpr std::array<float, 3> kEdgeLimits{0.25F, 0.75F, 1.0F};

/// The largest separation strength within two cells of a crack, up to 1: e2.
float edgeAt(const edges::DepthResponses& responses, std::size_t p, std::size_t step, int place, int count) {
    const std::size_t q = p + step;
    float edge = std::max(separationStrength(responses, p), separationStrength(responses, q));
    if (place > 0) edge = std::max(edge, separationStrength(responses, p - step));
    if (place + 2 < count) edge = std::max(edge, separationStrength(responses, q + step));
    return std::min(edge, 1.0F);
}

/// What one crack adds to an outline.
class OutlineMeasure {
public:
    explicit OutlineMeasure(const Inputs& inputs) : inputs_(inputs), u_(inputs.cracks->smoothed) {}

    /// The angle that the crack covers.
    [[nodiscard]] std::int64_t lengthAt(int line, int beam, edges::Along along) const {
        const AngularSteps& steps = inputs_.surface->steps;
        const float across = along == edges::Along::Beams ? steps.lineAt(line, beam) : steps.beam[static_cast<std::size_t>(beam)];
        return std::max<std::int64_t>(1, std::llround(static_cast<double>(across) / kLengthStep));
    }
    [[nodiscard]] OutlineSums at(int line, int beam, edges::Along along) const {
        const bool isBeams = along == edges::Along::Beams;
        const std::size_t step = isBeams ? 1 : static_cast<std::size_t>(u_.beams), p = u_.index(line, beam), q = p + step;
        const int place = isBeams ? beam : line, count = isBeams ? u_.beams : u_.lines;
        const AngularSteps& steps = inputs_.surface->steps;
        const double angle =
            std::max(kLeastStepRad, static_cast<double>(isBeams ? steps.beam[static_cast<std::size_t>(beam)] : steps.lineAt(line, beam)));
        OutlineSums sums;
        sums.length = lengthAt(line, beam, along);
        const auto times = [&sums](double value) { return std::llround(value * static_cast<double>(sums.length)); };
        const float edge = edgeAt(*inputs_.responses, p, step, place, count);
        const auto bin = std::ranges::count_if(kEdgeLimits, [edge](float limit) { return edge >= limit; });
        sums.byEdge[static_cast<std::size_t>(bin)] = sums.length;
        const auto a = static_cast<double>(u_[p]), b = static_cast<double>(u_[q]), mean = 0.5 * (a + b);
        const double rangeM = 1 / std::max(mean, 1 / kFarthestM);
        sums.step = times(std::min(kMostStep, std::abs(a - b) * rangeM / angle));
        for (std::size_t n = 0; n < kTurnRad.size(); ++n) {
            const int reach = static_cast<int>(std::clamp<long>(std::lround(kTurnRad[n] / angle), 1, kMostTurnCells));
            const int before = std::min(reach, place), after = std::min(reach, count - 2 - place);
            if (before <= 0 || after <= 0) continue;
            const auto from = static_cast<double>(u_[p - static_cast<std::size_t>(before) * step]);
            const auto to = static_cast<double>(u_[q + static_cast<std::size_t>(after) * step]);
            const double chord = (from * after + to * before) / (before + after);
            sums.turn[n] = times(std::clamp((mean - chord) * rangeM / (angle * 0.5 * (before + after)), -kMostTurn, kMostTurn));
        }
        const Grid<float>& fold = isBeams ? inputs_.cracks->foldBeams : inputs_.cracks->foldLines;
        sums.fold = times(std::clamp(static_cast<double>(std::min(fold[p], fold[q])), -kMostFold, kMostFold));
        return sums;
    }

private:
    const Inputs& inputs_;
    const Grid<float>& u_;
};

/// Finds the border of two segments; consecutive questions are mostly about the same one.
class BorderIndex {
public:
    explicit BorderIndex(std::span<const SegmentBorder> borders) : borders_(borders) {}
    /// The number of borders if there is none.
    [[nodiscard]] std::size_t of(std::uint32_t a, std::uint32_t b) {
        const std::pair<std::uint32_t, std::uint32_t> pair(std::min(a, b), std::max(a, b));
        if (last_ < borders_.size() && pairOf(borders_[last_]) == pair) return last_;
        const auto found = std::ranges::lower_bound(borders_, pair, {}, pairOf);
        if (found == borders_.end() || pairOf(*found) != pair) return borders_.size();
        return last_ = static_cast<std::size_t>(found - borders_.begin());
    }

private:
    static std::pair<std::uint32_t, std::uint32_t> pairOf(const SegmentBorder& border) { return {border.a, border.b}; }
    std::span<const SegmentBorder> borders_;
    std::size_t last_ = SIZE_MAX;
};

} // namespace

void OutlineSums::add(const OutlineSums& other) {
    length += other.length;
    for (std::size_t n = 0; n < byEdge.size(); ++n) byEdge[n] += other.byEdge[n];
    step += other.step;
    for (std::size_t n = 0; n < turn.size(); ++n) turn[n] += other.turn[n];
    fold += other.fold;
}

CrackMeasure::CrackMeasure(const Inputs& inputs, const Grid<std::uint32_t>& segment)
    : inputs_(inputs), cracks_(*inputs.cracks), segment_(segment) {}

bool CrackMeasure::isContact(std::size_t p, std::size_t q, edges::Along along) const {
    const Grid<float>& fold = along == edges::Along::Beams ? cracks_.foldBeams : cracks_.foldLines;
    return jump(p, along) <= kContactJump && std::min(fold[p], fold[q]) < kContactFold;
}

// From p to q, the two cells at the crack; `before` more cells of p's segment follow on its far side, `after` more of q's.
struct CrackMeasure::Chord {
    std::size_t p, q, step;
    float nearest, angle;
    int before, after;

    // Number of cells that a length covers here.
    [[nodiscard]] int cells(float lengthM, float most) const {
        return static_cast<int>(std::clamp(std::round(lengthM * nearest / angle), kFewestChord, most));
    }
};

CrackMeasure::Chord CrackMeasure::chordAt(int line, int beam, edges::Along along) const {
    const Grid<float>& u = cracks_.smoothed;
    const bool isBeams = along == edges::Along::Beams;
    const std::size_t step = isBeams ? 1 : static_cast<std::size_t>(segment_.beams);
    const std::size_t p = segment_.index(line, beam);
    const AngularSteps& steps = inputs_.surface->steps;
    Chord chord{
        p, p + step, step, std::max(u[p], u[p + step]), isBeams ? steps.beam[static_cast<std::size_t>(beam)] : steps.lineAt(line, beam),
        0, 0};
    const int reach = chord.cells(kWideM, kMostWide);
    const int place = isBeams ? beam : line;
    const int before = std::min(reach, place);
    const int after = std::min(reach, (isBeams ? segment_.beams : segment_.lines) - place - 2);
    const auto own = [&](std::size_t k, std::size_t of) { return segment_[k] == segment_[of]; };
    while (chord.before < before && own(chord.p - static_cast<std::size_t>(chord.before + 1) * step, chord.p)) ++chord.before;
    while (chord.after < after && own(chord.q + static_cast<std::size_t>(chord.after + 1) * step, chord.q)) ++chord.after;
    return chord;
}

double CrackMeasure::depthMm(const Chord& chord, int cells) const {
    const Grid<float>& u = cracks_.smoothed;
    const int a = std::min(cells, chord.before);
    const int b = std::min(cells, chord.after);
    if (a == 0 || b == 0) return 0.0;
    const auto from = static_cast<double>(u[chord.p - static_cast<std::size_t>(a) * chord.step]);
    const auto to = static_cast<double>(u[chord.q + static_cast<std::size_t>(b) * chord.step]);
    const double slope = (to - from) / static_cast<double>(a + b + 1);
    const double underP = from + slope * a - static_cast<double>(u[chord.p]);
    const double underQ = from + slope * (a + 1) - static_cast<double>(u[chord.q]);
    return 1000.0 * std::max(underP, underQ) / (static_cast<double>(chord.nearest) * static_cast<double>(chord.nearest));
}

CrackEvidence CrackMeasure::at(int line, int beam, edges::Along along) const {
    const bool isBeams = along == edges::Along::Beams;
    const std::size_t step = isBeams ? 1 : static_cast<std::size_t>(segment_.beams);
    const std::size_t p = segment_.index(line, beam);
    const std::size_t q = p + step;
    const Grid<float>& fold = isBeams ? cracks_.foldBeams : cracks_.foldLines;
    const float edge = edgeAt(*inputs_.responses, p, step, isBeams ? beam : line, isBeams ? segment_.beams : segment_.lines);
    CrackEvidence evidence;
    evidence.e1 = static_cast<double>(std::clamp(std::max({jump(p, along), -fold[p], -fold[q]}), 0.0F, 1.0F));
    evidence.e2 = static_cast<double>(edge);
    const Chord chord = chordAt(line, beam, along);
    evidence.valleyMm = depthMm(chord, chord.cells(kValleyM, kMostValley));
    evidence.v = std::clamp(evidence.valleyMm / kValleyUnitMm, -kMostUnits, kMostUnits);
    evidence.wideMm = depthMm(chord, chord.cells(kWideM, kMostWide));
    evidence.w = std::clamp(evidence.wideMm / kWideUnitMm, -kMostUnits, kMostUnits);
    evidence.z = kWeightCrack * evidence.e1 + kWeightEdge * evidence.e2 + kWeightValley * evidence.v + kWeightWide * evidence.w + kOdds;
    return evidence;
}

std::vector<SegmentBorder> segmentBorders(const Inputs& inputs, const Grid<std::uint32_t>& segment) {
    const CrackMeasure measure(inputs, segment);
    const auto look = [&](int line, int beam, edges::Along along, std::vector<SegmentBorder>& cracks) {
        const std::size_t p = segment.index(line, beam);
        const std::size_t q = p + (along == edges::Along::Beams ? 1 : static_cast<std::size_t>(segment.beams));
        if (segment[p] == segment[q] || segment[p] == kNoSegment || segment[q] == kNoSegment) return;
        const CrackEvidence evidence = measure.at(line, beam, along);
        const auto whole = [](double value) { return static_cast<std::int64_t>(std::llround(value / kEvidenceStep)); };
        SegmentBorder crack{segment[p],         segment[q],        whole(evidence.z), 1, 0, 0, 0, whole(evidence.e1),
                            whole(evidence.e2), whole(evidence.v), whole(evidence.w)};
        if (measure.jump(p, along) > 1.0F) (measure.isNearer(p, q) ? crack.jumpsA : crack.jumpsB) = 1;
        crack.valleys = measure.isContact(p, q, along) ? 1 : 0;
        cracks.push_back(crack.a < crack.b ? crack : crack.reversed());
    };
    const auto borders = madeOfParts(segment.lines, bandsFor(segment.size(), 0), [&](int first, int last) {
        std::vector<SegmentBorder> cracks;
        for (int i = first; i < last; ++i) {
            for (int j = 0; j < segment.beams; ++j) {
                if (j + 1 < segment.beams) look(i, j, edges::Along::Beams, cracks);
                if (i + 1 < segment.lines) look(i, j, edges::Along::Lines, cracks);
            }
        }
        return summedBorders(std::move(cracks));
    });
    if (borders.size() == 1) return borders.front();
    std::vector<SegmentBorder> all;
    for (const std::vector<SegmentBorder>& part : borders) all.insert(all.end(), part.begin(), part.end());
    return summedBorders(std::move(all)); // whole numbers: the sums are the same in any order
}

SegmentOutlines segmentOutlines(const Inputs& inputs, const Grid<std::uint32_t>& segment, std::span<const SegmentBorder> borders,
                                std::uint32_t count) {
    const OutlineMeasure measure(inputs);
    const auto parts = madeOfParts(segment.lines, bandsFor(segment.size(), 0), [&](int first, int last) {
        SegmentOutlines outlines{std::vector<OutlineSums>(borders.size()), std::vector<std::int64_t>(static_cast<std::size_t>(count) + 1)};
        BorderIndex index(borders);
        const auto look = [&](int line, int beam, edges::Along along) {
            const std::size_t p = segment.index(line, beam);
            const bool isBeams = along == edges::Along::Beams;
            const std::uint32_t a = segment[p], b = segment[p + (isBeams ? 1 : static_cast<std::size_t>(segment.beams))];
            if (a == b) return;
            if (a == kNoSegment || b == kNoSegment) {
                outlines.outer[std::max(a, b)] += measure.lengthAt(line, beam, along);
            } else if (const std::size_t border = index.of(a, b); border < borders.size()) {
                outlines.borders[border].add(measure.at(line, beam, along));
            }
        };
        const auto lookOut = [&](int line, int beam, edges::Along along) {
            if (segment.at(line, beam) != kNoSegment) outlines.outer[segment.at(line, beam)] += measure.lengthAt(line, beam, along);
        };
        for (int i = first; i < last; ++i) {
            for (int j = 0; j < segment.beams; ++j) {
                if (j + 1 < segment.beams) look(i, j, edges::Along::Beams);
                if (i + 1 < segment.lines) look(i, j, edges::Along::Lines);
                if (j == 0 || j + 1 == segment.beams) lookOut(i, j, edges::Along::Beams);
                if (i == 0 || i + 1 == segment.lines) lookOut(i, j, edges::Along::Lines);
            }
        }
        return outlines;
    });
    SegmentOutlines all = parts.front();
    for (std::size_t part = 1; part < parts.size(); ++part) {
        for (std::size_t n = 0; n < all.borders.size(); ++n) all.borders[n].add(parts[part].borders[n]);
        for (std::size_t n = 0; n < all.outer.size(); ++n) all.outer[n] += parts[part].outer[n];
    }
    return all;
}

std::vector<SegmentBorder> summedBorders(std::vector<SegmentBorder> parts) {
    // Finds borders of the same two segments by a hash table of indices of `parts`, at least half empty. The first one receives the sums of
    // the others.
    constexpr std::uint32_t kEmpty = UINT32_MAX;
    const auto pairOf = [](const SegmentBorder& border) { return (static_cast<std::uint64_t>(border.a) << 32U) | border.b; };
    const auto bits = static_cast<unsigned>(std::bit_width(2 * parts.size() + 1));
    std::vector<std::uint32_t> table(std::size_t{1} << bits, kEmpty);
    std::uint32_t count = 0;
    for (const SegmentBorder& part : parts) {
        std::size_t at = pairOf(part) * 0x9E3779B97F4A7C15U >> (64U - bits);
        while (table[at] != kEmpty && pairOf(parts[table[at]]) != pairOf(part)) at = (at + 1) & (table.size() - 1);
        if (table[at] == kEmpty) {
            table[at] = count;
            parts[count++] = part;
        } else {
            parts[table[at]].add(part);
        }
    }
    parts.resize(count);
    std::sort(parts.begin(), parts.end(), [&](const SegmentBorder& x, const SegmentBorder& y) { return pairOf(x) < pairOf(y); });
    return parts;
}

} // namespace edgescan::rocks
