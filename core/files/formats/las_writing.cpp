// LAS 1.4, point format 7 (colours) or 6, whole millimetres about an offset, a coordinate system that says what the numbers are; other
// columns as extra bytes; a whole scan with its cells behind the points, so that it comes back as it was.
#include "core/files/formats/coordinate_system.h"
#include "core/files/formats/las_layout.h"

#include "core/base/memory.h"
#include "core/base/version.h"
#include "core/files/point_tables/column_rows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace edgescan::files {
namespace {

static_assert(std::endian::native == std::endian::little, "LAS is written as the machine stores numbers");

constexpr double kScale = 0.001;
constexpr std::size_t kExtraBytesRecord = 192;
constexpr std::uint16_t kExtraBytesId = 4; // of user LASF_Spec
constexpr std::uint16_t kWktId = 2112;     // of user LASF_Projection

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}
template <class T>
void append(std::string& bytes, T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    put(bytes, at, value);
}
void putText(std::string& bytes, std::size_t at, std::string_view text, std::size_t length) {
    std::memcpy(bytes.data() + at, text.data(), std::min(text.size(), length));
}

/// Columns behind x y z, as LAS names their types: 1 byte, 4 bytes without sign, 4-byte and 8-byte floats.
struct Extra {
    const CloudColumn* column = nullptr;
    std::uint8_t type = 0;
    std::size_t bytes = 0;
};
std::vector<Extra> extrasOf(const CloudColumns& cloud) {
    std::vector<Extra> extras;
    for (std::size_t i = 3; i < cloud.columns.size(); ++i) {
        if (isColour(cloud.columns[i].name) || cloud.columns[i].name == "intensity") continue;
        static constexpr std::array<std::uint8_t, 4> kTypes{9, 10, 5, 1}; // float, double, unsigned long, unsigned char
        static constexpr std::array<std::size_t, 4> kBytes{4, 8, 4, 1};
        const std::size_t kind = cloud.columns[i].values.index();
        extras.push_back({&cloud.columns[i], kTypes[kind], kBytes[kind]});
    }
    return extras;
}

std::string recordHeader(std::string_view user, std::uint16_t id, std::uint64_t length, std::string_view description, bool extended) {
    std::string bytes(extended ? las::kExtendedHeader : las::kRecordHeader, '\0');
    putText(bytes, las::kRecordUser, user, 16);
    put(bytes, las::kRecordId, id);
    if (extended)
        put(bytes, las::kRecordLength, length);
    else
        put(bytes, las::kRecordLength, static_cast<std::uint16_t>(length));
    putText(bytes, bytes.size() - 32, description, 31);
    return bytes;
}

std::string extraBytesRecord(const std::vector<Extra>& extras) {
    std::string bytes = recordHeader("LASF_Spec", kExtraBytesId, extras.size() * kExtraBytesRecord, "Extra bytes", false);
    for (const Extra& extra : extras) {
        std::string one(kExtraBytesRecord, '\0');
        one[2] = static_cast<char>(extra.type);
        putText(one, 4, extra.column->name, 31);
        bytes += one;
    }
    return bytes;
}

struct Extent {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    Eigen::AlignedBox3d box; ///< of the points as the file holds them: rounded
    std::size_t points = 0;
    [[nodiscard]] Eigen::Vector3d steps(const Eigen::Vector3d& p) const {
        return ((p - offset) / kScale).unaryExpr([](double step) { return std::round(step); });
    }
};

/// Intensities as the 16 bits that LAS has for them: whole numbers that fit as they are, any others from their least to their greatest
/// stretched over 0 .. 65535; 0 where a point has no intensity.
class Intensity16 {
public:
    explicit Intensity16(const CloudColumn* column) {
        const IntensitySpan span = column != nullptr ? intensitySpan(*column) : IntensitySpan{};
        if (span.fits(kMost)) return;
        least_ = span.least;
        perStep_ = span.greatest > span.least ? kMost / (span.greatest - span.least) : 0;
    }
    [[nodiscard]] std::uint16_t operator()(double value) const {
        return std::isfinite(value) ? static_cast<std::uint16_t>(std::lround((value - least_) * perStep_)) : std::uint16_t{0};
    }

private:
    static constexpr double kMost = 65535;
    double least_ = 0, perStep_ = 1;
};

