// Counts and bounds of points, from the scan and from the file.
#include "core/exports/record_parts.h"
#include "core/files/formats/formats.h"
#include "core/inspect/measure/cell_sets.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

namespace edgescan::exports {
namespace {

void addTo(PointBounds& bounds, std::span<const Eigen::Vector3d> points) {
    for (const Eigen::Vector3d& p : points) {
        if (!p.allFinite()) continue; // a cell without a point
        if (bounds.count++ == 0) bounds.leastM = bounds.mostM = p;
        bounds.leastM = bounds.leastM.cwiseMin(p);
        bounds.mostM = bounds.mostM.cwiseMax(p);
    }
}

/// Bounds of one coordinate, computed for several cells in parallel. NaN changes neither the smallest nor the largest value.
struct SideBySide {
    static constexpr std::size_t kLanes = 16;
    std::array<float, kLanes> least, most;

    SideBySide() {
        least.fill(std::numeric_limits<float>::infinity());
        most.fill(-std::numeric_limits<float>::infinity());
    }
    void add(const std::vector<float>& values) { // a multiple of kLanes
        for (std::size_t first = 0; first < values.size(); first += kLanes) {
            for (std::size_t n = 0; n < kLanes; ++n) {
                const float value = values[first + n];
                least[n] = value < least[n] ? value : least[n];
                most[n] = value > most[n] ? value : most[n];
            }
        }
    }
};

/// Bounds of all valid cells of a polar scan in its own frame, line by line and without a cloud; empty if there are also other points.
std::optional<PointBounds> boundsOfCells(const Scan& scan) {
    if (!std::holds_alternative<PolarGeometry>(scan.geometry)) return std::nullopt;
    const CartesianTables tables(scan);
    const auto beams = static_cast<std::size_t>(scan.beams());
    const std::size_t room = (beams + SideBySide::kLanes - 1) / SideBySide::kLanes * SideBySide::kLanes;
    std::array<std::vector<float>, 3> line;
    for (std::vector<float>& ofAxis : line) ofAxis.resize(room, std::numeric_limits<float>::quiet_NaN());
    std::array<SideBySide, 3> all;
    for (int i = 0; i < scan.lines(); ++i) {
        tables.pointsOfLine(i, line[0].data(), line[1].data(), line[2].data());
        for (std::size_t axis = 0; axis < 3; ++axis) all[axis].add(line[axis]);
    }
    PointBounds bounds;
    bounds.count = static_cast<std::size_t>(std::ranges::count(scan.state.cells, CellState::Valid));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float least = *std::ranges::min_element(all[axis].least), most = *std::ranges::max_element(all[axis].most);
        // Floats are exact enough for these (core/files/point_tables/cloud_columns.cpp); of 0 and -0 the first one counts.
        constexpr float kMostM = 9000;
        if (!(std::abs(least) < kMostM && std::abs(most) < kMostM) || least == 0 || most == 0) return std::nullopt;
        bounds.leastM[static_cast<Eigen::Index>(axis)] = static_cast<double>(least);
        bounds.mostM[static_cast<Eigen::Index>(axis)] = static_cast<double>(most);
    }
    return bounds;
}

template <class T>
PointBounds boundsOf(const std::vector<T>& x, const std::vector<T>& y, const std::vector<T>& z) {
    PointBounds bounds;
    std::array<T, 3> least{}, most{};
    for (std::size_t n = 0; n < x.size(); ++n) {
        const std::array<T, 3> p{x[n], y[n], z[n]};
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue; // a cell without a point
        if (bounds.count++ == 0) least = most = p;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], p[axis]);
            most[axis] = std::max(most[axis], p[axis]);
        }
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        bounds.leastM[axis] = static_cast<double>(least[static_cast<std::size_t>(axis)]);
        bounds.mostM[axis] = static_cast<double>(most[static_cast<std::size_t>(axis)]);
    }
    return bounds;
}

PointBounds boundsOf(const files::CloudColumns& cloud) {
    const auto of = [&]<class T>(const std::vector<T>& x) -> PointBounds {
        if constexpr (std::is_floating_point_v<T>)
            return boundsOf(x, std::get<std::vector<T>>(cloud.columns[1].values), std::get<std::vector<T>>(cloud.columns[2].values));
        else
            return {}; // the coordinates have a decimal point
    };
    return std::visit(of, cloud.columns[0].values);
}

} // namespace

std::shared_ptr<const Scan> chosenScan(const edges::Detection& detection, const ExportOptions& options) {
    const bool filled = options.choices.filled && detection.filled;
    if (!options.selection && !filled) return detection.scan;
    auto chosen = std::make_shared<Scan>(filled ? withFilled(*detection.scan, *detection.filled).scan : *detection.scan);
    if (!options.selection) return chosen;
    for (const std::uint32_t k : inspect::allBut(*options.selection, chosen->cells())) {
        if (chosen->state[k] == CellState::Valid) chosen->state[k] = CellState::Masked;
    }
    return chosen;
}

nlohmann::ordered_json selectionRecord(const ExportOptions& options) {
    if (!options.selection) return {};
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const inspect::CellRun& run : inspect::runsOf(*options.selection)) runs.push_back({run.first, run.count});
    return {{"cells", options.selection->size()}, {"runs", std::move(runs)}};
}

std::shared_ptr<const std::vector<std::uint32_t>> selectionOf(const nlohmann::ordered_json& record, std::size_t cells) {
    const auto none = std::make_shared<const inspect::CellSet>();
    if (!record.is_object() || !record.contains("runs") || !record["runs"].is_array()) return none;
    std::vector<inspect::CellRun> runs;
    for (const auto& run : record["runs"]) {
        const bool pair = run.is_array() && run.size() == 2 && run[0].is_number_unsigned() && run[1].is_number_unsigned();
        if (!pair || run[0] > UINT32_MAX || run[1] > UINT32_MAX) return none;
        runs.push_back({run[0].get<std::uint32_t>(), run[1].get<std::uint32_t>()});
    }
    return std::make_shared<const inspect::CellSet>(inspect::cellsOf(runs, cells));
}

PointBounds pointsToWrite(ExportContent content, const edges::Detection& detection, const ExportOptions& options) {
    const bool edges = exportKind(content).counts == ExportKind::Counts::EdgePoints;
    const std::shared_ptr<const Scan> scan = chosenScan(detection, options);
    const bool attached = options.includeAttached && !scan->attached.empty();
    if (!edges && !attached && options.frame == CoordinateFrame::Scanner) {
        if (const auto bounds = boundsOfCells(*scan)) return *bounds;
    }
    return boundsOf(files::placesOfPoints(*scan, edges ? detection.mask.get() : nullptr, options.frame, options.includeAttached));
}

Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path) {
    const ReadingOptions options;
    files::Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    source.placesOnly = true;
    PointBounds bounds;
    source.receivePlaces = [&bounds](std::span<const Eigen::Vector3d> points) { addTo(bounds, points); };
    const files::Format* format = files::writtenFormat(path);
    if (format == nullptr || format->write == nullptr || format->read == nullptr) return std::optional<PointBounds>();
    auto reading = format->read(source);
    if (!reading) return reading.error();
    addTo(bounds, files::pointsAsWritten(std::move(*reading))); // those that the reader did not give away
    return std::optional(bounds);
}

} // namespace edgescan::exports
