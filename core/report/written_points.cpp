// Counts and bounds, once from the scan and once from the file.
#include "core/formats/formats.h"
#include "core/report/record_parts.h"

#include <ranges>
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

template <class T>
PointBounds boundsOf(const std::vector<T>& x, const std::vector<T>& y, const std::vector<T>& z) {
    return boundsOf(std::views::iota(std::size_t{0}, x.size()) | std::views::transform([&](std::size_t n) {
                        return Eigen::Vector3d(static_cast<double>(x[n]), static_cast<double>(y[n]), static_cast<double>(z[n]));
                    }));
}

PointBounds boundsOf(const CloudColumns& cloud) {
    const auto of = [&]<class T>(const std::vector<T>& x) {
        return boundsOf(x, std::get<std::vector<T>>(cloud.columns[1].values), std::get<std::vector<T>>(cloud.columns[2].values));
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
    const Source source{path, std::as_bytes(std::span(bytes.data(), bytes.size())), &options};
    const Format* format = writtenFormat(path);
    if (format == nullptr || format->points == nullptr) return std::optional<PointBounds>();
    const auto table = format->points(source);
    if (!table) return table.error();
    return std::optional(boundsOf(table->points));
}

} // namespace edgescan
