// Which folds can be edges at some crease angle, and what is stored of them.
#include "core/edges/edgescan_plus/stored_folds.h"

#include "core/base/simd.h"
#include "core/edges/edgescan_plus/suppression.h"

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kLinesHeld = 8;
constexpr std::size_t kParts = 4;

// Rounding never changes a fold by as much as this.
constexpr float kMore = 1.00001F;
constexpr float kTiny = 1e-30F;

// What is known of a cell's folds at every crease angle.
constexpr std::uint8_t kBeamsCertain = 1; // that along the beams always counts
constexpr std::uint8_t kLinesCertain = 2; // that along the lines always counts
constexpr std::uint8_t kAdd = 4;          // both have the same sign
constexpr std::uint8_t kUndecided = 8;    // it depends on the angle whether the cell's fold counts, ...
constexpr std::uint8_t kBeamBefore = 16;  // ... and these neighbours decide, as far as the cell's other direction does not
constexpr std::uint8_t kBeamAfter = 32;
constexpr std::uint8_t kLineBefore = 64;
constexpr std::uint8_t kLineAfter = 128;

// |S_C| of some cells at the smallest and at the largest crease angle, where it is strongest and weakest.
struct Extremes {
    const float *strongest, *weakest;
    [[nodiscard]] EDGESCAN_INLINE Extremes from(std::ptrdiff_t cells) const { return {strongest + cells, weakest + cells}; }
};
EDGESCAN_INLINE bool alwaysExceeds(const Extremes& a, const Extremes& b, int j) {
    return (a.strongest[j] > kMore * b.strongest[j] + kTiny) & (a.weakest[j] > kMore * b.weakest[j] + kTiny);
}

// A cell in one direction, compared with its neighbours at every crease angle.
// Bits: it exceeds the one before, the one after, is below the one before, the one after; it folds at all.
EDGESCAN_INLINE void compareWay(const Extremes& at, std::ptrdiff_t step, int beams, std::uint8_t* __restrict out) {
    const Extremes before = at.from(-step), after = at.from(step);
    for (int j = 0; j < beams; ++j) {
        const int known = (alwaysExceeds(at, before, j) ? 1 : 0) | (alwaysExceeds(at, after, j) ? 2 : 0) |
                          (alwaysExceeds(before, at, j) ? 4 : 0) | (alwaysExceeds(after, at, j) ? 8 : 0) | (at.strongest[j] != 0 ? 16 : 0);
        out[j] = static_cast<std::uint8_t>(known);
    }
}

// Both directions of a cell compared with each other. Bits: that along the beams exceeds, that along the lines; both have the same sign.
EDGESCAN_INLINE void compareWays(const Extremes& beamwise, const Extremes& linewise, const float* beamSizes, const float* lineSizes,
                                 int beams, std::uint8_t* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float b = beamSizes[j], l = lineSizes[j];
        const int known = (alwaysExceeds(beamwise, linewise, j) ? 1 : 0) | (alwaysExceeds(linewise, beamwise, j) ? 2 : 0) |
                          (((b > 0) & (l > 0)) | ((b < 0) & (l < 0)) ? 4 : 0);
        out[j] = static_cast<std::uint8_t>(known);
    }
}

// What follows for one direction; 0 or 1 each, because compilers vectorise bits more readily than conditions.
struct WayRank {
    int isStrongest, canCount; // always the strongest of its neighbours; not always exceeded by one of them
    int asksBefore, asksAfter; // neighbours that have to be compared: one that always exceeds the cell is enough
    explicit EDGESCAN_INLINE WayRank(int known) {
        const int exceedsBefore = known & 1, exceedsAfter = known >> 1 & 1, isBelowBefore = known >> 2 & 1, isBelowAfter = known >> 3 & 1;
        isStrongest = exceedsBefore & exceedsAfter;
        canCount = known >> 4 & ~isBelowBefore & ~isBelowAfter & 1;
        asksBefore = ~exceedsBefore & ~isBelowAfter & 1;
        asksAfter = ~exceedsAfter & ~(isBelowBefore & ~isBelowAfter) & 1;
    }
};

