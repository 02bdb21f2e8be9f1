// Each point by itself: what it was taken as, how else it could be, and what flat surfaces and usual ranges say to that.
#include "core/files/plausibility/opening_check.h"

#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/grid_recovery/unit.h"
#include "core/files/plausibility/common_planes.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/axis_from_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace edgescan::files {
namespace {

using Source = OpeningPoint::Source;

constexpr double kNearestUsualM = 0.3;    // half of all ranges shorter: no draw-bell
constexpr double kFarthestUsualM = 100.0; // half of all ranges longer: no scanner of rocks
constexpr const char* kRangeTable = "range CSV";
constexpr double kMostLeftOut = 0.1; // of the points behind others of their cell

// The words for each unit and each mounting. Every sentence below is one that the window translates (resources/languages/collect).
struct Unit {
    double mm;
    const char *taken, *other;
};
constexpr std::array<Unit, 3> kUnits{{
    {1.0, "millimetres, so that half of the ranges are below %1 m", "millimetres: half of the ranges are below %1 m"},
    {10.0, "centimetres, so that half of the ranges are below %1 m", "centimetres: half of the ranges are below %1 m"},
    {1000.0, "metres, so that half of the ranges are below %1 m", "metres: half of the ranges are below %1 m"},
}};
constexpr const char* kOddUnit = "%2 mm, so that half of the ranges are below %1 m";
constexpr const char* kUnusual = "In the unit that was taken half of the ranges are below %1 m, which is unusual for a scan of rocks.";

struct Mounting {
    const char *taken, *other, *bent, *moves;
};
constexpr Mounting kSpin{
    "spin: the stepper turns about the viewing direction; %1 of %2 flat pieces lie on three planes",
    "spin, about the viewing direction: %1 of %2 flat pieces lie on three planes",
    "Walls bend with mounting spin: %1 of %2 flat pieces lie on three planes, with sweep %3 do.",
    "The ranges do not fit mounting spin: from line to line they stay the same at beams 0 and 180 degrees, as with sweep."};
constexpr Mounting kSweep{"sweep: the stepper turns about the 0/180 degree line; %1 of %2 flat pieces lie on three planes",
                          "sweep, about the 0/180 degree line: %1 of %2 flat pieces lie on three planes",
                          "Walls bend with mounting sweep: %1 of %2 flat pieces lie on three planes, with spin %3 do.",
                          "The ranges do not fit mounting sweep: from line to line they stay the same at beam 90 degrees, as with spin."};

double medianRangeM(const Scan& scan) {
    std::vector<float> ranges;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) ranges.push_back(scan.rangeMm[k]);
    }
    return ranges.empty() ? 0.0 : static_cast<double>(valueInOrder(ranges, ranges.size() / 2)) / 1000.0;
}

bool isUsual(double rangeM) { return rangeM >= kNearestUsualM && rangeM <= kFarthestUsualM; }

std::optional<OpeningPoint> unitOf(const Scan& scan, const ReadingOptions& options) {
    const auto warned = std::ranges::find_if(scan.warnings, [](const std::string& w) { return unitOfWarning(w).has_value(); });
    const bool whole = scan.format == kRangeTable; // whole numbers in it are taken as millimetres without a word
    const bool guessed = warned != scan.warnings.end() || whole;
    if (!guessed && !options.unitMm) return std::nullopt; // the file says it
    const double mm = options.unitMm.value_or(warned != scan.warnings.end() ? *unitOfWarning(*warned) : 1.0);
    const double median = medianRangeM(scan);
    if (median <= 0.0) return std::nullopt;
    const auto now = std::ranges::find_if(kUnits, [mm](const Unit& unit) { return unit.mm == mm; });
    OpeningPoint point{"Unit", options.unitMm ? Source::Typed : Source::Guessed};
    const std::string half = significantText(median, 2);
    point.taken = now != kUnits.end() ? Sentence{now->taken, {half}} : Sentence{kOddUnit, {half, significantText(mm, 4)}};
    if (!isUsual(median)) point.against = {kUnusual, {half}};
    for (const Unit& unit : kUnits) {
        if (unit.mm == mm) continue;
        ReadingOptions other = options;
        other.unitMm = unit.mm;
        point.others.push_back({{unit.other, {significantText(median * unit.mm / mm, 2)}}, std::move(other)});
    }
    // What is usual first.
    std::ranges::stable_sort(point.others, {}, [&](const OtherReading& o) { return isUsual(median * *o.options.unitMm / mm) ? 0 : 1; });
    return point;
}

const Mounting& wordsOf(Axis axis) { return axis == Axis::Spin ? kSpin : kSweep; }

/// "%1 of %2 flat pieces".
std::vector<std::string> flatOf(const CommonPlanes& planes) { return {std::to_string(planes.onPlanes), std::to_string(planes.pieces)}; }

std::vector<std::string> with(std::vector<std::string> values, const std::string& last) {
    values.push_back(last);
    return values;
}

