// Saves a scan, its cloud or its edge points. The extension chooses the format.
#pragma once

#include "core/base/file_bytes.h"
#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/point_tables/cloud_columns.h"
#include "core/files/point_tables/writing_choices.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

struct SaveOptions {
    bool ascii = false; ///< PCD and PLY as text
    CoordinateFrame frame = CoordinateFrame::Scanner;
    std::string record{};         ///< provenance JSON for the comment lines; empty = none
    bool includeAttached = false; ///< clouds and edges of a projected cloud: also the points behind the nearest of each cell
    const Grid<edges::DepthEdge>* classes = nullptr; ///< lines x beams: clouds and edges get a field "class" with it; null = none
    WritingChoices choices{};
    std::vector<CellColumn> columns{}; ///< one more field each in clouds and edges
};

/// The frame of an export that names none, in every command, the window and Python: the mine grid if the scan has its place there, else the
/// scanner's. A `file` whose format holds measurements (raw grid, recording) has no other frame than the scanner's.
[[nodiscard]] CoordinateFrame usualFrame(const Scan& scan, const std::filesystem::path& file = {});

/// Error with the reason when the scan has no place in the mine and the frame asks for one. `where` goes into it.
Result<Done> checkFrame(const Scan& scan, CoordinateFrame frame, const std::string& where);

/// The bytes that the functions below write. `path` chooses the format and goes into errors; nothing is written.
Result<std::string> cloudBytes(const Scan& scan, const std::filesystem::path& path, const Grid<std::uint8_t>* edgeMask,
                               const SaveOptions& options = {});
Result<std::string> edgeBytes(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                              const SaveOptions& options = {});

/// The files that saveScan writes, in the order they must appear; nothing is written. A raw grid has two.
Result<std::vector<FileBytes>> scanFiles(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options = {});

/// Sentences about what of this scan a file of that name will not hold: attached points, the grid, states. Empty when it opens again as
/// the same scan.
[[nodiscard]] std::vector<std::string> lostOnSaving(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options = {});

/// The whole grid with every cell, its state and the angles: openScan gives back the same ranges, states, angles and axis. Points that
/// are attached to cells are not part of a grid: with `includeAttached` a cloud of all points is saved in its place.
/// Error: the format is unknown, cannot carry this scan (says why), or the file cannot be written; the old file stays.
Result<Done> saveScan(const Scan& scan, const std::filesystem::path& path, const SaveOptions& options = {});

} // namespace edgescan::files
