// JSON as text for files and people: any bytes in it, such as a file name that is no UTF-8, give valid JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan {

/// `indent` blanks for each level, or one line for -1. A byte that is no UTF-8 becomes the character U+FFFD; what printable() would replace
/// is written as \u001b. The one way to write JSON here: nlohmann's dump() throws at such bytes and passes the others on.
[[nodiscard]] std::string jsonText(const nlohmann::json& json, int indent = -1);
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json, int indent = -1);

/// The same in pure ASCII.
[[nodiscard]] std::string asciiJsonText(const nlohmann::ordered_json& json, int indent = -1);

/// For a terminal: strings of more than 4,000 characters are cut to their beginning and end.
[[nodiscard]] std::string shortJsonText(nlohmann::ordered_json json, int indent = -1);

} // namespace edgescan
