// The straight line from bytes to a scan.
#include "core/files/open_save/open_scan.h"

#include "core/base/held_file.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/base/translated_text.h"
#include "core/files/addons/addon.h"
#include "core/files/formats/formats.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/open_save/apply_options.h"
#include "core/files/open_save/check_measured.h"
#include "core/files/open_save/place_on_grid.h"
#include "core/files/open_save/pose_sidecar.h"
#include "core/files/open_save/unpack.h"

#include <algorithm>
#include <array>
#include <future>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string_view>

namespace edgescan::files {

/// Each step is in the file named.
Result<Scan> scanOfReading(Reading reading, const Source& source, bool placesItself) {
    auto scan = placeOnGrid(std::move(reading), source); // place_on_grid.h
    if (!scan) return scan;
    if (auto done = applyOptions(*scan, source, placesItself); !done) return done.error();  // apply_options.h
    if (auto done = checkMeasured(*scan, source.path.string()); !done) return done.error(); // check_measured.h
    if (source.options->unitMm) std::ranges::move(seldomMeasured(*scan, "--unit"), std::back_inserter(scan->warnings));
    if (std::ranges::find(scan->state.cells, CellState::Valid) == scan->state.cells.end())
        scan->warnings.emplace_back(
            "No cell of this scan has a range that was measured: check the file, the topic and the limits of the range.");
    return scan;
}

namespace {

namespace fs = std::filesystem;

/// On a thread of its own where that saves time: of a large file it takes a fifth of the reading.
std::future<std::string> sha256OnThread(std::span<const std::byte> bytes) {
    constexpr std::size_t kLarge = std::size_t{4} << 20U;
    const auto ifAsked = std::launch::deferred;
    return std::async(bytes.size() >= kLarge ? std::launch::async | ifAsked : ifAsked, sha256Hex, bytes);
}

/// The steps from plain bytes on.
Result<Scan> scanOf(const Source& source) {
    const Format& format = formatOfContent(source); // formats/formats.h
    auto reading = format.read(source);             // formats/pcd.cpp and the like
    if (!reading) return reading.error();
    auto scan = scanOfReading(std::move(*reading), source, format.placesItself);
    if (!scan) return scan;
    if (auto has = checkOptions(*scan, *source.options, format); !has) return has.error();
    return scan;
}

/// The options, without what openAsAsked() does.
std::string openedWith(ReadingOptions options) {
    options.straighten = false;
    return readingOptionsText(options);
}

/// The line: bytes, unpack, recognise, read, place on a grid, apply options, check; and the names by which the scan is known again.
Result<Scan> scanOfBytes(const Source& source) {
    auto sha256 = sha256OnThread(source.bytes);
    const auto plain = unpack(source);
    if (!plain) return plain.error();
    auto scan = scanOf(plain->source);
    if (!scan) {
        Error refused = scan.error();
        // What was odd about the text may be why it makes no scan.
        if (!plain->warnings.empty() && refused.what != "cancelled")
            refused.what += "; " + plain->warnings.front().substr(0, plain->warnings.front().rfind('.'));
        return plain->refused(refused);
    }
    scan->warnings.insert(scan->warnings.end(), plain->warnings.begin(), plain->warnings.end());
    scan->openedWith = openedWith(*source.options);
    scan->name = scanName(source.path);
    if (scan->sha256.empty()) scan->sha256 = sha256.get();
    if (!source.goOn("opened", 1.0)) return source.cancelled();
    return scan;
}

/// The bytes of a file, or all that comes out of a pipe.
Result<HeldFile> bytesAt(const fs::path& path, const ReadingOptions& options) {
    if (options.progress && !options.progress("reading", 0.0)) return Error{"cancelled", path.string(), ""};
    claimInput(path);
    if (!isPipe(path)) return holdFile(path);
    auto bytes = readPipe(path, [&] { return !options.progress || options.progress("reading", 0.0); });
    if (!bytes) return bytes.error();
    return HeldFile(std::move(*bytes));
}

/// How many scans a folder without a list of its files holds besides recordings.
std::size_t otherScansIn(const fs::path& folder) {
    std::error_code problem;
    std::size_t others = 0;
    if (!fs::is_directory(folder, problem) || fs::exists(folder / "metadata.yaml", problem)) return 0;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
        const std::string extension = Source::lowerCase(entry->path().extension());
        constexpr std::array<std::string_view, 3> kRecordings{".mcap", ".db3", ".bag"};
        if (std::ranges::find(kRecordings, extension) != kRecordings.end()) continue;
        const auto reads = [&](const Format& format) { return std::ranges::find(format.reads, extension) != format.reads.end(); };
        const bool isScan = extension == ".json" ? fs::exists(fs::path(entry->path()).replace_extension(".u16"), problem)
                                                 : std::ranges::any_of(formats(), reads);
        others += isScan ? 1 : 0;
    }
    return others;
}

/// What `make` gives; memory that runs out on the way is an error like all others.
template <class Make>
Result<Scan> withinMemory(const fs::path& path, const Make& make) {
    const Error tooLarge{"there is not enough memory for this file", path.string(), "close other programs or open a smaller file"};
    try {
        return make();
    } catch (const std::bad_alloc&) {
        return tooLarge;
    } catch (const std::length_error&) {
        return tooLarge;
    }
}

} // namespace

std::string scanName(const fs::path& path) {
    if (path == kStandardInput) return "stdin";
    const fs::path stem = path.stem();
    return (Source{path, {}}.isNamedPacked() ? stem.stem() : stem).string();
}

Result<Scan> openScan(const fs::path& path, const ReadingOptions& options, const LinePlayed& played) {
    return withinMemory(path, [&]() -> Result<Scan> {
        fs::path file = path;
        if (addon().openSeveral != nullptr) {
            if (auto several = addon().openSeveral(file, options, played)) {
                if (!*several && several->error().where == path.string() && otherScansIn(path) > 0)
                    return Error{"this folder holds several scans", path.string(), "open one of them, or use edgescan-cli batch"};
                if (*several) (*several)->openedWith = openedWith(options);
                return std::move(*several);
            }
        }
        const auto bytes = bytesAt(file, options);
        if (!bytes) return bytes.error();
        const ReadingOptions withPose = withPoseSidecar(options, file);
        auto scan = scanOfBytes({file, bytes->bytes(), &withPose, isPipe(file), played});
        if (!scan) return scan;
        scan->path = file.string();
        if (std::error_code none;
            !options.pose.empty() && fs::exists(poseSidecar(file), none) && !fs::equivalent(options.pose, poseSidecar(file), none))
            scan->warnings.push_back(withValues("The pose in %1 replaces that in %2.",
                                                {fs::path(options.pose).filename().string(), poseSidecar(file).filename().string()}));
        if (const std::size_t others = file == path ? 0 : otherScansIn(path); others > 0)
            scan->warnings.push_back(withValues("The folder holds %1 besides this recording: name one file, or use edgescan-cli batch.",
                                                {counted(others, "scan")}));
        if (std::string part = addon().partOf != nullptr ? addon().partOf(file) : ""; !part.empty())
            scan->warnings.push_back(std::move(part));
        return scan;
    });
}

Result<Scan> openAsAsked(const fs::path& path, const ReadingOptions& options) {
    auto scan = openScan(path, options);
    if (!scan) return scan;
    return withinMemory(path, [&] { return straightenedAsAsked(std::move(*scan), options); });
}

Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options) {
    const fs::path path("memory" + extension);
    return withinMemory(path, [&] { return scanOfBytes({path, bytes, &options, true}); });
}

} // namespace edgescan::files
