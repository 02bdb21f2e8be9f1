// What a reader gets: the bytes of one file, where they came from, and what the user said.
#pragma once

#include "core/base/bytes.h"
#include "core/base/number_text.h"
#include "core/base/result.h"
#include "core/scan/grid/reading_options.h"

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace edgescan::scanner {
struct PlayedLine;
}

namespace edgescan::files {

/// Called after every line of a recording or of a laser's bag.
using LinePlayed = std::function<void(const scanner::PlayedLine&)>;

struct Source {
    std::filesystem::path path;
    std::span<const std::byte> bytes; ///< the whole file
    const ReadingOptions* options = nullptr;
    bool inMemory = false;   ///< there is not a file, and no other file may be touched
    LinePlayed played = {};  ///< called after every line of a recording or of a laser's bag
    bool placesOnly = false; ///< only x y z of the points are asked for: their other columns may be left out
    /// Where it is set, a reader may pass these points on some at a time, in order, instead of storing them in its table.
    std::function<void(std::span<const Eigen::Vector3d>)> receivePlaces = {};

    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
    [[nodiscard]] ByteView octets() const { return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}; }
    /// Named scan.pcd.gz: what is packed carries its own extension before the last one.
    [[nodiscard]] bool isNamedPacked() const {
        const std::string last = lowerCase(path.extension());
        return last == ".gz" || last == ".zst" || last == ".zstd";
    }
    /// Lower case, with the dot; of what is packed its own.
    [[nodiscard]] std::string extension() const { return lowerCase(isNamedPacked() ? path.stem().extension() : path.extension()); }
    [[nodiscard]] static std::string lowerCase(const std::filesystem::path& name) { return asciiLower(name.string()); }

    [[nodiscard]] Error refused(std::string what, std::string hint) const { return {std::move(what), path.string(), std::move(hint)}; }
    [[nodiscard]] Error refusedAtLine(std::size_t lineNumber, std::string what, std::string hint) const {
        return {std::move(what), path.string() + ": line " + std::to_string(lineNumber), std::move(hint)};
    }
    [[nodiscard]] Error refusedAtByte(std::size_t byte, std::string what, std::string hint) const {
        return {std::move(what), path.string() + ": byte " + std::to_string(byte), std::move(hint)};
    }

    /// False when the user has cancelled.
    [[nodiscard]] bool goOn(const char* stage, double fraction) const {
        return options == nullptr || !options->progress || options->progress(stage, fraction);
    }
    [[nodiscard]] Error cancelled() const { return {"cancelled", path.string(), ""}; }
};

} // namespace edgescan::files
