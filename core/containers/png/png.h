// PNG pictures: row = line, column = beam, row 0 = first line.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/base/rgb.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgescan::containers {

/// Keyword of the text chunk that carries provenance.
inline constexpr const char* kPngRecordKeyword = "edgescan-record";

/// The bytes of the pictures below. `record`: provenance as ASCII for a text chunk; empty = none. `where` goes into errors.
Result<std::string> png8Bytes(const Grid<std::uint8_t>& gray, const std::string& where, const std::string& record = {});
Result<std::string> png16Bytes(const Grid<std::uint16_t>& values, const std::string& where, const std::string& record = {});

Result<std::string> pngRgbBytes(const Grid<Rgb>& picture, const std::string& where);

/// The gray values of an 8 or 16 bit picture that this program wrote, as they are. Error: another kind of picture, damaged.
Result<Grid<std::uint16_t>> pngValues(std::string_view bytes, const std::string& where);

/// The record in a picture's bytes; empty when there is none.
[[nodiscard]] std::string pngRecord(std::string_view bytes);

/// The text that any program put before the pixels of a picture under this key; empty if there is none, or if the picture is damaged there.
/// Unlike Qt's reader it prints nothing.
[[nodiscard]] std::string pngText(std::string_view bytes, std::string_view key);

/// The picture alone, packed again: without texts, times and what any program put behind it. Error: no PNG, damaged, cut off, or of more
/// pixels than `mostPixels`.
Result<std::string> barePng(std::string_view bytes, std::uint64_t mostPixels, const std::string& where);

/// 8-bit gray, one byte per cell unchanged. Error: the grid is empty or the file cannot be written.
Result<Done> savePng8(const Grid<std::uint8_t>& gray, const std::filesystem::path& path);

/// 16-bit gray, for example ranges in millimetres.
Result<Done> savePng16(const Grid<std::uint16_t>& values, const std::filesystem::path& path);

/// 8 bits per colour. Error: as above.
Result<Done> savePngRgb(const Grid<Rgb>& picture, const std::filesystem::path& path);

/// An 8-bit (or less) gray or colour picture as gray, for example an edge mask. Error: missing, damaged, 16-bit, too large.
Result<Grid<std::uint8_t>> readPng8(const std::filesystem::path& path);

} // namespace edgescan::containers
