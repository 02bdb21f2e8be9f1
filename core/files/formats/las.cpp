// LAS 1.0 to 1.4, uncompressed, point formats 0 to 10 (ASPRS). Every offset and count of the header is compared with the bytes that are
// there before anything is allocated.

#include "core/base/translated_text.h"
#include "core/files/formats/format.h"

#include "core/base/bytes_behind.h"
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/formats/las_layout.h"
#include "core/files/formats/las_records.h"
#include "core/files/formats/laz.h"
#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/point_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace edgescan::files {
namespace {

static_assert(std::endian::native == std::endian::little, "LAS is read as the machine stores numbers");

/// The caller has checked that the bytes are there.
template <class T>
T valueAt(const Source& source, std::uint64_t offset) {
    T value;
    std::memcpy(&value, source.bytes.data() + offset, sizeof value);
    return value;
}

struct LasHeader {
    int minor = 0;
    std::uint64_t headerBytes = 0, pointsAt = 0, records = 0, points = 0, extendedAt = 0, extended = 0, waveformAt = 0;
    unsigned format = 0;
    std::uint64_t pointBytes = 0;
    Eigen::Vector3d scale, offset;
};

constexpr NumberLimits kScales{1e-12, 1e6}; // metres per count
bool isScale(const Eigen::Vector3d& v) {
    return kScales.hold(std::abs(v.x())) && kScales.hold(std::abs(v.y())) && kScales.hold(std::abs(v.z()));
}
bool isReasonable(const Eigen::Vector3d& v) { return v.allFinite() && physical::kCoordinate.hold(v.cwiseAbs().maxCoeff()); }

Result<LasHeader> readLasHeader(const Source& source) {
    if (source.bytes.size() < las::kHeader12) return source.refused("the file ends within its LAS header", kCopyAgain);
    LasHeader header;
    const int major = valueAt<std::uint8_t>(source, las::kVersionMajor);
    header.minor = valueAt<std::uint8_t>(source, las::kVersionMinor);
    header.headerBytes = valueAt<std::uint16_t>(source, las::kHeaderSize);
    header.pointsAt = valueAt<std::uint32_t>(source, las::kPointsAt);
    header.records = valueAt<std::uint32_t>(source, las::kRecordCount);
    header.format = valueAt<std::uint8_t>(source, las::kPointFormat);
    header.pointBytes = valueAt<std::uint16_t>(source, las::kPointBytes);
    header.points = valueAt<std::uint32_t>(source, las::kLegacyPoints);
    if (major != 1 || header.minor > 4) {
        return source.refused(withValues("this is LAS version %1.%2, and versions up to 1.4 are known", {major, header.minor}),
                              "save it as LAS 1.2 or 1.4");
    }
    const std::uint64_t least = header.minor == 4 ? las::kHeader14 : las::kHeader12;
    if (header.headerBytes < least || header.headerBytes > source.bytes.size())
        return source.refused(withValues("the LAS header says it is %1 bytes long", {header.headerBytes}), kCopyAgain);
    if (header.minor >= 3 && header.headerBytes >= las::kHeader13) header.waveformAt = valueAt<std::uint64_t>(source, las::kWaveformAt);
    if (header.minor == 4) {
        header.extendedAt = valueAt<std::uint64_t>(source, las::kExtendedAt);
        header.extended = valueAt<std::uint32_t>(source, las::kExtendedCount);
        if (const auto points = valueAt<std::uint64_t>(source, las::kPoints); points != 0) header.points = points;
    }
    for (int axis = 0; axis < 3; ++axis) {
        header.scale[axis] = valueAt<double>(source, las::kScale + 8 * static_cast<std::size_t>(axis));
        header.offset[axis] = valueAt<double>(source, las::kOffset + 8 * static_cast<std::size_t>(axis));
    }
    if (!isScale(header.scale) || !isReasonable(header.offset))
        return source.refused("the scale or offset in the LAS header is not a number that coordinates can have", "export the file again");
    return header;
}

Result<Done> checkPoints(const LasHeader& header, const Source& source) {
    if (header.format >= las::kFormatBytes.size() || header.pointBytes < las::kFormatBytes[header.format]) {
        return source.refused(withValues("points of format %1 with %2 bytes are none that LAS knows", {header.format, header.pointBytes}),
                              "save it as LAS 1.2 or 1.4");
    }
    if (header.points == 0) return source.refused("the file holds no points", "choose another file");
    if (header.pointsAt < header.headerBytes || header.pointsAt > source.bytes.size())
        return source.refused(withValues("the points begin at byte %1, which is not in the file", {header.pointsAt}), kCopyAgain);
    const std::uint64_t held = source.bytes.size() - header.pointsAt;
    if (held / header.pointBytes < header.points) {
        return source.refused(withValues("the header promises %1 of %2 bytes and the file holds %3 bytes of them",
                                         {counted(header.points, "point"), header.pointBytes, held}),
                              kCopyAgain);
    }
    return checkMemory(productOf({header.points, sizeof(Eigen::Vector3d)}), source.path.string());
}

/// Our own records of a file that this program saved.
struct OwnRecords {
    std::string description;
    std::string provenance;
    std::span<const std::byte> cells;
    std::uint64_t missing = 0; ///< records that the header promises and the file does not hold
    std::uint64_t end = 0;     ///< byte behind the last one that is there
};

void keepRecord(OwnRecords& own, const Source& source, std::uint64_t at, std::span<const std::byte> content) {
    std::array<char, 17> user{};
    std::memcpy(user.data(), source.bytes.data() + at + las::kRecordUser, 16);
    if (std::strcmp(user.data(), las::kOurUser) != 0) return;
    const auto id = valueAt<std::uint16_t>(source, at + las::kRecordId);
    if (id == las::kDescriptionId) own.description.assign(reinterpret_cast<const char*>(content.data()), content.size());
    if (id == las::kCellsId) own.cells = content;
    if (id == las::kProvenanceId) own.provenance.assign(reinterpret_cast<const char*>(content.data()), content.size());
}

/// Records after the points (LAS 1.4). A damaged one ends the search: the points are there all the same, and a warning counts the missing.
OwnRecords ownRecords(const LasHeader& header, const Source& source) {
    OwnRecords own;
    own.missing = header.extended;
    std::uint64_t at = header.extendedAt;
    for (std::uint64_t n = 0; n < header.extended; ++n) {
        if (at > source.bytes.size() || source.bytes.size() - at < las::kExtendedHeader) break;
        const auto length = valueAt<std::uint64_t>(source, at + las::kRecordLength);
        const std::uint64_t from = at + las::kExtendedHeader;
        if (length > source.bytes.size() - from) break;
        keepRecord(own, source, at, source.bytes.subspan(from, length));
        --own.missing;
        at = own.end = from + length;
    }
    return own;
}

Result<LasPoints> readPoints(const LasHeader& header, const Source& source) {
    LasPoints read;
    read.points.reserve(header.points);
    read.intensity.reserve(header.points);
    read.returnNumber.reserve(header.points);
    for (std::uint64_t n = 0; n < header.points; ++n) {
        const std::uint64_t at = header.pointsAt + n * header.pointBytes;
        const Eigen::Vector3d whole(valueAt<std::int32_t>(source, at), valueAt<std::int32_t>(source, at + 4),
                                    valueAt<std::int32_t>(source, at + 8));
        const unsigned flags = valueAt<std::uint8_t>(source, at + las::kFlags);
        const bool isWithheld =
            header.format >= 6 ? (flags & las::kWithheldFlag) != 0 : header.minor > 0 && (flags & las::kWithheldClass) != 0;
        read.withheld += isWithheld ? 1 : 0;
        read.points.push_back(isWithheld ? Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())
                                         : Eigen::Vector3d(whole.cwiseProduct(header.scale) + header.offset));
        read.intensity.push_back(valueAt<std::uint16_t>(source, at + las::kIntensity));
        const unsigned returns = valueAt<std::uint8_t>(source, at + las::kReturn);
        read.returnNumber.push_back(static_cast<std::uint8_t>(returns & (header.format >= 6 ? las::kLongReturn : las::kLegacyReturn)));
        if (n % 65536 == 0 && !source.goOn("reading points", 0.5 * static_cast<double>(n) / static_cast<double>(header.points)))
            return source.cancelled();
    }
    read.end = header.pointsAt + header.points * header.pointBytes; // checkPoints: the file holds as much
    return read;
}

