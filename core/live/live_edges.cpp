// The method on the rows that a new line can reach.
#include "core/live/live_edges.h"

#include "core/gray/canny.h"
#include "core/scan/missing_cells.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace edgescan {
namespace {

constexpr int kWholeMm = 1 << 17; // ranges of whole millimetres that are looked up
constexpr int kLooked = 4;        // every how many cells are looked at to know a scan again

/// One line that holds these ranges, all valid.
Scan lineOf(std::vector<float> ranges) {
    Scan line;
    const int beams = static_cast<int>(ranges.size());
    line.rangeMm = Grid<float>(1, beams, std::move(ranges));
    line.state = Grid<CellState>(1, beams, CellState::Valid);
    return line;
}

bool isFixed(const Settings& settings) {
    return settings.scaling != Scaling::Thesis && !std::isnan(settings.nearMm) && !std::isnan(settings.farMm);
}

} // namespace

Settings withFixedWindow(const Settings& settings, const Scan& scan) {
    Settings fixed = settings;
    const GrayScale scale = grayScale(scan, settings);
    if (settings.scaling == Scaling::Thesis) fixed.scaling = Scaling::Window;
    fixed.nearMm = scale.nearMm;
    fixed.farMm = scale.farMm;
    return fixed;
}

Result<LiveEdges> LiveEdges::make(const Settings& settings) {
    if (settings.method != Method::Canny)
        return Error{"this method looks at the whole scan and cannot follow it line by line", "--method", "use canny"};
    if (isFixed(settings)) return LiveEdges(settings);
    return Error{"gray levels that follow the nearest and farthest range cannot stay while a scan grows", "near and far",
                 "fix them before the scan begins"};
}

LiveEdges::LiveEdges(const Settings& settings) : settings_(settings) {
    std::vector<float> ranges(kWholeMm);
    for (int mm = 0; mm < kWholeMm; ++mm) ranges[static_cast<std::size_t>(mm)] = static_cast<float>(mm);
    GrayImage table = grayImage(lineOf(std::move(ranges)), settings);
    levels_ = std::move(table.levels.cells);
    scale_ = table.scale;
}

int LiveEdges::unsettledRows() const { return gray_.lines - hysteresis_.settledRows(); }

void LiveEdges::reset(int beams) {
    gray_ = masked_ = smoothed_ = Grid<std::uint8_t>(0, beams);
    gradient_ = GradientRows(beams);
    hysteresis_ = LiveHysteresis(beams);
    saturated_ = 0;
}

std::uint8_t LiveEdges::levelOf(float rangeMm) const {
    if (rangeMm >= 0 && rangeMm < kWholeMm) {
        const int mm = static_cast<int>(rangeMm);
        if (static_cast<float>(mm) == rangeMm) return levels_[static_cast<std::size_t>(mm)];
    }
    return grayImage(lineOf({rangeMm}), settings_).levels[0];
}

/// The first and the last row taken are still there, as far as a sample of their cells tells.
bool LiveEdges::continues(const Scan& scan) const {
    if (scan.lines() < gray_.lines || scan.beams() != gray_.beams) return false;
    for (const int row : {0, gray_.lines - 1}) {
        for (int beam = 0; row >= 0 && beam < gray_.beams; beam += kLooked) {
            const std::size_t k = gray_.index(row, beam);
            if (gray_[k] != (scan.state[k] == CellState::Valid ? levelOf(scan.rangeMm[k]) : 0)) return false;
        }
    }
    return true;
}

void LiveEdges::update(const Scan& scan) {
    if (gray_.lines == 0 || !continues(scan)) reset(scan.beams());
    const int first = gray_.lines;
    if (scan.lines() == first || scan.beams() == 0) return;
    takeGray(scan, first);
    takeMasked(scan, first);
    // A new row changes whether its neighbour stands alone, and takes the mirrored border away from those above.
    const int alone = 1;
    const Grid<std::uint8_t>* masked = settings_.maskMissing ? &masked_ : nullptr;
    smoothRows(smoothed_, gray_, masked, settings_, std::max(0, first - alone - smoothReach()));
    const int unsteady = alone + smoothReach() + gradientReach();
    const int unsettled = unsteady + 1; // neighbours in non-maximum suppression
    gradient_.update(smoothed_, masked, settings_, std::max(0, first - unsteady), std::max(0, first - unsettled - 1));
    const int row = std::max(0, first - unsettled);
    hysteresis_.update(gradient_.classes(settings_, row), std::max(0, scan.lines() - unsettled) - row);
}

void LiveEdges::takeGray(const Scan& scan, int first) {
    gray_.lines = scan.lines();
    gray_.cells.resize(scan.cells());
    for (std::size_t k = gray_.index(first, 0); k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const float range = scan.rangeMm[k];
        gray_[k] = levelOf(range);
        saturated_ += range < scale_.nearMm || range > scale_.farMm ? 1U : 0U;
    }
}

void LiveEdges::takeMasked(const Scan& scan, int first) {
    const bool isolated = settings_.maskMissing && settings_.maskIsolated;
    const int changed = isolated ? std::max(0, first - 1) : first;
    masked_.lines = scan.lines();
    masked_.cells.resize(scan.cells());
    const std::size_t from = masked_.index(changed, 0);
    for (std::size_t k = from; k < scan.cells(); ++k) masked_[k] = scan.state[k] == CellState::Valid ? 0 : 255;
    if (!isolated) return;
    const Grid<std::uint8_t> alone = isolatedCells(scan, changed, scan.lines());
    for (std::size_t k = 0; k < alone.size(); ++k) masked_[from + k] |= alone[k];
}

std::shared_ptr<const Detection> LiveEdges::detection(const std::shared_ptr<const Scan>& scan) const {
    const auto start = std::chrono::steady_clock::now();
    Detection detection;
    detection.scan = scan;
    detection.settings = settings_;
    detection.gray = std::make_shared<const GrayImage>(GrayImage{gray_, scale_, saturated_});
    detection.smoothed = std::make_shared<const Grid<std::uint8_t>>(smoothed_);
    detection.mask = std::make_shared<const Grid<std::uint8_t>>(mask());
    detection.edges = std::make_shared<const std::vector<std::uint32_t>>(edgeCells(mask()));
    detection.totalMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return std::make_shared<const Detection>(std::move(detection));
}

} // namespace edgescan
