// What an E57 file says of itself: its scans, the columns of their points and their places (ASTM E2807; the XML part).
#pragma once

#include "core/containers/e57/paged_bytes.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace edgescan::containers {

/// One column of a scan's points and how its numbers are stored.
struct E57Field {
    enum class Kind : std::uint8_t { Integer, ScaledInteger, Single, Double, Other }; ///< Other: text and what is not known

    std::string name; ///< "cartesianX"; of an extension "nor:normalX"
    Kind kind = Kind::Double;
    std::int64_t minimum = 0, maximum = 0; ///< of the whole numbers; minimum <= maximum
    double scale = 1.0, offset = 0.0;      ///< ScaledInteger: value = whole number * scale + offset

    /// Of one number; 0: all are `minimum` and none is stored.
    [[nodiscard]] unsigned bits() const;
    /// Largest rounding error of the numbers: absolute, and relative to the number.
    [[nodiscard]] double absoluteError() const { return kind == Kind::ScaledInteger ? 0.5 * std::abs(scale) : 0.0; }
    [[nodiscard]] double relativeError() const { return kind == Kind::Single ? 0x1p-24 : 0x1p-53; }
};

/// p_file = rotation p + translationM.
struct E57Pose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translationM = Eigen::Vector3d::Zero();
};

struct E57IndexBounds {
    std::int64_t firstRow = 0, lastRow = 0, firstColumn = 0, lastColumn = 0;
};

struct E57Scan {
    std::string name, description, vendor, model, serial, firmware; ///< empty where the file does not say
    std::uint64_t points = 0;
    std::uint64_t sectionAt = 0; ///< byte of the file where its points begin
    std::vector<E57Field> fields;
    std::optional<E57Pose> pose;
    bool poseIsNone = false; ///< there is a pose and its numbers do not make one
    std::optional<E57IndexBounds> bounds;
    std::string lineIndex; ///< "rowIndex" or "columnIndex": what counts the scan lines; empty where the file does not say

    /// The column of this name; empty when there is none, or it holds no numbers.
    [[nodiscard]] std::optional<std::size_t> field(std::string_view wanted) const;
};

struct E57File {
    PagedBytes pages;
    std::vector<E57Scan> scans;
    std::size_t pictures = 0;
    std::span<const std::byte> rest; ///< what follows the bytes that the header promises
};

inline constexpr std::string_view kE57Magic = "ASTM-E57";

/// Reads header and XML part; the points are left where they are. Error: cut off, damaged, of another version, no sense in it.
Result<E57File> openE57(std::span<const std::byte> bytes, const std::string& where);

} // namespace edgescan::containers