/// What the file does not hold of what its header promises behind the points, which end at `end`, or holds beyond it.
void sayRest(PointTable& table, const LasHeader& header, std::uint64_t end, const OwnRecords& own, const Source& source) {
    if (own.missing > 0) {
        table.remarks.push_back(withValues("The end of the file is damaged or missing: %1 of %2 records behind the points cannot be read. "
                                           "A grid, cell states or a place in the mine that they held are lost; copy the file again.",
                                           {own.missing, header.extended}));
    }
    const std::uint64_t size = source.bytes.size();
    std::uint64_t next = size;
    if (header.extended > 0) next = std::min(next, header.extendedAt);
    if (header.waveformAt > 0) next = std::min(next, header.waveformAt);
    const auto say = [&](std::uint64_t from, std::uint64_t to, const std::string& what) {
        if (auto behind = from < to ? bytesBehind(source.bytes.subspan(from, to - from), what) : std::nullopt)
            table.remarks.push_back(std::move(*behind));
    };
    say(end, next, withValues("the %1 that the header promises", {counted(header.points, "point")}));
    if (header.extended > 0 && own.missing == 0 && header.waveformAt == 0) say(std::max(own.end, end), size, "the last record");
    if (header.waveformAt > 0) table.remarks.emplace_back("The waveforms of this file were not read.");
}

