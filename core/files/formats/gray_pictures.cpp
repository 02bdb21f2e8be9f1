// Ranges as gray pictures: row = line, column = beam, one number per pixel, 0 = no return. PNG of 16 bits, TIFF of 16 bits or floats.
// PNG is read through libpng, whose errors leave by longjmp: see png.cpp.
#include "core/base/bytes_behind.h"
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/point_tables/point_table.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#ifdef EDGESCAN_WITH_TIFF
#include <tiffio.h>
#endif

namespace edgescan::files {
namespace {

constexpr std::uint64_t kBytesPerPixel = 32; // while a picture becomes a scan

/// A sentence where a picture asks to be turned or mirrored when it is shown (tag 274 of TIFF and EXIF): its rows are taken as they are.
std::optional<std::string> orientationNotApplied(std::uint64_t orientation) {
    if (orientation < 2 || orientation > 8) return std::nullopt;
    return withValues("The picture asks to be turned or mirrored when it is shown (orientation %1): its rows were taken as scan lines as "
                      "they are stored.",
                      {orientation});
}

/// Error when the file is far too small for so many bytes of pixels: a bomb, or a false header.
Result<Done> checkUnpacked(std::uint64_t bytes, const Source& source) {
    if (bytes <= mostUnpackedBytes(source.bytes.size())) return Done{};
    return source.refused(withValues("the picture promises more pixels than a file of %1 holds of a scan", {sizeText(source.bytes.size())}),
                          "copy the file again");
}

/// The scan that a picture's numbers are: counts of 16 bits are millimetres, the unit of floats shows itself, and --unit goes before both.
/// Values that are not finite or not above 0 are missing returns.
Result<Scan> scanFromPicture(const Grid<float>& values, bool counts, const char* format, const Source& source) {
    constexpr double kMostCounts = 65535;
    BareRanges ranges{{values.cells.begin(), values.cells.end()},
                      static_cast<std::size_t>(values.lines),
                      static_cast<std::size_t>(values.beams),
                      {0.0, counts ? 0x1p-53 : kFloatError}};
    if (counts) ranges.stated = kMostCounts;
    std::size_t odd = 0;
    for (double& value : ranges.values) {
        if (value == 0 || (value > 0 && physical::kRangeMm.hold(value))) continue;
        value = 0;
        ++odd;
    }
    ReadingOptions options = *source.options;
    if (counts && !options.unitMm) options.unitMm = 1.0;
    Source asked = source;
    asked.options = &options;
    auto scan = scanFromRanges(std::move(ranges), kPicture, asked, [](std::size_t, std::size_t) { return std::string("a pixel"); });
    if (!scan) return scan;
    scan->format = format;
    scan->unitMm = source.options->unitMm.value_or(1.0);
    if (odd > 0)
        scan->warnings.push_back(counted(odd, "pixel holds no range (negative, not a number, or too far) and was taken as no return.",
                                         "pixels hold no range (negative, not a number, or too far) and were taken as no return."));
    if (counts && !source.options->unitMm) scan->warnings.emplace_back("Unit taken as millimetres, as range pictures have it.");
    return scan;
}

std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t count, bool bigEndian) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i)
        value |= std::uint64_t{static_cast<std::uint8_t>(bytes[at + i])} << 8U * (bigEndian ? count - 1 - i : i);
    return value;
}

// Through libtiff where the program was built with it.
#ifdef EDGESCAN_WITH_TIFF
struct Memory {
    std::span<const std::byte> bytes;
    std::uint64_t at = 0;
};

tmsize_t readSome(thandle_t handle, void* to, tmsize_t count) {
    auto* memory = static_cast<Memory*>(handle);
    const std::uint64_t left = memory->at < memory->bytes.size() ? memory->bytes.size() - memory->at : 0;
    const auto taken = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(std::max<tmsize_t>(count, 0)));
    if (taken > 0) std::memcpy(to, memory->bytes.data() + memory->at, taken);
    memory->at += taken;
    return static_cast<tmsize_t>(taken);
}
tmsize_t writeNothing(thandle_t, void*, tmsize_t) { return 0; }
toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    auto* memory = static_cast<Memory*>(handle);
    if (whence == SEEK_CUR) offset += memory->at;
    if (whence == SEEK_END) offset += memory->bytes.size();
    return memory->at = offset;
}
int closeNothing(thandle_t) { return 0; }
toff_t sizeOfIt(thandle_t handle) { return static_cast<Memory*>(handle)->bytes.size(); }
int mapNothing(thandle_t, void**, toff_t*) { return 0; }
void unmapNothing(thandle_t, void*, toff_t) {}

