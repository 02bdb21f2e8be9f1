// Tries the rotation axes, takes the best fit, and turns it the way a scanner would be described.
#include "core/files/grid_recovery/recover_grid.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/files/grid_recovery/parts.h"
#include "core/scan/grid/mean_step.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace edgescan::files {
namespace {

using namespace recognition;

constexpr int kMostPhases = 8;
constexpr double kNearlyAll = 0.95;
constexpr int kFewestTurns = 3;

/// The phase of each line; -1 where a line has no points, or points of several phases.
std::vector<int> phasesOf(const Grid<std::uint32_t>& pointOf, int phases) {
    std::vector<int> found;
    for (int i = 0; i < pointOf.lines; ++i) {
        std::array<int, kMostPhases> count{};
        int all = 0;
        for (int j = 0; j < pointOf.beams; ++j) {
            if (pointOf.at(i, j) == RecoveredGrid::kNoPoint) continue;
            ++count[static_cast<std::size_t>(j % phases)];
            ++all;
        }
        const auto most = std::max_element(count.begin(), count.end());
        found.push_back(all > 0 && *most >= kNearlyAll * all ? static_cast<int>(most - count.begin()) : -1);
    }
    return found;
}

/// Phase of line i is (first + step * i) % phases.
struct Turns {
    int phases = 1, first = 0, step = 0;
    [[nodiscard]] int phase(int line) const { return (first + step * line) % phases; }
};

Turns turnsIn(const Grid<std::uint32_t>& pointOf) {
    for (int phases = std::min(kMostPhases, pointOf.lines / kFewestTurns); phases > 1; --phases) {
        const std::vector<int> phase = phasesOf(pointOf, phases);
        const auto known = std::count_if(phase.begin(), phase.end(), [](int p) { return p >= 0; });
        if (static_cast<double>(known) < kNearlyAll * pointOf.lines) continue;
        for (int step = 1; step < phases; ++step) {
            if (std::gcd(step, phases) != 1) continue;
            for (int first = 0; first < phases; ++first) {
                const Turns turns{phases, first, step};
                int agreeing = 0;
                for (int i = 0; i < pointOf.lines; ++i) agreeing += phase[static_cast<std::size_t>(i)] == turns.phase(i) ? 1 : 0;
                if (agreeing >= kNearlyAll * pointOf.lines) return turns;
            }
        }
    }
    return {};
}

/// Puts two to eight lines that follow each other side by side where each of them has every so many beams only, the next one those next to
/// them, in turn over the whole grid; each beam keeps the angle of its line as its skew. Returns how many lines make one, 1 when nothing
/// was changed.
int foldPhases(RecoveredGrid& grid) {
    const Turns turns = turnsIn(grid.pointOf);
    if (turns.phases == 1) return 1;
    const int rows = (grid.pointOf.lines + turns.phases - 1) / turns.phases;
    const int beams = grid.pointOf.beams;
    const std::vector<double>& lineDeg = grid.geometry.lineDeg;
    const double stepDeg = meanStepDeg(lineDeg);
    std::vector<double> rowDeg;
    std::vector<double> ahead(static_cast<std::size_t>(turns.phases), 0.0); // of its row, by place among the lines of the row
    for (int row = 0; row < rows; ++row) {
        const auto first = static_cast<std::size_t>(row * turns.phases);
        const std::size_t count = std::min(static_cast<std::size_t>(turns.phases), lineDeg.size() - first);
        const double sum = std::accumulate(lineDeg.begin() + static_cast<std::ptrdiff_t>(first),
                                           lineDeg.begin() + static_cast<std::ptrdiff_t>(first + count), 0.0);
        rowDeg.push_back(sum / static_cast<double>(count) +
                         0.5 * stepDeg * static_cast<double>(static_cast<std::size_t>(turns.phases) - count));
        for (std::size_t k = 0; k < ahead.size(); ++k) {
            const double deg =
                k < count ? lineDeg[first + k] : rowDeg.back() + stepDeg * (static_cast<double>(k) - 0.5 * (turns.phases - 1));
            ahead[k] += (deg - rowDeg.back()) / rows;
        }
    }
    Grid<std::uint32_t> pointOf(rows, beams, RecoveredGrid::kNoPoint);
    grid.geometry.lineSkewDeg.assign(static_cast<std::size_t>(beams), 0.0);
    for (int line = 0; line < grid.pointOf.lines; ++line) {
        const int row = line / turns.phases;
        for (int j = 0; j < beams; ++j) {
            const std::uint32_t point = grid.pointOf.at(line, j);
            if (j % turns.phases == turns.phase(line)) {
                pointOf.at(row, j) = point;
                grid.geometry.lineSkewDeg[static_cast<std::size_t>(j)] = ahead[static_cast<std::size_t>(line % turns.phases)];
            } else {
                grid.unplaced += point != RecoveredGrid::kNoPoint ? 1 : 0;
            }
        }
    }
    grid.pointOf = std::move(pointOf);
    grid.geometry.lineDeg = std::move(rowDeg);
    grid.remarks.push_back(withValues("Each line has every %1th beam only, in turn: %2 lines that follow each other were put side by side.",
                                      {turns.phases, turns.phases}));
    return turns.phases;
}

// Beams of the far side are those of the near side with their tilt negated.

constexpr double kSameBeam = 0.25;      // steps
constexpr double kClearOfAxis = 2.0;    // steps
constexpr double kMostUnpaired = 0.1;   // of the beams, seen on one side only
constexpr double kCoversHalfTurn = 0.9; // of the lines of a half turn

/// A beam of either side, at its tilt on the near side, 0..pi.
struct SideBeam {
    double tilt = 0.0;
    int column = 0;
    bool far = false;
};

std::vector<SideBeam> sideBeams(const std::vector<double>& tilts) {
    std::vector<SideBeam> beams;
    for (std::size_t j = 0; j < tilts.size(); ++j) {
        const double tilt = std::remainder(tilts[j], 2 * kPi);
        beams.push_back({std::abs(tilt), static_cast<int>(j), tilt < 0});
    }
    std::ranges::sort(beams, {}, &SideBeam::tilt);
    return beams;
}

/// Beams of both sides that are one; -1 where a side has none.
struct BeamPair {
    double tilt = 0.0;
    int near = -1, far = -1;
};

std::vector<BeamPair> pairsOf(const std::vector<SideBeam>& beams, double step) {
    std::vector<BeamPair> pairs;
    for (const SideBeam& beam : beams) {
        const bool joins =
            !pairs.empty() && beam.tilt - pairs.back().tilt <= kSameBeam * step && (beam.far ? pairs.back().far : pairs.back().near) < 0;
        if (!joins) pairs.push_back({beam.tilt});
        (beam.far ? pairs.back().far : pairs.back().near) = beam.column;
        if (joins) pairs.back().tilt = (pairs.back().tilt + beam.tilt) / 2;
    }
    return pairs;
}

/// A scanner that turns round and round with several beams to one side (a spinning lidar) puts two of its lines into one plane through the
/// axis. Points in any order are found as such planes, with beams to both sides. Where both sides have the same beams, no line comes near
/// the axis and the planes cover the half turn, each plane becomes the two lines that it is, so that a line's neighbours go on all round.
/// Returns whether it was so.
bool unfoldHalves(Fit& fit) {
    if (fit.plane.size() < 2 || fit.tilt.size() < 2) return false;
    const double beamStep = medianStep(fit.tilt);
    const double lineStep = medianStep(fit.plane);
    const std::vector<SideBeam> beams = sideBeams(fit.tilt);
    if (beams.front().tilt < kClearOfAxis * beamStep || kPi - beams.back().tilt < kClearOfAxis * beamStep) return false;
    if (std::abs(fit.plane.back() - fit.plane.front()) + lineStep < kCoversHalfTurn * kPi) return false;
    const std::vector<BeamPair> pairs = pairsOf(beams, beamStep);
    const auto unpaired = std::ranges::count_if(pairs, [](const BeamPair& pair) { return pair.near < 0 || pair.far < 0; });
    if (static_cast<double>(unpaired) > kMostUnpaired * static_cast<double>(pairs.size())) return false;

    const int lines = fit.pointOf.lines;
    Grid<std::uint32_t> pointOf(2 * lines, static_cast<int>(pairs.size()), kNone);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < pointOf.beams; ++j) {
            const BeamPair& pair = pairs[static_cast<std::size_t>(j)];
            if (pair.near >= 0) pointOf.at(i, j) = fit.pointOf.at(i, pair.near);
            if (pair.far >= 0) pointOf.at(lines + i, j) = fit.pointOf.at(i, pair.far);
        }
    }
    const double halfTurn = fit.plane.back() > fit.plane.front() ? kPi : -kPi;
    for (int i = 0; i < lines; ++i) fit.plane.push_back(fit.plane[static_cast<std::size_t>(i)] + halfTurn);
    fit.tilt.clear();
    for (const BeamPair& pair : pairs) fit.tilt.push_back(pair.tilt);
    fit.pointOf = std::move(pointOf);
    return true;
}