/// Lines, beams and ranges of the points, where extra bytes hold them; of a file of ours with all cells the points as they were before they
/// were placed in the mine. Each record is `stride` bytes long and begins `from` bytes into its point.
void readColumns(PointTable& table, const LasHeader& header, std::span<const std::byte> records, std::size_t stride, std::size_t from,
                 bool withCells, const Source& source) {
    if (header.format >= las::kFormatBytes.size()) return;
    const std::vector<RecordField> fields = las::extraFields(source.bytes, header.headerBytes, header.records, header.pointsAt,
                                                             las::kFormatBytes[header.format], header.pointBytes);
    std::vector<std::string> names;
    for (const RecordField& field : fields) names.push_back(field.name);
    const NamedColumns named = columnsNamed(names);
    if (!(withCells ? named.hasScannerPoint() : named.hasCell()) || records.size() < table.points.size() * stride) return;
    const auto value = [&](ColumnRole role, std::size_t n) {
        const RecordField& field = fields[*named[role]];
        return readScalar(field.scalar, records.data() + n * stride + (field.offset - from), false);
    };
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (withCells) {
            table.scannerPoints.emplace_back(value(ColumnRole::ScannerX, n), value(ColumnRole::ScannerY, n),
                                             value(ColumnRole::ScannerZ, n));
            continue;
        }
        table.line.push_back(indexOf(value(ColumnRole::Line, n)));
        table.beam.push_back(indexOf(value(ColumnRole::Beam, n)));
        if (named[ColumnRole::RangeMm]) table.rangeMm.push_back(static_cast<float>(value(ColumnRole::RangeMm, n)));
    }
}

/// Spreads the valid points over the cells that were saved with them.
Result<Done> spreadOverCells(PointTable& table, const OwnRecords& own, const Source& source) {
    const std::size_t cells = own.cells.size() / las::kCellBytes;
    const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    std::vector<Eigen::Vector3d> points(cells, none), scannerPoints(table.scannerPoints.empty() ? 0 : cells, none);
    std::vector<float> intensities(table.intensity.empty() ? 0 : cells, std::numeric_limits<float>::quiet_NaN());
    std::size_t next = 0;
    for (std::size_t k = 0; k < cells; ++k) {
        const std::byte* at = own.cells.data() + k * las::kCellBytes;
        float range = 0;
        std::memcpy(&range, at + 1, sizeof range);
        table.state.push_back(std::to_integer<std::uint8_t>(at[0]));
        table.rangeMm.push_back(range);
        if (table.state.back() != static_cast<std::uint8_t>(CellState::Valid)) continue;
        if (next < table.points.size()) {
            points[k] = table.points[next];
            if (!scannerPoints.empty()) scannerPoints[k] = table.scannerPoints[next];
            if (!intensities.empty()) intensities[k] = table.intensity[next];
        }
        ++next;
    }
    if (next != table.points.size()) {
        return source.refused(withValues("describes a scan of %1 valid cells and holds %2", {next, counted(table.points.size(), "point")}),
                              "save the scan again");
    }
    table.points = std::move(points);
    table.scannerPoints = std::move(scannerPoints);
    table.intensity = std::move(intensities);
    table.description = own.description;
    return Done{};
}