struct TiffShape {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT;
    [[nodiscard]] bool floats() const { return bits == 32 && format == SAMPLEFORMAT_IEEEFP; }
};

TiffShape shapeOf(TIFF* tiff) {
    TiffShape shape;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &shape.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &shape.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &shape.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &shape.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &shape.format);
    return shape;
}

/// The byte behind everything that the directory of a picture names: its strips, its own entries, and the values of these.
std::uint64_t endOfPicture(TIFF* tiff, std::string_view file) {
    std::uint64_t end = 0;
    for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff); ++strip)
        end = std::max(end, sumOf({TIFFGetStrileOffset(tiff, strip), TIFFGetStrileByteCount(tiff, strip)}));
    const bool bigEndian = TIFFIsBigEndian(tiff) != 0, wide = file.size() > 2 && file[bigEndian ? 3 : 2] == 43; // BigTIFF
    const auto number = [&](std::uint64_t at, std::size_t bytes) { return numberAt(file, at, bytes, bigEndian); };
    const std::size_t count = wide ? 8 : 2, entry = wide ? 20 : 12, offset = wide ? 8 : 4;
    const std::uint64_t directory = std::min<std::uint64_t>(TIFFCurrentDirOffset(tiff), file.size());
    const std::uint64_t entries = std::min<std::uint64_t>(number(directory, count), (file.size() - directory) / entry);
    for (std::uint64_t n = 0; n < entries; ++n) {
        static constexpr std::array<std::uint8_t, 19> kBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
        const std::uint64_t at = directory + count + n * entry, type = number(at + 2, 2);
        const std::uint64_t bytes = productOf({type < kBytes.size() ? kBytes[type] : 0U, number(at + 4, offset)});
        if (bytes > offset) end = std::max(end, sumOf({number(at + 4 + offset, offset), bytes}));
    }
    return std::max(end, directory + count + entries * entry + offset);
}

Result<Done> checkShape(const TiffShape& shape, TIFF* tiff, const Source& source) {
    if (shape.samples != 1 || !(shape.floats() || (shape.bits == 16 && shape.format != SAMPLEFORMAT_IEEEFP))) {
        return source.refused(withValues("this TIFF picture has %1 of %2 bits, and ranges need one of 16 bits or of 4-byte floats",
                                         {counted(shape.samples, "channel"), shape.bits}),
                              "choose a scan, or a range picture of 16 bits per pixel");
    }
    if (TIFFIsTiled(tiff) != 0) return source.refused("this TIFF picture is stored in tiles", "save it in strips");
    const std::uint64_t pixels = productOf({shape.width, shape.height});
    if (pixels == 0) return source.refused("the picture has no pixels", "choose another file");
    if (auto possible = checkUnpacked(productOf({pixels, shape.bits / 8U}), source); !possible) return possible;
    if (auto known = checkAnglesKnown(shape.width, kPicture, source); !known) return known.error();
    return checkMemory(productOf({pixels, kBytesPerPixel}), source.path.string());
}

