// What a reader makes of a file's content.
#pragma once

#include "core/files/point_tables/point_table.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace edgescan::files {

/// The scanner's place by the file's own header: p_file = turn p + place, in the numbers of the file.
struct WrittenPlace {
    const char* format = ""; ///< the name of the format in sentences
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    bool fewDigits = false; ///< `turn` was printed with few digits, and may not be a rotation at all
};

/// A scan whose grid the file gives, or points whose grid is still to be found; and what else the file states of the scan.
struct Reading {
    Reading(Scan scan) : content(std::move(scan)) {}
    Reading(PointTable table) : content(std::move(table)) {}

    std::variant<Scan, PointTable> content;
    std::optional<WrittenPlace> place;              ///< of points in the scanner's own frame
    std::shared_ptr<const Acquisition> acquisition; ///< null = not stated
    std::string note;
    std::vector<std::string> warnings; ///< follow those of the grid
};

/// The points of a reading where its file puts them; empty for a scan.
[[nodiscard]] std::vector<Eigen::Vector3d> pointsAsWritten(Reading reading);

/// A function that reads a Scan or a PointTable, as Format::read.
template <auto read>
Result<Reading> readingOf(const Source& source) {
    auto content = read(source);
    if (!content) return content.error();
    return Reading(std::move(*content));
}

} // namespace edgescan::files