constexpr std::size_t kFewestPoints = 12;

/// A rotation axis that PolarGeometry can express, if need be after `turn`.
struct Hypothesis {
    char letter;
    Axis axis;
    Eigen::Matrix3d turn;
};

std::vector<Hypothesis> hypothesesFor(std::optional<Axis> axis) {
    Eigen::Matrix3d yToZ;
    yToZ << 0, 0, 1, 1, 0, 0, 0, 1, 0; // x' = z, y' = x, z' = y
    std::vector<Hypothesis> all{
        {'z', Axis::Spin, Eigen::Matrix3d::Identity()}, {'x', Axis::Sweep, Eigen::Matrix3d::Identity()}, {'y', Axis::Spin, yToZ}};
    if (axis) std::erase_if(all, [&](const Hypothesis& h) { return h.axis != *axis; });
    return all;
}

std::vector<AxisPoint> axisPointsOf(const Hypothesis& hypothesis, std::span<const Eigen::Vector3d> points) {
    std::vector<AxisPoint> seen;
    seen.reserve(points.size());
    for (const Eigen::Vector3d& given : points) {
        if (!isReturn(given)) {
            seen.emplace_back();
            continue;
        }
        const Eigen::Vector3d p = hypothesis.turn * given;
        // Right-handed with u along the axis, so that `plane` is the line angle of docs/reference/coordinates.md, "Step 1".
        if (hypothesis.axis == Axis::Spin)
            seen.push_back({p.z(), p.x(), p.y()});
        else
            seen.push_back({p.x(), p.z(), -p.y()});
    }
    return seen;
}

