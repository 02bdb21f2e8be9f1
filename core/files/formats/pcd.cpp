// Point Cloud Data v0.7 (PCL): ascii, binary and binary_compressed; fields of any type and count. Everything a header promises is compared
// with the bytes that are there before anything is allocated.
#include "core/base/bytes_behind.h"
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/translated_text.h"
#include "core/files/formats/format.h"
#include "core/files/point_tables/axis_words.h"
#include "core/files/point_tables/cloud_columns.h"
#include "core/files/point_tables/column_rows.h"
#include "core/files/point_tables/point_columns.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace edgescan::files {
namespace {

/// Three numbers follow this in a comment of our own PCD files with metres from the origin of a mine grid: what is to be added to x y z and
/// to the sensor's place in VIEWPOINT.
constexpr const char* kPcdOrigin = "edgescan-origin ";
/// The same for the sensor's place where VIEWPOINT holds the origin, as in files of the first versions.
constexpr const char* kPcdSensor = "edgescan-sensor ";

// PCD v0.7: text or binary records; colours as PCL knows them; mine coordinates as metres from their origin.

/// Of each kind of column.
struct PcdType {
    const char* size;
    const char* type;
};
PcdType pcdTypeOf(const CloudColumn& column) {
    static constexpr std::array<PcdType, 4> kTypes{{{"4", "F"}, {"8", "F"}, {"4", "U"}, {"1", "U"}}};
    return kTypes[column.values.index()];
}

template <class Word>
std::string headerLine(const char* key, const CloudColumns& cloud, Word word) {
    std::string line = key;
    for (const CloudColumn& column : cloud.columns) {
        line += ' ';
        line += word(column);
    }
    line += '\n';
    return line;
}

/// red, green and blue as the one field that PCL, Open3D, CloudCompare and three.js know: the bits 0x00RRGGBB as a number of type F.
void packColours(CloudColumns& cloud) {
    const std::array<const CloudColumn*, 3> channels{columnNamed(cloud, "red"), columnNamed(cloud, "green"), columnNamed(cloud, "blue")};
    if (std::ranges::count(channels, nullptr) > 0) return;
    std::vector<float> packed;
    packed.reserve(rowsOf(cloud));
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        std::uint32_t colour = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            colour |= static_cast<std::uint32_t>(numberIn(*channels[channel], row)) << (16U - 8U * channel);
        packed.push_back(std::bit_cast<float>(colour));
    }
    dropColumns(cloud, isColour);
    cloud.columns.push_back({"rgb", std::move(packed)});
}

void appendThree(std::string& text, const Eigen::Vector3d& v) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendShortest(text, v[axis]);
    }
}

/// Binary, or text. Error: not enough memory.
Result<std::string> pcdBytes(CloudColumns cloud, const std::string& where, bool ascii) {
    if (auto enough = checkRoom(cloud, where, ascii ? 12 : 8); !enough) return enough.error();
    std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
    packColours(cloud);
    Eigen::Vector3d viewpoint = cloud.sensorM;
    // PCL and Open3D read coordinates of 4 bytes only.
    if (cloud.frame == CoordinateFrame::Mine && !cloud.choices.doubles) {
        subtractOrigin(cloud);
        viewpoint -= cloud.originM;
        text += std::string("# ") + kPcdOrigin;
        appendThree(text, cloud.originM);
        text += " m Easting Northing Elevation: add it to x y z and to VIEWPOINT\n";
    }
    if (cloud.frame != CoordinateFrame::Scanner) text += "# " + frameText(cloud) + "\n";
    appendComments(text, cloud, "# ");
    text += "VERSION 0.7\n";
    text += headerLine("FIELDS", cloud, [](const CloudColumn& c) { return c.name; });
    text += headerLine("SIZE", cloud, [](const CloudColumn& c) { return pcdTypeOf(c).size; });
    text += headerLine("TYPE", cloud, [](const CloudColumn& c) { return pcdTypeOf(c).type; });
    text += headerLine("COUNT", cloud, [](const CloudColumn&) { return "1"; });
    text += "WIDTH " + std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) + "\nVIEWPOINT ";
    appendThree(text, viewpoint);
    text += " 1 0 0 0\nPOINTS " + std::to_string(rowsOf(cloud)) + "\nDATA " + (ascii ? "ascii" : "binary") + "\n";
    if (ascii)
        appendRows(text, cloud, ' ');
    else
        appendRecords(text, cloud);
    return text;
}