/// What the coordinate system of the file says of its numbers. Error: they are degrees.
Result<Done> readUnits(PointTable& table, const LasHeader& header, const Source& source) {
    const las::StatedUnits stated =
        las::statedUnits(source.bytes, {header.headerBytes, header.records, header.pointsAt, header.extendedAt, header.extended});
    if (source.options->unitMm) { // goes before the file
        table.unitMm = stated.mm;
        return Done{};
    }
    if (stated.degrees)
        return source.refused(
            "x and y of this file are degrees of longitude and latitude, as its coordinate system says, and points need metres",
            "export it in a projected coordinate system such as UTM");
    if (!stated.mm) {
        const bool named = !stated.name.empty() && stated.name != "EPSG:0" && stated.name != "EPSG:32767";
        if (named)
            table.remarks.push_back(withValues(
                "The coordinate system of the file is %1, without its unit: metres were taken. --unit says another one.", {stated.name}));
        return Done{};
    }
    table.unitMm = stated.mm;
    if (*stated.mm != 1000.0)
        table.remarks.push_back(withValues("The coordinate system of the file gives lengths in %1 of %2 mm: they were converted.",
                                           {stated.name, significantText(*stated.mm, 10)}));
    if (!stated.heightMm || *stated.heightMm == *stated.mm) return Done{};
    for (Eigen::Vector3d& p : table.points) p.z() *= *stated.heightMm / *stated.mm;
    table.remarks.push_back(withValues("Heights of the file have another unit than x and y, %1 mm: they were converted.",
                                       {significantText(*stated.heightMm, 10)}));
    return Done{};
}

bool looksLikeLas(const Source& source) { return source.text().starts_with("LASF"); }

std::string lasRecord(std::string_view bytes) {
    const Source source{{}, std::as_bytes(std::span(bytes.data(), bytes.size())), nullptr};
    const auto header = readLasHeader(source);
    return header ? ownRecords(*header, source).provenance : std::string();
}

/// The points and what our own records say of them.
Result<PointTable> readLasPoints(const Source& source) {
    auto header = readLasHeader(source);
    if (!header) return header.error();
    PointTable table;
    table.format = "LAS";
    table.unitMm = 1000.0;
    table.precision = {0.5 * header->scale.cwiseAbs().maxCoeff(), 1e-15};
    const bool packed = (header->format & 0xC0U) != 0; // LAZ marks its point format so
    if (packed) table.format = "LAZ";
    header->format &= 0x3FU;
    if (!packed) {
        if (auto fits = checkPoints(*header, source); !fits) return fits.error();
    }
    auto read = packed ? readLazPoints(source) : readPoints(*header, source);
    if (!read) return read.error();
    table.points = std::move(read->points);
    if (read->withheld > 0)
        table.remarks.push_back(counted(read->withheld, "point is marked as withheld in the file and counts as no return.",
                                        "points are marked as withheld in the file and count as no return."));
    // Who has no intensities leaves the field 0.
    if (std::ranges::any_of(read->intensity, [](float value) { return value != 0; })) table.intensity = std::move(read->intensity);
    if (std::ranges::any_of(read->returnNumber, [](std::uint8_t number) { return number > 1; }))
        table.returnNumber = std::move(read->returnNumber);
    const OwnRecords own = ownRecords(*header, source);
    if (own.description.empty()) {
        if (auto known = readUnits(table, *header, source); !known) return known.error();
    }
    sayRest(table, *header, read->end, own, source);
    const bool withCells = !own.description.empty() && !own.cells.empty();
    const std::size_t extra = read->extra.size() / table.points.size(); // bytes of a point
    if (!packed)
        readColumns(table, *header, source.bytes.subspan(header->pointsAt), header->pointBytes, 0, withCells, source);
    else if (extra < header->pointBytes)
        readColumns(table, *header, read->extra, extra, header->pointBytes - extra, withCells, source);
    if (withCells) {
        if (auto enough = checkMemory(productOf({own.cells.size(), 8}), source.path.string()); !enough) return enough.error();
        if (auto spread = spreadOverCells(table, own, source); !spread) return spread.error();
    }
    table.width = table.points.size();
    return table;
}

} // namespace

Format lasFormat() {
    return {.title = "LAS point cloud",
            .reads = {".las", ".laz"},
            .writes = {".las"},
            .recognises = looksLikeLas,
            .read = readingOf<readLasPoints>,
            .write = lasBytes,
            .record = lasRecord,
            .stepM = 0.001,
            .keepsIntensity = true};
}

} // namespace edgescan::files
