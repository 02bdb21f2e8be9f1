// Finds out what a file is and hands it to its reader.
#include "core/io/open_scan.h"

#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/georef/poses.h"
#include "core/pictures/range_image.h"
#include "core/points/source.h"
#include "core/points/text_layout.h"
#include "core/readers/las.h"
#include "core/readers/obj.h"
#include "core/readers/pcd.h"
#include "core/readers/ply.h"
#include "core/readers/point_text.h"
#include "core/readers/ptx.h"
#include "core/readers/range_csv.h"
#include "core/readers/raw_grid.h"
#include "core/recording/replay.h"
#include "core/scan/reading_options.h"

#include <array>
#include <new>
#include <stdexcept>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

/// First bytes of files that people pick by mistake, so that the sentence can name them.
const char* foreignKind(std::string_view text) {
    struct Magic {
        std::string_view bytes;
        const char* what;
    };
    using namespace std::string_view_literals;
    static constexpr std::array<Magic, 6> kMagics{{
        {"\xff\xd8\xff"sv, "a JPEG picture"},
        {"\x7f\x45LF"sv, "a program"},
        {"%PDF"sv, "a PDF document"},
        {"PK\x03\x04"sv, "a ZIP archive"},
        {"\x1f\x8b"sv, "a gzip archive"},
        {"ASTM-E57"sv, "an E57 file, which this version cannot read"},
    }};
    for (const Magic& magic : kMagics) {
        if (text.starts_with(magic.bytes)) return magic.what;
    }
    return nullptr;
}

Result<Scan> readText(const Source& source) {
    if (const auto byte = firstByteThatIsNoText(source.text())) {
        return source.refusedAtByte(*byte, "this is neither text nor any scan format that is known",
                                    "choose a scan: raw grid, PCD, PLY, XYZ, CSV or .3d");
    }
    if (looksLikePtx(source.text())) return readPtx(source);
    if (looksLikeObj(source.text())) return readObj(source);
    const auto layout = textLayoutOf(source);
    if (!layout) return layout.error();
    Result<Scan> scan = looksLikeRangeCsv(*layout, source) ? readRangeCsv(source, *layout) : readPointText(source, *layout);
    if (scan && !source.text().ends_with('\n') && !source.text().ends_with('\r')) {
        scan->warnings.emplace_back("The last row has no line end: the file may have been cut off there; compare it with the original.");
    }
    return scan;
}

Result<Scan> readByContent(const Source& source, const LinePlayed& played) {
    const std::string_view text = source.text();
    if (text.empty()) return source.refused("the file is empty", "copy it again or choose another");
    if (source.extension() == ".u16") return readRawGridCounts(source);
    if (const char* kind = foreignKind(text)) return source.refused(std::string("this is ") + kind + ", not a scan", "choose a scan file");
    if (text.starts_with(kMcapMagic)) return readRecording(source, played);
    if (looksLikePcd(text)) return readPcd(source);
    if (looksLikePly(text)) return readPly(source);
    if (looksLikeLas(text)) return readLas(source);
    if (looksLikePng(text)) return readRangePng(source);
    if (looksLikeTiff(text)) return readRangeTiff(source);
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first != std::string_view::npos && text[first] == '{') return readRawGridJson(source);
    return readText(source);
}

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

Result<Scan> readWhole(const Source& source, const LinePlayed& played) {
    auto scan = readByContent(source, played);
    if (!scan) return scan;
    applyOptions(*scan, *source.options);
    if (!source.text().starts_with(kMcapMagic)) {
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
        auto scan = readWhole({path, *bytes, &options}, played);
        if (scan) scan->path = path.string();
        return scan;
    });
}

Result<Scan> readScanBytes(std::span<const std::byte> bytes, const std::string& extension, const ReadingOptions& options) {
    const fs::path path("memory" + extension);
    return withinMemory(path, [&] { return readWhole({path, bytes, &options, true}, {}); });
}

const std::vector<FileKind>& readableKinds() {
    static const std::vector<FileKind> kinds{
        {"Raw grid", {".json", ".u16"}},
        {"Point Cloud Library", {".pcd"}},
        {"Polygon file", {".ply"}},
        {"Point list", {".xyz", ".txt", ".asc", ".pts"}},
        {"Range or point table", {".csv"}},
        {"Leica PTX", {".ptx"}},
        {"LAS point cloud", {".las", ".laz"}},
        {"Wavefront OBJ", {".obj"}},
        {"Range picture", {".png", ".tif", ".tiff"}},
        {"3DTK scan", {".3d"}},
        {"Recording", {".mcap"}},
    };
    return kinds;
}

} // namespace edgescan
