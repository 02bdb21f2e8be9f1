// Gray pictures: row = line, column = beam, row 0 = first line.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"

#include <cstdint>
#include <filesystem>

namespace edgescan {

/// 8-bit gray, one byte per cell unchanged. Error: the grid is empty or the file cannot be written.
Result<Done> savePng8(const Grid<std::uint8_t>& gray, const std::filesystem::path& path);

/// 16-bit gray, for example ranges in millimetres.
Result<Done> savePng16(const Grid<std::uint16_t>& values, const std::filesystem::path& path);

/// An 8-bit (or less) gray or colour picture as gray, for example an edge mask. Error: missing, damaged, 16-bit, too large.
Result<Grid<std::uint8_t>> readPng8(const std::filesystem::path& path);

} // namespace edgescan
