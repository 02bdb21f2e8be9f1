// Counts and bounds, once from the scan and once from the file.
#include "core/io/save_scan.h"
#include "core/readers/las.h"
#include "core/readers/obj.h"
#include "core/readers/pcd.h"
#include "core/readers/ply.h"
#include "core/readers/point_text.h"
#include "core/readers/ptx.h"
#include "core/report/record_parts.h"
#include "core/writers/cloud_columns.h"
#include "core/writers/dxf_points.h"

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

Result<std::optional<PointBounds>> boundsIn(const Result<PointTable>& table) {
    if (!table) return table.error();
    return std::optional(boundsOf(table->points));
}

Result<std::optional<PointBounds>> boundsOfPoints(const Result<std::vector<Eigen::Vector3d>>& points) {
    if (!points) return points.error();
    return std::optional(boundsOf(*points));
}

} // namespace

PointBounds pointsToWrite(ExportContent content, const Detection& detection, const ExportOptions& options) {
    const bool edges = content == ExportContent::EdgeCloud;
    return boundsOf(edges ? edgePoints(*detection.scan, *detection.mask, options.frame, options.includeAttached)
                          : validPoints(*detection.scan, detection.mask.get(), options.frame, options.includeAttached));
}

Result<std::optional<PointBounds>> pointsWritten(std::string_view bytes, const std::filesystem::path& path) {
    const ReadingOptions options;
    const Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    const auto format = saveFormatOf(path);
    if (!format) return std::optional<PointBounds>();
    switch (*format) {
    case SaveFormat::Pcd:
        return boundsIn(readPcdPoints(source));
    case SaveFormat::Ply:
        return boundsIn(readPlyPoints(source));
    case SaveFormat::Las:
        return boundsIn(readLasPoints(source));
    case SaveFormat::Obj:
        return boundsIn(readObjPoints(source));
    case SaveFormat::Ptx:
        return boundsOfPoints(readPtxPoints(source));
    case SaveFormat::Dxf:
        return boundsOfPoints(dxfPoints(bytes, path.string()));
    case SaveFormat::Csv:
    case SaveFormat::Xyz: {
        const auto layout = textLayoutOf(source);
        if (!layout) return layout.error();
        return boundsIn(readTextPoints(source, *layout));
    }
    case SaveFormat::RawGrid:
    case SaveFormat::Recording:
        break;
    }
    return std::optional<PointBounds>();
}

} // namespace edgescan
