// Checks the outputs of a command before it reads anything.
#pragma once

#include "core/base/result.h"
#include "core/exports/provenance.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::cli {

/// The report with its first key "schema": "edgescan-detect/1" for the command "detect" (docs/reference/command-line.md, "JSON").
[[nodiscard]] nlohmann::ordered_json document(const std::string& command, const nlohmann::ordered_json& report);

/// The document of a file that was refused: "schema", "input" and "error" with "what", "where", "hint".
[[nodiscard]] nlohmann::ordered_json refusal(const std::string& command, const std::string& input, const Error& error);

/// Writes a document as a whole file; "-" is standard output. Indented, or on one line.
[[nodiscard]] Result<Done> writeDocument(const std::string& path, const nlohmann::ordered_json& document, bool indented = true);

/// Refuses a file that holds something else than one of these documents.
[[nodiscard]] CLI::Validator replacesOnly(std::vector<std::string> documents);

/// Adds --json FILE, which has one meaning in every command. `what`: what the JSON holds. `documents`: the names given to document(), if
/// not that of the command; a file that is neither is not replaced.
CLI::Option& addJsonFlag(CLI::App& command, std::string& path, const std::string& what, std::vector<std::string> documents = {});

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

/// Error if two of the paths are the same file, however they are spelled, or if one is the provenance record or sidecar of another
/// (core/files/open_save/sidecar_grid.h). Empty paths and devices are ignored; standard output takes only one result.
Result<Done> checkDistinct(std::span<const std::string> outputs);

/// Error if one of them cannot be written, as far as this is known before the work begins: no folder, an input, a name that is too long.
Result<Done> checkOutputs(std::span<const std::string> outputs);

/// "a.pcd (replaced), standard output": what was written, and what of it was there before.
[[nodiscard]] std::string placesText(const std::vector<std::string>& paths);
/// Their names in the folder; of those elsewhere the paths.
[[nodiscard]] std::string namesText(const std::vector<std::string>& paths, const std::string& folder);

/// Refuses other names than of this kind ("a picture", ".png"). `orStream`: standard output and devices have any.
[[nodiscard]] CLI::Validator namedAs(const char* kind, const char* extension, bool orStream = true);

/// The results of one scan, written one after the other. If one cannot be written, the message names those that were.
class WrittenOutputs {
public:
    template <class T>
    void add(const std::string& path, const Result<T>& written) {
        if (written)
            written_.push_back(path);
        else if (first_)
            missing_.push_back(path);
        else
            first_ = written.error();
    }
    void add(const std::string& path, const Result<exports::Written>& written);
    /// Was not tried because another one failed.
    void leftOut(const std::string& path) { missing_.push_back(path); }
    [[nodiscard]] bool allWritten() const { return !first_; }
    /// Error: the first one, with the names of what was written and of what else was not.
    [[nodiscard]] Result<Done> outcome() const;
    /// The frame and the extent of all of them, by frame, after the folder or else the files that have them: the last line of a command.
    /// Empty without coordinates.
    [[nodiscard]] std::string coordinates(const std::string& folder) const;

private:
    std::optional<Error> first_;
    std::vector<exports::WrittenCoordinates> coordinates_; ///< one per frame
    std::vector<std::string> written_, placed_, missing_;  ///< placed: with coordinates; missing: besides the first
};

} // namespace edgescan::cli
