// Looks for jumps in the lines and beams around a click.
#include "core/inspect/measure/near_side.h"

#include "core/inspect/measure/jumps_along.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr int kBeyond = 4;                     // cells beyond the reach: the straight lines at a jump need them
constexpr int kRadius = kSnapReach + kBeyond;  // of the cells that are read
constexpr int kSide = 2 * kRadius + 1;         // of their square
constexpr int kWidestGap = 2 * kSnapReach + 1; // cells without a range between two surfaces
constexpr int kMixedAtEnd = 2;                 // a chosen cell may be one of these
constexpr double kStair = 0.35;                // of the limit of a jump
constexpr double kOffSurface = 0.3;            // least jumps: a cell at a rim that is this much behind its surface is a mixed pixel
constexpr std::ptrdiff_t kFewestCells = 4;     // of a surface: fewer are dust
constexpr int kEdgeReach = 2;                  // cells from a surface's cell to its edge
constexpr int kFewestBefore = 2;               // cells next to a rim that are in front of the chosen cell too
constexpr std::array<std::array<int, 2>, 4> kSides{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};

struct Place {
    int line = 0, beam = 0; // in the square
    bool operator==(const Place&) const = default;
    [[nodiscard]] Place by(int lines, int beams) const { return {line + lines, beam + beams}; }
};

/// The near side of a jump.
struct Rim {
    Place at;
    double behindM = 0.0;       // range of the surface behind it
    int inLine = 0, inBeam = 0; // one step into the near surface
};

/// The cells around a click, the jumps between them, and which of them are on one surface.
class Square {
public:
    Square(const Scan& scan, std::uint32_t k)
        : line0_(static_cast<int>(k) / scan.beams() - kRadius), beam0_(static_cast<int>(k) % scan.beams() - kRadius), beams_(scan.beams()) {
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                if (!scan.rangeMm.contains(line0_ + i, beam0_ + j) || scan.state.at(line0_ + i, beam0_ + j) != CellState::Valid) continue;
                rangeM_[index({i, j})] = static_cast<double>(scan.rangeMm.at(line0_ + i, beam0_ + j)) / 1000.0;
            }
        }
        for (int n = 0; n < kSide; ++n) {
            findRimsAlong({n, 0}, 0, 1);
            findRimsAlong({0, n}, 1, 0);
        }
    }

    [[nodiscard]] static Place centre() { return {kRadius, kRadius}; }
    [[nodiscard]] double rangeM(Place at) const { return isInside(at) ? rangeM_[index(at)] : 0.0; }
    [[nodiscard]] bool isMixed(Place at) const { return mixed_[index(at)]; }
    [[nodiscard]] const std::vector<Rim>& rims() const { return rims_; }
    [[nodiscard]] std::uint32_t cellOf(Place at) const {
        return static_cast<std::uint32_t>(line0_ + at.line) * static_cast<std::uint32_t>(beams_) +
               static_cast<std::uint32_t>(beam0_ + at.beam);
    }

    /// The cells that are connected with `from` without a jump.
    [[nodiscard]] std::array<bool, kSide * kSide> surfaceOf(Place from) const {
        std::array<bool, kSide * kSide> reached{};
        std::vector<Place> open{from};
        reached[index(from)] = true;
        while (!open.empty()) {
            const Place at = open.back();
            open.pop_back();
            for (std::size_t side = 0; side < kSides.size(); ++side) {
                const Place next = at.by(kSides[side][0], kSides[side][1]);
                if (!isInside(next) || reached[index(next)] || rangeM(next) <= 0.0 || isMixed(next) || isCut(at, next)) continue;
                reached[index(next)] = true;
                open.push_back(next);
            }
        }
        return reached;
    }
    /// Whether the straight way between two cells has a jump, and the surface of the second is the nearer one.
    [[nodiscard]] bool jumpsTowards(Place from, Place to) const {
        const int lines = to.line - from.line, beams = to.beam - from.beam, steps = std::max(std::abs(lines), std::abs(beams));
        std::vector<double> row;
        for (int n = -kBeyond; n <= steps + kBeyond; ++n) {
            const auto part = [&](int cells) { return static_cast<int>(std::lround(static_cast<double>(n * cells) / steps)); };
            row.push_back(rangeM(from.by(part(lines), part(beams))));
        }
        return std::ranges::any_of(jumpsAlong(row, kWidestGap, kStair), [&](const RowJump& jump) {
            // It may end behind `to`: two jumps in one direction are joined, and `to` is between them.
            return jump.from >= kBeyond - kMixedAtEnd && jump.from < kBeyond + steps && jump.to > kBeyond && jump.stepM < 0.0;
        });
    }
    /// The cells around `at` that are not farther than `farthestM`.
    [[nodiscard]] int cellsBefore(Place at, double farthestM) const {
        int cells = 0;
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const double rangeAt = i == 0 && j == 0 ? 0.0 : rangeM(at.by(i, j));
                cells += rangeAt > 0.0 && rangeAt <= farthestM ? 1 : 0;
            }
        }
        return cells;
    }
    /// An echo in front of all that is around it.
    [[nodiscard]] bool isDust(Place at) const { return cellsBefore(at, rangeM(at) + leastJumpM(rangeM(at))) == 0; }
    [[nodiscard]] static std::size_t index(Place at) { return static_cast<std::size_t>(at.line * kSide + at.beam); }