void reverseBeams(Fit& fit) {
    std::reverse(fit.tilt.begin(), fit.tilt.end());
    for (int i = 0; i < fit.pointOf.lines; ++i) std::reverse(fit.pointOf.line(i), fit.pointOf.line(i) + fit.pointOf.beams);
}
void reverseLines(Fit& fit) {
    std::reverse(fit.plane.begin(), fit.plane.end());
    for (int i = 0; i < fit.pointOf.lines / 2; ++i) {
        std::swap_ranges(fit.pointOf.line(i), fit.pointOf.line(i) + fit.pointOf.beams, fit.pointOf.line(fit.pointOf.lines - 1 - i));
    }
}
/// The same plane seen from its other side.
void turnOver(Fit& fit) {
    for (double& plane : fit.plane) plane += kPi;
    for (double& tilt : fit.tilt) tilt = -tilt;
}

/// +1 when the list runs along neighbouring cells, -1 when against, about 0 when it is shuffled.
double runsAlong(const Grid<std::uint32_t>& pointOf, int lineStep, int beamStep) {
    double votes = 0;
    double pairs = 0;
    for (int i = 0; i + lineStep < pointOf.lines; ++i) {
        for (int j = 0; j + beamStep < pointOf.beams; ++j) {
            const std::uint32_t here = pointOf.at(i, j);
            const std::uint32_t next = pointOf.at(i + lineStep, j + beamStep);
            if (here == kNone || next == kNone) continue;
            votes += next > here ? 1 : -1;
            ++pairs;
        }
    }
    return pairs > 0 ? votes / pairs : 0.0;
}