constexpr std::size_t kMostFields = 4096;
constexpr auto kMostAlong = static_cast<std::uint64_t>(physical::kAlongOneSide.limits.most);
constexpr std::uint64_t kLargestRecord = 1U << 20U;
constexpr std::uint64_t kMostPerPackedByte = 132; // three bytes of LZF unpack to 264 at most

struct PcdHeader {
    std::vector<std::string> names;
    std::vector<std::uint64_t> sizes, counts;
    std::vector<char> types;
    std::uint64_t width = 0, height = 1;
    std::optional<std::uint64_t> points;
    Eigen::Vector3d sensor = Eigen::Vector3d::Zero();
    std::optional<Eigen::Vector3d> originM, sensorM; ///< of our own files in mine coordinates: see kPcdOrigin
    std::string encoding;
    std::string description;
    std::optional<double> unitMm; ///< of a comment
    std::size_t firstByte = 0;    ///< of the points
    std::size_t firstLine = 1;
};

std::optional<std::vector<std::uint64_t>> wholeNumbers(const std::vector<std::string_view>& words) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto number = wholeNumber(words[i]);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

void readViewpoint(const std::vector<std::string_view>& words, PcdHeader& header) {
    for (std::size_t i = 1; i < words.size() && i <= 3; ++i) {
        double value = 0;
        std::from_chars(words[i].data(), words[i].data() + words[i].size(), value);
        if (!physical::kPlaceM.hold(value)) value = 0; // no place on earth: as good as not given
        header.sensor[static_cast<Eigen::Index>(i - 1)] = value;
    }
}

/// One line of the header; false when it is not understood.
bool readHeaderLine(const std::vector<std::string_view>& words, PcdHeader& header) {
    const std::string_view key = words[0];
    if (key == "VERSION") return true;
    if (key == "FIELDS" || key == "COLUMNS") {
        header.names.assign(words.begin() + 1, words.end());
        return header.names.size() <= kMostFields;
    }
    if (key == "TYPE") {
        for (std::size_t i = 1; i < words.size(); ++i) header.types.push_back(words[i][0]);
        return true;
    }
    if (key == "VIEWPOINT") return readViewpoint(words, header), true;
    if (key == "DATA") {
        header.encoding = words.size() > 1 ? std::string(words[1]) : std::string();
        return true;
    }
    const auto numbers = wholeNumbers(words);
    if (!numbers) return false;
    if (key == "SIZE") return header.sizes = *numbers, true;
    if (key == "COUNT") return header.counts = *numbers, true;
    if (numbers->size() != 1) return false;
    if (key == "WIDTH") return header.width = numbers->front(), true;
    if (key == "HEIGHT") return header.height = numbers->front(), true;
    if (key == "POINTS") return header.points = numbers->front(), true;
    return false;
}

void readOwnComment(std::string_view line, PcdHeader& header) {
    for (const auto& [mark, target] : {std::pair(kPcdOrigin, &header.originM), std::pair(kPcdSensor, &header.sensorM)}) {
        const std::size_t found = line.substr(0, 32).find(mark);
        if (found == std::string_view::npos) continue;
        const auto words = wordsOf(line.substr(found));
        PcdHeader numbers;
        readViewpoint(words, numbers);
        *target = numbers.sensor;
    }
}

Result<PcdHeader> readPcdHeader(const Source& source) {
    PcdHeader header;
    HeaderLines lines(source.text());
    while (header.encoding.empty() && lines.next()) {
        if (lines.line().starts_with('#')) {
            if (addToDescription(lines.line().substr(1), header.description)) continue;
            readOwnComment(lines.line(), header);
            if (const auto unit = unitInComment(lines.line())) header.unitMm = unit;
            continue;
        }
        const auto words = wordsOf(lines.line());
        if (words.empty()) continue;
        if (!readHeaderLine(words, header)) {
            return source.refusedAtLine(lines.number(), "this header line of the PCD file is not understood",
                                        "compare it with a PCD file of version 0.7");
        }
    }
    if (header.encoding.empty()) return source.refused("the PCD header has no DATA line", kCopyAgain);
    header.firstByte = lines.nextByte();
    header.firstLine = lines.number() + 1;
    return header;
}

