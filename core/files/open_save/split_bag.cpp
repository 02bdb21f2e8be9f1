// Holds every part; what is missing costs only itself.
#include "core/files/open_save/split_bag.h"

#include "core/base/inputs.h"
#include "core/base/sha256.h"

namespace edgescan::files {

Result<SplitBag> holdSplitBag(const BagFiles& bag, const ReadingOptions& options) {
    SplitBag all;
    Sha256 sha256;
    std::optional<Error> first;
    const auto leaveOut = [&](const std::filesystem::path& part, const Error& error) {
        all.warnings.push_back("The part " + part.filename().string() + " of the bag could not be read (" + error.what +
                               "): its messages are not in the scan.");
        if (!first) first = error;
    };
    for (const std::string& name : bag.missing)
        all.warnings.push_back("The part " + name + " of the bag is missing: its messages are not in the scan.");
    for (const std::string& name : bag.others)
        all.warnings.push_back("metadata.yaml names " + name +
                               ", whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.");
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
        auto plain = unpack({part, held.bytes(), &options});
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

} // namespace edgescan::files