/// A line angle can be given from either side of its plane. The side is chosen so that the fan looks along +z of the scanner (sweep) or
/// outwards (spin); the beam angles of a fan that is even on both sides ascend.
void describeLikeAScanner(Fit& fit, Axis axis) {
    const double along = runsAlong(fit.pointOf, 0, 1);
    if (along < -0.5) reverseBeams(fit);
    if (runsAlong(fit.pointOf, 1, 0) < -0.5) reverseLines(fit);
    const auto [least, most] = std::minmax(fit.tilt.front(), fit.tilt.back());
    const double span = most - least;
    const double centre = std::remainder((least + most) / 2, 2 * kPi);
    const bool even = std::abs(centre) < 0.1 * span || span > 350 / kDegreesPerRadian;
    const auto ascends = [&] { return (fit.tilt.back() > fit.tilt.front()) == (axis == Axis::Sweep); };
    if (!even && centre < 0) turnOver(fit);
    if (std::abs(along) <= 0.5 && !ascends())
        reverseBeams(fit);
    else if (even && !ascends())
        turnOver(fit);
}

/// Shifted by whole turns so that the smallest beam angle is in [-180, 180), or one turn lower where the largest would lie beyond 360.
void shiftBeams(std::vector<double>& degrees) {
    const auto [least, most] = std::minmax_element(degrees.begin(), degrees.end());
    double turns = std::floor((*least + 180.0 + 1e-6) / 360.0);
    if (*most - 360.0 * turns > 360.0) turns += 1.0;
    for (double& angle : degrees) angle -= 360.0 * turns;
}
void shiftLines(std::vector<double>& degrees) {
    const double turns = std::ceil((degrees.front() - 180.0 - 1e-6) / 360.0);
    for (double& angle : degrees) angle -= 360.0 * turns;
}

PolarGeometry geometryOf(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision, Axis axis) {
    MeasuredAngles measured = measureAngles(fit, points, precision);
    for (auto* angles : {&measured.plane, &measured.planeError, &measured.tilt, &measured.tiltError}) {
        for (double& angle : *angles) angle *= kDegreesPerRadian;
    }
    if (axis == Axis::Spin) {
        for (double& tilt : measured.tilt) tilt = 90.0 - tilt;
    }
    shiftBeams(measured.tilt);
    shiftLines(measured.plane);
    PolarGeometry geometry;
    geometry.beamDeg = tidyAngles(measured.tilt, measured.tiltError);
    geometry.lineDeg = tidyAngles(measured.plane, measured.planeError);
    geometry.axis = axis;
    return geometry;
}

/// Some drivers store every line twice. Drops the copies and returns how many there were.
std::size_t dropCopiedLines(Fit& fit, std::span<const AxisPoint> points) {
    const auto beams = static_cast<std::size_t>(fit.pointOf.beams);
    const auto samePoint = [&](std::uint32_t a, std::uint32_t b) {
        return a != kNone && b != kNone && points[a].u == points[b].u && points[a].v == points[b].v && points[a].w == points[b].w;
    };
    std::vector<bool> copied(fit.plane.size(), false);
    for (std::size_t i = 1; i < fit.plane.size(); ++i) {
        const std::uint32_t* line = fit.pointOf.line(static_cast<int>(i));
        const bool returns = std::any_of(line, line + beams, [&](std::uint32_t k) { return k != kNone && !points[k].missing(); });
        copied[i] = returns && !copied[i - 1] && std::equal(line, line + beams, line - beams, samePoint);
    }
    const auto copies = static_cast<std::size_t>(std::count(copied.begin(), copied.end(), true));
    if (copies * 10 < copied.size() * 4) return 0;
    Fit kept = fit;
    kept.plane.clear();
    kept.pointOf.cells.clear();
    for (std::size_t i = 0; i < copied.size(); ++i) {
        if (copied[i]) continue;
        kept.plane.push_back(fit.plane[i]);
        kept.pointOf.cells.insert(kept.pointOf.cells.end(), fit.pointOf.line(static_cast<int>(i)),
                                  fit.pointOf.line(static_cast<int>(i)) + beams);
    }
    kept.pointOf.lines = static_cast<int>(kept.plane.size());
    fit = std::move(kept);
    return copies;
}