std::optional<Scalar> scalarOf(char type, std::uint64_t size) {
    static constexpr std::array<std::array<Scalar, 4>, 2> kWhole{
        {{Scalar::Int8, Scalar::Int16, Scalar::Int32, Scalar::Int64}, {Scalar::UInt8, Scalar::UInt16, Scalar::UInt32, Scalar::UInt64}}};
    const std::size_t log = size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : size == 8 ? 3 : 4;
    if (log == 4) return std::nullopt;
    if (type == 'I') return kWhole[0][log];
    if (type == 'U') return kWhole[1][log];
    if (type == 'F' && size == 4) return Scalar::Float32;
    if (type == 'F' && size == 8) return Scalar::Float64;
    return std::nullopt;
}

struct PcdLayout {
    PointFields fields;
    std::uint64_t points = 0;
    std::uint64_t recordBytes = 0;
    std::size_t recordNumbers = 0;
};

/// Fields with their places. Columns of a compressed file follow each other, those of a binary file in records.
Result<PcdLayout> layoutOf(PcdHeader& header, const Source& source) {
    const std::size_t count = header.names.size();
    if (header.counts.empty()) header.counts.assign(count, 1);
    if (count == 0 || header.sizes.size() != count || header.types.size() != count || header.counts.size() != count) {
        return source.refused(withValues("the PCD header names %1 and gives %2, %3 and %4",
                                         {counted(count, "field"), counted(header.sizes.size(), "size"),
                                          counted(header.types.size(), "type"), counted(header.counts.size(), "count")}),
                              "export the file again");
    }
    PcdLayout layout;
    if (productOf({header.width, header.height}) > kMostPoints || header.width > kMostAlong || header.height > kMostAlong) {
        return source.refused("the header promises more points than any file holds", "check WIDTH and HEIGHT");
    }
    layout.points = header.width * header.height;
    if (header.points && *header.points != layout.points) {
        return source.refused(
            withValues("the header promises %1 and %2 x %3 of them", {counted(*header.points, "point"), header.width, header.height}),
            "check POINTS, WIDTH and HEIGHT");
    }
    if (layout.points == 0) return source.refused("the file holds no points", "choose another file");
    std::vector<RecordField> fields;
    for (std::size_t i = 0; i < count; ++i) {
        if (header.counts[i] == 0) continue; // padding that takes no bytes, as PCL makes it of a ROS message
        const auto scalar = scalarOf(header.types[i], header.sizes[i]);
        if (!scalar || header.counts[i] > kLargestRecord) {
            return source.refused(withValues("the field %1 has a type or size that PCD does not know", {header.names[i].substr(0, 40)}),
                                  "export the file again");
        }
        fields.push_back({header.names[i], *scalar, layout.recordNumbers, layout.recordBytes, 0});
        layout.recordBytes += header.sizes[i] * header.counts[i];
        layout.recordNumbers += header.counts[i];
        if (layout.recordBytes > kLargestRecord) return source.refused("one point would take more than a megabyte", "check SIZE and COUNT");
    }
    const bool columns = header.encoding == "binary_compressed";
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::uint64_t end = i + 1 < fields.size() ? fields[i + 1].offset : layout.recordBytes;
        fields[i].stride = columns ? end - fields[i].offset : layout.recordBytes;
    }
    if (columns) {
        for (RecordField& field : fields) field.offset *= layout.points;
    }
    const auto picked = pickFields(fields);
    if (!picked) return source.refused("the PCD file has no fields x, y and z", "export the file with coordinates");
    layout.fields = *picked;
    return layout;
}

Error tooShort(const Source& source, const PcdLayout& layout, std::uint64_t held) {
    return source.refused(withValues("the header promises %1 of %2 bytes and the file holds %3 bytes of them",
                                     {counted(layout.points, "point"), layout.recordBytes, held}),
                          kCopyAgain);
}

Result<Done> readBinary(PointTable& table, const PcdHeader& header, const PcdLayout& layout, const Source& source) {
    const auto held = source.bytes.subspan(header.firstByte);
    if (held.size() / layout.recordBytes < layout.points) return tooShort(source, layout, held.size());
    if (auto whole = checkRest(table, layout.points, layout.recordBytes, held, source); !whole) return whole;
    const bool givenAway = source.placesOnly && source.receivePlaces && !header.originM;
    const auto read = givenAway ? givePlaces : readRecords;
    if (!read(table, layout.fields, layout.points, held, false, source)) return source.cancelled();
    return Done{};
}

