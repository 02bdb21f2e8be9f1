// Holds every part; what is missing costs only itself.
#include "core/robots/opening/split_bag.h"
#include "core/base/translated_text.h"

#include "core/base/inputs.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/pose_sidecar.h"

namespace edgescan::robots {

Result<SplitBag> holdSplitBag(const BagFiles& bag, const ReadingOptions& options) {
    SplitBag all;
    Sha256 sha256;
    std::optional<Error> first;
    const auto leaveOut = [&](const std::filesystem::path& part, const Error& error) {
        all.warnings.push_back(withValues("The part %1 of the bag could not be read (%2): its messages are not in the scan.",
                                          {part.filename().string(), error.what}));
        if (!first) first = error;
    };
    for (const std::string& name : bag.missing)
        all.warnings.push_back(withValues("The part %1 of the bag is missing: its messages are not in the scan.", {name}));
    for (const std::string& name : bag.others)
        all.warnings.push_back(withValues(
            "metadata.yaml names %1, whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.", {name}));
    for (const std::filesystem::path& part : bag.parts) {
        if (options.progress && !options.progress("reading", 0.0)) return Error{"cancelled", bag.path.string(), ""};
        claimInput(part);
        auto file = holdFile(part);
        if (!file) {
            leaveOut(part, file.error());
            continue;
        }
        const HeldFile& held = all.files.emplace_back(std::move(*file));
        sha256.add(held.bytes());
        auto plain = files::unpack({part, held.bytes(), &options});
        if (!plain) {
            leaveOut(part, plain.error());
            continue;
        }
        all.plain.push_back(std::move(*plain));
        all.parts.push_back({part, all.plain.back().source.bytes});
    }
    if (all.parts.empty()) return first.value_or(Error{"no part of the bag is there", bag.path.string(), "copy it again"});
    all.sha256 = sha256.hex();
    return all;
}

namespace {

/// It has the name of the folder.
Result<Scan> scanOf(const BagFiles& bag, const ReadingOptions& options, const files::LinePlayed& played) {
    const std::filesystem::path folder = std::filesystem::absolute(bag.parts.front()).parent_path();
    auto held = holdSplitBag(bag, options);
    if (!held) return held.error();
    const ReadingOptions withPose = files::withPoseSidecar(options, folder);
    const files::Source source{folder, held->parts.front().bytes, &withPose, false, played};
    auto reading = readBagParts(held->parts, source);
    if (!reading) return reading.error();
    auto scan = files::scanOfReading(std::move(*reading), source, false);
    if (!scan) return scan;
    scan->warnings.insert(scan->warnings.begin(), held->warnings.begin(), held->warnings.end());
    scan->name = folder.filename().string();
    scan->sha256 = held->sha256;
    scan->path = bag.path.string();
    if (!source.goOn("opened", 1.0)) return source.cancelled();
    return scan;
}

} // namespace

std::optional<Result<Scan>> openSplitBag(std::filesystem::path& path, const ReadingOptions& options, const files::LinePlayed& played) {
    const auto bag = filesOfBag(path);
    if (!bag) return Result<Scan>(bag.error());
    if (bag->isSplit()) return scanOf(*bag, options, played);
    path = bag->parts.front();
    return std::nullopt;
}

std::optional<Result<files::BagListing>> topicsOfBag(const std::filesystem::path& path, const ReadingOptions& options) {
    const auto bag = filesOfBag(path);
    if (bag && bag->isSplit()) {
        const auto held = holdSplitBag(*bag, options);
        if (!held) return Result<files::BagListing>(held.error());
        auto listing = listingOfParts(held->parts, {bag->path, {}, &options});
        if (listing) listing->warnings.insert(listing->warnings.begin(), held->warnings.begin(), held->warnings.end());
        return listing;
    }
    if (!bag || isPipe(bag->parts.front())) return std::nullopt;
    const auto bytes = holdFile(bag->parts.front());
    if (!bytes) return std::nullopt;
    const auto plain = files::unpack({bag->parts.front(), bytes->bytes(), &options});
    if (!plain) return std::nullopt;
    return bagListing(plain->source);
}

} // namespace edgescan::robots
