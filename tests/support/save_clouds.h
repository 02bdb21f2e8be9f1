// Point clouds without provenance, as files: tests compare them with other programs' readers.
#pragma once

#include "core/base/whole_file.h"
#include "core/files/open_save/save_scan.h"

#include <cstdint>
#include <filesystem>

namespace edgescan {

/// All valid points, with field `edge`: 0 or 255 as in `edgeMask` (lines x beams; null = all 0).
inline Result<Done> saveCloud(const Scan& scan, const std::filesystem::path& path, const Grid<std::uint8_t>* edgeMask,
                              const files::SaveOptions& options = {}) {
    const Result<std::string> bytes = files::cloudBytes(scan, path, edgeMask, options);
    return bytes ? writeWholeFile(path, *bytes) : bytes.error();
}

/// Only the valid points whose mask is not 0.
inline Result<Done> saveEdges(const Scan& scan, const Grid<std::uint8_t>& edgeMask, const std::filesystem::path& path,
                              const files::SaveOptions& options = {}) {
    const Result<std::string> bytes = files::edgeBytes(scan, edgeMask, path, options);
    return bytes ? writeWholeFile(path, *bytes) : bytes.error();
}

} // namespace edgescan