bool warned(std::string_view words, const Scan& scan) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// Grid and angles were found from a bare list of points.
bool gridWasFound(const Scan& scan) { return warned(kListsOnlyPoints, scan); }

bool anglesWereAssumed(const Scan& scan) { return warned("does not say its angles", scan) || gridWasFound(scan); }

OpeningPoint mountingOf(const Scan& scan, const PolarGeometry& polar, const ReadingOptions& options, const CommonPlanes& now) {
    const bool assumed = anglesWereAssumed(scan) || warned("ASSUMED: the axis", scan);
    OpeningPoint point{"Mounting", options.axis ? Source::Typed : assumed ? Source::Assumed : Source::Stated};
    point.taken = {wordsOf(polar.axis).taken, flatOf(now)};
    PolarGeometry turned = polar;
    turned.axis = polar.axis == Axis::Spin ? Axis::Sweep : Axis::Spin;
    const CommonPlanes other = commonPlanes(scan, turned);
    ReadingOptions so = options;
    so.axis = turned.axis;
    point.others.push_back({{wordsOf(turned.axis).other, flatOf(other)}, std::move(so)});
    if (clearlyFlatter(other, now))
        point.against = {wordsOf(polar.axis).bent, with(flatOf(now), std::to_string(other.onPlanes))};
    else if (axisFromRanges(scan.rangeMm, scan.state, polar.beamDeg) == turned.axis && !clearlyFlatter(now, other))
        point.against = {wordsOf(polar.axis).moves, {}};
    return point;
}

std::optional<double> evenStep(const std::vector<double>& deg) {
    if (deg.size() < 2) return std::nullopt;
    const double step = (deg.back() - deg.front()) / static_cast<double>(deg.size() - 1);
    for (std::size_t n = 1; n < deg.size(); ++n) {
        if (std::abs(deg[n] - deg[n - 1] - step) > 0.01 * std::abs(step)) return std::nullopt;
    }
    return step;
}

ReadingOptions withLines(ReadingOptions options, double startDeg, double stepDeg) {
    options.lineStartDeg = startDeg;
    options.lineStepDeg = stepDeg;
    return options;
}

/// By what the angles of the lines are multiplied: usual mistakes, and before them usual turns in all where the step was assumed.
std::vector<double> timesOf(double allDeg, bool assumed) {
    constexpr double kMostDeg = 400.0;
    std::vector<double> times;
    const auto add = [&](double by) {
        const bool known = std::ranges::any_of(times, [by](double other) { return std::abs(other / by - 1.0) < 0.01; });
        if (!known && std::abs(by - 1.0) > 0.002 && by * allDeg <= kMostDeg) times.push_back(by);
    };
    if (assumed) {
        for (const double turnDeg : {180.0, 360.0, 90.0, 270.0}) add(turnDeg / allDeg);
    }
    for (const double by : {0.5, 2.0 / 3.0, 1.5, 2.0}) add(by);
    return times;
}

/// The angle from line to line, which bends walls where it is wrong.
OpeningPoint stepOf(const Scan& scan, const PolarGeometry& polar, double step, const ReadingOptions& options, const CommonPlanes& now,
                    bool mountingFits) {
    const bool assumed = anglesWereAssumed(scan) || (mountingAssumed(scan) && warned("the step from line to line", scan));
    OpeningPoint point{"Line angles", options.lineStepDeg ? Source::Typed : assumed ? Source::Assumed : Source::Stated};
    const double between = static_cast<double>(polar.lineDeg.size() - 1), all = std::abs(step) * between;
    const auto inWords = [between](const CommonPlanes& planes, double stepDeg) {
        return with(with(flatOf(planes), significantText(std::abs(stepDeg), 4)), significantText(std::abs(stepDeg) * between, 4));
    };
    std::vector<std::pair<int, OtherReading>> tried; // the likelier first: number of pieces on planes, if it shows the step
    for (const double times : timesOf(all, assumed)) {
        PolarGeometry stretched = polar;
        for (std::size_t i = 0; i < stretched.lineDeg.size(); ++i)
            stretched.lineDeg[i] = polar.lineDeg.front() + times * (polar.lineDeg[i] - polar.lineDeg.front());
        const CommonPlanes other = commonPlanes(scan, stretched);
        const bool flatter = clearlyFlatter(other, now);
        tried.push_back({flatter || !assumed ? other.onPlanes : 0,
                         {{"a step of %3 degrees, %4 in all: %1 of %2 flat pieces lie on three planes", inWords(other, step * times)},
                          withLines(options, polar.lineDeg.front(), step * times)}});
        if (mountingFits && flatter && point.against.empty())
            point.against = {
                "Walls bend at the line angles that were taken: %1 of %2 flat pieces lie on three planes, other steps give more.",
                flatOf(now)};
    }
    const bool shows = !assumed || std::ranges::any_of(tried, [](const auto& one) { return one.first > 0; });
    point.taken = {shows ? "a step of %3 degrees, %4 in all; %1 of %2 flat pieces lie on three planes"
                         : "a step of %3 degrees, %4 in all; rough rock cannot show it: choose how far the motor turned in all",
                   inWords(now, step)};
    std::ranges::stable_sort(tried, std::greater<>{}, [](const auto& one) { return one.first; });
    for (auto& [flat, other] : tried) point.others.push_back(std::move(other));
    return point;
}

