// JSON on standard output: every object names its schema. Each file has one document, also when it is the only file or when it failed.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <string>

namespace edgescan::cli {

/// The report with its first key "schema": "edgescan-detect/1" for the command "detect" (docs/reference/command-line.md, "JSON").
[[nodiscard]] nlohmann::ordered_json document(const std::string& command, const nlohmann::ordered_json& report);

/// The document of a file that was refused: "schema", "input" and "error" with "what", "where", "hint".
[[nodiscard]] nlohmann::ordered_json refusal(const std::string& command, const std::string& input, const Error& error);

/// Writes a document as a whole file; "-" is standard output. Indented, or on one line.
[[nodiscard]] Result<Done> writeDocument(const std::string& path, const nlohmann::ordered_json& document, bool indented = true);

} // namespace edgescan::cli