EDGESCAN_INLINE void rankCells(const std::uint8_t* beamwise, const std::uint8_t* linewise, const std::uint8_t* ways, const Support* support,
                               int beams, std::uint8_t* __restrict ranks) {
    for (int j = 0; j < beams; ++j) {
        const WayRank b(beamwise[j]), l(linewise[j]);
        const int beamsExceed = ways[j] & 1, linesExceed = ways[j] >> 1 & 1, add = ways[j] >> 2 & 1;
        // Where both add, either may be called the stronger one.
        const int beamsCertain = b.isStrongest & (beamsExceed | (add & l.isStrongest));
        const int linesCertain = l.isStrongest & linesExceed;
        const int can = (~linesExceed & b.canCount) | (~beamsExceed & l.canCount);
        const int undecided = can & ~beamsCertain & ~linesCertain & 1;
        const int byBeams = undecided & ~linesExceed, byLines = undecided & ~beamsExceed;
        const int solid = support[j] != Support::Void ? 0xFF : 0;
        const int rank = beamsCertain * kBeamsCertain | linesCertain * kLinesCertain | add * kAdd | undecided * kUndecided |
                         (byBeams & b.asksBefore) * kBeamBefore | (byBeams & b.asksAfter) * kBeamAfter |
                         (byLines & l.asksBefore) * kLineBefore | (byLines & l.asksAfter) * kLineAfter;
        ranks[j] = static_cast<std::uint8_t>(rank & solid);
    }
}

// 1 where a cell is listed, by its rank and those of the neighbours.
struct Listed {
    std::uint8_t *adding, *alone, *open, *comparedBeams, *comparedLines;
};
EDGESCAN_INLINE void markListed(const std::uint8_t* before, const std::uint8_t* here, const std::uint8_t* after, int beams,
                                const Listed& to) {
    std::uint8_t* __restrict adding = to.adding, * __restrict alone = to.alone, * __restrict open = to.open;
    std::uint8_t* __restrict comparedBeams = to.comparedBeams, * __restrict comparedLines = to.comparedLines;
    for (int j = 0; j < beams; ++j) {
        const int rank = here[j];
        static_assert(kBeamsCertain == 1 && kLinesCertain == 2 && kAdd == 4 && kUndecided == 8 && kBeamBefore == 16);
        const int certain = (rank | rank >> 1) & 1, undecided = rank >> 3 & 1;
        adding[j] = static_cast<std::uint8_t>(certain & rank >> 2);
        alone[j] = static_cast<std::uint8_t>(certain & ~(rank >> 2));
        open[j] = static_cast<std::uint8_t>(undecided);
        comparedBeams[j] = static_cast<std::uint8_t>((undecided | here[j - 1] >> 5 | here[j + 1] >> 4) & 1);
        comparedLines[j] = static_cast<std::uint8_t>((undecided | before[j] >> 7 | after[j] >> 6) & 1);
    }
}

// The places of the ones. `room`: for one more than all.
std::vector<std::uint16_t> placesOf(const std::uint8_t* marks, int count, std::vector<std::uint16_t>& room) {
    std::uint16_t* const places = room.data();
    std::size_t ones = 0;
    for (int j = 0; j < count; ++j) {
        places[ones] = static_cast<std::uint16_t>(j);
        ones += marks[j];
    }
    return {places, places + ones};
}

EDGESCAN_INLINE float strengthAt(const FoldParts& parts, int j, float creaseDeg) {
    return std::abs(parts.size[j]) / (parts.all[j] * std::max(creaseDeg * parts.flatter[j], parts.noise[j]));
}

