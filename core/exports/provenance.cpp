// Writes exports with their records.
#include "core/exports/provenance.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/exports/cell_columns.h"
#include "core/exports/frame_points.h"
#include "core/exports/record_parts.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/cell_runs.h"
#include "core/files/point_tables/description.h"
#include "core/files/point_tables/source.h"
#include "core/rocks/attributes/study.h"
#include "core/rocks/attributes/visible_surface.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <utility>

namespace edgescan::exports {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kToleranceM = 6e-4; // LAS rounds to half a millimetre; whole millimetres must be preserved (docs/reference/rules.md, "S9")

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

Json vectorJson(const Eigen::Vector3d& v) {
    constexpr double kPerM = 1e6; // the digits behind a micrometre are those of arithmetic
    return {rounded(v.x(), kPerM), rounded(v.y(), kPerM), rounded(v.z(), kPerM)};
}

/// The expected content of the file, in addition to its bytes.
struct Expected {
    std::size_t count = 0; ///< points or cells
    std::optional<PointBounds> bounds;
    const char* of = "points";
    std::optional<Eigen::AlignedBox3d> box{}; ///< of what a section cuts, and of targets
};

Expected expectedOf(ExportContent content, const edges::Detection& detection, const fs::path& path, const ExportOptions& options) {
    const ExportKind& kind = exportKind(content);
    if (kind.own != nullptr && kind.own->content != nullptr) {
        const OwnPart::Content own = kind.own->content(detection, options, path);
        return Expected{own.count, std::nullopt, countedThings(kind), own.box};
    }
    if (kind.counts == ExportKind::Counts::Rocks)
        return Expected{options.rocks ? rocks::rocksToList(*options.rocks).size() : 0, std::nullopt, countedThings(kind)};
    const bool points = isCloud(content) || (kind.holds == ExportKind::Holds::Scan && files::writtenFormat(path)->write != nullptr);
    if (!points) return Expected{detection.scan->cells(), std::nullopt, countedThings(kind)};
    const PointBounds bounds = pointsToWrite(content, detection, options);
    return Expected{bounds.count, bounds};
}

/// The requested file.
const FileBytes& fileOf(const std::vector<FileBytes>& files, const fs::path& path) {
    const auto named = std::ranges::find_if(files, [&](const FileBytes& file) { return file.path.extension() == path.extension(); });
    return named == files.end() ? files.front() : *named;
}

/// The grid of the points for clouds, and for whole scans whose file has no room for it, with the cell of each point: so the points open
/// as cells of the grid again.
struct SidecarGrid {
    Json description{};  ///< null: the file holds its grid itself
    std::string cells{}; ///< the same: empty
};
SidecarGrid sidecarGrid(ExportContent content, const edges::Detection& detection, const fs::path& path, const ExportOptions& options) {
    const files::Format* format = files::writtenFormat(path);
    const bool whole = exportKind(content).holds == ExportKind::Holds::Scan;
    if (format == nullptr || format->write == nullptr || !(isCloud(content) || whole)) return {};
    const bool everyCell = whole && (!options.includeAttached || detection.scan->attached.empty());
    const bool holdsGrid = format->keeps == files::Keeps::States || (format->keeps == files::Keeps::Sidecar && options.choices.comments);
    if (everyCell && holdsGrid) return {};
    const bool edges = exportKind(content).counts == ExportKind::Counts::EdgePoints;
    const std::shared_ptr<const Scan> chosen = isCloud(content) ? chosenScan(detection, options) : detection.scan;
    return {files::descriptionJson(*detection.scan),
            files::cellRunsText(*chosen, edges ? detection.mask.get() : nullptr, options.includeAttached)};
}

std::string sidecarText(const FileBytes& file, const std::string& record, SidecarGrid grid, const Expected& expected,
                        const std::vector<FileBytes>& files) {
    Json about{{"file", file.path.filename().string()},
               {"sha256", sha256Hex(bytesOf(file.bytes))},
               {"bytes", file.bytes.size()},
               {"written_utc", utcText(utcNow())},
               {expected.of, expected.count}};
    if (expected.bounds && expected.count > 0)
        about["bounds_m"] = {{"least", vectorJson(expected.bounds->leastM)}, {"most", vectorJson(expected.bounds->mostM)}};
    for (const FileBytes& other : files) {
        if (&other != &file)
            about["with"].push_back({{"file", other.path.filename().string()}, {"sha256", sha256Hex(bytesOf(other.bytes))}});
    }
    if (!grid.cells.empty()) about["cells_of_points"] = grid.cells;
    const auto parsed = parseOrderedJson(record, "");
    Json sidecar{{"format", files::kSidecarFormat}, {"export", about}, {"record", parsed ? *parsed : Json()}};
    if (!grid.description.is_null()) sidecar["grid"] = std::move(grid.description);
    return asciiJsonText(sealedSidecar(std::move(sidecar)), 1) + "\n";
}

/// The box of the points; of the cells of the listed rocks where rocks are written.
Eigen::AlignedBox3d extentOf(ExportContent content, const Expected& expected, const edges::Detection& detection, CoordinateFrame frame,
                             const ExportOptions& options) {
    if (expected.box) return *expected.box;
    Eigen::AlignedBox3d box;
    if (expected.bounds && expected.count > 0) box = {expected.bounds->leastM, expected.bounds->mostM};
    const ExportKind& kind = exportKind(content);
    if (kind.counts != ExportKind::Counts::Rocks || !options.rocks) return box;
    const Scan& scan = *detection.scan;
    const FramePoints points(scan, frame);
    const Grid<std::uint32_t> labels = rocks::visibleSurfaces(*options.rocks->segmentation, options.rocks->map); // as their outlines
    std::vector<std::uint8_t> isListed(options.rocks->map.rocks + std::size_t{1});
    for (const rocks::Rock* rock : rocks::rocksToList(*options.rocks)) isListed[rock->label] = 1;
    for (std::uint32_t k = 0; k < scan.cells(); ++k) {
        if (isListed[labels[k]] != 0 && scan.state[k] == CellState::Valid) box.extend(points.at(k));
    }
    return box;
}

/// Reads the bytes before they are written: if a format cannot hold the numbers, the error must not blame the disk.
Result<Done> checkContent(const FileBytes& file, const Expected& expected) {
    if (!expected.bounds || expected.count == 0) return Done{};
    const auto refused = [&](const std::string& what) {
        return Error{"this format cannot hold the scan, nothing was written: " + what, file.path.string(), "choose another format"};
    };
    const auto written = pointsWritten(file.bytes, file.path);
    if (!written) return refused(written.error().what);
    if (!*written) return Done{};
    const PointBounds& points = **written;
    if (points.count != expected.count)
        return refused("it would hold " + std::to_string(points.count) + " points instead of " + std::to_string(expected.count));
    const double off = std::max((points.leastM - expected.bounds->leastM).cwiseAbs().maxCoeff(),
                                (points.mostM - expected.bounds->mostM).cwiseAbs().maxCoeff());
    if (!(off < kToleranceM)) return refused("its bounds would be off by " + significantText(off, 6) + " m");
    return Done{};
}

} // namespace

