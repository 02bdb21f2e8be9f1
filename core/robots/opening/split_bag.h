// A bag that was split into several files, in memory.
#pragma once

#include "core/base/held_file.h"
#include "core/files/open_save/unpack.h"
#include "core/robots/opening/ros_bag.h"
#include "core/robots/sweeps/bag_folder.h"

#include <list>
#include <string>
#include <vector>

namespace edgescan::robots {

struct SplitBag {
    std::vector<BagPart> parts;             ///< those that could be read; they point into the rest
    std::list<HeldFile> files;              ///< as they are on the disk
    std::list<files::UnpackedSource> plain; ///< without their packing
    std::vector<std::string> warnings;      ///< parts that are missing or damaged, by name
    std::string sha256;                     ///< of the files in their order, one behind the other
};

/// Error: no part can be read.
Result<SplitBag> holdSplitBag(const BagFiles& bag, const ReadingOptions& options);

/// As Addon::openSeveral and Addon::topicsOf.
std::optional<Result<Scan>> openSplitBag(std::filesystem::path& path, const ReadingOptions& options, const files::LinePlayed& played);
std::optional<Result<files::BagListing>> topicsOfBag(const std::filesystem::path& path, const ReadingOptions& options);

} // namespace edgescan::robots
