// The table of exports.
#include "core/exports/export_kinds.h"

#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/exports/rock_files.h"
#include "core/exports/section_files.h"
#include "core/exports/target_files.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/range_image.h"

#include <algorithm>
#include <array>

namespace edgescan::exports {
namespace {

using Files = Result<std::vector<FileBytes>>;
using Coordinates = ExportFile::Coordinates;
using Needs = ExportKind::Needs;
using Holds = ExportKind::Holds;
using Counts = ExportKind::Counts;

Files one(const ExportInput& input, Result<std::string> bytes) {
    if (!bytes) return bytes.error();
    std::vector<FileBytes> files; // a list in braces would copy all bytes
    files.push_back({input.path, std::move(*bytes)});
    return files;
}

Files edgeCloud(const ExportInput& in) { return one(in, files::edgeBytes(in.scan, *in.detection.mask, in.path, in.save)); }
Files fullCloud(const ExportInput& in) { return one(in, files::cloudBytes(in.scan, in.path, in.detection.mask.get(), in.save)); }
Files edgeImage(const ExportInput& in) { return one(in, containers::png8Bytes(*in.detection.mask, in.path.string(), in.record)); }
Files grayImageFile(const ExportInput& in) {
    return one(in, containers::png8Bytes(in.detection.gray->levels, in.path.string(), in.record));
}
Files rangeImage(const ExportInput& in) { return one(in, containers::png16Bytes(rangePicture(in.scan), in.path.string(), in.record)); }
Files wholeScan(const ExportInput& in) { return files::scanFiles(in.scan, in.path, in.save); }

rocks::NamedCells rockNames(const ExportOptions& options) { return options.targets ? namedCells(*options.targets) : rocks::NamedCells(); }
Files rockReport(const ExportInput& in) {
    return one(in, reportBytes(*in.options.rocks, in.options.frame, rockNames(in.options), in.path, in.record));
}
Files rockTable(const ExportInput& in) { return one(in, tableBytes(*in.options.rocks, in.options.frame, rockNames(in.options), in.path)); }
Files rockLabelPicture(const ExportInput& in) {
    const auto picture = labelPicture(*in.options.rocks, in.path.string());
    if (!picture) return picture.error();
    return one(in, containers::png16Bytes(*picture, in.path.string(), in.record));
}
Files rockOutlines(const ExportInput& in) { return one(in, outlineBytes(*in.options.rocks, in.options.frame, in.path, in.record)); }
Files rockPictureOutlines(const ExportInput& in) { return one(in, pictureOutlines(*in.options.rocks, in.record)); }
Files rockHullFile(const ExportInput& in) { return one(in, hullBytes(*in.options.rocks, in.options.frame, in.path, in.record)); }
Files section(const ExportInput& in) { return one(in, sectionBytes(in)); }
Files targets(const ExportInput& in) { return one(in, targetBytes(in)); }
constexpr OwnPart kPlane{"section", true, planeRecord, readPlane, sectionContent};
constexpr OwnPart kTargets{"targets", true, targetsRecord, readTargets, targetContent};
constexpr OwnPart kNamesOfTargets{"targets", false, targetsRecord, readTargets};
constexpr std::array kCloudFile{ExportFile{".pcd", nullptr, Coordinates::InName}};
constexpr std::array kPictureFile{ExportFile{".png", nullptr, Coordinates::None}};
constexpr std::array kReportFile{ExportFile{".json", "Report with settings and edits", Coordinates::Inside}};
constexpr std::array kTableFile{ExportFile{".csv", "Table, one row per rock", Coordinates::InName}};
constexpr std::array kLabelFile{ExportFile{".png", "Labels as a 16-bit picture", Coordinates::None}};
constexpr std::array kOutlineFiles{ExportFile{".dxf", "Outlines in space", Coordinates::InName},
                                   ExportFile{".geojson", "Outlines in the mine grid", Coordinates::MineOnly}};
constexpr std::array kPictureOutlineFile{ExportFile{".json", nullptr, Coordinates::None}};
constexpr std::array kHullFiles{ExportFile{".ply", "Convex hulls of the visible points", Coordinates::InName},
                                ExportFile{".obj", "Convex hulls of the visible points", Coordinates::InName, false}};
constexpr std::array kSectionFiles{ExportFile{".dxf", nullptr, Coordinates::Inside, false},
                                   ExportFile{".csv", nullptr, Coordinates::Inside, false},
                                   ExportFile{".png", nullptr, Coordinates::Inside, false}};
constexpr std::array kTargetFiles{ExportFile{".csv", nullptr, Coordinates::InName, false},
                                  ExportFile{".dxf", nullptr, Coordinates::InName, false}};

// clang-format off
constexpr ExportKind kKinds[]{
    {ExportContent::EdgeCloud, "edges", "edge cloud", Needs::Edges, Holds::Points, Counts::EdgePoints, "edges", kCloudFile,
     "--edges", "Edge points in metres: %1", edgeCloud, {"&Edge Cloud…", "Ctrl+E", "Edge points (%1)", "edges"}},
    {ExportContent::FullCloud, "cloud", "full cloud", Needs::Edges, Holds::Points, Counts::Points, "cloud", kCloudFile,
     "--cloud", "All points in metres with a field for edges: the same formats", fullCloud,
     {"&Full Cloud…", "", "All points, with a field for edges (%1)", "cloud"}},
    {ExportContent::EdgeImage, "mask", "edge image", Needs::Edges, Holds::Picture, Counts::Cells, "edges", kPictureFile,
     "--mask", "Edge map, 8-bit PNG, 255 = edge, row = line, column = beam", edgeImage,
     {"Edge &Image…", "", "Edge map as a picture, %1", "edge-map"}},
    {ExportContent::GrayImage, "gray", "gray image", Needs::Edges, Holds::Picture, Counts::Cells, "gray", kPictureFile,
     "--gray", "Gray image, 8-bit PNG", grayImageFile, {"&Gray Image…", "", "Gray image, %1", "gray", false}},
    {ExportContent::RangeImage, "range", "range image", Needs::Edges, Holds::Picture, Counts::Cells, "range", kPictureFile,
     "--range", "Ranges in mm, 16-bit PNG", rangeImage,
     {"&Range Image…", "", "Ranges in millimetres as a picture of 16 bits, %1", "range", false}, "mm"},
    // Every cell with its state, as saveScan writes it; of the detection only the scan counts.
    {ExportContent::WholeScan, "scan", "whole scan", Needs::Scan, Holds::Scan, Counts::Cells, "scan", {}, nullptr, nullptr, wholeScan},
    {ExportContent::RockReport, "rocks", "rock report", Needs::Rocks, Holds::Numbers, Counts::Rocks, "rocks", kReportFile,
     "--json", "All rocks with what may be said of them; - is stdout", rockReport, {}, nullptr, &kNamesOfTargets},
    {ExportContent::RockTable, "rock-table", "rock table", Needs::Rocks, Holds::Numbers, Counts::Rocks, "rocks", kTableFile,
     "--csv", "One row per rock, units in the names", rockTable, {}, nullptr, &kNamesOfTargets},
    {ExportContent::RockLabels, "rock-labels", "rock labels", Needs::Rocks, Holds::Picture, Counts::Cells, "rocks", kLabelFile,
     "--labels", "16-bit PNG: 0 none, then 1..n, the largest visible area first", rockLabelPicture},
    {ExportContent::RockOutlines, "rock-outlines", "rock outlines", Needs::Rocks, Holds::Shapes, Counts::Rocks, "rocks", kOutlineFiles,
     "--outlines", "Around the visible surfaces: closed polylines and numbers (.dxf), or lines in the mine grid (.geojson)", rockOutlines},
    {ExportContent::RockPictureOutlines, "rock-picture-outlines", "rock outlines in the picture", Needs::Rocks, Holds::Picture, Counts::Rocks,
     "picture-outlines", kPictureOutlineFile, "--picture-outlines", "Polygons around the labels, x = beam, y = line: .json", rockPictureOutlines},
    {ExportContent::RockHulls, "rock-hulls", "rock hulls", Needs::Rocks, Holds::Shapes, Counts::Rocks, "hulls", kHullFiles,
     "--hulls", "Convex hulls of the visible points, never a volume: .ply or .obj", rockHullFile},
    {ExportContent::RockCloud, "rock-cloud", "rock cloud", Needs::Rocks, Holds::Points, Counts::Points, "rocks", kCloudFile,
     "--cloud", "All points in metres with a field for rocks", fullCloud},
    {ExportContent::Section, "section", "section", Needs::Rocks, Holds::Shapes, Counts::Rocks, "section", kSectionFiles,
     "--section", "Where a plane cuts the surfaces, in true scale, with edges and rocks: .dxf, .csv or .png", section, {}, nullptr,
     &kPlane},
    {ExportContent::Targets, "targets", "targets", Needs::Targets, Holds::Shapes, Counts::Targets, "targets", kTargetFiles, nullptr,
     nullptr, targets, {"&Targets…", "", "Targets (%1)", "targets", false}, nullptr, &kTargets},
};
// clang-format on

constexpr bool inOrder() {
    for (std::size_t n = 0; n < std::size(kKinds); ++n) {
        if (static_cast<std::size_t>(kKinds[n].content) != n) return false;
    }
    return static_cast<std::size_t>(ExportContent::End) == std::size(kKinds);
}
static_assert(inOrder(), "one row per ExportContent, in its order");

} // namespace

std::span<const ExportKind> exportKinds() { return kKinds; }

const ExportKind& exportKind(ExportContent content) { return kKinds[static_cast<std::size_t>(content)]; }

const ExportKind* exportKindNamed(std::string_view record) {
    const auto* found = std::ranges::find_if(kKinds, [&](const ExportKind& kind) { return record == kind.record; });
    return found == std::end(kKinds) ? nullptr : found;
}

bool namesTargets(ExportContent content) {
    const OwnPart* own = exportKind(content).own;
    return own != nullptr && own->record == targetsRecord;
}

const char* countedThings(const ExportKind& kind) {
    constexpr std::array kThings{"edge points", "points", "cells", "rocks", "targets"};
    return kThings.at(static_cast<std::size_t>(kind.counts));
}

std::string exportFileName(const ExportKind& kind, std::string_view extension, CoordinateFrame frame) {
    const auto file = std::ranges::find_if(kind.files, [&](const ExportFile& each) { return asciiLower(extension) == each.extension; });
    const bool named = kind.holds == Holds::Points || (file != kind.files.end() && file->coordinates == Coordinates::InName);
    return std::string(kind.tail) + (named ? frameTail(frame) : "") + std::string(extension);
}

Result<Done> checkExtension(const ExportKind& kind, const std::filesystem::path& path, const std::string& where, const char* between) {
    std::error_code ignored;
    if (!path.has_filename() || std::filesystem::is_directory(path, ignored))
        return Error{"this is a folder", where, "give the name of a file"};
    const files::Format* format = files::writtenFormat(path);
    if (kind.holds == Holds::Points) {
        if (format != nullptr && format->write != nullptr) return Done{};
        return Error{"the extension names no format for points", where, "use " + files::writtenExtensions(false)};
    }
    if (kind.holds == Holds::Scan)
        return format != nullptr
                   ? Result<Done>(Done{})
                   : Error{"the extension names no format that can be written", where, "use " + files::writtenExtensions(true)};
    // A file under the name of another kind would be refused by the program that opens it.
    if (kind.files.empty() || isDevice(path)) return Done{};
    std::string extensions;
    for (const ExportFile& file : kind.files) {
        if (asciiLower(path.extension().string()) == file.extension) return Done{};
        extensions += (extensions.empty() ? "" : between) + std::string(file.extension);
    }
    return Error{"the extension names no format for this", where, "use " + extensions};
}

} // namespace edgescan::exports
