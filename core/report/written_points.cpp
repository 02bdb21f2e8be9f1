// Counts and bounds, once from the scan and once from the file.
#include "core/formats/formats.h"
#include "core/report/record_parts.h"

#include <span>

namespace edgescan {
namespace {

template <class Points>
PointBounds boundsOf(const Points& points) {
    PointBounds bounds;
    for (const Eigen::Vector3d& p : points) {
        if (!p.allFinite()) continue; // a cell without a point
        if (bounds.count++ == 0) bounds.leastM = bounds.mostM = p;
        bounds.leastM = bounds.leastM.cwiseMin(p);
        bounds.mostM = bounds.mostM.cwiseMax(p);
    }
    return bounds;
}

PointBounds boundsOf(const CloudColumns& cloud) {
    std::vector<Eigen::Vector3d> points(cloud.width * cloud.height);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::visit(
            [&](const auto& values) {
                for (std::size_t n = 0; n < points.size(); ++n) points[n][static_cast<Eigen::Index>(axis)] = static_cast<double>(values[n]);
            },
            cloud.columns[axis].values);
    }
    return boundsOf(points);
}

} // namespace

PointBounds pointsToWrite(ExportContent content, const Detection& detection, const ExportOptions& options) {
    const bool edges = content == ExportContent::EdgeCloud;
    const std::shared_ptr<const Scan> scan = chosenScan(detection, options);
    return boundsOf(edges ? edgePoints(*scan, *detection.mask, options.frame, options.includeAttached)
                          : validPoints(*scan, detection.mask.get(), options.frame, options.includeAttached));
}

Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path) {
    const ReadingOptions options;
    const Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    const Format* format = writtenFormat(path);
    if (format == nullptr || format->points == nullptr) return std::optional<PointBounds>();
    const auto table = format->points(source);
    if (!table) return table.error();
    return std::optional(boundsOf(table->points));
}

} // namespace edgescan