/// A single line is a line only if its beams are regular: any flat curve about the origin is monotone.
bool believable(const Fit& fit) {
    if (fit.plane.size() > 1) return true;
    const double step = medianStep(fit.tilt);
    std::size_t regular = 0;
    for (std::size_t j = 1; j < fit.tilt.size(); ++j) {
        const double ratio = std::abs(fit.tilt[j] - fit.tilt[j - 1]) / step;
        regular += std::abs(ratio - std::max(1.0, std::round(ratio))) < 0.25 ? 1 : 0;
    }
    return regular * 10 >= (fit.tilt.size() - 1) * 9;
}

/// Lines or beams of which no point was left are put back empty, where the others show the step.
std::vector<double> spread(const std::vector<double>& angles, const std::vector<std::size_t>& places) {
    std::vector<double> all(places.back() + 1);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto gap = static_cast<double>(places[i] - places[i - 1]);
        for (std::size_t k = places[i - 1]; k <= places[i]; ++k) {
            all[k] = angles[i - 1] + (angles[i] - angles[i - 1]) * static_cast<double>(k - places[i - 1]) / gap;
        }
    }
    return all;
}
std::size_t putBackMissing(Fit& fit) {
    std::vector<std::size_t> lines = placesOnSteps(fit.plane);
    std::vector<std::size_t> beams = placesOnSteps(fit.tilt);
    if (lines.empty() && beams.empty()) return 0;
    const auto unchanged = [](std::vector<std::size_t>& places, std::size_t count) {
        if (!places.empty()) return false;
        for (std::size_t i = 0; i < count; ++i) places.push_back(i);
        return true;
    };
    if (!unchanged(lines, fit.plane.size())) fit.plane = spread(fit.plane, lines);
    if (!unchanged(beams, fit.tilt.size())) fit.tilt = spread(fit.tilt, beams);
    Grid<std::uint32_t> pointOf(static_cast<int>(fit.plane.size()), static_cast<int>(fit.tilt.size()), kNone);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = 0; j < beams.size(); ++j) {
            pointOf.at(static_cast<int>(lines[i]), static_cast<int>(beams[j])) = fit.pointOf.at(static_cast<int>(i), static_cast<int>(j));
        }
    }
    const std::size_t added = fit.plane.size() - lines.size() + fit.tilt.size() - beams.size();
    fit.pointOf = std::move(pointOf);
    return added;
}

/// Smallest and largest step.
std::pair<double, double> stepsIn(const std::vector<double>& angles) {
    double least = 1e9;
    double most = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        least = std::min(least, std::abs(angles[i] - angles[i - 1]));
        most = std::max(most, std::abs(angles[i] - angles[i - 1]));
    }
    return {least, most};
}

struct Found {
    Fit fit;
    Hypothesis hypothesis;
    std::vector<AxisPoint> points;
};

std::string percent(double share) { return fixedText(std::floor(share * 100), 0); }

std::string sentenceFor(const std::array<NoFit, 3>& seen, const std::vector<Hypothesis>& hypotheses, std::size_t returns) {
    std::string text = withValues("the %1 points do not lie on beam x line angles about the origin:", {returns});
    for (std::size_t h = 0; h < hypotheses.size(); ++h) {
        const bool onLines = seen[h].beams == 0;
        text += h > 0 ? ", " : " ";
        text += withValues(
            seen[h].lines == 0 ? "about %1 no scan lines can be recognised" : "about %1 %2 % lie on the best %3",
            {std::string(1, hypotheses[h].letter), percent(seen[h].onGrid),
             onLines ? counted(seen[h].lines, "line angles", "line angles") : counted(seen[h].beams, "beam angles", "beam angles")});
    }
    return text + " (99 % are needed)";
}

