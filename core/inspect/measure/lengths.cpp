// Lengths and angles, with first-order error propagation from each end.
#include "core/inspect/measure/lengths.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/open_way.h"
#include "core/inspect/measure/surface_path.h"
#include "core/inspect/measure/throat.h"
#include "core/rocks/attributes/attributes.h"
#include "core/rocks/segmentation/cuts.h"
#include "core/scan/grid/missing_cells.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ranges>

namespace edgescan::inspect {
namespace {

constexpr std::array<MeasureTraits, kMeasureKinds> kMeasures{{
    {MeasureKind::Distance, "distance", "Distance", 2, true},
    {MeasureKind::Vertical, "vertical", "Vertical Difference", 2, true},
    {MeasureKind::Angle, "angle", "Angle", 3, true},
    {MeasureKind::Spans, "spans", "Spans a × b", 4, true},
    {MeasureKind::Path, "path", "Along the Surface", 2, true},
    {MeasureKind::Throat, "throat", "Throat Width", 2, true},
    {MeasureKind::Section, "section", "Length in a Section", 4, false},
}};

struct PickedEnd {
    Eigen::Vector3d pointM;
    Eigen::Matrix3d covariance;
    double smallestM;
    double rangeM;
};

std::optional<PickedEnd> endAt(const Scan& scan, const CartesianTables& tables, const RangeNoise& noise, std::uint32_t k) {
    if (k >= scan.cells()) return std::nullopt;
    const auto resolution = resolutionAt(scan, tables, k);
    if (!resolution) return std::nullopt;
    const double rangeM = static_cast<double>(scan.rangeMm[k]) / 1000.0;
    const Eigen::Vector3d point = tables.point(k);
    const Eigen::Vector3d direction = (point - tables.sensor()).normalized();
    const double sigmaM = std::hypot(noise.at(rangeM) / 1000.0, clippedBeamM(scan, tables, k, *resolution));
    return PickedEnd{point, placeCovariance(direction, sigmaM, *resolution), resolution->smallestM(), rangeM};
}

/// The tolerance of a value with these gradients with respect to the ends.
double toleranceOf(std::span<const PickedEnd> ends, std::span<const Eigen::Vector3d> gradients) {
    double variance = 0.0;
    for (std::size_t n = 0; n < ends.size(); ++n) variance += gradients[n].dot(ends[n].covariance * gradients[n]);
    return kReportedSigmas * std::sqrt(variance);
}

MeasuredLength distanceOf(std::span<const PickedEnd> ends) {
    const Eigen::Vector3d way = ends[1].pointM - ends[0].pointM;
    MeasuredLength length;
    length.valueM = way.norm();
    length.smallestM = std::max(ends[0].smallestM, ends[1].smallestM);
    length.isBelow = length.valueM < length.smallestM;
    const Eigen::Vector3d along = length.valueM > 0.0 ? Eigen::Vector3d(way / length.valueM) : Eigen::Vector3d::UnitX();
    const std::array<Eigen::Vector3d, 2> gradients{-along, along};
    length.toleranceM = toleranceOf(ends, gradients);
    return length;
}

MeasuredLength heightOf(std::span<const PickedEnd> ends, const Eigen::Vector3d& up) {
    MeasuredLength length = distanceOf(ends); // the smallest resolved distance depends on the two cells only
    length.valueM = up.dot(ends[1].pointM - ends[0].pointM);
    const std::array<Eigen::Vector3d, 2> gradients{-up, up};
    length.toleranceM = toleranceOf(ends, gradients);
    return length;
}

/// Of a line that has a length.
void measureSlope(std::span<const PickedEnd> ends, const Eigen::Vector3d& up, MeasuredCells& measured) {
    const Eigen::Vector3d way = ends[1].pointM - ends[0].pointM;
    const double height = up.dot(way);
    const Eigen::Vector3d flat = way - height * up;
    const double run = flat.norm();
    const Eigen::Vector3d ahead = run > 0.0 ? Eigen::Vector3d(flat / run) : up.unitOrthogonal();
    const Eigen::Vector3d gradient = (run * up - height * ahead) / way.squaredNorm();
    const std::array<Eigen::Vector3d, 2> gradients{-gradient, gradient};
    measured.slopeDeg = degrees(std::atan2(height, run));
    measured.slopeToleranceDeg = std::min(90.0, degrees(toleranceOf(ends, gradients)));
}

/// Returns false if a side has no length.
bool measureAngle(std::span<const PickedEnd> ends, MeasuredCells& measured) {
    const Eigen::Vector3d a = ends[0].pointM - ends[1].pointM;
    const Eigen::Vector3d b = ends[2].pointM - ends[1].pointM;
    if (!(a.norm() > 0.0) || !(b.norm() > 0.0)) return false;
    const Eigen::Vector3d plane = a.cross(b);
    const double angle = std::atan2(plane.norm(), a.dot(b));
    // Only a movement across a side, in the plane of both sides, changes the angle. If both sides are on one line, any plane is used.
    const Eigen::Vector3d axis = plane.norm() > 0.0 ? Eigen::Vector3d(plane.normalized()) : Eigen::Vector3d(a.unitOrthogonal());
    const Eigen::Vector3d ofA = a.cross(axis) / a.squaredNorm();
    const Eigen::Vector3d ofB = axis.cross(b) / b.squaredNorm();
    const std::array<Eigen::Vector3d, 3> gradients{ofA, -ofA - ofB, ofB};
    measured.angleDeg = degrees(angle);
    measured.angleToleranceDeg = std::min(180.0, degrees(toleranceOf(ends, gradients)));
    measured.angleIsBelow = distanceOf(ends.subspan(0, 2)).isBelow || distanceOf(ends.subspan(1, 2)).isBelow;
    return true;
}

/// How much farther the surface is after the jumps that follow each other in one direction; m. A ledge at a rim divides one jump in two.
template <class Jumps>
double stepsOf(const Jumps& jumps) {
    double stepM = 0.0;
    for (const RowJump& jump : jumps) {
        if (stepM * jump.stepM < 0.0) break;
        stepM += jump.stepM;
    }
    return stepM;
}

/// The ranges of the cells under the line; 0: none, or an echo of dust.
std::vector<double> rangesUnder(const Scan& scan, std::uint32_t from, std::uint32_t to) {
    std::vector<double> rangesM;
    for (const std::uint32_t k : rocks::strokeCells({from, to}, scan.lines(), scan.beams())) {
        const bool isSurface = scan.state[k] == CellState::Valid && (k == from || k == to || !isIsolated(scan, k));
        rangesM.push_back(isSurface ? static_cast<double>(scan.rangeMm[k]) / 1000.0 : 0.0);
    }
    return rangesM;
}

/// Also across cells without a range.
std::vector<RowJump> jumpsUnder(std::span<const double> rangesM) { return jumpsAlong(rangesM, static_cast<int>(rangesM.size())); }

/// From both ends over their first jumps. `lengthM`: straight from end to end.
void measureJumpsUnder(const Scan& scan, std::uint32_t from, std::uint32_t to, double lengthM, MeasuredCells& measured) {
    const std::vector<double> rangesM = rangesUnder(scan, from, to);
    const std::vector<RowJump> jumps = jumpsUnder(rangesM);
    if (jumps.empty()) return;
    // A click that missed its edge has the nearer surface next to it, or is so far behind that the length is another one.
    constexpr int kNextTo = 15;                          // cells
    constexpr double kShare = 1.0 / 3.0;                 // of the length
    const auto storeJump = [&](double stepM, int away) { // as seen from the end: positive is farther away
        if (stepM > 0.0 && measured.kind != MeasureKind::Throat) measured.inFrontM = std::max(measured.inFrontM, stepM);
        if (stepM >= 0.0) return;
        double& nearer = away <= kNextTo || -stepM > kShare * lengthM ? measured.behindM : measured.nearerBetweenM;
        nearer = std::max(nearer, -stepM);
    };
    storeJump(stepsOf(jumps), jumps.front().from);
    storeJump(-stepsOf(std::views::reverse(jumps)), static_cast<int>(rangesM.size()) - 1 - jumps.back().to);
}

std::optional<MeasuredCells> measureInSection(const Scan& scan, const RangeNoise& noise, std::span<const std::uint32_t> cells,
                                              std::span<const double> shares) {
    const bool measured =
        std::ranges::all_of(cells, [&](std::uint32_t k) { return k < scan.cells() && scan.state[k] == CellState::Valid; });
    if (!measured || shares.size() != 2) return std::nullopt;
    const CartesianTables tables(scan);
    const auto pointAt = [&](std::size_t n) {
        const double share = shares[n];
        return SurfacePoint{(1.0 - share) * tables.point(cells[2 * n]) + share * tables.point(cells[2 * n + 1]), cells[2 * n]};
    };
    const std::array<SurfacePoint, 2> ends{pointAt(0), pointAt(1)};
    MeasuredCells known;
    known.kind = MeasureKind::Section;
    known.lengths = {lengthBetween(scan, noise, ends[0], ends[1])};
    for (const SurfacePoint& end : ends) known.rangesM.push_back((end.pointM - tables.sensor()).norm());
    return known;
}

constexpr double kShownM = 0.001;       // a length has three decimals
constexpr double kMuchTurnedDeg = 45.0; // then the line is not between the sides that were clicked
constexpr int kFewCells = 3;            // an end within so many cells of its click is where it was clicked

/// Why a throat is not where it was clicked, or longer than the way between the clicks. Empty: it is there.
std::string clicksPart(const MeasuredCells& measured, Translated translated) {
    const auto say = [&](const char* pattern, std::initializer_list<ValueText> values) { return withValues(translated(pattern), values); };
    if (measured.isLongerThanClicks())
        return say("▲ longer than the %1 m between the clicks: the sides of the throat are up to %2 m from them",
                   {fixedText(measured.clicksM, 3), fixedText(measured.fromClicksM, 2)});
    if (measured.isFarFromClicks())
        return say("▲ its ends are up to %1 m from the clicks: check that it is the opening that was meant",
                   {fixedText(measured.fromClicksM, 2)});
    return measured.fromClicks > kFewCells ? say("its ends are up to %1 m from the clicks", {fixedText(measured.fromClicksM, 2)}) : "";
}

/// From the direction of one cell to that of another.
Eigen::Vector3d turnTo(const Scan& scan, const CartesianTables& tables, std::uint32_t from, std::uint32_t to) {
    const auto beams = static_cast<std::uint32_t>(scan.beams());
    const auto direction = [&](std::uint32_t k) { return tables.direction(static_cast<int>(k / beams), static_cast<int>(k % beams)); };
    return direction(to) - direction(from);
}

/// Across the beams, at the range of `end`.
double acrossBeamsM(const Scan& scan, const CartesianTables& tables, std::uint32_t end, std::uint32_t to) {
    const double apart = turnTo(scan, tables, end, to).norm();
    return std::isfinite(apart) ? apart * static_cast<double>(scan.rangeMm[end]) / 1000.0 : 0.0;
}

/// How far the cell that the click meant is behind this end, across a jump; 0: it is not seen through the opening, or nothing was measured
/// there.
double behindEndM(const Scan& scan, std::uint32_t end, std::uint32_t clicked, double openingRad) {
    const ClickedCell click = nearSideCell(scan, clicked);
    if (!click.measured()) return 0.0;
    const double endM = scan.rangeMm[end] / 1000.0, behindM = scan.rangeMm[click.cell] / 1000.0 - endM;
    if (behindM <= leastJumpM(endM) || !isBehind(endM + behindM, endM, openingRad)) return 0.0;
    double acrossM = 0.0; // a slanted surface has no jumps
    for (const RowJump& jump : jumpsUnder(rangesUnder(scan, end, click.cell))) acrossM += jump.stepM;
    return acrossM > leastJumpM(endM) ? behindM : 0.0;
}

/// Where the ends of a throat are, seen from the clicks at its two sides.
void measureSides(const Scan& scan, const CartesianTables& tables, std::span<const std::uint32_t> cells,
                  std::span<const std::uint32_t> clicked, MeasuredCells& measured) {
    const int beams = scan.beams();
    const double wide = openingRad(tables, cells[0], cells[1]);
    for (std::size_t n = 0; n < 2; ++n) {
        measured.clickBehindM = std::max(measured.clickBehindM, behindEndM(scan, cells[n], clicked[n], wide));
        const int cell = static_cast<int>(cells[n]), click = static_cast<int>(clicked[n]);
        measured.fromClicks =
            std::max({measured.fromClicks, std::abs(cell / beams - click / beams), std::abs(cell % beams - click % beams)});
        measured.fromClicksM = std::max(measured.fromClicksM, acrossBeamsM(scan, tables, cells[n], clicked[n]));
    }
    const Eigen::Vector3d line = turnTo(scan, tables, cells[0], cells[1]), clicks = turnTo(scan, tables, clicked[0], clicked[1]);
    if (line.norm() > 0.0 && clicks.norm() > 0.0)
        measured.turnedDeg = degrees(std::acos(std::min(1.0, std::abs(line.normalized().dot(clicks.normalized())))));
    if (std::ranges::any_of(clicked, [&](std::uint32_t k) { return scan.state[k] != CellState::Valid; })) return;
    measured.clicksM = (tables.point(clicked[0]) - tables.point(clicked[1])).norm();
}

std::string millimetres(double metres) { return fixedText(std::ceil(metres * 1000.0 - 1e-9), 0) + " mm"; }

} // namespace

std::span<const MeasureTraits> measureTraits() { return kMeasures; }

const MeasureTraits& traitsOf(MeasureKind kind) { return kMeasures[static_cast<std::size_t>(kind)]; }

std::optional<MeasureKind> measureKindNamed(std::string_view key) {
    const auto row = std::ranges::find(kMeasures, key, &MeasureTraits::key);
    return row == kMeasures.end() ? std::nullopt : std::optional(row->kind);
}

std::vector<std::pair<std::size_t, std::size_t>> linksOf(MeasureKind kind) {
    if (kind == MeasureKind::Angle) return {{0, 1}, {1, 2}};
    if (kind == MeasureKind::Spans) return {{0, 1}, {2, 3}};
    if (kind == MeasureKind::Section) return {{0, 2}};
    return {{0, 1}};
}

Eigen::Matrix3d placeCovariance(const Eigen::Vector3d& direction, double sigmaRangeM, const Resolution& resolution) {
    // Standard deviation per axis of a place anywhere in a disc of diameter d: d / 4. Anywhere in a cell of side s: s / sqrt(12).
    const double acrossM2 = resolution.beamM * resolution.beamM / 16.0 + resolution.spacingM * resolution.spacingM / 12.0;
    const Eigen::Matrix3d along = direction * direction.transpose();
    return sigmaRangeM * sigmaRangeM * along + acrossM2 * (Eigen::Matrix3d::Identity() - along);
}

MeasuredLength lengthBetween(const Scan& scan, const RangeNoise& noise, const SurfacePoint& a, const SurfacePoint& b) {
    const CartesianTables tables(scan);
    MeasuredLength length;
    const Eigen::Vector3d way = b.pointM - a.pointM;
    length.valueM = way.norm();
    const Eigen::Vector3d along = length.valueM > 0.0 ? Eigen::Vector3d(way / length.valueM) : Eigen::Vector3d::UnitX();
    double variance = 0.0;
    for (const SurfacePoint& end : {a, b}) {
        const auto resolution = resolutionAt(scan, tables, end.cell);
        if (!resolution) continue;
        const Eigen::Vector3d ray = end.pointM - tables.sensor();
        const Eigen::Matrix3d covariance = placeCovariance(ray.normalized(), noise.at(ray.norm()) / 1000.0, {0.0, resolution->beamM});
        variance += along.dot(covariance * along);
        length.smallestM = std::max(length.smallestM, resolution->smallestM());
    }
    length.toleranceM = kReportedSigmas * std::sqrt(variance);
    length.isBelow = length.valueM < length.smallestM;
    return length;
}

std::optional<MeasuredCells> measureCells(const Scan& scan, const RangeNoise& noise, MeasureKind kind, std::span<const std::uint32_t> cells,
                                          std::span<const double> shares) {
    if (cells.size() != traitsOf(kind).cells) return std::nullopt;
    if (kind == MeasureKind::Section) return measureInSection(scan, noise, cells, shares);
    const CartesianTables tables(scan);
    std::vector<PickedEnd> ends;
    MeasuredCells measured;
    measured.kind = kind;
    for (const std::uint32_t k : cells) {
        const auto end = endAt(scan, tables, noise, k);
        if (!end) return std::nullopt;
        ends.push_back(*end);
        measured.rangesM.push_back(end->rangeM);
    }
    const std::span<const PickedEnd> all(ends);
    switch (kind) {
    case MeasureKind::Path: {
        const auto path = surfacePath(scan, tables, noise, cells[0], cells[1]);
        if (!path) return std::nullopt;
        MeasuredLength length = distanceOf(all); // ends that are too near have no length, whatever the kind
        length.valueM = path->lengthM;
        length.toleranceM = path->toleranceM;
        measured.lengths = {length};
        measured.leaps = path->leaps;
        break;
    }
    case MeasureKind::Throat:
        measured.lengths = {distanceOf(all)};
        break;
    case MeasureKind::Distance:
    case MeasureKind::Vertical: {
        const rocks::UpDirection up = rocks::upOf(scan);
        measured.lengths = {kind == MeasureKind::Vertical ? heightOf(all, up.up) : distanceOf(all)};
        measured.upAssumed = up.assumed && (kind == MeasureKind::Vertical || !measured.lengths.front().isBelow);
        if (kind == MeasureKind::Distance && !measured.lengths.front().isBelow) measureSlope(all, up.up, measured);
        break;
    }
    case MeasureKind::Angle:
        if (!measureAngle(all, measured)) return std::nullopt;
        break;
    case MeasureKind::Spans:
        measured.lengths = {distanceOf(all.subspan(0, 2)), distanceOf(all.subspan(2, 2))};
        break;
    case MeasureKind::Section: // see measureInSection()
        break;
    }
    for (const auto& [from, to] : linksOf(kind))
        measureJumpsUnder(scan, cells[from], cells[to], (ends[from].pointM - ends[to].pointM).norm(), measured);
    return measured;
}

void measureClicks(const Scan& scan, std::span<const std::uint32_t> cells, std::span<const std::uint32_t> clicked,
                   MeasuredCells& measured) {
    if (measured.kind != MeasureKind::Throat || cells.size() != 2) return;
    if (clicked.empty()) clicked = cells; // each end is where it was clicked
    const bool isPair = clicked.size() == 2 && std::ranges::all_of(clicked, [&](std::uint32_t k) { return k < scan.cells(); });
    const CartesianTables tables(scan);
    measured.byOneClick = isPair && clicked[0] == clicked[1];
    const std::vector<double> rangesM = rangesUnder(scan, cells[0], cells[1]);
    measured.isDark =
        rangesM.size() > 2 && std::all_of(rangesM.begin() + 1, rangesM.end() - 1, [](double rangeM) { return rangeM == 0.0; });
    if (!isPair) return;
    if (const auto throat = throatAt(scan, tables, clicked[0], clicked[1])) {
        measured.leastM = throat->leastM;
        measured.mostM = throat->mostM;
        MeasuredLength& length = measured.lengths.front();
        length.toleranceM = std::max({length.toleranceM, length.valueM - throat->leastM, throat->mostM - length.valueM});
    }
    for (const std::uint32_t k : cells) {
        if (const auto resolution = resolutionAt(scan, tables, k))
            measured.spreadM = std::max(measured.spreadM, kClickSpread * resolution->spacingM);
    }
    if (!measured.byOneClick) measureSides(scan, tables, cells, clicked, measured);
}

double MeasuredCells::endsApartM() const {
    constexpr double kShare = 1.0 / 3.0; // of the length: no way across an opening
    if (kind != MeasureKind::Throat || rangesM.size() != 2) return 0.0;
    const double apartM = std::abs(rangesM[0] - rangesM[1]);
    return apartM > std::max(leastJumpM(std::min(rangesM[0], rangesM[1])), kShare * lengths.front().valueM) ? apartM : 0.0;
}

bool MeasuredCells::isLongerThanClicks() const {
    return kind == MeasureKind::Throat && clicksM > 0.0 && fromClicks > 0 && lengths.front().valueM > clicksM;
}

bool MeasuredCells::isWarned() const {
    return behindM > 0.0 || clickBehindM > 0.0 || endsApartM() > 0.0 || isLongerThanClicks() || isFarFromClicks() || dependsMuch() ||
           isDark;
}

bool MeasuredCells::isFarFromClicks() const {
    return kind == MeasureKind::Throat && fromClicks > kFewCells && !lengths.empty() && fromClicksM > lengths.front().valueM;
}

bool MeasuredCells::dependsMuch() const {
    constexpr double kShare = 0.2; // of the length
    return kind == MeasureKind::Throat && !lengths.empty() && mostM - leastM > kShare * lengths.front().valueM;
}

std::string lengthText(const MeasuredLength& length) {
    if (length.isBelow) return "< " + millimetres(length.smallestM);
    return fixedText(length.valueM, 3) + " m ± " + fixedText(shownTolerance(length.toleranceM, 3), 3) + " m";
}

std::string measureText(const MeasuredCells& measured) {
    if (measured.kind == MeasureKind::Angle) {
        if (measured.angleIsBelow) return "not resolved";
        return fixedText(measured.angleDeg, 1) + "° ± " + fixedText(shownTolerance(measured.angleToleranceDeg, 1), 1) + "°";
    }
    std::string text;
    for (const MeasuredLength& length : measured.lengths) text += (text.empty() ? "" : " × ") + lengthText(length);
    return text;
}

std::vector<std::string> measureRemarks(const MeasuredCells& measured, Translated translated) {
    const auto say = [&](const char* pattern, std::initializer_list<ValueText> values = {}) {
        return withValues(translated(pattern), values);
    };
    std::string ranges;
    for (std::size_t n = 0; n < measured.rangesM.size(); ++n) ranges += (n == 0 ? "" : " / ") + fixedText(measured.rangesM[n], 2);
    std::vector<std::string> parts;
    if (measured.kind == MeasureKind::Throat) {
        if (measured.clickBehindM > 0.0)
            parts.push_back(say("▲ a click went through this throat, %1 m behind it: the rim in front was taken",
                                {fixedText(measured.clickBehindM, 2)}));
        if (measured.isDark) parts.push_back(say("▲ no beam came back between its ends: this may be an opening, or dark or wet rock"));
        if (const double apartM = measured.endsApartM(); apartM > 0.0)
            parts.push_back(say("▲ one end is %1 m farther away than the other", {fixedText(apartM, 2)}));
        if (measured.byOneClick)
            parts.push_back(say("across the middle of the opening"));
        else if (measured.turnedDeg > kMuchTurnedDeg)
            parts.push_back(
                say("across the opening between the clicks, turned by %1° from their line", {fixedText(measured.turnedDeg, 0)}));
        else if (!measured.isFarFromClicks())
            parts.push_back(say("between the two sides that were clicked"));
        const bool dependsOnClicks = measured.mostM - measured.leastM >= kShownM;
        if (measured.dependsMuch())
            parts.push_back(say("▲ clicks %1 away find %2 to %3 m: zoom in and click again",
                                {millimetres(measured.spreadM), fixedText(measured.leastM, 3), fixedText(measured.mostM, 3)}));
        else if (dependsOnClicks)
            parts.push_back(say("clicks %1 away find %2 to %3 m",
                                {millimetres(measured.spreadM), fixedText(measured.leastM, 3), fixedText(measured.mostM, 3)}));
    }
    parts.push_back(say("ranges %1 m", {ranges}));
    if (measured.kind == MeasureKind::Distance && !measured.lengths.front().isBelow) {
        constexpr double kSteep = 80.0; // degrees: a grade says little there
        const std::string slope = fixedText(measured.slopeDeg, 1), tolerance = fixedText(shownTolerance(measured.slopeToleranceDeg, 1), 1);
        if (std::abs(measured.slopeDeg) < kSteep)
            parts.push_back(
                say("slope %1° ± %2°, grade %3 %", {slope, tolerance, fixedText(100.0 * std::tan(radians(measured.slopeDeg)), 0)}));
        else
            parts.push_back(say("slope %1° ± %2°", {slope, tolerance}));
    }
    if (const std::string clicks = clicksPart(measured, translated); !clicks.empty()) parts.push_back(clicks);
    if (measured.angleIsBelow) parts.push_back(say("a side is below what is resolved there"));
    if (measured.leaps > 0) parts.push_back(say("jumps that are part of it: %1", {std::to_string(measured.leaps)}));
    if (measured.behindM > 0.0) parts.push_back(say("▲ an end is %1 m behind the surface next to it", {fixedText(measured.behindM, 2)}));
    if (measured.inFrontM > 0.0)
        parts.push_back(say("between its ends the surface is up to %1 m farther away", {fixedText(measured.inFrontM, 2)}));
    if (measured.nearerBetweenM > 0.0)
        parts.push_back(say("between its ends the surface is up to %1 m nearer", {fixedText(measured.nearerBetweenM, 2)}));
    if (measured.upAssumed) parts.push_back(say("no pose: up is the scanner's z"));
    return parts;
}

std::string measureBasis(const MeasuredCells& measured, Translated translated) {
    std::string text;
    for (const std::string& part : measureRemarks(measured, translated)) text += (text.empty() ? "" : "; ") + part;
    return text;
}

} // namespace edgescan::inspect
