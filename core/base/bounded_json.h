// The one way JSON from outside is read: presets, descriptions, records, sidecars, calibrations, poses, readings, what the viewer
// remembers. Its depth, size and number of keys are bounded before anything is built, so that nobody who walks through it runs out of stack
// or memory.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace edgescan {

struct JsonBounds {
    std::size_t bytes = std::size_t{64} << 20U;
    int depth = 12;               ///< objects and lists inside each other
    std::size_t keys = 1'000'000; ///< of all objects together
};
inline constexpr JsonBounds kSettingsJson{std::size_t{1} << 20U, 8, 10'000}; ///< presets and what the viewer remembers
inline constexpr JsonBounds kReadingJson{4096, 8, 100};                      ///< a reading of a sensor, a value of a metadata record

/// Error: damaged (with the byte), out of bounds, a key that stands twice in one object, a number that no double holds. `where` goes into
/// it.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& where, const JsonBounds& bounds = {});

/// The same with the keys in the order of the text.
Result<nlohmann::ordered_json> parseOrderedJson(std::string_view text, const std::string& where, const JsonBounds& bounds = {});

} // namespace edgescan
