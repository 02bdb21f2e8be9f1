// Finds out what a file is and hands it to its reader.
#include "core/files/open_save/open_scan.h"

#include "core/base/held_file.h"
#include "core/base/inputs.h"
#include "core/base/pipe.h"
#include "core/base/sha256.h"
#include "core/containers/compression/gunzip.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/measured_scan.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/files/point_tables/source.h"
#include "core/scan/georef/poses.h"
#include "core/scan/grid/given_angles.h"

#include <future>
#include <new>
#include <stdexcept>

namespace edgescan::files {
namespace {

namespace fs = std::filesystem;

/// The place that --pose and --calibration give. A recording has placed itself already: it may hold one of the two.
Result<Done> placeAsAsked(Scan& scan, const ReadingOptions& options, const std::string& where) {
    if (options.pose.empty() && options.calibration.empty()) return Done{};
    if (options.calibration.empty()) return Error{"a pose needs the robot's calibration", where, "give --calibration ROBOT.json too"};
    if (options.pose.empty()) return Error{"a calibration alone gives no place", where, "give --pose POSE.json too"};
    auto placement = openPlacement(options.pose, options.calibration, scan);
    if (!placement) return placement.error();
    scan.placement = *placement;
    return Done{};
}

Result<Scan> readAs(const Format& format, const Source& source) {
    std::vector<std::string> remarks;
    if (format.points != nullptr && (format.read == nullptr || isGridBeside(source))) {
        auto table = format.points(source);
        if (!table) return table.error();
        takeFilledOut(*table);
        if (auto scan = scanOfGridBeside(*table, source)) return std::move(*scan);
        if (format.read == nullptr) return scanFromPoints(std::move(*table), source);
        remarks = std::move(table->remarks);
    }
    auto scan = format.read(source);
    if (scan) scan->warnings.insert(scan->warnings.end(), remarks.begin(), remarks.end());
    return scan;
}

Result<Scan> readPlain(const Source& source) {
    if (source.bytes.empty()) return source.refused("the file is empty", "copy it again or choose another");
    const Format& format = formatOfContent(source);
    auto scan = readAs(format, source);
    if (!scan) return scan;
    applyGivenAngles(*scan, *source.options);
    if (!format.placesItself) {
        if (auto placed = placeAsAsked(*scan, *source.options, source.path.string()); !placed) return placed.error();
    }
    if (auto measured = checkMeasured(*scan, source.path.string()); !measured) return measured.error();
    return scan;
}

/// What is packed, as if it were not; places in it are told as such.
Result<Scan> readPacked(const Source& source) {
    const std::string path = source.path.string();
    auto unpacked = containers::gunzip(source.bytes, path, [&](double done) { return source.goOn("unpacking", done); });
    if (!unpacked) return unpacked.error();
    Source inside = source;
    inside.bytes = *unpacked;
    auto scan = readPlain(inside);
    if (scan || !scan.error().where.starts_with(path)) return scan;
    Error error = scan.error();
    return Error{error.what, path + " (unpacked)" + error.where.substr(path.size()), error.hint};
}

/// Beside the reading where that is worth a thread: of a large file it takes a fifth of the time.
std::future<std::string> sha256Beside(std::span<const std::byte> bytes) {
    constexpr std::size_t kLarge = std::size_t{4} << 20U;
    const auto ifAsked = std::launch::deferred;
    return std::async(bytes.size() >= kLarge ? std::launch::async | ifAsked : ifAsked, sha256Hex, bytes);
}

Result<Scan> readWhole(const Source& source) {
    auto sha256 = sha256Beside(source.bytes);
    const bool packed = containers::isGzip(source.bytes);
    auto scan = packed ? readPacked(source) : readPlain(source);
    if (!scan) return scan;
    ReadingOptions done = *source.options;
    done.straighten = false; // openAsAsked() does that
    scan->openedWith = readingOptionsText(done);
    scan->name = scanName(source.path);
    if (scan->sha256.empty()) scan->sha256 = sha256.get();
    if (!source.goOn("opened", 1.0)) return source.cancelled();
    return scan;
}

/// The bytes of a file, or all that comes out of a pipe.
Result<HeldFile> bytesAt(const fs::path& path, const ReadingOptions& options) {
    if (!isPipe(path)) return holdFile(path);
    auto bytes = readPipe(path, [&] { return !options.progress || options.progress("reading", 0.0); });
    if (!bytes) return bytes.error();
    return HeldFile(std::move(*bytes));
}

} // namespace

std::string scanName(const fs::path& path) {
    if (path == kStandardInput) return "stdin";
    const fs::path stem = path.stem();
    return (Source{path, {}}.isNamedPacked() ? stem.stem() : stem).string();
}

Result<Scan> withinMemory(const fs::path& path, const std::function<Result<Scan>()>& make) {
    try {
        return make();
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for this file", path.string(), "close other programs or open a smaller file"};
    } catch (const std::length_error&) {
        return Error{"there is not enough memory for this file", path.string(), "close other programs or open a smaller file"};
    }
}

Result<Scan> openScan(const fs::path& path, const ReadingOptions& options, const LinePlayed& played) {
    return withinMemory(path, [&]() -> Result<Scan> {
        if (options.progress && !options.progress("reading", 0.0)) return Error{"cancelled", path.string(), ""};
        claimInput(path);
        const auto bytes = bytesAt(path, options);
        if (!bytes) return bytes.error();
        auto scan = readWhole({path, bytes->bytes(), &options, isPipe(path), played});
        if (scan) scan->path = path.string();
        return scan;
    });
}

Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options) {
    const fs::path path("memory" + extension);
    return withinMemory(path, [&] { return readWhole({path, bytes, &options, true}); });
}

} // namespace edgescan::files