// From the least crease angle on: the number of whole degrees at which a cell folds. A strength never grows with the angle, also when
// rounded, so the angles next to the computed one decide.
EDGESCAN_INLINE int degreesOf(const FoldParts& parts, int j) {
    constexpr float kLeast = StoredFolds::kLeastDeg, kMost = StoredFolds::kMostDeg;
    const float about = std::abs(parts.size[j]) / (kFoldingFrom * parts.all[j] * parts.flatter[j]);
    const float last = static_cast<float>(static_cast<int>(std::max(kLeast, std::min(kMost, about))));
    const bool folds = strengthAt(parts, j, kLeast) > kFoldingFrom;
    const bool here = strengthAt(parts, j, last) > kFoldingFrom;
    const bool next = strengthAt(parts, j, last + 1) > kFoldingFrom;
    return folds ? static_cast<int>(last - kLeast) + (here ? 1 : 0) + (next ? 1 : 0) : 0;
}

EDGESCAN_INLINE void degreesOfLine(const FoldParts& beamwise, const FoldParts& linewise, const Support* support, int beams,
                                   std::uint8_t* __restrict degrees) {
    for (int j = 0; j < beams; ++j) {
        const int most = std::max(degreesOf(beamwise, j), degreesOf(linewise, j));
        degrees[j] = static_cast<std::uint8_t>(support[j] != Support::Void ? most : 0);
    }
}

EDGESCAN_INLINE void computeWholeFolds(float* folds, const float* others, int cells) {
    for (int n = 0; n < cells; ++n) folds[n] = wholeFold(folds[n], others[n]);
}
EDGESCAN_INLINE void computeLoneFolds(float* folds, int cells) {
    for (int n = 0; n < cells; ++n) folds[n] = wholeFold(folds[n], 0.0F);
}

// The folds of some cells and of their neighbours, and what is left of them.
struct ComparedCells {
    float *beamwise, *beamBefore, *beamAfter, *linewise, *lineBefore, *lineAfter;
};
EDGESCAN_INLINE void suppressCompared(const ComparedCells& at, int cells, float* __restrict out) {
    for (int n = 0; n < cells; ++n) {
        const float value = wholeFold(at.beamwise[n], at.linewise[n]);
        const bool kept = isStrongest(at.beamwise[n], at.beamBefore[n], at.beamAfter[n], at.linewise[n], at.lineBefore[n], at.lineAfter[n]);
        out[n] = kept ? value : 0.0F;
    }
}

EDGESCAN_INLINE void computeMagnitudes(float* strengths, int beams) {
    for (int j = 0; j < beams; ++j) strengths[j] = std::abs(strengths[j]);
}

EDGESCAN_INLINE void markSolid(const Support* support, int beams, std::uint8_t* __restrict solid) {
    for (int j = 0; j < beams; ++j) solid[j] = static_cast<std::uint8_t>(support[j] != Support::Void);
}

EDGESCAN_INLINE void markFoldsAt(const std::uint8_t* states, int beams, int degrees, std::uint8_t* __restrict folding) {
    for (int j = 0; j < beams; ++j) folding[j] = static_cast<std::uint8_t>(states[j] > degrees);
}

const float* scatter(const std::vector<std::uint16_t>& cells, const float* values, float* out) {
    for (const std::uint16_t beam : cells) out[beam] = *values++;
    return values;
}

} // namespace

StoredFolds::StoredFolds(const Grid<Support>& support)
    : degrees_(support.lines, support.beams), solid_(FoldingCells(support.lines, support.beams).solid),
      lines_(static_cast<std::size_t>(support.lines)) {
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(solid_.beams) * Roughness::kGroup, 0);
    for (int i = 0; i < support.lines; ++i) {
        vectorised<markSolid>(support.line(i), support.beams, marks.data());
        countGroups(marks, solid_.line(i));
    }
}

bool StoredFolds::covers(double creaseDeg, int beams) {
    constexpr int kMostBeams = 1 << 16;
    return creaseDeg >= kLeastDeg && creaseDeg <= kMostDeg && creaseDeg == std::floor(creaseDeg) && beams <= kMostBeams;
}

std::size_t StoredFolds::bytes() const {
    std::size_t bytes = degrees_.size() + solid_.size();
    for (const Line& line : lines_) {
        bytes += sizeof line + sizeof(float) * line.parts.size();
        for (const Cells* cells : {&line.adding, &line.alone, &line.open, &line.comparedBeams, &line.comparedLines})
            bytes += sizeof(Cells::value_type) * cells->size();
    }
    return bytes;
}

