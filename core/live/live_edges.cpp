// The method on the rows that a new line can reach.
#include "core/live/live_edges.h"

#include "core/edges/canny.h"
#include "core/edges/holes.h"
#include "core/edges/smooth.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace edgescan {
namespace {

constexpr int kWholeMm = 1 << 17; // ranges of whole millimetres that are looked up

Grid<std::uint8_t> rowsFrom(const Grid<std::uint8_t>& grid, int first) {
    return {grid.lines - first, grid.beams,
            std::vector<std::uint8_t>(grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.index(first, 0)), grid.cells.end())};
}

/// Ranges and states of some rows.
Scan rowsOf(const Scan& scan, int first) {
    Scan rows;
    const auto begin = static_cast<std::ptrdiff_t>(scan.rangeMm.index(first, 0));
    rows.rangeMm =
        Grid<float>(scan.lines() - first, scan.beams(), std::vector<float>(scan.rangeMm.cells.begin() + begin, scan.rangeMm.cells.end()));
    rows.state = Grid<CellState>(scan.lines() - first, scan.beams(),
                                 std::vector<CellState>(scan.state.cells.begin() + begin, scan.state.cells.end()));
    return rows;
}

/// Puts the rows of `part` from `row` on into the same rows of `whole`; row 0 of `part` is row `start` of `whole`.
void replaceRows(Grid<std::uint8_t>& whole, const Grid<std::uint8_t>& part, int start, int row) {
    whole.lines = start + part.lines;
    whole.cells.resize(whole.index(whole.lines, 0));
    std::copy(part.cells.begin() + static_cast<std::ptrdiff_t>(part.index(row - start, 0)), part.cells.end(),
              whole.cells.begin() + static_cast<std::ptrdiff_t>(whole.index(row, 0)));
}

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
    hysteresis_ = LiveHysteresis(beams);
    saturated_ = 0;
}

std::uint8_t LiveEdges::levelOf(float rangeMm) const {
    if (rangeMm >= 0 && rangeMm < kWholeMm && rangeMm == std::floor(rangeMm)) return levels_[static_cast<std::size_t>(rangeMm)];
    return grayImage(lineOf({rangeMm}), settings_).levels[0];
}

/// The first and the last row taken are still there.
bool LiveEdges::continues(const Scan& scan) const {
    if (scan.lines() < gray_.lines || scan.beams() != gray_.beams) return false;
    for (const int row : {0, gray_.lines - 1}) {
        for (int beam = 0; row >= 0 && beam < gray_.beams; ++beam) {
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
    smoothFrom(std::max(0, first - alone - smoothReach()));
    const int unsettled = alone + smoothReach() + gradientReach() + 1; // 1: neighbours in non-maximum suppression
    classifyFrom(std::max(0, first - unsettled), std::max(0, scan.lines() - unsettled));
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
    const int start = std::max(0, changed - 1);
    const Scan rows = rowsOf(scan, start);
    Grid<std::uint8_t> masked = missingCells(rows);
    if (isolated) {
        const Grid<std::uint8_t> alone = isolatedCells(rows);
        for (std::size_t k = 0; k < masked.size(); ++k) masked[k] |= alone[k];
    }
    replaceRows(masked_, masked, start, changed);
}

void LiveEdges::smoothFrom(int row) {
    const int start = std::max(0, row - smoothReach());
    const Grid<std::uint8_t> gray = rowsFrom(gray_, start);
    const Grid<std::uint8_t> smoothed =
        settings_.maskMissing ? smoothAroundHoles(gray, rowsFrom(masked_, start), settings_) : smooth(gray, settings_);
    replaceRows(smoothed_, smoothed, start, row);
}

/// With both thresholds alike Canny tells which cells are beyond: beyond the lower one weak, beyond the upper one strong.
void LiveEdges::classifyFrom(int row, int settled) {
    const int start = std::max(0, row - 1 - gradientReach());
    const Grid<std::uint8_t> smoothed = rowsFrom(smoothed_, start);
    const Grid<std::uint8_t> masked = rowsFrom(masked_, start);
    const auto beyond = [&](double threshold) {
        Settings one = settings_;
        one.lower = threshold;
        one.ratio = 1.0;
        return settings_.maskMissing ? cannyAroundHoles(smoothed, masked, one) : canny(smoothed, one);
    };
    const Grid<std::uint8_t> weak = beyond(std::min(settings_.lower, settings_.upper()));
    const Grid<std::uint8_t> strong = beyond(std::max(settings_.lower, settings_.upper()));
    Grid<EdgeClass> classes(smoothed.lines - (row - start), smoothed.beams, EdgeClass::None);
    const std::size_t offset = smoothed.index(row - start, 0);
    for (std::size_t k = 0; k < classes.size(); ++k) {
        if (weak[k + offset] != 0) classes[k] = strong[k + offset] != 0 ? EdgeClass::Strong : EdgeClass::Weak;
    }
    hysteresis_.update(classes, settled - row);
}

std::shared_ptr<const Frame> LiveEdges::frame(const std::shared_ptr<const Scan>& scan) const {
    const auto start = std::chrono::steady_clock::now();
    Frame frame;
    frame.scan = scan;
    frame.settings = settings_;
    frame.gray = std::make_shared<const GrayImage>(GrayImage{gray_, scale_, saturated_});
    frame.smoothed = std::make_shared<const Grid<std::uint8_t>>(smoothed_);
    frame.mask = std::make_shared<const Grid<std::uint8_t>>(mask());
    frame.edges = std::make_shared<const std::vector<std::uint32_t>>(edgeCells(mask()));
    frame.totalMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return std::make_shared<const Frame>(std::move(frame));
}

} // namespace edgescan
