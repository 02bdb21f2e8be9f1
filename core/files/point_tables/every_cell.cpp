// The columns of all cells together take more memory than the file; those of some lines stay in the cache.
#include "core/files/point_tables/every_cell.h"

#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/scan_time.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgescan::files {
namespace {

template <class T>
std::vector<T>& emptied(CloudColumn& column, std::size_t room) {
    auto& values = std::get<std::vector<T>>(column.values);
    values.clear();
    values.reserve(room);
    return values;
}

/// Names and types, in the order of the file.
std::vector<CloudColumn> columnsOf(const Scan& scan) {
    std::vector<CloudColumn> columns;
    for (const char* name : {"x", "y", "z"}) columns.push_back({name, std::vector<float>()});
    for (const char* name : {"line", "beam"}) columns.push_back({name, std::vector<std::uint32_t>()});
    columns.push_back({"range_mm", std::vector<float>()});
    if (scan.intensity.size() > 0) columns.push_back({"intensity", std::vector<float>()});
    columns.push_back({"state", std::vector<std::uint8_t>()});
    return columns;
}

/// Lines first <= line < last.
void fill(std::vector<CloudColumn>& columns, const Scan& scan, const CartesianTables& tables, int first, int last) {
    const auto beams = static_cast<std::size_t>(scan.beams());
    const std::size_t room = beams * static_cast<std::size_t>(last - first), before = scan.rangeMm.index(first, 0);
    if (columns.empty()) columns = columnsOf(scan);
    for (std::size_t axis = 0; axis < 3; ++axis) emptied<float>(columns[axis], 0).resize(room);
    auto& line = emptied<std::uint32_t>(columns[3], room);
    auto& beam = emptied<std::uint32_t>(columns[4], room);
    const auto at = [&](std::size_t axis, std::size_t row) { return std::get<std::vector<float>>(columns[axis].values).data() + row; };
    for (int i = first; i < last; ++i) {
        const std::size_t row = beam.size();
        tables.pointsOfLine(i, at(0, row), at(1, row), at(2, row));
        line.insert(line.end(), beams, static_cast<std::uint32_t>(i));
        for (std::uint32_t j = 0; j < beams; ++j) beam.push_back(j);
    }
    const auto take = [&](const auto& cells, auto& values) {
        const auto from = cells.begin() + static_cast<std::ptrdiff_t>(before);
        std::transform(from, from + static_cast<std::ptrdiff_t>(room), std::back_inserter(values),
                       [](auto cell) { return static_cast<typename std::decay_t<decltype(values)>::value_type>(cell); });
    };
    take(scan.rangeMm.cells, emptied<float>(columns[5], room));
    if (scan.intensity.size() > 0) take(scan.intensity.cells, emptied<float>(columns[6], room));
    take(scan.state.cells, emptied<std::uint8_t>(columns.back(), room));
}

} // namespace

bool areWithinFloats(const std::vector<float>& rangesMm) {
    constexpr auto kLargestMm = static_cast<float>(0.99 * kLargestInFloat * 1000.0);
    return std::ranges::all_of(rangesMm, [](float range) { return std::abs(range) < kLargestMm; });
}

std::optional<CloudColumns> cellsByLines(const Scan& scan, CoordinateFrame frame) {
    if (frame != CoordinateFrame::Scanner || !std::holds_alternative<PolarGeometry>(scan.geometry) || !areWithinFloats(scan.rangeMm.cells))
        return std::nullopt;
    CloudColumns cloud;
    cloud.lines = cloud.height = static_cast<std::size_t>(scan.lines());
    cloud.beams = cloud.width = static_cast<std::size_t>(scan.beams());
    if (scan.acquisition) cloud.lineTimesS = scan.acquisition->lineTimesS;
    cloud.startS = startOfScan(scan);
    const auto tables = std::make_shared<const CartesianTables>(scan);
    cloud.sensorM = tables->sensor();
    cloud.columns = columnsOf(scan);
    cloud.linesLater = [&scan, tables](std::size_t first, std::size_t last, std::vector<CloudColumn>& columns) {
        fill(columns, scan, *tables, static_cast<int>(first), static_cast<int>(last));
    };
    return cloud;
}

void makeAll(CloudColumns& cloud) {
    if (!cloud.linesLater) return;
    cloud.linesLater(0, cloud.height, cloud.columns);
    cloud.linesLater = nullptr;
}

} // namespace edgescan::files