void StoredFolds::foldsAt(float creaseDeg, int first, int last, Grid<float>& crease) const {
    const int from = std::max(0, first - 1);
    FoldStrengths compared{Lines(crease.beams, 3, 0.0F, from), Lines(crease.beams, 3, 0.0F, from)};
    std::vector<float> strengths;
    for (int line = from; line <= last; ++line) {
        compared.nextEmpty();
        if (line < crease.lines) {
            const Line& at = lines_[static_cast<std::size_t>(line)];
            const std::size_t count = at.parts.size() / kParts;
            const float* parts = at.parts.data();
            strengths.resize(count);
            strengthsAt({parts, parts + count, parts + 2 * count, parts + 3 * count}, static_cast<int>(count), creaseDeg, strengths.data());
            scatterFolds(at, strengths.data(), line, compared, line >= first && line < last ? crease.line(line) : nullptr);
        }
        if (line - 1 >= first) suppressOpen(lines_[static_cast<std::size_t>(line - 1)].open, compared, line - 1, strengths, crease);
    }
}

void StoredFolds::suppressOpen(const Cells& open, const FoldStrengths& compared, int line, std::vector<float>& work, Grid<float>& crease) {
    const std::size_t count = open.size();
    work.resize(7 * count);
    float* at = work.data();
    const ComparedCells cells{at, at + count, at + 2 * count, at + 3 * count, at + 4 * count, at + 5 * count};
    const float *beamwise = compared.alongBeams.line(line), *linewise = compared.alongLines.line(line);
    const std::ptrdiff_t stride = compared.alongLines.stride;
    for (std::size_t n = 0; n < count; ++n) {
        const float *b = beamwise + open[n], *l = linewise + open[n];
        cells.beamwise[n] = b[0];
        cells.beamBefore[n] = b[-1];
        cells.beamAfter[n] = b[1];
        cells.linewise[n] = l[0];
        cells.lineBefore[n] = l[-stride];
        cells.lineAfter[n] = l[stride];
    }
    vectorised<suppressCompared>(cells, static_cast<int>(count), at + 6 * count);
    scatter(open, at + 6 * count, crease.line(line));
}

void StoredFolds::scatterFolds(const Line& at, float* strengths, int line, FoldStrengths& compared, float* crease) {
    const auto adding = static_cast<int>(at.adding.size()), alone = static_cast<int>(at.alone.size());
    vectorised<computeWholeFolds>(strengths, strengths + adding, adding);
    float* next = strengths + 2 * adding;
    vectorised<computeLoneFolds>(next, alone);
    if (crease != nullptr) {
        scatter(at.adding, strengths, crease);
        scatter(at.alone, next, crease);
    }
    const float* other = scatter(at.comparedBeams, next + alone, compared.alongBeams.line(line));
    scatter(at.comparedLines, other, compared.alongLines.line(line));
}

FoldingCells StoredFolds::folding(float creaseDeg) const {
    FoldingCells cells(degrees_.lines, degrees_.beams);
    cells.solid = solid_;
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(solid_.beams) * Roughness::kGroup, 0);
    for (int i = 0; i < degrees_.lines; ++i) {
        vectorised<markFoldsAt>(degrees_.line(i), degrees_.beams, static_cast<int>(creaseDeg) - kLeastDeg, marks.data());
        countGroups(marks, cells.folding.line(i));
    }
    return cells;
}

FoldRecorder::FoldRecorder(StoredFolds& stored, const Grid<Support>& support, int from, int first, int last)
    : stored_(stored), support_(support), from_(from), first_(first),
      last_(last), alongBeams_{Lines(support.beams, kLinesHeld, 0.0F, from), Lines(support.beams, kLinesHeld, 0.0F, from)},
      alongLines_(alongBeams_), ranks_(support.beams, kLinesHeld, 0, from) {}

