// The only way JSON from outside is read: presets, descriptions, records, sidecars, calibrations, poses, readings, and the viewer's stored
// state. Depth, size and number of keys are checked before anything is built, so that no input exhausts stack or memory.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace edgescan {

struct JsonBounds {
    std::size_t bytes = std::size_t{64} << 20U;
    int depth = 12;               ///< nesting of objects and lists
    std::size_t keys = 1'000'000; ///< keys of all objects together
};
inline constexpr JsonBounds kSettingsJson{std::size_t{1} << 20U, 8, 10'000}; ///< presets and the viewer's stored state
inline constexpr JsonBounds kReadingJson{4096, 8, 100};                      ///< a reading of a sensor, a value of a metadata record

/// Strings and keys have the bytes that jsonText() wrote. Error: damaged text (with the byte), out of bounds, the same key twice in one
/// object, a number outside the range of a double. The error names `where`.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& where, const JsonBounds& bounds = {});

/// The same, with the keys in the order of the text.
Result<nlohmann::ordered_json> parseOrderedJson(std::string_view text, const std::string& where, const JsonBounds& bounds = {});

} // namespace edgescan
