// Opens any readable file as a scan. The content decides what it is; the extension is only a hint.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/reading_options.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace edgescan::files {

class Replay;

/// The file as a scan of lines x beams cells; "-" is standard input. A pipe is read to its end, and gzip is unpacked by content. `played`:
/// called behind every line of a recording. Error: one sentence; nothing is loaded by halves.
Result<Scan> openScan(const std::filesystem::path& path, const ReadingOptions& options = {},
                      const std::function<void(const Replay&)>& played = {});

/// The same from bytes in memory; `extension` (".pcd") is the hint that a file's name would be. No file is touched: a raw grid is its
/// description, a NUL byte and its counts.
Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options = {});

/// What a scan of this file is called: "wall" for wall.pcd and wall.pcd.gz, "stdin" for "-".
[[nodiscard]] std::string scanName(const std::filesystem::path& path);

/// What `make` gives; memory that runs out on the way is one sentence like everything else that can go wrong with the file.
Result<Scan> withinMemory(const std::filesystem::path& path, const std::function<Result<Scan>()>& make);

} // namespace edgescan::files