/// The columns that the record itself has room for.
struct Known {
    std::array<const CloudColumn*, 3> colours;
    const CloudColumn* edge;
    const CloudColumn* classes;
    const CloudColumn* intensity;
    Intensity16 as16;
    bool onlyEdges;

    explicit Known(const CloudColumns& cloud)
        : colours{columnNamed(cloud, "red"), columnNamed(cloud, "green"), columnNamed(cloud, "blue")}, edge(columnNamed(cloud, "edge")),
          classes(columnNamed(cloud, "class")), intensity(columnNamed(cloud, "intensity")), as16(intensity),
          onlyEdges(colours[0] != nullptr && edge == nullptr) {}

    [[nodiscard]] std::size_t pointFormat() const { return colours[0] != nullptr ? 7 : 6; }
    /// docs/reference/formats.md, "LAS": 1 not classified; from 64 on the file's own: 64 an edge, 65 to 70 its class.
    [[nodiscard]] std::uint8_t classOf(std::size_t row) const {
        const bool isEdge = onlyEdges || (edge != nullptr && numberIn(*edge, row) != 0);
        if (!isEdge) return 1;
        return static_cast<std::uint8_t>(64 + (classes != nullptr ? numberIn(*classes, row) : 0));
    }
};

/// Offset and bounds of the points that are there. Mine coordinates leave their large part to the offset.
Result<Extent> extentOf(const CloudColumns& cloud, const std::string& where) {
    Extent frame;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        const Eigen::Vector3d p = pointIn(cloud, row);
        if (!p.allFinite()) continue;
        frame.box.extend(p);
        ++frame.points;
    }
    if (frame.points == 0) return Error{"there are no points to save", where, "choose other cells or settings"};
    Eigen::AlignedBox3d rounded;
    if (frame.box.min().cwiseAbs().maxCoeff() > 1e4 || frame.box.max().cwiseAbs().maxCoeff() > 1e4)
        frame.offset = frame.box.min().array().floor();
    if ((frame.box.max() - frame.offset).maxCoeff() / kScale > std::numeric_limits<std::int32_t>::max()) {
        return Error{"LAS holds 2147 km in whole millimetres, and these points lie farther apart", where, "save them as .pcd or .ply"};
    }
    // Readers refuse points outside the bounds, and compare what they compute from the steps.
    for (const Eigen::Vector3d& corner : {frame.box.min(), frame.box.max()}) rounded.extend(frame.steps(corner) * kScale + frame.offset);
    frame.box = rounded;
    return frame;
}

std::string headerBytes(const Extent& frame, std::size_t pointFormat, std::size_t pointBytes, std::size_t records, std::uint64_t pointsAt,
                        std::uint64_t extendedAt, std::uint32_t extended) {
    std::string bytes(las::kHeader14, '\0');
    putText(bytes, 0, "LASF", 4);
    put<std::uint16_t>(bytes, las::kGlobalEncoding, 1U << 4U); // coordinate systems as WKT: asked for by point formats from 6 on
    bytes[las::kVersionMajor] = 1;
    bytes[las::kVersionMinor] = 4;
    putText(bytes, las::kSystem, "EXTRACTION", 32);
    putText(bytes, las::kSoftware, std::string("EdgeScan ") + version(), 32);
    put(bytes, las::kHeaderSize, static_cast<std::uint16_t>(las::kHeader14));
    put(bytes, las::kPointsAt, static_cast<std::uint32_t>(pointsAt));
    put(bytes, las::kRecordCount, static_cast<std::uint32_t>(records));
    bytes[las::kPointFormat] = static_cast<char>(pointFormat);
    put(bytes, las::kPointBytes, static_cast<std::uint16_t>(pointBytes));
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        put(bytes, las::kScale + 8 * a, kScale);
        put(bytes, las::kOffset + 8 * a, frame.offset[axis]);
        put(bytes, las::kMaxMin + 16 * a, frame.box.max()[axis]);
        put(bytes, las::kMaxMin + 16 * a + 8, frame.box.min()[axis]);
    }
    put(bytes, las::kExtendedAt, extended > 0 ? extendedAt : std::uint64_t{0});
    put(bytes, las::kExtendedCount, extended);
    put(bytes, las::kPoints, static_cast<std::uint64_t>(frame.points));
    put(bytes, las::kPointsByReturn, static_cast<std::uint64_t>(frame.points));
    return bytes;
}

