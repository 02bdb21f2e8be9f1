// Counts and bounds, once from the scan and once from the file.
#include "core/formats/formats.h"
#include "core/report/record_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

namespace edgescan {
namespace {

PointBounds boundsOf(const std::vector<Eigen::Vector3d>& points) {
    PointBounds bounds;
    for (const Eigen::Vector3d& p : points) {
        if (!p.allFinite()) continue; // a cell without a point
        if (bounds.count++ == 0) bounds.leastM = bounds.mostM = p;
        bounds.leastM = bounds.leastM.cwiseMin(p);
        bounds.mostM = bounds.mostM.cwiseMax(p);
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

PointBounds boundsOf(const CloudColumns& cloud) {
    const auto of = [&]<class T>(const std::vector<T>& x) -> PointBounds {
        if constexpr (std::is_floating_point_v<T>)
            return boundsOf(x, std::get<std::vector<T>>(cloud.columns[1].values), std::get<std::vector<T>>(cloud.columns[2].values));
        else
            return {}; // coordinates are numbers with a point
    };
    return std::visit(of, cloud.columns[0].values);
}

} // namespace

PointBounds pointsToWrite(ExportContent content, const Detection& detection, const ExportOptions& options) {
    const bool edges = content == ExportContent::EdgeCloud;
    const std::shared_ptr<const Scan> scan = chosenScan(detection, options);
    return boundsOf(placesOfPoints(*scan, edges ? detection.mask.get() : nullptr, options.frame, options.includeAttached));
}

Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path) {
    const ReadingOptions options;
    Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    source.placesOnly = true;
    const Format* format = writtenFormat(path);
    if (format == nullptr || format->points == nullptr) return std::optional<PointBounds>();
    const auto table = format->points(source);
    if (!table) return table.error();
    return std::optional(boundsOf(table->points));
}

} // namespace edgescan
