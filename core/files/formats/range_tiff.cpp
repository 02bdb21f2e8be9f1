// Range pictures as TIFF, through libtiff where the program was built with it.
#include "core/base/bytes_behind.h"
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/files/formats/gray_pictures.h"
#include "core/files/formats/range_geometry.h"

#ifdef EDGESCAN_WITH_TIFF
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#endif

namespace edgescan::files {

#ifdef EDGESCAN_WITH_TIFF
namespace {

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
std::uint64_t endOfPicture(TIFF* tiff, std::span<const std::byte> file) {
    std::uint64_t end = 0;
    for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff); ++strip)
        end = std::max(end, sumOf({TIFFGetStrileOffset(tiff, strip), TIFFGetStrileByteCount(tiff, strip)}));
    const bool bigEndian = TIFFIsBigEndian(tiff) != 0, wide = file.size() > 2 && file[bigEndian ? 3 : 2] == std::byte{43}; // BigTIFF
    const auto number = [&](std::uint64_t at, std::size_t bytes) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes && at + i < file.size(); ++i)
            value |= std::to_integer<std::uint64_t>(file[at + i]) << 8U * (bigEndian ? bytes - 1 - i : i);
        return value;
    };
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

} // namespace

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
    std::uint64_t end = endOfPicture(tiff.get(), source.bytes);
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &orientation);
    if (auto turned = orientationNotApplied(orientation)) scan->warnings.push_back(std::move(*turned));
    std::size_t more = 0;
    constexpr std::size_t kMostPictures = 1000;
    for (; more < kMostPictures && TIFFReadDirectory(tiff.get()) != 0; ++more) end = std::max(end, endOfPicture(tiff.get(), source.bytes));
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

} // namespace edgescan::files
