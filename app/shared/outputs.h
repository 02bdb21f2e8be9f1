// Checks the outputs of a command before it reads anything.
#pragma once

#include "core/base/result.h"
#include "core/exports/provenance.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::cli {

/// Error if two of the paths are the same file, however they are spelled, or if one is the provenance record or sidecar of another
/// (core/files/open_save/sidecar_grid.h). Empty paths and devices are ignored; standard output takes only one result.
Result<Done> checkDistinct(std::span<const std::string> outputs);

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
    /// The frame and the extent of all of them, by frame: the last line of a command. Empty where there are no coordinates.
    [[nodiscard]] std::string coordinates() const;

private:
    std::optional<Error> first_;
    std::vector<exports::WrittenCoordinates> coordinates_; ///< one per frame
    std::vector<std::string> written_, missing_;           ///< missing: besides the first
};

} // namespace edgescan::cli
