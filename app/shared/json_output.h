// JSON of the commands: every object names its schema. Each input file has one document, also when it is the only file or when it failed.
#pragma once

#include "core/base/result.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace edgescan::cli {

/// The report with its first key "schema": "edgescan-detect/1" for the command "detect" (docs/reference/command-line.md, "JSON").
[[nodiscard]] nlohmann::ordered_json document(const std::string& command, const nlohmann::ordered_json& report);

/// The document of a file that was refused: "schema", "input" and "error" with "what", "where", "hint".
[[nodiscard]] nlohmann::ordered_json refusal(const std::string& command, const std::string& input, const Error& error);

/// Writes a document as a whole file; "-" is standard output. Indented, or on one line.
[[nodiscard]] Result<Done> writeDocument(const std::string& path, const nlohmann::ordered_json& document, bool indented = true);

/// Adds --json FILE, which has one meaning in every command. `what`: what the JSON holds.
CLI::Option& addJsonFlag(CLI::App& command, std::string& path, const std::string& what);

/// The documents of several files in one output, a line each: on standard output at once, in a file when all are there.
class JsonLines {
public:
    explicit JsonLines(std::string path) : path_(std::move(path)) {}
    void add(const nlohmann::ordered_json& document);
    /// The exit code of the command: `code`, or kRefused if the file cannot be written.
    [[nodiscard]] int ended(int code);

private:
    std::string path_, lines_;
};

} // namespace edgescan::cli
