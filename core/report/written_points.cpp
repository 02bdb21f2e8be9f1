// Counts and bounds, once from the scan and once from the file.
#include "core/files/cloud_columns.h"
#include "core/files/pcd.h"
#include "core/files/ply.h"
#include "core/files/point_text.h"
#include "core/report/record_parts.h"

#include <span>

namespace edgescan {
namespace {

template <class Points>
PointBounds boundsOf(const Points& points) {
    PointBounds bounds;
    for (const Eigen::Vector3d& p : points) {
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

Result<std::optional<PointBounds>> boundsIn(const Result<PointTable>& table) {
    if (!table) return table.error();
    return std::optional(boundsOf(table->points));
}

} // namespace

Result<PointBounds> pointsToWrite(ExportContent content, const Frame& frame, CoordinateFrame coordinates) {
    const bool all = content == ExportContent::FullCloud;
    return boundsOf(all ? validPoints(*frame.scan, frame.mask.get(), coordinates) : edgePoints(*frame.scan, *frame.mask, coordinates));
}

Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path) {
    const OpenOptions options;
    const Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    if (looksLikePcd(bytes)) return boundsIn(readPcdPoints(source));
    if (looksLikePly(bytes)) return boundsIn(readPlyPoints(source));
    const std::string extension = source.extension();
    if (extension != ".csv" && extension != ".xyz" && extension != ".txt" && extension != ".asc") return std::optional<PointBounds>();
    const auto layout = textLayoutOf(source);
    if (!layout) return layout.error();
    return boundsIn(readTextPoints(source, *layout));
}

} // namespace edgescan
