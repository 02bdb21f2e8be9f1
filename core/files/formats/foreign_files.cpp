// Files of other programs that are not read, known by their first bytes or by their name, and what turns them into files that are.
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/containers/compression/zip_archive.h"
#include "core/files/addons/addon.h"
#include "core/files/formats/format.h"
#include "core/files/point_tables/text_layout.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <array>

namespace edgescan::files {
namespace {

struct ForeignKind {
    std::string_view mark; ///< first bytes, or an extension
    const char* what;
    const char* hint;
};

using namespace std::string_view_literals;

constexpr const char* kNoScan = "choose a scan file";
constexpr const char* kFromSite = "it may be what a site sent instead of the file: download the file again, or choose a scan file";
constexpr const char* kUnpack = "unpack it and open the scan in it";
constexpr const char* kFromMeshLab = "save its points as PLY in MeshLab";
constexpr const char* kFromRaster = "choose the scan that it was made from";
constexpr const char* kAsNumbers = "save the ranges as .npy or .csv";

constexpr std::array<ForeignKind, 25> kByBytes{{
    {"\xff\xd8\xff"sv, "this is a JPEG picture, not a scan", kNoScan},
    {"GIF8"sv, "this is a GIF picture, not a scan", kNoScan},
    {"RIFF"sv, "this is a picture, sound or film (RIFF), not a scan", kNoScan},
    {"\0\0\0\x18"
     "ftyp"sv,
     "this is a picture or film, not a scan", kNoScan},
    {"\0\0\0\x1c"
     "ftyp"sv,
     "this is a picture or film, not a scan", kNoScan},
    {"\0\0\0\x20"
     "ftyp"sv,
     "this is a picture or film, not a scan", kNoScan},
    {"8BPS"sv, "this is a Photoshop picture, not a scan", kNoScan},
    {"\x7f\x45LF"sv, "this is a program, not a scan", kNoScan},
    {"MZ\x90\0"sv, "this is a program, not a scan", kNoScan},
    {"%PDF"sv, "this is a PDF document, not a scan", kNoScan},
    {"PK\x03\x04"sv, "this is a ZIP archive, not a scan", kUnpack},
    {"\x1f\x8b"sv, "this is a gzip archive in another one, not a scan", kUnpack},
    {"\xfd\x37zXZ\0"sv, "this is an xz archive, not a scan", "unpack it (xz -d) and open the scan in it"},
    {"BZh"sv, "this is a bzip2 archive, not a scan", "unpack it (bzip2 -d) and open the scan in it"},
    {"\x28\xb5\x2f\xfd"sv, "this is a zstd archive, not a scan", "unpack it (zstd -d) and open the scan in it"},
    {"7z\xbc\xaf\x27\x1c"sv, "this is a 7-Zip archive, not a scan", kUnpack},
    {"Rar!\x1a\x07"sv, "this is a RAR archive, not a scan", kUnpack},
    {"\x89HDF\r\n"sv, "this is an HDF5 file, which is not read", kAsNumbers},
    {"MATLAB 5.0"sv, "this is a MATLAB file, which is not read", "save the ranges with writematrix(ranges, 'scan.csv')"},
    {"\xd0\xcf\x11\xe0\xa1\xb1"sv, "this is an old Office document, not a scan", "save the table as .csv"},
    {"PAR1"sv, "this is a Parquet table, which is not read", kAsNumbers},
    {"ARROW1"sv, "this is an Arrow table, which is not read", kAsNumbers},
    {"glTF"sv, "this is a glTF model, which is not read", "save it as PLY in Blender or MeshLab"},
    {"ISO-10303-21"sv, "this is a STEP model, not a scan", kNoScan},
    {"Kaydara FBX"sv, "this is an FBX model, which is not read", "save it as PLY in Blender"},
}};

/// Documents of text, in any case of letters, behind white space and a byte order mark.
constexpr std::array<ForeignKind, 15> kByText{{
    {"<!doctype html"sv, "this is a web page (HTML), not a scan", kFromSite},
    {"<html"sv, "this is a web page (HTML), not a scan", kFromSite},
    {"<svg"sv, "this is an SVG picture, not a scan", kNoScan},
    {"<?xml"sv, "this is an XML document, not a scan", kNoScan},
    {"{\\rtf"sv, "this is a text document (RTF), not a scan", kNoScan},
    {"%!ps"sv, "this is a PostScript document, not a scan", kNoScan},
    {"# vtk DataFile"sv, "this is a file of VTK, which is not read", "save its points as PLY, or as CSV from ParaView's table"},
    {"OFF\n"sv, "this is an OFF mesh, which is not read", kFromMeshLab},
    {"OFF\r\n"sv, "this is an OFF mesh, which is not read", kFromMeshLab},
    {"COFF"sv, "this is an OFF mesh, which is not read", kFromMeshLab},
    {"NOFF"sv, "this is an OFF mesh, which is not read", kFromMeshLab},
    {"#VRML"sv, "this is a VRML scene, which is not read", kFromMeshLab},
    {"rock,line,beam,"sv, "this is a table of rocks, not a scan", kFromRaster},
    {"ncols "sv, "this is a raster of heights (Esri ASCII grid), not a scan", kFromRaster},
    {"DSAA"sv, "this is a raster of heights (Surfer grid), not a scan", kFromRaster},
}};

constexpr const char* kFromScene = "export it as E57 with FARO SCENE";
constexpr const char* kFromRiegl = "export it as E57 or LAS with RiSCAN PRO, or with RIEGL's rdbconvert";
constexpr const char* kFromLaserControl = "export it as E57 with Z+F LaserControl";
constexpr const char* kFromCyclone = "export it as E57 or PTX with Leica Cyclone";
constexpr const char* kFromRecap = "export it as E57 with Autodesk ReCap";

/// Binary files whose first bytes no document names; only where nothing else recognises the content.
constexpr std::array<ForeignKind, 24> kByName{{
    {".fls", "this is a FARO scan (FLS), which is not read", kFromScene},
    {".fws", "this is a FARO workspace, which is not read", kFromScene},
    {".lsproj", "this is a FARO project, which is not read", kFromScene},
    {".rxp", "this is a RIEGL stream (RXP), which is not read", kFromRiegl},
    {".rdb", "this is a RIEGL database, which is not read", kFromRiegl},
    {".rdbx", "this is a RIEGL database (RDBX), which is not read", kFromRiegl},
    {".3dd", "this is a RIEGL scan (3DD), which is not read", kFromRiegl},
    {".zfs", "this is a Z+F scan (ZFS), which is not read", kFromLaserControl},
    {".zfprj", "this is a Z+F project (ZFPRJ), which is not read", kFromLaserControl},
    {".zfc", "this is a Z+F scan (ZFC), which is not read", kFromLaserControl},
    {".lgs", "this is a Leica LGS project, which is not read", kFromCyclone},
    {".lgsx", "this is a Leica LGSx project, which is not read", kFromCyclone},
    {".imp", "this is a Leica Cyclone database, which is not read", kFromCyclone},
    {".rcp", "this is an Autodesk ReCap project, which is not read", kFromRecap},
    {".rcs", "this is an Autodesk ReCap scan, which is not read", kFromRecap},
    {".tzf", "this is a Trimble scan (TZF), which is not read", "export it as E57 with Trimble RealWorks"},
    {".cl3", "this is a Topcon scan (CL3), which is not read", "export it as E57 or PTX with Topcon's program"},
    {".clr", "this is a Topcon scan (CLR), which is not read", "export it as E57 or PTX with Topcon's program"},
    {".pod", "this is a Pointools cloud (POD), which is not read", "export it as LAS with Bentley's program"},
    {".pkl", "this is a Python pickle, which only Python can open", kAsNumbers},
    {".pickle", "this is a Python pickle, which only Python can open", kAsNumbers},
    {".bag", "this is a ROS bag that does not begin like one", "copy it again"},
    {".db3", "this is a ROS 2 bag that does not begin like one", "copy it again"},
    {".bin", "this is a binary file without a telegram of a SICK scanner in it",
     "save points as PCD or PLY; a capture of telegrams holds the bytes as they came from the scanner"},
}};

constexpr ForeignKind kBitmap{"BM"sv, "this is a BMP picture, not a scan", kNoScan};
constexpr ForeignKind kDrawing{"0"sv, "this is a drawing (DXF), which is not read",
                               "choose the scan, or save the points of the drawing as CSV, LAS or PLY"};
constexpr ForeignKind kWorkbook{"xl/"sv, "this is an Excel workbook, not a table of text", "save the sheet as .csv"};
constexpr ForeignKind kSpreadsheet{"mimetype"sv, "this is an OpenDocument spreadsheet, not a table of text", "save the sheet as .csv"};

constexpr ForeignKind kArrays{"npy"sv, "this is a numpy archive, which is not read", "save the array of ranges or points as .npy"};

/// Archives that programs call documents, by the names in their directory.
const ForeignKind* documentKind(const Source& source) {
    if (!containers::isZip(source.bytes)) return nullptr;
    const auto entries = containers::zipEntries(source.bytes, source.path.string());
    if (!entries) return nullptr;
    const auto has = [&](std::string_view start) {
        return std::ranges::any_of(*entries, [&](const containers::ZipEntry& entry) { return entry.name.starts_with(start); });
    };
    if (has("xl/")) return &kWorkbook;
    if (std::ranges::any_of(*entries, [](const containers::ZipEntry& entry) { return entry.name.ends_with(".npy"); })) return &kArrays;
    return has("mimetype") && has("content.xml") ? &kSpreadsheet : nullptr;
}

bool startsLike(std::string_view text, std::string_view mark) { return asciiLower(text.substr(0, mark.size())) == asciiLower(mark); }

const ForeignKind* kindByText(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const auto found = std::ranges::find_if(kByText, [&](const ForeignKind& kind) { return startsLike(text, kind.mark); });
    return found == kByText.end() ? nullptr : &*found;
}

/// Comments, then the start of a section: groups of a code and a value, a line each.
bool isDrawing(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const TextLine code = textLineAt(text, at), value = textLineAt(text, code.next);
        const std::string_view group = trimmed(code.text);
        if (group == "0") return trimmed(value.text) == "SECTION";
        if (group != "999" || value.next == at) return false;
        at = value.next;
    }
    return false;
}

const ForeignKind* kindByBytes(const Source& source) {
    if (isDrawing(source.text())) return &kDrawing;
    if (const ForeignKind* office = documentKind(source)) return office;
    if (const ForeignKind* document = kindByText(source.text())) return document;
    if (source.text().starts_with(kBitmap.mark) && firstByteThatIsNoText(source.text())) return &kBitmap;
    const auto found = std::ranges::find_if(kByBytes, [&](const ForeignKind& kind) { return source.text().starts_with(kind.mark); });
    return found == kByBytes.end() ? nullptr : &*found;
}

const ForeignKind* kindByName(const Source& source) {
    if (!firstByteThatIsNoText(source.text())) return nullptr;
    const std::string extension = source.extension();
    const auto found = std::ranges::find(kByName, extension, &ForeignKind::mark);
    return found == kByName.end() ? nullptr : &*found;
}

template <const ForeignKind* (*kindOf)(const Source&)>
Format refusing() {
    return {.title = "",
            .recognises = [](const Source& source) { return kindOf(source) != nullptr; },
            .read = [](const Source& source) -> Result<Reading> {
                const ForeignKind& kind = *kindOf(source);
                return source.refused(kind.what, kind.hint);
            }};
}

} // namespace

Format bagWithoutRobots() {
    return {.title = "",
            .recognises = [](const Source& s) { return s.text().starts_with("#ROSBAG V") || s.text().starts_with("SQLite format 3"); },
            .read = [](const Source& source) -> Result<Reading> {
                return source.refused(withValues("this is a ROS bag, and %1", {kNoRobots}), kBuildWithRobots);
            }};
}

Format fileThatIsNoScan() { return refusing<kindByBytes>(); }

Format fileOfAnotherProgram() { return refusing<kindByName>(); }

} // namespace edgescan::files