private:
    [[nodiscard]] static bool isInside(Place at) { return at.line >= 0 && at.line < kSide && at.beam >= 0 && at.beam < kSide; }
    [[nodiscard]] bool isCut(Place a, Place b) const {
        if (b.line < a.line || b.beam < a.beam) std::swap(a, b);
        return a.line == b.line ? cutBeam_[index(a)] : cutLine_[index(a)];
    }
    void findRimsAlong(Place start, int downLine, int alongBeam) {
        std::array<double, kSide> row;
        const auto place = [&](int n) { return start.by(n * downLine, n * alongBeam); };
        for (int n = 0; n < kSide; ++n) row[static_cast<std::size_t>(n)] = rangeM(place(n));
        for (const RowJump& jump : jumpsAlong(row, kWidestGap)) {
            for (int n = jump.from + 1; n < jump.to; ++n) mixed_[index(place(n))] = rangeM(place(n)) > 0.0;
            const int inward = jump.nearer() == jump.from ? -1 : 1;
            rims_.push_back({place(jump.nearer()), rangeM(place(jump.farther())), inward * downLine, inward * alongBeam});
        }
        // Mixed pixels along a slanted outline make a stair from one surface to the other, of steps below the limit of a jump.
        for (const RowJump& step : jumpsAlong(row, kWidestGap, kStair)) {
            for (int n = step.from; n < step.to; ++n) (alongBeam != 0 ? cutBeam_ : cutLine_)[index(place(n))] = true;
        }
    }

    int line0_, beam0_, beams_;
    std::array<double, kSide * kSide> rangeM_{};
    std::array<bool, kSide * kSide> mixed_{}, cutBeam_{}, cutLine_{}; // cut: from the next cell along the beams, or along the lines
    std::vector<Rim> rims_;
};

int squareAway(Place at) {
    const int di = at.line - kRadius, dj = at.beam - kRadius;
    return di * di + dj * dj;
}
int cellsAway(Place at) { return std::max(std::abs(at.line - kRadius), std::abs(at.beam - kRadius)); }

/// Whether the click means `at` before `other`: nearer to it, or as near and on a surface in front. Of one surface none goes before by its
/// noise: the shortest range of several would be too short.
bool isPreferred(const Square& square, Place at, Place other) {
    if (squareAway(at) != squareAway(other)) return squareAway(at) < squareAway(other);
    return square.rangeM(at) < square.rangeM(other) - kStair * leastJumpM(square.rangeM(other));
}

/// The measured cell nearest to the click; dust only where nothing else was measured.
std::optional<Place> nearestMeasured(const Square& square) {
    std::optional<Place> best;
    for (const bool dust : {false, true}) {
        for (int i = kRadius - kSnapReach; i <= kRadius + kSnapReach; ++i) {
            for (int j = kRadius - kSnapReach; j <= kRadius + kSnapReach; ++j) {
                if (square.rangeM({i, j}) > 0.0 && square.isDust({i, j}) == dust && (!best || isPreferred(square, {i, j}, *best)))
                    best = Place{i, j};
            }
        }
        if (best) break;
    }
    return best;
}

/// The nearest rim in front of the surface of `at`.
std::optional<Place> rimInFront(const Square& square, Place at) {
    const double rangeM = square.rangeM(at);
    const auto surface = square.surfaceOf(at);
    std::optional<Place> best;
    for (const Rim& rim : square.rims()) {
        if (cellsAway(rim.at) > kSnapReach || surface[Square::index(rim.at)] || square.isMixed(rim.at) || square.isDust(rim.at)) continue;
        // In the middle between two surfaces a cell is on neither of them.
        const double limit = square.isMixed(at) ? square.rangeM(rim.at) : (square.rangeM(rim.at) + rim.behindM) / 2;
        if (rangeM <= limit || (best && !isPreferred(square, rim.at, *best))) continue;
        if (std::ranges::count(square.surfaceOf(rim.at), true) >= kFewestCells) best = rim.at;
    }
    return best;
}

