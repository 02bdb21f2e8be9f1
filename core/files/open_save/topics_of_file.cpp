// Reads the bag, and not the scan in it.
#include "core/files/open_save/topics_of_file.h"

#include "core/base/held_file.h"
#include "core/base/pipe.h"
#include "core/files/formats/ros_bag.h"
#include "core/files/open_save/unpack.h"
#include "core/files/ros/bag_folder.h"

namespace edgescan::files {

std::optional<Result<BagListing>> topicsOfFile(const std::filesystem::path& path) {
    const auto file = fileOfBag(path);
    if (!file || isPipe(*file)) return std::nullopt;
    const auto bytes = holdFile(*file);
    if (!bytes) return std::nullopt;
    const ReadingOptions options;
    const auto plain = unpack({*file, bytes->bytes(), &options});
    if (!plain) return std::nullopt;
    return bagListing(plain->source);
}

} // namespace edgescan::files