/// No surface distinguishes left from right: only a person who was there can.
OpeningPoint orderOf(const Scan& scan, const PolarGeometry& polar, double step, const ReadingOptions& options) {
    OpeningPoint point{"Order of the lines", options.lineStepDeg ? Source::Typed : gridWasFound(scan) ? Source::Guessed : Source::Stated};
    point.taken = {"line angles from %1 to %2 degrees; ranges cannot show whether left and right are exchanged",
                   {significantText(polar.lineDeg.front(), 4), significantText(polar.lineDeg.back(), 4)}};
    point.others.push_back({{"the other way round: left and right exchanged"}, withLines(options, -polar.lineDeg.front(), -step)});
    return point;
}

std::optional<OpeningPoint> gridOf(const Scan& scan, const ReadingOptions& options) {
    if (gridWasFound(scan)) {
        OpeningPoint point{"Grid", Source::Guessed};
        point.taken = {"%1 lines of %2 beams, found from the directions of the points",
                       {std::to_string(scan.lines()), std::to_string(scan.beams())}};
        return point;
    }
    const auto* cloud = std::get_if<PointGeometry>(&scan.geometry);
    if (scan.pointsRead == 0 || cloud == nullptr || !cloud->angles || scan.attached.empty()) return std::nullopt;
    const auto step = evenStep(cloud->angles->beamDeg);
    if (!step) return std::nullopt;
    const double leftOut = static_cast<double>(scan.pointsLeftOut) / static_cast<double>(scan.pointsRead);
    OpeningPoint point{"Grid", options.gridStepDeg ? Source::Typed : Source::Guessed};
    const std::string behind = significantText(100.0 * leftOut, 2);
    point.taken = {"projected onto cells of %1 degrees; %2 % of the points are behind others of their cell",
                   {significantText(std::abs(*step), 3), behind}};
    if (leftOut > kMostLeftOut)
        point.against = {"%1 % of the points are behind others of their cell: the cells are coarse, or the sensor was at another place.",
                         {behind}};
    for (const double times : {0.5, 2.0}) {
        ReadingOptions other = options;
        other.gridStepDeg = std::abs(*step) * times;
        point.others.push_back({{"cells of %1 degrees", {significantText(*other.gridStepDeg, 3)}}, std::move(other)});
    }
    return point;
}

std::optional<OpeningPoint> displacementOf(const Scan& scan, const ReadingOptions& options) {
    const auto warned = std::ranges::find_if(scan.warnings, isDisplacementWarning);
    if (warned == scan.warnings.end() && !options.straighten) return std::nullopt;
    OpeningPoint point{kDisplacedPoint.data(), options.straighten ? Source::Typed : Source::Stated};
    point.taken = options.straighten ? Sentence{"straightened"} : Sentence{"where their angles say"};
    if (!options.straighten) point.against = {"%1", {*warned}}; // a warning of the scan: as it is in records
    ReadingOptions other = options;
    other.straighten = !options.straighten;
    point.others.push_back(
        {options.straighten ? Sentence{"as they were recorded"} : Sentence{"straightened by the scan's own surfaces"}, std::move(other)});
    return point;
}

} // namespace

std::vector<OpeningPoint> openingCheck(const Scan& scan, const ReadingOptions& options) {
    std::vector<OpeningPoint> points;
    const auto add = [&points](std::optional<OpeningPoint> point) {
        if (point) points.push_back(std::move(*point));
    };
    add(unitOf(scan, options));
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry); polar != nullptr && scan.lines() > 1 && scan.beams() > 1) {
        const CommonPlanes now = commonPlanes(scan, *polar);
        add(mountingOf(scan, *polar, options, now));
        if (const auto step = evenStep(polar->lineDeg)) {
            add(stepOf(scan, *polar, *step, options, now, points.back().against.empty()));
            add(orderOf(scan, *polar, *step, options));
        }
    }
    add(gridOf(scan, options));
    add(displacementOf(scan, options));
    return points;
}

bool looksWrong(const std::vector<OpeningPoint>& points) {
    return std::ranges::any_of(points, [](const OpeningPoint& point) { return !point.against.empty(); });
}

bool looksGuessed(const std::vector<OpeningPoint>& points) {
    return std::ranges::any_of(points, [](const OpeningPoint& point) {
        return point.source == OpeningPoint::Source::Guessed || point.source == OpeningPoint::Source::Assumed;
    });
}

} // namespace edgescan::files
