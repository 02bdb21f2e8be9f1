// The cloud's view of a sweep while it grows, until the operator moves it.
#include "core/base/order_statistic.h"
#include "core/scan/grid/mean_step.h"
#include "core/scan/grid/scan.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/cloud_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kCoarseSide = 33;     // lines and beams of the coarse cloud
constexpr double kHalfTurn = 180.0; // degrees

float medianRange(const Scan& scan) {
    std::vector<float> ranges;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state.cells[k] == CellState::Valid) ranges.push_back(scan.rangeMm.cells[k]);
    }
    return median(std::move(ranges));
}

/// A coarse cloud in the directions of all lines of a sweep, at the median range of its first ones: a view that shows it need not move
/// while the sweep grows. `expectedLines` 0: not known, half a turn. Null: fewer than two lines, or no line angles.
std::shared_ptr<const CloudGeometry> wholeSweep(const Scan& scan, int expectedLines) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || scan.placement || polar->lineDeg.size() < 2 || polar->beamDeg.size() < 2) return nullptr;
    const double step = meanStepDeg(polar->lineDeg);
    const float range = medianRange(scan);
    if (!std::isfinite(step) || step == 0.0 || range <= 0.0F) return nullptr;
    const double lines = expectedLines > 0 ? expectedLines : std::max<double>(scan.lines(), 1.0 + kHalfTurn / std::abs(step));
    PolarGeometry coarse{{}, {}, polar->axis, polar->lineDirection};
    for (int n = 0; n < kCoarseSide; ++n) {
        const double share = n / (kCoarseSide - 1.0);
        coarse.lineDeg.push_back(polar->lineDeg.front() + share * step * (lines - 1.0));
        coarse.beamDeg.push_back(std::lerp(polar->beamDeg.front(), polar->beamDeg.back(), share));
    }
    Scan whole;
    whole.rangeMm = Grid<float>(kCoarseSide, kCoarseSide, range);
    whole.state = Grid<CellState>(kCoarseSide, kCoarseSide, CellState::Valid);
    whole.geometry = std::move(coarse);
    return makeCloudGeometry(whole);
}

constexpr double kSeen = 0.1;     // share of the points: half a turn in a narrow cloud has .15
constexpr double kMuchMore = 1.2; // times
constexpr int kLinesToFit = 8;    // of a growing sweep: if their places are not known by now, the view stays where it is

/// The lines of a growing sweep got other places: its axis showed in the ranges, or the operator gave angles.
bool turnsOtherwise(const Scan& before, const Scan& now) {
    constexpr double kSameStep = 0.01; // share of the step
    constexpr double kSameStart = 1.0; // degrees
    const auto *a = std::get_if<PolarGeometry>(&before.geometry), *b = std::get_if<PolarGeometry>(&now.geometry);
    if (a == nullptr || b == nullptr || a->lineDeg.size() < 2 || b->lineDeg.size() < 2) return false;
    const double stepOfA = a->lineDirection * meanStepDeg(a->lineDeg), stepOfB = b->lineDirection * meanStepDeg(b->lineDeg);
    return a->axis != b->axis || std::abs(stepOfA - stepOfB) > kSameStep * std::abs(stepOfA) ||
           std::abs(a->lineDeg.front() - b->lineDeg.front()) > kSameStart;
}

} // namespace

/// Another sweep has directions of its own after a part of one, and a view of its own then, and where its first lines are outside of the
/// view. So has a sweep whose lines got other places. A view that the operator moved stays.
void LinkedViews::followSweep(const Picture& last, bool untouched) {
    const Growth &before = last.source.growth, &now = shown()->source.growth;
    const bool isAnother = before.sweep != now.sweep;
    const bool wasPart = isAnother && last.detection->scan->lines() < std::max(1, before.expectedLines);
    const bool hasOtherPlaces = !isAnother && now.growing && turnsOtherwise(*last.detection->scan, *shown()->detection->scan);
    const bool wasPlaced = last.detection->scan->placement != nullptr, isPlaced = shown()->detection->scan->placement != nullptr;
    if (wasPart || hasOtherPlaces || wasPlaced != isPlaced) cloud_.setAxes(std::nullopt);
    nameDirections();
    if (!untouched) return;
    if (wasPart || hasOtherPlaces || (isAnother && cloud_.shareInPicture() < kSeen)) {
        fitted_ = false;
        framedLines_ = 0;
    }
    fitToSweep();
}

/// Of the engine's picture, also while another one is shown. A sweep has those of the whole sweep, from its beginning to its end and in the
/// next sweep: the mean direction of its points turns while it grows, and one view would be Top at first and then Front.
void LinkedViews::nameDirections() {
    const Growth& growth = picture_->source.growth;
    const Scan& scan = *picture_->detection->scan;
    if (growth.sweep >= 0 && cloud_.axesSet() && !scan.placement) return;
    if (!growth.growing || scan.placement) return cloud_.setAxes(picture_->cloud->axes);
    if (const auto whole = wholeSweep(scan, growth.expectedLines)) cloud_.setAxes(whole->axes);
}

/// The view moves only where it shows, or would soon show, a small part of them.
void LinkedViews::frameFirstLines(const CameraPose& before) {
    const int lines = shown()->detection->scan->lines();
    cloud_.setCamera(before);
    if (lines < 2 * framedLines_ && cloud_.shareInPicture() >= kSeen) return;
    framedLines_ = lines;
    cloud_.viewFromScanner();
}

/// Its first lines were at other ranges, or at the angles of a part: the view moves if it shows much more of the points then.
void LinkedViews::showEndOfSweep() {
    const CameraPose before = cloud_.camera();
    const double share = cloud_.shareInPicture();
    cloud_.viewFromScanner();
    if (cloud_.shareInPicture() < kMuchMore * share) cloud_.setCamera(before);
}

/// Once, as soon as the place of its lines is known: the view shows what is to come, and does not move while it comes. A sweep may begin
/// far at a side, outside of that view: it shows the first lines until enough of what came is in it.
void LinkedViews::fitToSweep() {
    const Growth& growth = shown()->source.growth;
    if (!fitted_ && growth.growing) {
        const auto whole = wholeSweep(*shown()->detection->scan, growth.expectedLines);
        const CameraPose before = cloud_.camera();
        if (whole) cloud_.frameFromScanner(*whole);
        fitted_ = whole ? cloud_.shareInPicture() >= kSeen : shown()->detection->scan->lines() >= kLinesToFit;
        if (whole && !fitted_) frameFirstLines(before);
    } else {
        if (!fitted_ && framedLines_ > 0) cloud_.viewFromScanner(); // the sweep ended before
        if (growth.sweep >= 0 && !growth.growing) showEndOfSweep();
        fitted_ = true;
    }
    fittedCamera_ = cloud_.camera();
}

} // namespace edgescan::ui
