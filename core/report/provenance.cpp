// Writing exports with their records.
#include "core/report/provenance.h"

#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/formats/formats.h"
#include "core/io/save_scan.h"
#include "core/pictures/png.h"
#include "core/report/record_parts.h"
#include "core/scan/range_picture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <system_error>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kToleranceM = 6e-4; // LAS rounds to half of a millimetre; a whole one must survive (docs/operator.md, "S9")

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

bool isDevice(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Json vectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// What has to hold of the file besides its bytes.
struct Expected {
    std::size_t count = 0; ///< points or cells
    std::optional<PointBounds> bounds;
};

Expected expectedOf(ExportContent content, const Detection& detection, const fs::path& path, const ExportOptions& options) {
    const bool points = isCloud(content) || (content == ExportContent::WholeScan && writtenFormat(path)->write != nullptr);
    if (!points) return Expected{detection.scan->cells(), std::nullopt};
    const PointBounds bounds = pointsToWrite(content, detection, options);
    return Expected{bounds.count, bounds};
}

/// The one that was asked for.
const FileBytes& fileOf(const std::vector<FileBytes>& files, const fs::path& path) {
    const auto named = std::ranges::find_if(files, [&](const FileBytes& file) { return file.path.extension() == path.extension(); });
    return named == files.end() ? files.front() : *named;
}

std::string sidecarText(const FileBytes& file, const std::string& record, const Expected& expected, const std::vector<FileBytes>& files) {
    Json about{{"file", file.path.filename().string()},
               {"sha256", sha256Hex(bytesOf(file.bytes))},
               {"bytes", file.bytes.size()},
               {"written_utc", utcText(utcNow())},
               {expected.bounds ? "points" : "cells", expected.count}};
    if (expected.bounds && expected.count > 0)
        about["bounds_m"] = {{"least", vectorJson(expected.bounds->leastM)}, {"most", vectorJson(expected.bounds->mostM)}};
    for (const FileBytes& other : files) {
        if (&other != &file)
            about["with"].push_back({{"file", other.path.filename().string()}, {"sha256", sha256Hex(bytesOf(other.bytes))}});
    }
    const Json sidecar{{"format", kSidecarFormat}, {"export", about}, {"record", Json::parse(record)}};
    return sidecar.dump(1, ' ', true, Json::error_handler_t::replace) + "\n";
}

Error differs(const fs::path& path, const std::string& what) {
    return {"what was read back is not what was written: " + what, path.string(), "check the disk and export again"};
}

Result<Done> readBack(const FileBytes& file, const Expected& expected) {
    const fs::path& path = file.path;
    const std::string& bytes = file.bytes;
    const auto found = readWholeFile(path);
    if (!found) return found.error();
    if (!std::ranges::equal(*found, bytesOf(bytes))) return differs(path, "the bytes differ");
    if (!expected.bounds || expected.count == 0) return Done{};
    const auto written = pointsWritten(bytes, path);
    if (!written) return differs(path, written.error().what);
    if (!*written) return Done{};
    const PointBounds& points = **written;
    if (points.count != expected.count)
        return differs(path, "it holds " + std::to_string(points.count) + " points instead of " + std::to_string(expected.count));
    const double off = std::max((points.leastM - expected.bounds->leastM).cwiseAbs().maxCoeff(),
                                (points.mostM - expected.bounds->mostM).cwiseAbs().maxCoeff());
    if (!(off < kToleranceM)) return differs(path, "its bounds are off by " + std::to_string(off) + " m");
    return Done{};
}

} // namespace

Result<std::vector<FileBytes>> exportFiles(ExportContent content, const Detection& detection, const fs::path& path,
                                           const std::string& record, const ExportOptions& options) {
    const Scan& scan = *detection.scan;
    const SaveOptions save{options.ascii, options.frame, record, options.includeAttached, detection.classes.get()};
    const auto one = [&](Result<std::string> bytes) -> Result<std::vector<FileBytes>> {
        if (!bytes) return bytes.error();
        return std::vector<FileBytes>{{path, std::move(*bytes)}};
    };
    switch (content) {
    case ExportContent::EdgeCloud:
        return one(edgeBytes(scan, *detection.mask, path, save));
    case ExportContent::FullCloud:
        return one(cloudBytes(scan, path, detection.mask.get(), save));
    case ExportContent::EdgeImage:
        return one(png8Bytes(*detection.mask, path.string(), record));
    case ExportContent::GrayImage:
        return one(png8Bytes(detection.gray->levels, path.string(), record));
    case ExportContent::WholeScan:
        return scanFiles(scan, path, save);
    case ExportContent::RangeImage:
        break;
    }
    return one(png16Bytes(rangePicture(scan), path.string(), record));
}

std::string embeddedRecord(std::string_view bytes) {
    if (std::string record = pngRecord(bytes); !record.empty()) return record;
    const ReadingOptions options;
    return formatOfContent({{}, std::as_bytes(std::span(bytes)), &options}).record(bytes);
}

fs::path sidecarPath(const fs::path& exported) { return fs::path(exported.string() + ".provenance.json"); }

Result<std::size_t> exportWithProvenance(ExportContent content, const Detection& detection, const fs::path& path,
                                         const ExportOptions& options) {
    const std::string record = exportRecord(content, detection, options);
    const auto files = exportFiles(content, detection, path, record, options);
    if (!files) return files.error();
    const Expected expected = expectedOf(content, detection, path, options);
    if (isDevice(path)) {
        if (files->size() > 1) return Error{"this format is of two files and a device takes one", path.string(), "choose a file"};
        if (auto written = writeWholeFile(path, files->front().bytes); !written) return written.error();
        return expected.count;
    }
    const FileBytes& named = fileOf(*files, path);
    const std::string sidecar = sidecarText(named, record, expected, *files);
    std::vector<FileContent> contents;
    for (const FileBytes& file : *files) contents.push_back({file.path, bytesOf(file.bytes)});
    contents.push_back({sidecarPath(named.path), bytesOf(sidecar)});
    if (auto written = writeWholeFiles(contents); !written) return written.error();
    for (const FileBytes& file : *files) {
        if (auto same = readBack(file, expected); !same) return same.error();
    }
    return expected.count;
}

} // namespace edgescan