Result<Scan> readRangeTiff(const Source& source) {
    TIFFSetErrorHandler(nullptr); // libtiff would print
    TIFFSetWarningHandler(nullptr);
    Memory memory{source.bytes};
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(
        TIFFClientOpen("picture", "rm", &memory, readSome, writeNothing, seekTo, closeNothing, sizeOfIt, mapNothing, unmapNothing),
        TIFFClose);
    const auto damaged = [&] { return source.refused("the TIFF picture is damaged or of a kind that cannot be read", "save it again"); };
    if (!tiff) return damaged();
    const TiffShape shape = shapeOf(tiff.get());
    if (auto fits = checkShape(shape, tiff.get(), source); !fits) return fits.error();
    const std::size_t rowBytes = std::size_t{shape.width} * shape.bits / 8;
    if (TIFFScanlineSize64(tiff.get()) != rowBytes) return damaged();
    std::vector<unsigned char> row(rowBytes);
    Grid<float> values(static_cast<int>(shape.height), static_cast<int>(shape.width));
    for (std::uint32_t i = 0; i < shape.height; ++i) {
        if (TIFFReadScanline(tiff.get(), row.data(), i, 0) < 0) return damaged();
        float* line = values.line(static_cast<int>(i));
        for (std::size_t j = 0; j < shape.width; ++j) {
            if (shape.floats()) {
                std::memcpy(line + j, row.data() + 4 * j, 4);
            } else {
                std::uint16_t value = 0;
                std::memcpy(&value, row.data() + 2 * j, 2);
                line[j] = value;
            }
        }
        if (i % 256 == 0 && !source.goOn("reading the picture", static_cast<double>(i) / shape.height)) return source.cancelled();
    }
    auto scan = scanFromPicture(values, !shape.floats(), "range TIFF", source);
    if (!scan) return scan;
    std::uint64_t end = endOfPicture(tiff.get(), source.text());
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &orientation);
    if (auto turned = orientationNotApplied(orientation)) scan->warnings.push_back(std::move(*turned));
    std::size_t more = 0;
    constexpr std::size_t kMostPictures = 1000;
    for (; more < kMostPictures && TIFFReadDirectory(tiff.get()) != 0; ++more) end = std::max(end, endOfPicture(tiff.get(), source.text()));
    if (more > 0) scan->warnings.push_back(withValues("The file holds %1 (pages); the first was read.", {counted(more + 1, "picture")}));
    if (auto behind = bytesBehind(source.bytes.subspan(std::min<std::uint64_t>(end, source.bytes.size())), "the picture"))
        scan->warnings.push_back(std::move(*behind));
    return scan;
}

#else

Result<Scan> readRangeTiff(const Source& source) {
    return source.refused("this is a TIFF picture, and this build of the program cannot read TIFF", "save the ranges as PNG of 16 bits");
}

#endif

struct PngBytes {
    const std::byte* at = nullptr;
    std::size_t left = 0;
    char problem[120] = "";
};

extern "C" {
void readBytes(png_structp png, png_bytep to, png_size_t count) {
    auto* reading = static_cast<PngBytes*>(png_get_io_ptr(png));
    if (count > reading->left) png_error(png, "the file ends too early");
    std::memcpy(to, reading->at, count);
    reading->at += count;
    reading->left -= count;
}
void keepProblem(png_structp png, png_const_charp text) {
    auto* reading = static_cast<PngBytes*>(png_get_error_ptr(png));
    std::strncpy(reading->problem, text, sizeof reading->problem - 1);
    png_longjmp(png, 1);
}
void ignoreIt(png_structp, png_const_charp) {}
}

struct Header {
    png_uint_32 width = 0, height = 0;
    int depth = 0, colour = 0, interlace = 0;
};

/// Only trivial objects live in these two, so a longjmp skips no destructor.
bool readHeader(png_structp png, png_infop head, PngBytes* reading, Header* header) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_read_fn(png, reading, readBytes);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1); // a thousand texts of 8 MB fit into 8 MB of file
    png_read_info(png, head);
    png_get_IHDR(png, head, &header->width, &header->height, &header->depth, &header->colour, &header->interlace, nullptr, nullptr);
    return true;
}
bool readRows(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_swap(png); // PNG is big-endian
    png_read_image(png, rows);
    return true;
}

struct PngReader {
    png_structp png = nullptr;
    png_infop head = nullptr;
    explicit PngReader(PngBytes* reading) : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, reading, keepProblem, ignoreIt)) {
        if (png != nullptr) head = png_create_info_struct(png);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &head, nullptr); }
};

Result<Done> checkHeader(const Header& header, const Source& source) {
    if (header.depth != 16 || header.colour != PNG_COLOR_TYPE_GRAY) {
        return source.refused(withValues(header.colour == PNG_COLOR_TYPE_GRAY
                                             ? "this is a PNG picture of %1 bit gray, and ranges need 16 bit gray"
                                             : "this is a PNG picture of %1 bit colour, and ranges need 16 bit gray",
                                         {header.depth}),
                              "choose a scan, or a range picture of 16 bits per pixel");
    }
    const std::uint64_t pixels = productOf({header.width, header.height});
    if (auto possible = checkUnpacked(productOf({pixels, 2}), source); !possible) return possible;
    if (auto known = checkAnglesKnown(header.width, kPicture, source); !known) return known.error();
    return checkMemory(productOf({pixels, kBytesPerPixel}), source.path.string());
}

