// JSON on standard output: every object says which shape it has, one document for one file and for many, one for a file that failed.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <string>

namespace edgescan::cli {

/// The report with its first key "schema": "edgescan-detect/1" for the command "detect" (docs/command-line.md, "JSON").
[[nodiscard]] nlohmann::ordered_json document(const std::string& command, const nlohmann::ordered_json& report);

/// What stands in the place of a file's document when it was refused: "schema", "input" and "error" with "what", "where", "hint".
[[nodiscard]] nlohmann::ordered_json refusal(const std::string& command, const std::string& input, const Error& error);

/// Writes a document as a whole file; "-" is standard output. Indented, or on one line.
[[nodiscard]] Result<Done> writeDocument(const std::string& path, const nlohmann::ordered_json& document, bool indented = true);

} // namespace edgescan::cli
