// Reads the bag, and not the scan in it.
#include "core/files/open_save/topics_of_file.h"

#include "core/base/pipe.h"
#include "core/files/open_save/split_bag.h"

namespace edgescan::files {

std::optional<Result<BagListing>> topicsOfFile(const std::filesystem::path& path, const ReadingOptions& options) {
    const auto bag = filesOfBag(path);
    if (bag && bag->isSplit()) {
        const auto held = holdSplitBag(*bag, options);
        if (!held) return Result<BagListing>(held.error());
        auto listing = listingOfParts(held->parts, {bag->path, {}, &options});
        if (listing) listing->warnings.insert(listing->warnings.begin(), held->warnings.begin(), held->warnings.end());
        return listing;
    }
    if (!bag || isPipe(bag->parts.front())) return std::nullopt;
    const auto bytes = holdFile(bag->parts.front());
    if (!bytes) return std::nullopt;
    const auto plain = unpack({bag->parts.front(), bytes->bytes(), &options});
    if (!plain) return std::nullopt;
    return bagListing(plain->source);
}

} // namespace edgescan::files