void FoldRecorder::Way::addLine(const FoldParts& parts, int beams) {
    const auto magnitudesAt = [&](int creaseDeg, float* out) {
        strengthsAt(parts, beams, static_cast<float>(creaseDeg), out);
        vectorised<computeMagnitudes>(out, beams);
    };
    magnitudesAt(StoredFolds::kLeastDeg, atLeast.next());
    magnitudesAt(StoredFolds::kMostDeg, atMost.next());
}

void FoldRecorder::addLine(int line, const FoldPartLines& parts) {
    alongBeams_.addLine(parts.alongBeams.at(line), support_.beams);
    alongLines_.addLine(parts.alongLines.at(line), support_.beams);
    rank(line - 1, parts);
    if (line - 2 >= first_ && line - 2 < last_) store(line - 2, parts);
}

void FoldRecorder::rank(int line, const FoldPartLines& parts) {
    if (line < from_) return;
    if (line >= support_.lines) return ranks_.nextEmpty();
    const auto at = [line](const Way& way) { return Extremes{way.atLeast.line(line), way.atMost.line(line)}; };
    const Extremes beamwise = at(alongBeams_), linewise = at(alongLines_);
    const auto beams = static_cast<std::size_t>(support_.beams);
    known_.resize(3 * beams);
    std::uint8_t *b = known_.data(), *l = b + beams, *ways = l + beams;
    vectorised<compareWay>(beamwise, 1, support_.beams, b);
    vectorised<compareWay>(linewise, alongLines_.atLeast.stride, support_.beams, l);
    vectorised<compareWays>(beamwise, linewise, parts.alongBeams.at(line).size, parts.alongLines.at(line).size, support_.beams, ways);
    vectorised<rankCells>(b, l, ways, support_.line(line), support_.beams, ranks_.next());
}

void FoldRecorder::store(int line, const FoldPartLines& parts) {
    const FoldParts beamwise = parts.alongBeams.at(line), linewise = parts.alongLines.at(line);
    const int beams = support_.beams;
    vectorised<degreesOfLine>(beamwise, linewise, support_.line(line), beams, stored_.degrees_.line(line));
    const std::uint8_t* ranks = ranks_.line(line);
    StoredFolds::Line& to = stored_.lines_[static_cast<std::size_t>(line)];
    const auto each = static_cast<std::size_t>(beams);
    marks_.resize(5 * each);
    room_.resize(each + 1);
    std::uint8_t* marks = marks_.data();
    const Listed listed{marks, marks + each, marks + 2 * each, marks + 3 * each, marks + 4 * each};
    vectorised<markListed>(ranks - ranks_.stride, ranks, ranks + ranks_.stride, beams, listed);
    to.adding = placesOf(listed.adding, beams, room_);
    to.alone = placesOf(listed.alone, beams, room_);
    to.open = placesOf(listed.open, beams, room_);
    to.comparedBeams = placesOf(listed.comparedBeams, beams, room_);
    to.comparedLines = placesOf(listed.comparedLines, beams, room_);
    const std::size_t count = 2 * to.adding.size() + to.alone.size() + to.comparedBeams.size() + to.comparedLines.size();
    to.parts.resize(kParts * count);
    float* next = to.parts.data();
    const auto add = [&](const std::vector<std::uint16_t>& cells, auto wayOf) {
        for (const std::uint16_t j : cells) {
            const FoldParts& from = wayOf(j);
            next[0] = from.size[j];
            next[count] = from.all[j];
            next[2 * count] = from.flatter[j];
            next[3 * count] = from.noise[j];
            ++next;
        }
    };
    const auto stronger = [&](int j) -> const FoldParts& { return (ranks[j] & kBeamsCertain) != 0 ? beamwise : linewise; };
    const auto weaker = [&](int j) -> const FoldParts& { return (ranks[j] & kBeamsCertain) != 0 ? linewise : beamwise; };
    add(to.adding, stronger);
    add(to.adding, weaker);
    add(to.alone, stronger);
    add(to.comparedBeams, [&](int) -> const FoldParts& { return beamwise; });
    add(to.comparedLines, [&](int) -> const FoldParts& { return linewise; });
}

} // namespace edgescan::edges
