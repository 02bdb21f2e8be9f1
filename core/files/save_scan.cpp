// Chooses the writer by extension.
#include "core/files/save_scan.h"

#include "core/files/cloud_columns.h"
#include "core/files/raw_grid.h"

#include <algorithm>
#include <array>

namespace edgescan {
namespace {

constexpr std::array<std::pair<const char*, SaveFormat>, 8> kExtensions{{
    {".json", SaveFormat::RawGrid},
    {".u16", SaveFormat::RawGrid},
    {".pcd", SaveFormat::Pcd},
    {".ply", SaveFormat::Ply},
    {".xyz", SaveFormat::Xyz},
    {".txt", SaveFormat::Xyz},
    {".asc", SaveFormat::Xyz},
    {".csv", SaveFormat::Csv},
}};

Error unknownFormat(const std::filesystem::path& path, const char* known) {
    const std::string extension = path.extension().string();
    return {extension.empty() ? "the file name has no extension that names a format"
                              : "\"" + extension + "\" is no format that can be written",
            path.string(), std::string("use ") + known};
}

Result<Done> saveColumns(const CloudColumns& columns, SaveFormat format, const std::filesystem::path& path, const SaveOptions& options) {
    switch (format) {
    case SaveFormat::Pcd:
        return savePcd(columns, path, options.ascii);
    case SaveFormat::Ply:
        return savePly(columns, path, options.ascii);
    case SaveFormat::Xyz:
        return savePointText(columns, path, ' ');
    case SaveFormat::Csv:
        return savePointText(columns, path, ',');
    case SaveFormat::RawGrid:
        break;
    }
    return unknownFormat(path, ".pcd, .ply, .xyz or .csv");
}

Result<Done> checkMask(const Scan& scan, const Grid<std::uint8_t>& mask, const std::filesystem::path& path) {
    if (mask.lines == scan.lines() && mask.beams == scan.beams()) return Done{};
    return Error{"the edge mask has " + std::to_string(mask.lines) + " x " + std::to_string(mask.beams) + " cells and the scan " +
                     std::to_string(scan.lines()) + " x " + std::to_string(scan.beams()),
                 path.string(), "detect the edges of this scan again"};
}

} // namespace

std::optional<SaveFormat> saveFormatOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const auto& [known, format] : kExtensions) {
        if (extension == known) return format;
    }
    return std::nullopt;
}

const std::vector<FileKind>& writableScanKinds() {
    static const std::vector<FileKind> kinds{
        {"Point Cloud Library", {".pcd"}},        {"Raw grid", {".json", ".u16"}}, {"Polygon file", {".ply"}},
        {"Point list", {".xyz", ".txt", ".asc"}}, {"Point table", {".csv"}},
    };
    return kinds;
}

const std::vector<FileKind>& writableCloudKinds() {
    static const std::vector<FileKind> kinds{
        {"Point Cloud Library", {".pcd"}},
        {"Polygon file", {".ply"}},
        {"Point list", {".xyz", ".txt", ".asc"}},
        {"Point table", {".csv"}},
    };
    return kinds;
}

Result<Done> saveScan(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!format) return unknownFormat(path, ".json, .pcd, .ply, .xyz or .csv");
    if (scan.cells() == 0) return Error{"the scan has no cells", path.string(), "open a scan first"};
    if (*format == SaveFormat::RawGrid) return saveRawGrid(scan, path);
    return saveColumns(everyCell(scan), *format, path, options);
}

Result<Done> saveCloud(const Scan& scan, const std::filesystem::path& path, const Grid<std::uint8_t>* edgeMask,
                       const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!format || *format == SaveFormat::RawGrid) return unknownFormat(path, ".pcd, .ply, .xyz or .csv");
    if (edgeMask != nullptr) {
        if (auto fits = checkMask(scan, *edgeMask, path); !fits) return fits.error();
    }
    return saveColumns(validPoints(scan, edgeMask), *format, path, options);
}

Result<Done> saveEdges(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                       const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!format || *format == SaveFormat::RawGrid) return unknownFormat(path, ".pcd, .ply, .xyz or .csv");
    if (auto fits = checkMask(scan, edgeMask, path); !fits) return fits.error();
    return saveColumns(edgePoints(scan, edgeMask), *format, path, options);
}

} // namespace edgescan
