// Sets of cells.
#include "core/inspect/measure/cell_sets.h"

#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace edgescan::inspect {

CellSet cellsInside(int lines, int beams, std::span<const Eigen::Vector2d> corners) {
    CellSet set;
    if (corners.size() < 3) return set;
    std::vector<double> crossings;
    for (int line = 0; line < lines; ++line) {
        const double y = line + 0.5;
        crossings.clear();
        for (std::size_t n = 0; n < corners.size(); ++n) {
            const Eigen::Vector2d& a = corners[n];
            const Eigen::Vector2d& b = corners[(n + 1) % corners.size()];
            if ((a.y() <= y) == (b.y() <= y)) continue;
            crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
        std::ranges::sort(crossings);
        for (std::size_t n = 0; n + 1 < crossings.size(); n += 2) {
            const double first = std::clamp(std::ceil(crossings[n] - 0.5), 0.0, static_cast<double>(beams));
            const double end = std::clamp(std::ceil(crossings[n + 1] - 0.5), 0.0, static_cast<double>(beams));
            for (auto beam = static_cast<std::uint32_t>(first); beam < static_cast<std::uint32_t>(end); ++beam)
                set.push_back(static_cast<std::uint32_t>(line) * static_cast<std::uint32_t>(beams) + beam);
        }
    }
    return set;
}

CellSet chainAt(const Grid<std::uint8_t>& mask, std::uint32_t k) {
    if (k >= mask.size() || mask[k] == 0) return {};
    std::vector<std::uint8_t> taken(mask.size(), 0);
    CellSet chain{k};
    taken[k] = 1;
    for (std::size_t next = 0; next < chain.size(); ++next) {
        const int line = static_cast<int>(chain[next] / static_cast<std::uint32_t>(mask.beams));
        const int beam = static_cast<int>(chain[next] % static_cast<std::uint32_t>(mask.beams));
        for (int i = line - 1; i <= line + 1; ++i) {
            for (int j = beam - 1; j <= beam + 1; ++j) {
                if (!mask.contains(i, j)) continue;
                const std::size_t at = mask.index(i, j);
                if (mask[at] == 0 || taken[at] != 0) continue;
                taken[at] = 1;
                chain.push_back(static_cast<std::uint32_t>(at));
            }
        }
    }
    std::ranges::sort(chain);
    return chain;
}

CellSet united(const CellSet& a, const CellSet& b) {
    CellSet both;
    std::ranges::set_union(a, b, std::back_inserter(both));
    return both;
}

CellSet without(const CellSet& a, const CellSet& b) {
    CellSet rest;
    std::ranges::set_difference(a, b, std::back_inserter(rest));
    return rest;
}

CellSet allBut(const CellSet& set, std::size_t cells) {
    CellSet rest;
    rest.reserve(cells - std::min(cells, set.size()));
    auto next = set.begin();
    for (std::uint32_t k = 0; k < cells; ++k) {
        if (next != set.end() && *next == k)
            ++next;
        else
            rest.push_back(k);
    }
    return rest;
}

CellSet cellsBeyond(const Scan& scan, double nearM, double farM) {
    CellSet beyond;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const double rangeM = static_cast<double>(scan.rangeMm[k]) / 1000.0;
        if (scan.state[k] == CellState::Valid && (rangeM < nearM || rangeM > farM)) beyond.push_back(static_cast<std::uint32_t>(k));
    }
    return beyond;
}

CellSet cellsOutsideBoxOf(const Scan& scan, const CellSet& set) {
    const CartesianTables tables(scan);
    Eigen::AlignedBox3d box;
    for (const std::uint32_t k : set) {
        if (k < scan.cells() && scan.state[k] == CellState::Valid) box.extend(tables.point(k));
    }
    CellSet outside;
    if (box.isEmpty()) return outside;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid && !box.contains(tables.point(k))) outside.push_back(static_cast<std::uint32_t>(k));
    }
    return outside;
}

std::vector<CellRun> runsOf(const CellSet& set) {
    std::vector<CellRun> runs;
    for (const std::uint32_t k : set) {
        if (!runs.empty() && runs.back().first + runs.back().count == k)
            ++runs.back().count;
        else
            runs.push_back({k, 1});
    }
    return runs;
}

CellSet cellsOf(std::span<const CellRun> runs, std::size_t cells) {
    CellSet set;
    std::size_t end = 0;
    for (const CellRun& run : runs) {
        if (run.count == 0 || run.first < end || run.count > cells || run.first > cells - run.count) return {};
        for (std::uint32_t n = 0; n < run.count; ++n) set.push_back(run.first + n);
        end = run.first + static_cast<std::size_t>(run.count);
    }
    return set;
}

} // namespace edgescan::inspect