Result<Done> readCompressed(PointTable& table, const PcdHeader& header, const PcdLayout& layout, const Source& source) {
    const auto held = source.bytes.subspan(header.firstByte);
    if (held.size() < 8) return source.refused("the file ends before its compressed points", kCopyAgain);
    const auto packedSize = static_cast<std::uint64_t>(readScalar(Scalar::UInt32, held.data(), false));
    const auto size = static_cast<std::uint64_t>(readScalar(Scalar::UInt32, held.data() + 4, false));
    if (packedSize > held.size() - 8) {
        return source.refused(withValues("promises %1 compressed bytes and holds %2", {packedSize, held.size() - 8}), kCopyAgain);
    }
    if (size != productOf({layout.points, layout.recordBytes}) || size / kMostPerPackedByte > packedSize)
        return tooShort(source, layout, size);
    if (size > mostUnpackedBytes(packedSize))
        return source.refused(withValues("promises that %1 unpack to %2, which no scan does", {sizeText(packedSize), sizeText(size)}),
                              "export the file again, uncompressed");
    if (auto enough = checkMemory(size, source.path.string()); !enough) return enough.error();
    std::vector<std::byte> unpacked(size);
    const bool sound = packedSize > 0 && lzf_decompress(held.data() + 8, static_cast<unsigned>(packedSize), unpacked.data(),
                                                        static_cast<unsigned>(size)) == size;
    if (!sound) return source.refused("the compressed points are damaged", "copy the file again");
    if (auto behind = bytesBehind(held.subspan(8 + packedSize), "the points")) table.remarks.push_back(std::move(*behind));
    if (!readRecords(table, layout.fields, layout.points, unpacked, false, source)) return source.cancelled();
    return Done{};
}

Result<Done> readPoints(PointTable& table, const PcdHeader& header, const PcdLayout& layout, const Source& source) {
    if (header.encoding == "binary") return readBinary(table, header, layout, source);
    if (header.encoding == "binary_compressed") return readCompressed(table, header, layout, source);
    if (header.encoding == "ascii") {
        // Two bytes of text per number at least: a digit and a blank.
        if (productOf({layout.points, layout.recordNumbers, 2}) > source.bytes.size() + 2)
            return tooShort(source, layout, source.bytes.size() - header.firstByte);
        return readRows(table, layout.fields, {layout.points, layout.recordNumbers, header.firstByte, header.firstLine}, source);
    }
    return source.refused(withValues("the encoding \"%1\" is not ascii, binary or binary_compressed", {header.encoding.substr(0, 40)}),
                          "export the file again");
}

bool looksLikePcd(const Source& source) {
    std::string_view text = source.text();
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    HeaderLines lines(text.substr(0, 65536));
    while (lines.next()) {
        if (lines.line().starts_with("# .PCD")) return true;
        if (lines.line().starts_with('#') || lines.line().empty()) continue;
        return lines.line().starts_with("VERSION") || lines.line().starts_with("FIELDS") || lines.line().starts_with("COLUMNS");
    }
    return false;
}

Result<PointTable> readPcdPoints(const Source& source) {
    auto header = readPcdHeader(source);
    if (!header) return header.error();
    const auto layout = layoutOf(*header, source);
    if (!layout) return layout.error();
    PointTable table;
    table.format = "PCD";
    table.width = header->width;
    table.height = header->height;
    table.sensor = header->sensor;
    table.description = header->description;
    takeUnitOfComment(table, header->unitMm, source);
    if (auto enough = checkMemory(productOf({std::min(layout->points, mostUnpackedBytes(source.bytes.size())), 32}), source.path.string());
        !enough)
        return enough.error();
    if (auto read = readPoints(table, *header, *layout, source); !read) return read.error();
    if (header->originM) {
        double largest = 0; // the sums have more digits than were written
        for (Eigen::Vector3d& p : table.points) {
            if (isReturn(p)) largest = std::max(largest, p.cwiseAbs().maxCoeff());
            p += *header->originM;
        }
        table.precision.absolute = std::max(table.precision.absolute, kFloatError / 2 * largest);
        table.sensor = header->sensorM.value_or(header->sensor + *header->originM);
    }
    return table;
}

} // namespace

Format pcdFormat() {
    return {.title = "Point Cloud Library",
            .reads = {".pcd"},
            .writes = {".pcd"},
            .recognises = looksLikePcd,
            .read = readingOf<readPcdPoints>,
            .write = pcdBytes,
            .keepsIntensity = true,
            .aboutOrigin = true,
            .writesByLines = true};
}

} // namespace edgescan::files
