// JSON as text for files and people. Any bytes in it, such as a file name that is not UTF-8, give valid JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan {

/// `indent` blanks for each level, or one line for -1. A byte that is not UTF-8 is written as escapedBytes() does, and parseJson() reads
/// it back. A character that printable() would replace is written as \u001b. This is the only way to write JSON in EdgeScan: nlohmann's
/// dump() throws at invalid bytes and does not escape the other characters.
[[nodiscard]] std::string jsonText(const nlohmann::json& json, int indent = -1);
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json, int indent = -1);

/// The same text in pure ASCII.
[[nodiscard]] std::string asciiJsonText(const nlohmann::ordered_json& json, int indent = -1);

/// For a terminal: strings of more than 4,000 characters are cut to their beginning and their end.
[[nodiscard]] std::string shortJsonText(nlohmann::ordered_json json, int indent = -1);

} // namespace edgescan
