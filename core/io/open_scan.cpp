// Finds out what a file is and hands it to its reader.
#include "core/io/open_scan.h"

#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/formats/formats.h"
#include "core/georef/poses.h"
#include "core/points/source.h"

#include <new>
#include <stdexcept>

namespace edgescan {
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

/// Angles that the user gave win over what the file says or what was recognised.
void applyAngles(std::vector<double>& degrees, std::optional<double> start, std::optional<double> step) {
    if (!start && !step) return;
    const double first = start.value_or(degrees.front());
    const double shift = first - degrees.front();
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = step ? first + static_cast<double>(i) * *step : degrees[i] + shift;
}

void applyOptions(Scan& scan, const ReadingOptions& options) {
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return;
    applyAngles(polar->beamDeg, options.beamStartDeg, options.beamStepDeg);
    applyAngles(polar->lineDeg, options.lineStartDeg, options.lineStepDeg);
    if (options.axis) polar->axis = *options.axis;
}

Result<Scan> readAs(const Format& format, const Source& source) {
    if (format.read != nullptr) return format.read(source);
    auto table = format.points(source);
    if (!table) return table.error();
    return scanFromPoints(std::move(*table), source);
}

Result<Scan> readWhole(const Source& source) {
    if (source.bytes.empty()) return source.refused("the file is empty", "copy it again or choose another");
    const Format& format = formatOfContent(source);
    auto scan = readAs(format, source);
    if (!scan) return scan;
    applyOptions(*scan, *source.options);
    if (!format.placesItself) {
        if (auto placed = placeAsAsked(*scan, *source.options, source.path.string()); !placed) return placed.error();
    }
    ReadingOptions done = *source.options;
    done.straighten = false; // openAsAsked() does that
    scan->openedWith = readingOptionsText(done);
    scan->name = source.path.stem().string();
    if (scan->sha256.empty()) scan->sha256 = sha256Hex(source.bytes);
    if (!source.goOn("opened", 1.0)) return source.cancelled();
    return scan;
}

} // namespace

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
        const auto bytes = readWholeFile(path);
        if (!bytes) return bytes.error();
        auto scan = readWhole({path, *bytes, &options, false, played});
        if (scan) scan->path = path.string();
        return scan;
    });
}

Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options) {
    const fs::path path("memory" + extension);
    return withinMemory(path, [&] { return readWhole({path, bytes, &options, true}); });
}

} // namespace edgescan
