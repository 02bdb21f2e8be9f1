// What is said of the coordinates in exported files: their frame, their extent, and which programs need another frame.
#pragma once

#include "core/exports/export_kinds.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Geometry>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::exports {

struct WrittenCoordinates {
    CoordinateFrame frame = CoordinateFrame::Scanner;
    std::optional<Eigen::Vector3d> originEnhM{}; ///< of the scan's place; empty without one
    Eigen::AlignedBox3d box{};                   ///< metres in the frame; empty where no point is there
    bool measurements = false;                   ///< a raw grid or a recording: ranges and angles in place of coordinates
    std::vector<std::string> aboutOrigin{};      ///< extensions of the files that hold 4-byte metres from the origin
    std::vector<std::string> inFloats{};         ///< programs that read the files' coordinates into 4-byte numbers

    /// Of several files of one scan in one frame.
    void add(const WrittenCoordinates& other);
};

/// The frame of the coordinates in a file; empty where it holds none. A file of the mine grid alone is not in the frame of the options.
[[nodiscard]] std::optional<CoordinateFrame> frameOfFile(ExportContent content, const std::filesystem::path& path,
                                                         const ExportOptions& options);

/// Of one export with coordinates. `box`: of its points, in the frame of the file.
[[nodiscard]] WrittenCoordinates coordinatesOf(ExportContent content, const Scan& scan, const std::filesystem::path& path,
                                               const ExportOptions& options, const Eigen::AlignedBox3d& box);

inline constexpr double kLeastStepM = 0.001; ///< the least that is worth a sentence
/// The step from a 4-byte number to the next, of the largest coordinate in the box.
[[nodiscard]] double stepOfFloatsM(const Eigen::AlignedBox3d& box);

/// "Mine grid: E 498753.21 to 498771.90, ...", as sentences.
[[nodiscard]] std::string coordinatesText(const WrittenCoordinates& written);

} // namespace edgescan::exports