/// The cell of the near surface at a rim that is not a mixed pixel: the rim itself, or the next one inward.
Place soundCell(const Square& square, Place at) {
    for (const Rim& rim : square.rims()) {
        if (rim.at != at) continue;
        const Place next = at.by(rim.inLine, rim.inBeam), afterNext = next.by(rim.inLine, rim.inBeam);
        const double first = square.rangeM(next), second = square.rangeM(afterNext);
        if (!(first > 0.0) || !(second > 0.0) || square.isMixed(next) || square.isMixed(afterNext)) continue;
        const double continued = 1.0 / std::max(1e-3, 2.0 / first - 1.0 / second); // straight in inverse range
        if (square.rangeM(at) > first && square.rangeM(at) - continued > kOffSurface * leastJumpM(first)) return next;
    }
    return at;
}

/// The nearest rim within reach of a surface in front of the chosen cell: a jump towards the scanner is between them.
std::optional<Place> rimBeforeChosen(const Square& square, Place chosen) {
    const double nearEnough = square.rangeM(chosen) - kStair * leastJumpM(square.rangeM(chosen));
    std::optional<Place> best;
    for (const Rim& rim : square.rims()) {
        if (cellsAway(rim.at) > kSnapReach || rim.at == chosen || square.rangeM(rim.at) > nearEnough) continue;
        if (best && squareAway(*best) <= squareAway(rim.at)) continue;
        // Stairs may divide a narrow ledge into surfaces of few cells. A cell of dust is alone.
        if (square.jumpsTowards(chosen, rim.at) && square.cellsBefore(rim.at, nearEnough) >= kFewestBefore) best = rim.at;
    }
    return best;
}

double nearerM(const Scan& scan, const ClickedCell& click) {
    if (scan.state[click.clicked] != CellState::Valid) return 0.0;
    return static_cast<double>(scan.rangeMm[click.clicked] - scan.rangeMm[click.cell]) / 1000.0;
}

} // namespace

ClickedCell nearSideCell(const Scan& scan, std::uint32_t k) {
    const Square square(scan, k);
    const std::optional<Place> start = nearestMeasured(square); // the clicked cell itself if it has a range and is not dust
    if (!start) return {k, k, SnapReason::NoRange, 0.0};
    ClickedCell click{square.cellOf(*start), k, SnapReason::AsClicked, 0.0};
    if (click.moved()) click.reason = scan.state[k] == CellState::Valid ? SnapReason::Dust : SnapReason::NoRange;
    const std::optional<Place> rim = rimInFront(square, *start);
    if (rim && !click.moved()) click.reason = square.isMixed(*start) ? SnapReason::MixedPixel : SnapReason::BehindAnEdge;
    const Place chosen = soundCell(square, rim.value_or(*start));
    click.cell = square.cellOf(chosen);
    if (const auto other = rimBeforeChosen(square, chosen)) click.alsoNear = square.cellOf(*other);
    if (click.moved() && click.reason == SnapReason::AsClicked) click.reason = SnapReason::MixedPixel;
    click.nearerM = nearerM(scan, click);
    return click;
}

ClickedCell nearSideEdge(const Scan& scan, const Grid<std::uint8_t>& mask, std::uint32_t k) {
    ClickedCell click = nearSideCell(scan, k);
    if (!click.measured() || mask.cells[k] != 255 || mask.cells[click.cell] == 255) return click;
    const int line = static_cast<int>(click.cell) / scan.beams(), beam = static_cast<int>(click.cell) % scan.beams();
    const double rangeM = static_cast<double>(scan.rangeMm[click.cell]) / 1000.0;
    std::optional<std::uint32_t> best;
    int least = kEdgeReach * kEdgeReach * 2 + 1;
    for (int i = -kEdgeReach; i <= kEdgeReach; ++i) {
        for (int j = -kEdgeReach; j <= kEdgeReach; ++j) {
            if (i * i + j * j >= least || !mask.contains(line + i, beam + j) || mask.at(line + i, beam + j) != 255) continue;
            if (scan.state.at(line + i, beam + j) != CellState::Valid) continue;
            const double awayM = static_cast<double>(scan.rangeMm.at(line + i, beam + j)) / 1000.0 - rangeM;
            if (std::abs(awayM) > kStair * leastJumpM(rangeM)) continue;
            least = i * i + j * j;
            best = static_cast<std::uint32_t>(mask.index(line + i, beam + j));
        }
    }
    if (!best) return click;
    click.cell = *best;
    if (!click.moved()) click.reason = SnapReason::AsClicked;
    click.nearerM = nearerM(scan, click);
    return click;
}

} // namespace edgescan::inspect