/// Of a chunk eXIf, which begins like a TIFF file; 1 where it does not say.
std::uint64_t orientationIn(std::string_view exif) {
    constexpr std::uint64_t kOrientation = 274;
    const bool bigEndian = exif.starts_with("MM");
    const std::uint64_t directory = numberAt(exif, 4, 4, bigEndian), entries = numberAt(exif, directory, 2, bigEndian);
    for (std::uint64_t n = 0; n < entries && directory + 14 + 12 * n <= exif.size(); ++n) {
        const std::uint64_t entry = directory + 2 + 12 * n;
        if (numberAt(exif, entry, 2, bigEndian) == kOrientation) return numberAt(exif, entry + 8, 2, bigEndian);
    }
    return 1;
}

/// What the chunks around the pixels ask for and what follows them.
void remarkOnChunks(Scan& scan, const Source& source) {
    const std::string_view text = source.text();
    std::size_t at = 8;
    bool ended = false, frames = false;
    while (!ended && at + 12 <= text.size()) {
        const std::uint64_t length = numberAt(text, at, 4, true);
        if (length > text.size() - at - 12) break;
        const std::string_view kind = text.substr(at + 4, 4);
        if (kind == "eXIf") {
            if (auto turned = orientationNotApplied(orientationIn(text.substr(at + 8, length))))
                scan.warnings.push_back(std::move(*turned));
        }
        frames = frames || kind == "fdAT";
        ended = kind == "IEND";
        at += 12 + length;
    }
    if (frames) scan.warnings.emplace_back("The picture is animated; the first frame was read.");
    if (!ended) return scan.warnings.emplace_back("The picture does not end with IEND: the file was cut off behind its pixels."), void();
    if (auto behind = bytesBehind(source.bytes.subspan(at), "the picture")) scan.warnings.push_back(std::move(*behind));
}

bool isPng(const Source& source) { return source.text().starts_with("\x89PNG\r\n\x1a\n"); }

Result<Scan> readRangePng(const Source& source) {
    PngBytes reading{source.bytes.data(), source.bytes.size()};
    const PngReader reader(&reading);
    const auto damaged = [&] {
        return source.refused(std::string("this is a PNG picture that cannot be read: ") + reading.problem, "copy it again");
    };
    if (reader.head == nullptr) return Error{"there is not enough memory for this file", source.path.string(), "close other programs"};
    Header header;
    if (!readHeader(reader.png, reader.head, &reading, &header)) return damaged();
    if (auto fits = checkHeader(header, source); !fits) return fits.error();
    std::vector<std::uint16_t> samples(std::size_t{header.width} * header.height);
    std::vector<png_bytep> rows;
    for (std::size_t i = 0; i < header.height; ++i) rows.push_back(reinterpret_cast<png_bytep>(samples.data() + i * header.width));
    if (!readRows(reader.png, rows.data())) return damaged();
    Grid<float> values(static_cast<int>(header.height), static_cast<int>(header.width));
    for (std::size_t k = 0; k < samples.size(); ++k) values[k] = static_cast<float>(samples[k]);
    auto scan = scanFromPicture(values, true, "range PNG", source);
    if (scan) remarkOnChunks(*scan, source);
    return scan;
}

bool looksLikePicture(const Source& source) {
    using namespace std::string_view_literals;
    static constexpr std::array<std::string_view, 4> kTiff{"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv};
    return isPng(source) || std::ranges::any_of(kTiff, [&](std::string_view magic) { return source.text().starts_with(magic); });
}

Result<Scan> readPicture(const Source& source) { return isPng(source) ? readRangePng(source) : readRangeTiff(source); }

} // namespace

Format rangePictureFormat() {
    return {.title = "Range picture", .reads = {".png", ".tif", ".tiff"}, .recognises = looksLikePicture, .read = readingOf<readPicture>};
}

} // namespace edgescan::files
