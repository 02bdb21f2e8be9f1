// Arrays of numpy: ranges as lines x beams, points as records or with three numbers each; .npy.
#include "core/base/bytes_behind.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"
#include "core/files/formats/numpy_header.h"
#include "core/files/formats/range_geometry.h"
#include "core/files/point_tables/point_columns.h"

#include <algorithm>
#include <cmath>

namespace edgescan::files {
namespace {

constexpr std::uint64_t kFewestBeams = 16; // narrower tables are points, as in text

/// The number of cell (i, j) or of part c of point n, whatever the order of the indexes.
struct NumpyNumbers {
    const NumpyArray* array;
    std::array<std::uint64_t, 3> stride{0, 0, 0}; ///< items per step of each index

    explicit NumpyNumbers(const NumpyArray& from) : array(&from) {
        std::uint64_t step = 1;
        const std::size_t sides = std::min<std::size_t>(from.shape.size(), 3);
        for (std::size_t n = 0; n < sides; ++n) {
            const std::size_t index = from.fortranOrder ? n : sides - 1 - n;
            stride[index] = step;
            step *= from.shape[index];
        }
    }
    [[nodiscard]] std::uint64_t item(std::uint64_t i, std::uint64_t j, std::uint64_t k = 0) const {
        return i * stride[0] + j * stride[1] + k * stride[2];
    }
    [[nodiscard]] double value(std::uint64_t item) const { return array->scalar.valueAt(array->data.data() + item * array->itemBytes); }
};

/// How exactly the numbers of a type are written; whole ones are what they are.
Precision precisionOf(const NumpyScalar& scalar) {
    if (scalar.kind != 'f') return {0.0, 0x1p-53};
    return {0.0, scalar.isHalf() ? 0x1p-11 : kFloatError};
}

Result<Scan> rangeScan(const NumpyArray& array, const Source& source) {
    const std::uint64_t lines = array.shape[0];
    const std::uint64_t beams = array.shape[1];
    if (auto known = checkAnglesKnown(beams, kArray, source); !known) return known.error();
    if (auto enough = checkMemory(lines * beams * 24, source.path.string()); !enough) return enough.error();
    const NumpyNumbers numbers(array);
    BareRanges ranges{{}, lines, beams, precisionOf(array.scalar)};
    if (array.scalar.kind == 'u' && array.scalar.bytes <= 2) ranges.stated = std::ldexp(1.0, 8 * static_cast<int>(array.scalar.bytes)) - 1;
    ranges.values.reserve(lines * beams);
    for (std::uint64_t i = 0; i < lines; ++i) {
        for (std::uint64_t j = 0; j < beams; ++j) ranges.values.push_back(numbers.value(numbers.item(i, j)));
        if (i % 64 == 0 && !source.goOn("reading ranges", static_cast<double>(i) / static_cast<double>(lines))) return source.cancelled();
    }
    auto scan = scanFromRanges(std::move(ranges), kArray, source, [](std::size_t line, std::size_t beam) {
        return withValues("the array at [%1, %2]", {line, beam});
    });
    if (scan) scan->format = "numpy";
    return scan;
}

/// x y z in the last index, or in the columns of a table.
Result<PointTable> plainPoints(const NumpyArray& array, const Source& source) {
    const bool grid = array.shape.size() == 3;
    const std::uint64_t height = grid ? array.shape[0] : 1;
    const std::uint64_t width = grid ? array.shape[1] : array.shape[0];
    if (auto enough = checkMemory(height * width * sizeof(Eigen::Vector3d), source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "numpy";
    table.width = width;
    table.height = height;
    table.precision = precisionOf(array.scalar);
    table.points.reserve(height * width);
    const NumpyNumbers numbers(array);
    for (std::uint64_t i = 0; i < height; ++i) {
        for (std::uint64_t j = 0; j < width; ++j) {
            const auto part = [&](std::uint64_t c) { return numbers.value(grid ? numbers.item(i, j, c) : numbers.item(j, c)); };
            table.points.emplace_back(part(0), part(1), part(2));
            if (table.points.size() % 65536 == 0 && !source.goOn("reading points", 0.3)) return source.cancelled();
        }
    }
    const std::uint64_t parts = array.shape.back();
    if (parts > 3) {
        table.remarks.push_back(withValues("The first three of %1 columns were taken as x, y and z; the others are not read.", {parts}));
    }
    return table;
}

/// Records with x, y and z; the fields of a record may be called as in other formats.
Result<PointTable> recordPoints(const NumpyArray& array, const Source& source) {
    const std::uint64_t points = array.items();
    std::vector<RecordField> fields;
    std::string names;
    bool bigEndian = false;
    for (const NumpyField& field : array.fields) {
        names += (names.empty() ? "" : ", ") + field.name;
        const auto scalar = field.scalar.scalar();
        if (!scalar) continue;
        bigEndian = bigEndian || field.scalar.bigEndian;
        fields.push_back({asciiLower(field.name), *scalar, 0, field.offset, array.itemBytes});
    }
    const auto picked = pickFields(fields);
    if (!picked)
        return source.refused(withValues("the records of this numpy array have no x, y and z, only %1", {names}),
                              "save points with fields x, y and z");
    const bool mixed =
        std::ranges::any_of(array.fields, [&](const NumpyField& f) { return f.scalar.bytes > 1 && f.scalar.bigEndian != bigEndian; });
    if (mixed) return source.refused("the fields of this numpy array have different byte orders", "save it again with one");
    if (auto enough = checkMemory(points * sizeof(Eigen::Vector3d), source.path.string()); !enough) return enough.error();
    PointTable table;
    table.format = "numpy";
    if (!readRecords(table, *picked, points, array.data, bigEndian, source)) return source.cancelled();
    table.width = points;
    if (array.shape.size() == 2) {
        table.width = array.shape[1];
        table.height = array.shape[0];
    }
    return table;
}

enum class Holds : std::uint8_t { Ranges, Points, Records, Neither };

/// Three rows of numbers: the x, y and z of points, the wrong way round, unless the angles of three lines are given.
bool mayBePointsAcross(const NumpyArray& array, const ReadingOptions& options) {
    return array.fields.empty() && array.shape.size() == 2 && array.shape[0] == 3 && array.shape[1] >= kFewestBeams && !options.beamStepDeg;
}

Holds whatIsIn(const NumpyArray& array, const ReadingOptions& options) {
    const std::size_t sides = array.shape.size();
    if (!array.fields.empty()) return sides == 1 || (sides == 2 && !array.fortranOrder) ? Holds::Records : Holds::Neither;
    if (sides == 3 && array.shape[2] == 1) return Holds::Ranges;
    if (sides == 3 && array.shape[2] >= 3 && array.shape[2] < kFewestBeams) return Holds::Points;
    if (sides != 2) return Holds::Neither;
    if (array.shape[1] >= kFewestBeams || (options.beamStepDeg && options.lineStepDeg)) return Holds::Ranges;
    return array.shape[1] >= 3 ? Holds::Points : Holds::Neither;
}

Result<Done> checkSides(const NumpyArray& array, const Source& source) {
    const bool tooMany = array.items() > kMostPoints || std::ranges::any_of(array.shape, [](std::uint64_t n) {
                             return !physical::kAlongOneSide.hold(static_cast<double>(n));
                         });
    if (tooMany) return source.refused(withValues("a numpy array of shape %1 is larger than any scan", {array.shapeText()}), "split it");
    return Done{};
}

Result<Reading> readingOfArray(const NumpyArray& array, const Source& source) {
    if (auto fits = checkSides(array, source); !fits) return fits.error();
    if (mayBePointsAcross(array, *source.options)) {
        return source.refused(
            withValues("a numpy array of shape %1 may be points the wrong way round, or three lines of ranges", {array.shapeText()}),
            "save points as (n, 3), which is points.T, or give --beam-start --beam-step --line-start "
            "--line-step --axis");
    }
    const Holds what = whatIsIn(array, *source.options);
    if (what == Holds::Ranges) {
        auto scan = rangeScan(array, source);
        if (!scan) return scan.error();
        return Reading(std::move(*scan));
    }
    if (what == Holds::Neither) {
        return source.refused(
            withValues("a numpy array of shape %1 is neither ranges (lines, beams) nor points (n, 3) or (lines, beams, 3)",
                       {array.shapeText()}),
            "save it in one of these shapes");
    }
    auto table = what == Holds::Records ? recordPoints(array, source) : plainPoints(array, source);
    if (!table) return table.error();
    return Reading(std::move(*table));
}

Result<Reading> readArray(const Source& source) {
    const auto array = readNumpy(source);
    if (!array) return array.error();
    auto reading = readingOfArray(*array, source);
    if (!reading) return reading;
    if (isNumpy(array->rest))
        reading->warnings.emplace_back("The file holds more than one array (numpy.save more than once); the first was read.");
    else if (auto behind = bytesBehind(array->rest, "the array"))
        reading->warnings.push_back(std::move(*behind));
    return reading;
}

bool looksLikeNumpy(const Source& source) { return isNumpy(source.bytes); }

} // namespace

Format numpyFormat() { return {.title = "numpy array", .reads = {".npy"}, .recognises = looksLikeNumpy, .read = readArray}; }

} // namespace edgescan::files
