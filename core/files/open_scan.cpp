// Finds out what a file is and hands it to its reader.
#include "core/files/open_scan.h"

#include "core/base/sha256.h"
#include "core/files/pcd.h"
#include "core/files/ply.h"
#include "core/files/point_text.h"
#include "core/files/open_options_json.h"
#include "core/files/range_csv.h"
#include "core/files/raw_grid.h"
#include "core/files/source.h"
#include "core/files/text_layout.h"
#include "core/files/whole_file.h"
#include "core/live/replay.h"

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
    static constexpr std::array<Magic, 10> kMagics{{
        {"\x89PNG\r\n\x1a\n"sv, "a PNG picture"},
        {"\xff\xd8\xff"sv, "a JPEG picture"},
        {"II*\0"sv, "a TIFF picture"},
        {"MM\0*"sv, "a TIFF picture"},
        {"\x7f\x45LF"sv, "a program"},
        {"%PDF"sv, "a PDF document"},
        {"PK\x03\x04"sv, "a ZIP archive"},
        {"\x1f\x8b"sv, "a gzip archive"},
        {"LASF"sv, "a LAS file, which this version cannot read"},
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
    const auto layout = textLayoutOf(source);
    if (!layout) return layout.error();
    Result<Scan> scan = looksLikeRangeCsv(*layout, source) ? readRangeCsv(source, *layout) : readPointText(source, *layout);
    if (scan && !source.text().ends_with('\n') && !source.text().ends_with('\r')) {
        scan->warnings.emplace_back("The last row has no line end: the file may have been cut off there; compare it with the original.");
    }
    return scan;
}

Result<Scan> readByContent(const Source& source) {
    const std::string_view text = source.text();
    if (text.empty()) return source.refused("the file is empty", "copy it again or choose another");
    if (source.extension() == ".u16") return readRawGridCounts(source);
    if (const char* kind = foreignKind(text)) return source.refused(std::string("this is ") + kind + ", not a scan", "choose a scan file");
    if (text.starts_with(kMcapMagic)) return readRecording(source);
    if (looksLikePcd(text)) return readPcd(source);
    if (looksLikePly(text)) return readPly(source);
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first != std::string_view::npos && text[first] == '{') return readRawGridJson(source);
    return readText(source);
}

/// Angles that the user gave win over what the file says or what was recognised.
void applyAngles(std::vector<double>& degrees, std::optional<double> start, std::optional<double> step) {
    if (!start && !step) return;
    const double first = start.value_or(degrees.front());
    const double shift = first - degrees.front();
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = step ? first + static_cast<double>(i) * *step : degrees[i] + shift;
}

void applyOptions(Scan& scan, const OpenOptions& options) {
    auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return;
    applyAngles(polar->beamDeg, options.beamStartDeg, options.beamStepDeg);
    applyAngles(polar->lineDeg, options.lineStartDeg, options.lineStepDeg);
    if (options.axis) polar->axis = *options.axis;
}

} // namespace

Result<Scan> openScan(const fs::path& path, const OpenOptions& options) {
    try {
        if (options.progress && !options.progress("reading", 0.0)) return Error{"cancelled", path.string(), ""};
        const auto bytes = readWholeFile(path);
        if (!bytes) return bytes.error();
        auto scan = readByContent({path, *bytes, &options});
        if (!scan) return scan;
        applyOptions(*scan, options);
        scan->openedWith = openOptionsText(options);
        scan->path = path.string();
        scan->name = path.stem().string();
        if (scan->sha256.empty()) scan->sha256 = sha256Hex(*bytes);
        if (options.progress && !options.progress("opened", 1.0)) return Error{"cancelled", path.string(), ""};
        return scan;
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for this file", path.string(), "close other programs or open a smaller file"};
    } catch (const std::length_error&) {
        return Error{"there is not enough memory for this file", path.string(), "close other programs or open a smaller file"};
    }
}

const std::vector<FileKind>& readableKinds() {
    static const std::vector<FileKind> kinds{
        {"Raw grid", {".json", ".u16"}},    {"Point Cloud Library", {".pcd"}},
        {"Polygon file", {".ply"}},         {"Point list", {".xyz", ".txt", ".asc", ".pts"}},
        {"Range or point table", {".csv"}}, {"3DTK scan", {".3d"}},
        {"Recording", {".mcap"}},
    };
    return kinds;
}

} // namespace edgescan