void appendPoints(std::string& bytes, const CloudColumns& cloud, const Extent& frame, const Known& known,
                  const std::vector<Extra>& extras) {
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        const Eigen::Vector3d p = pointIn(cloud, row);
        if (!p.allFinite()) continue;
        const Eigen::Vector3d steps = frame.steps(p);
        for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<std::int32_t>(steps[axis]));
        append(bytes, known.intensity != nullptr ? known.as16(numberIn(*known.intensity, row)) : std::uint16_t{0});
        append<std::uint8_t>(bytes, 0x11); // return 1 of 1
        append<std::uint8_t>(bytes, 0);    // flags
        append(bytes, known.classOf(row));
        bytes.append(las::kFormatBytes[6] - 17, '\0'); // user, angle, source, time: not known
        for (const CloudColumn* colour : known.colours) {
            if (colour != nullptr) append(bytes, static_cast<std::uint16_t>(numberIn(*colour, row) * 257.0));
        }
        for (const Extra& extra : extras) {
            std::visit([&](const auto& values) { append(bytes, values[row]); }, extra.column->values);
        }
    }
}

/// A whole scan's description and the state and range of every cell.
std::string cellRecords(const CloudColumns& cloud) {
    const CloudColumn* range = columnNamed(cloud, "range_mm");
    const CloudColumn* state = columnNamed(cloud, "state");
    std::string bytes =
        recordHeader(las::kOurUser, las::kDescriptionId, cloud.description.size(), "grid as JSON", true) + cloud.description;
    bytes += recordHeader(las::kOurUser, las::kCellsId, rowsOf(cloud) * las::kCellBytes, "state and range of every cell", true);
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        append(bytes, static_cast<std::uint8_t>(numberIn(*state, row)));
        append(bytes, static_cast<float>(numberIn(*range, row)));
    }
    return bytes;
}

} // namespace

Result<std::string> lasBytes(CloudColumns cloud, const std::string& where, bool) {
    const std::vector<Extra> extras = extrasOf(cloud);
    const Known known(cloud);
    std::size_t pointBytes = las::kFormatBytes[known.pointFormat()];
    for (const Extra& extra : extras) pointBytes += extra.bytes;
    if (auto enough = checkMemory(std::uint64_t{rowsOf(cloud)} * (pointBytes + las::kCellBytes), where); !enough) return enough.error();
    const auto frame = extentOf(cloud, where);
    if (!frame) return frame.error();
    const bool wholeScan =
        !cloud.description.empty() && columnNamed(cloud, "state") != nullptr && columnNamed(cloud, "range_mm") != nullptr;
    const std::string wkt = coordinateSystemWkt(cloud);
    const std::string records =
        recordHeader("LASF_Projection", kWktId, wkt.size() + 1, "coordinate system", false) + wkt + '\0' + extraBytesRecord(extras);
    const std::uint64_t pointsAt = las::kHeader14 + records.size();
    const std::uint64_t extendedAt = pointsAt + std::uint64_t{frame->points} * pointBytes;
    const std::uint32_t extended = (wholeScan ? 2U : 0U) + (cloud.record.empty() ? 0U : 1U);
    std::string bytes = headerBytes(*frame, known.pointFormat(), pointBytes, 2, pointsAt, extendedAt, extended);
    bytes.reserve(extendedAt);
    bytes += records;
    appendPoints(bytes, cloud, *frame, known, extras);
    if (wholeScan) bytes += cellRecords(cloud);
    if (!cloud.record.empty())
        bytes += recordHeader(las::kOurUser, las::kProvenanceId, cloud.record.size(), "provenance as JSON", true) + cloud.record;
    return bytes;
}

} // namespace edgescan::files
