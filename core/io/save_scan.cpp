// Chooses the writer by extension.
#include "core/io/save_scan.h"

#include "core/base/whole_file.h"
#include "core/readers/raw_grid.h"
#include "core/recording/save_recording.h"
#include "core/writers/cloud_columns.h"
#include "core/writers/save_formats.h"

#include <algorithm>
#include <array>
#include <span>

namespace edgescan {
namespace {

constexpr std::array<std::pair<const char*, SaveFormat>, 13> kExtensions{{
    {".json", SaveFormat::RawGrid},
    {".u16", SaveFormat::RawGrid},
    {".pcd", SaveFormat::Pcd},
    {".ply", SaveFormat::Ply},
    {".xyz", SaveFormat::Xyz},
    {".txt", SaveFormat::Xyz},
    {".asc", SaveFormat::Xyz},
    {".csv", SaveFormat::Csv},
    {".las", SaveFormat::Las},
    {".dxf", SaveFormat::Dxf},
    {".ptx", SaveFormat::Ptx},
    {".obj", SaveFormat::Obj},
    {".mcap", SaveFormat::Recording},
}};

constexpr const char* kPointFormats = ".pcd, .ply, .xyz, .csv, .las, .dxf, .ptx or .obj";

Error unknownFormat(const std::filesystem::path& path, const char* known) {
    const std::string extension = path.extension().string();
    return {extension.empty() ? "the file name has no extension that names a format"
                              : "\"" + extension + "\" is no format that can be written",
            path.string(), std::string("use ") + known};
}

Result<std::string> bytesOf(CloudColumns columns, SaveFormat format, const std::filesystem::path& path, const SaveOptions& options) {
    columns.record = options.record;
    switch (format) {
    case SaveFormat::Pcd:
        return pcdBytes(columns, path.string(), options.ascii);
    case SaveFormat::Ply:
        return plyBytes(columns, path.string(), options.ascii);
    case SaveFormat::Xyz:
        return pointTextBytes(columns, path.string(), ' ');
    case SaveFormat::Csv:
        return pointTextBytes(columns, path.string(), ',');
    case SaveFormat::Las:
        return lasBytes(columns, path.string());
    case SaveFormat::Dxf:
        return dxfBytes(columns, path.string());
    case SaveFormat::Ptx:
        return ptxBytes(columns, path.string());
    case SaveFormat::Obj:
        return objBytes(columns, path.string());
    case SaveFormat::RawGrid:
    case SaveFormat::Recording:
        break;
    }
    return unknownFormat(path, kPointFormats);
}

Result<Done> write(const Result<std::string>& bytes, const std::filesystem::path& path) {
    if (!bytes) return bytes.error();
    return writeWholeFile(path, *bytes);
}

Result<Done> checkMask(const Scan& scan, const Grid<std::uint8_t>& mask, const std::filesystem::path& path) {
    if (mask.lines == scan.lines() && mask.beams == scan.beams()) return Done{};
    return Error{"the edge mask has " + std::to_string(mask.lines) + " x " + std::to_string(mask.beams) + " cells and the scan " +
                     std::to_string(scan.lines()) + " x " + std::to_string(scan.beams()),
                 path.string(), "detect the edges of this scan again"};
}

bool holdsPoints(std::optional<SaveFormat> format) { return format && edgescan::holdsPoints(*format); }

Result<std::vector<FileBytes>> oneFile(const std::filesystem::path& path, Result<std::string> bytes) {
    if (!bytes) return bytes.error();
    return std::vector<FileBytes>{{path, std::move(*bytes)}};
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
        {"Point Cloud Library", {".pcd"}}, {"Raw grid", {".json", ".u16"}},
        {"Polygon file", {".ply"}},        {"Point list", {".xyz", ".txt", ".asc"}},
        {"Point table", {".csv"}},         {"Recording", {".mcap"}},
        {"Leica PTX", {".ptx"}},           {"LAS point cloud", {".las"}},
        {"Wavefront OBJ", {".obj"}},       {"Drawing", {".dxf"}},
    };
    return kinds;
}

const std::vector<FileKind>& writableCloudKinds() {
    static const std::vector<FileKind> kinds{
        {"Point Cloud Library", {".pcd"}}, {"Polygon file", {".ply"}},    {"Point list", {".xyz", ".txt", ".asc"}},
        {"Point table", {".csv"}},         {"LAS point cloud", {".las"}}, {"Drawing with edge lines", {".dxf"}},
        {"Leica PTX", {".ptx"}},           {"Wavefront OBJ", {".obj"}},
    };
    return kinds;
}

Result<Done> checkFrame(const Scan& scan, CoordinateFrame frame, const std::string& where) {
    if (frame == CoordinateFrame::Scanner || scan.placement) return Done{};
    return Error{"the scan has no pose, so its place in the mine grid is not known", where,
                 "give a pose and the robot's calibration, or save in the scanner's frame"};
}

bool holdsPoints(SaveFormat format) { return format != SaveFormat::RawGrid && format != SaveFormat::Recording; }

Result<std::vector<FileBytes>> scanFiles(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!format) return unknownFormat(path, ".json, .pcd, .ply, .xyz, .csv, .las, .ptx, .obj, .dxf or .mcap");
    if (scan.cells() == 0) return Error{"the scan has no cells", path.string(), "open a scan first"};
    if (*format == SaveFormat::RawGrid && options.frame == CoordinateFrame::Scanner) return rawGridFiles(scan, path);
    if (*format == SaveFormat::Recording && options.frame == CoordinateFrame::Scanner) {
        auto bytes = recordingOf(scan, path.string());
        if (!bytes) return bytes.error();
        return oneFile(path, std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
    }
    if (!holdsPoints(*format))
        return Error{"a raw grid or a recording holds ranges and no coordinates", path.string(),
                     std::string("save it without a frame, or as ") + kPointFormats};
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    const bool allPoints = options.includeAttached && !scan.attached.empty();
    const CloudColumns columns = allPoints ? validPoints(scan, nullptr, options.frame, true) : everyCell(scan, options.frame);
    return oneFile(path, bytesOf(columns, *format, path, options));
}

std::vector<std::string> lostOnSaving(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    std::vector<std::string> lost;
    const auto format = saveFormatOf(path);
    if (!format) return lost;
    const auto cells = countCells(scan);
    const std::size_t valid = cells[static_cast<std::size_t>(CellState::Valid)];
    const std::size_t noReturn = cells[static_cast<std::size_t>(CellState::NoReturn)];
    const std::size_t without = scan.cells() - valid;
    const bool attached = !scan.attached.empty();
    if (attached && !options.includeAttached)
        lost.push_back(std::to_string(scan.attached.size()) +
                       " points behind the nearest of their cell are not in this file: --include-attached saves all points.");
    const bool list = *format == SaveFormat::Dxf || *format == SaveFormat::Obj || (attached && options.includeAttached);
    if (list)
        lost.push_back("The file holds points and no grid: " + std::to_string(without) + " cells without a range are not in it.");
    else if (*format == SaveFormat::Ptx && without > noReturn)
        lost.push_back("PTX knows only points and no returns: " + std::to_string(without - noReturn) +
                       " cells of other states become no returns.");
    return lost;
}

Result<Done> saveScan(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    const auto files = scanFiles(scan, path, options);
    if (!files) return files.error();
    std::vector<FileContent> contents;
    for (const FileBytes& file : *files) contents.push_back({file.path, std::as_bytes(std::span(file.bytes))});
    return contents.size() == 1 ? writeWholeFile(path, contents.front().bytes) : writeWholeFiles(contents);
}

Result<std::string> cloudBytes(const Scan& scan, const std::filesystem::path& path, const Grid<std::uint8_t>* edgeMask,
                               const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!holdsPoints(format)) return unknownFormat(path, kPointFormats);
    if (edgeMask != nullptr) {
        if (auto fits = checkMask(scan, *edgeMask, path); !fits) return fits.error();
    }
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    return bytesOf(validPoints(scan, edgeMask, options.frame, options.includeAttached, options.classes), *format, path, options);
}

Result<std::string> edgeBytes(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                              const SaveOptions& options) {
    const auto format = saveFormatOf(path);
    if (!holdsPoints(format)) return unknownFormat(path, kPointFormats);
    if (auto fits = checkMask(scan, edgeMask, path); !fits) return fits.error();
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    return bytesOf(edgePoints(scan, edgeMask, options.frame, options.includeAttached, options.classes), *format, path, options);
}

Result<Done> saveCloud(const Scan& scan, const std::filesystem::path& path, const Grid<std::uint8_t>* edgeMask,
                       const SaveOptions& options) {
    return write(cloudBytes(scan, path, edgeMask, options), path);
}

Result<Done> saveEdges(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                       const SaveOptions& options) {
    return write(edgeBytes(scan, edgeMask, path, options), path);
}

} // namespace edgescan
