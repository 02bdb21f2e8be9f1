// Chooses the writer by extension.
#include "core/files/open_save/save_scan.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/files/formats/formats.h"
#include "core/scan/georef/placed_points.h"

#include <algorithm>
#include <span>
#include <utility>

namespace edgescan::files {
namespace {

Error unknownFormat(const std::filesystem::path& path, bool wholeScans) {
    const std::string extension = path.extension().string();
    return {extension.empty() ? "the file name has no extension that names a format"
                              : withValues("\"%1\" is not a format that can be written", {extension}),
            path.string(), withValues("use %1", {writtenExtensions(wholeScans)})};
}

/// The format of a cloud; null when the file's name does not choose one.
const Format* cloudFormat(const std::filesystem::path& path) {
    const Format* format = writtenFormat(path);
    return format != nullptr && format->write != nullptr ? format : nullptr;
}

Result<std::string> bytesOf(CloudColumns columns, const Format& format, const std::filesystem::path& path, const SaveOptions& options) {
    columns.record = options.record;
    columns.choices = options.choices;
    return format.write(std::move(columns), path.string(), options.ascii);
}

Result<Done> checkMask(const Scan& scan, const Grid<std::uint8_t>& mask, const std::filesystem::path& path) {
    if (mask.lines == scan.lines() && mask.beams == scan.beams()) return Done{};
    return Error{withValues("the edge mask has %1 x %2 cells and the scan %3 x %4", {mask.lines, mask.beams, scan.lines(), scan.beams()}),
                 path.string(), "detect the edges of this scan again"};
}

Result<std::vector<FileBytes>> oneFile(const std::filesystem::path& path, Result<std::string> bytes) {
    if (!bytes) return bytes.error();
    std::vector<FileBytes> files; // a list in braces would copy all bytes
    files.push_back({path, std::move(*bytes)});
    return files;
}

} // namespace

CoordinateFrame usualFrame(const Scan& scan, const std::filesystem::path& file) {
    const Format* format = writtenFormat(file);
    const bool measurements = format != nullptr && format->write == nullptr;
    return scan.placement && !measurements ? CoordinateFrame::Mine : CoordinateFrame::Scanner;
}

Result<Done> checkFrame(const Scan& scan, CoordinateFrame frame, const std::string& where) {
    if (frame == CoordinateFrame::Scanner || scan.placement) return Done{};
    return Error{"the scan has no pose, so its place in the mine grid is not known", where,
                 "give a pose and the robot's calibration, or save in the scanner's frame"};
}

Result<std::vector<FileBytes>> scanFiles(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    const Format* format = writtenFormat(path);
    if (format == nullptr) return unknownFormat(path, true);
    if (scan.cells() == 0) return Error{"the scan has no cells", path.string(), "open a scan first"};
    if (format->writeScan != nullptr && options.frame == CoordinateFrame::Scanner) return format->writeScan(scan, path);
    if (format->write == nullptr)
        return Error{"a raw grid or a recording holds ranges and no coordinates", path.string(),
                     withValues("save it without a frame, or as %1", {writtenExtensions(false)})};
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    const bool allPoints = options.includeAttached && !scan.attached.empty();
    CloudColumns columns = allPoints               ? validPoints(scan, nullptr, options.frame, true)
                           : format->writesByLines ? everyCellByLines(scan, options.frame)
                                                   : everyCell(scan, options.frame);
    return oneFile(path, bytesOf(std::move(columns), *format, path, options));
}

namespace {

/// How far the place from which beams start is from that of the first line at most, metres: a lever arm turns it with the stepper, a moving
/// base carries it on.
double scannerMovesM(const Scan& scan) {
    const PlacedPoints placed(scan);
    const auto start = [&](int line) { return placed.local(line, 0, Eigen::Vector3d::Zero()); };
    double most = 0;
    for (int line = 1; line < scan.lines(); ++line) most = std::max(most, (start(line) - start(0)).norm());
    return most;
}

} // namespace

std::vector<std::string> lostOnSaving(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options) {
    std::vector<std::string> lost;
    const Format* format = writtenFormat(path);
    if (format == nullptr) return lost;
    const auto cells = countCells(scan);
    const std::size_t valid = cells[static_cast<std::size_t>(CellState::Valid)];
    const std::size_t noReturn = cells[static_cast<std::size_t>(CellState::NoReturn)];
    const std::size_t without = scan.cells() - valid;
    const bool attached = !scan.attached.empty();
    if (attached && !options.includeAttached)
        lost.push_back(counted(scan.attached.size(),
                               "point behind the nearest of its cell is not in this file: --include-attached saves all points.",
                               "points behind the nearest of their cell are not in this file: --include-attached saves all points."));
    const bool bySidecar = format->keeps == Keeps::Sidecar;
    const bool needsSidecar = bySidecar && !options.choices.comments;
    const bool list = format->keeps == Keeps::Points || (attached && options.includeAttached);
    if (list)
        lost.push_back(withValues("The file holds points and no grid: %1 cells without a range are not in it.", {without}));
    else if ((format->keeps == Keeps::NoReturns || needsSidecar) && without > noReturn)
        lost.push_back(
            withValues("This file knows only points and no returns: %1 cells of other states become no returns.", {without - noReturn}));
    if (needsSidecar && !list)
        lost.push_back(withValues(
            "The file holds numbers only: keep %1.provenance.json next to it, which holds the grid, or write it with --comments.",
            {path.filename().string()}));
    if (scan.intensity.size() > 0 && !format->keepsIntensity && !(bySidecar && options.choices.comments))
        lost.emplace_back("The file does not hold the intensities: .pcd, .ply, .las, .ptx and .csv do.");
    if (format->stepM > 0 && std::holds_alternative<PointGeometry>(scan.geometry) && options.frame == CoordinateFrame::Scanner)
        lost.push_back(withValues("The file rounds the points to whole steps of %1 mm.", {significantText(format->stepM * 1000, 3)}));
    if (scan.placement && options.frame == CoordinateFrame::Scanner && format->keeps != Keeps::States &&
        !(bySidecar && options.choices.comments))
        lost.emplace_back(
            "The file is in the scanner's frame and does not hold the scan's place in the mine: --frame mine gives mine coordinates.");
    constexpr double kMovesM = 0.0005;
    if (format->keeps == Keeps::NoReturns && scan.placement && options.frame != CoordinateFrame::Scanner) {
        if (const double moves = scannerMovesM(scan); moves > kMovesM)
            lost.push_back(withValues("The file has room for one place of the scanner, and this scanner moved by up to %1 mm: without "
                                      "%2.provenance.json its ranges are as much off; its points are exact.",
                                      {significantText(moves * 1000, 2), path.filename().string()}));
    }
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
    const Format* format = cloudFormat(path);
    if (format == nullptr) return unknownFormat(path, false);
    if (edgeMask != nullptr) {
        if (auto fits = checkMask(scan, *edgeMask, path); !fits) return fits.error();
    }
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    return bytesOf(validPoints(scan, edgeMask, options.frame, options.includeAttached, options.classes, options.columns), *format, path,
                   options);
}

Result<std::string> edgeBytes(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                              const SaveOptions& options) {
    const Format* format = cloudFormat(path);
    if (format == nullptr) return unknownFormat(path, false);
    if (auto fits = checkMask(scan, edgeMask, path); !fits) return fits.error();
    if (auto known = checkFrame(scan, options.frame, path.string()); !known) return known.error();
    return bytesOf(edgePoints(scan, edgeMask, options.frame, options.includeAttached, options.classes, options.columns), *format, path,
                   options);
}

} // namespace edgescan::files