Result<std::vector<FileBytes>> exportFiles(ExportContent content, const edges::Detection& detection, const fs::path& path,
                                           const std::string& record, const ExportOptions& options) {
    const std::shared_ptr<const Scan> chosen = isCloud(content) ? chosenScan(detection, options) : detection.scan;
    const Scan& scan = *chosen;
    auto columns = cellColumns(exportKind(content), detection, path, options);
    if (!columns) return columns.error();
    const files::SaveOptions save{options.ascii,   options.frame,      record, options.includeAttached, detection.classes.get(),
                                  options.choices, std::move(*columns)};
    return exportKind(content).make({detection, scan, path, record, options, save});
}

std::string embeddedRecord(std::string_view bytes) {
    if (std::string record = containers::pngRecord(bytes); !record.empty()) return record;
    const ReadingOptions options;
    return files::formatOfContent({{}, std::as_bytes(std::span(bytes)), &options}).record(bytes);
}

Result<Written> exportWithProvenance(ExportContent content, const edges::Detection& detection, const fs::path& path,
                                     const ExportOptions& options) {
    const std::string record = exportRecord(content, detection, options);
    const auto files = exportFiles(content, detection, path, record, options);
    if (!files) return files.error();
    const Expected expected = expectedOf(content, detection, path, options);
    for (const FileBytes& file : *files) {
        if (auto same = checkContent(file, expected); !same) return same.error();
    }
    Written done{expected.count};
    if (const auto frame = frameOfFile(content, path, options))
        done.coordinates = coordinatesOf(content, *detection.scan, path, options, extentOf(content, expected, detection, *frame, options));
    if (isDevice(path)) {
        if (files->size() > 1) return Error{"this format is of two files and a device takes one", path.string(), "choose a file"};
        if (auto written = writeWholeFile(path, files->front().bytes); !written) return written.error();
        return done;
    }
    const FileBytes& named = fileOf(*files, path);
    const std::string sidecar = sidecarText(named, record, sidecarGrid(content, detection, named.path, options), expected, *files);
    std::vector<FileContent> contents;
    for (const FileBytes& file : *files) contents.push_back({file.path, bytesOf(file.bytes)});
    if (options.sidecar) contents.push_back({files::sidecarPath(named.path), bytesOf(sidecar)});
    if (auto written = writeWholeFiles(contents); !written) return written.error();
    return done;
}

} // namespace edgescan::exports