/// Remarks on how the list differed from a full grid in order.
void tellRepairs(RecoveredGrid& grid, std::size_t putBack) {
    const auto tell = [&](std::size_t count, const char* sentence) {
        if (count > 0) grid.remarks.push_back(std::to_string(count) + sentence);
    };
    if (!grid.complete) {
        grid.remarks.push_back(
            withValues("The list was not a full grid in order: %1 lines x %2 beams were recovered from the angles of its points.",
                       {grid.pointOf.lines, grid.pointOf.beams}));
    }
    tell(grid.copiedLines, " lines repeated the line before and were left out.");
    tell(grid.copied, " points stood in the list before, as when a driver stores lines twice, and were taken once.");
    tell(putBack, " lines or beams without any point were put back empty, to keep the steps even.");
    tell(grid.unplaced, " points belong to no single cell of the grid (on the rotation axis, or off the grid) and were left out.");
    tell(grid.doubled, " points lay in a cell with a nearer one, which was taken.");
    const auto [least, most] = stepsIn(grid.geometry.lineDeg);
    if (most > 1.2 * least) {
        grid.remarks.push_back(withValues("The line angles are uneven: steps from %1 to %2 degrees, kept as they are.",
                                          {significantText(least, 4), significantText(most, 4)}));
    }
}

RecoveredGrid finished(Found found, const PointList& list) {
    RecoveredGrid grid;
    grid.copiedLines = found.fit.complete ? dropCopiedLines(found.fit, found.points) : 0;
    if (!found.fit.complete) unfoldHalves(found.fit);
    const std::size_t putBack = found.fit.complete ? 0 : putBackMissing(found.fit);
    describeLikeAScanner(found.fit, found.hypothesis.axis);
    grid.geometry = geometryOf(found.fit, found.points, list.precision, found.hypothesis.axis);
    grid.turn = found.hypothesis.turn;
    grid.complete = found.fit.complete;
    grid.unplaced = found.fit.unplaced;
    grid.doubled = found.fit.doubled;
    grid.copied = found.fit.copied;
    if (!found.hypothesis.turn.isIdentity()) {
        grid.remarks.emplace_back("The lines turn about the file's y axis, which became z: x is the file's z, y its x, z its y.");
    }
    grid.pointOf = std::move(found.fit.pointOf);
    if (!grid.complete) foldPhases(grid);
    tellRepairs(grid, putBack);
    return grid;
}

} // namespace

bool isReturn(const Eigen::Vector3d& point) {
    if (!point.allFinite()) return false;
    const double largest = point.cwiseAbs().maxCoeff();
    return largest > 1e-9 && largest < 1e12; // squares of both stay far from the ends of double
}

Result<RecoveredGrid> recoverGrid(const PointList& list) {
    const auto returns = static_cast<std::size_t>(std::count_if(list.points.begin(), list.points.end(), isReturn));
    if (returns < kFewestPoints) {
        return Error{withValues("holds %1 with a return, too few to find a scanner's grid", {counted(returns, "point")}), "",
                     "check that the file is complete"};
    }
    if (list.points.size() >= kNone) return Error{"holds more points than can be put on a grid", "", "split the file"};
    const auto hypotheses = hypothesesFor(list.axis);
    std::optional<Found> best;
    std::array<NoFit, 3> seen{};
    // Every cell in order; lines in order, with points left out; any order. An organised cloud is in order or no grid of angles.
    enum Way : std::size_t { kEveryCell, kRuns, kGroups };
    for (const Way way : {kEveryCell, kRuns, kGroups}) {
        if (way != kEveryCell && list.rowLength > 0) break;
        for (std::size_t h = 0; h < hypotheses.size(); ++h) {
            const double done = (static_cast<double>(h) / static_cast<double>(hypotheses.size()) + static_cast<double>(way)) / 3;
            if (list.progress && !list.progress("finding the grid", done)) return Error{"cancelled", "", ""};
            std::vector<AxisPoint> points = axisPointsOf(hypotheses[h], list.points);
            auto fit = way == kEveryCell ? fitFileOrder(points, list.precision, list.rowLength)
                       : way == kRuns    ? fitRuns(points, list.precision, seen[h])
                                         : fitGroups(points, list.precision, seen[h]);
            if (!fit || !believable(*fit) || (best && best->fit.residual <= fit->residual)) continue;
            best = Found{std::move(*fit), hypotheses[h], std::move(points)};
            if (best->fit.plane.size() > 1) break; // only a single line can fit more than one axis
        }
        if (best) return finished(std::move(*best), list);
    }
    return Error{sentenceFor(seen, hypotheses, returns), "", "open the scan as the scanner stored it, with its origin at the scanner"};
}

} // namespace edgescan::files
