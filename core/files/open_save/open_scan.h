// Opens any readable file as a scan. The content decides what it is; the extension is only a hint.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/reading_options.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace edgescan::scanner {
struct PlayedLine;
}

namespace edgescan::files {

struct Reading;
struct Source;

/// The file as a scan of lines x beams cells; "-" is standard input, and the folder of a ROS 2 bag is its file. A pipe is read to its end,
/// and gzip is unpacked by content. `played`: called after every line of a recording. Error: one sentence; a file is never loaded in part.
Result<Scan> openScan(const std::filesystem::path& path, const ReadingOptions& options = {},
                      const std::function<void(const scanner::PlayedLine&)>& played = {});

/// openScan(), and then the step that needs the whole sweep: with options.straighten the angles are corrected, else a warning reports beams
/// or lines that are displaced. For all programs that show, export or verify scans.
Result<Scan> openAsAsked(const std::filesystem::path& path, const ReadingOptions& options = {});

/// As openScan(), from bytes in memory; `extension` (".pcd") is the hint that a file's name would be. No file is touched: a raw grid is its
/// description, a NUL byte and its counts.
Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options = {});

/// The steps behind a reader: place on a grid, apply options, check. `placesItself`: Format::placesItself. For what comes from elsewhere
/// than a file.
Result<Scan> scanOfReading(Reading reading, const Source& source, bool placesItself);

/// The name of a scan of this file: "wall" for wall.pcd and wall.pcd.gz, "stdin" for "-".
[[nodiscard]] std::string scanName(const std::filesystem::path& path);

} // namespace edgescan::files
