// Points of cells in the frame of an export.
#pragma once

#include "core/files/point_tables/cloud_columns.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

#include <cstdint>
#include <optional>
#include <string>

namespace edgescan::exports {

/// Frames other than Scanner need a scan with a placement. The scan must outlive it.
class FramePoints {
public:
    FramePoints(const Scan& scan, CoordinateFrame frame) : scan_(scan), tables_(scan), frame_(frame) {
        if (frame == CoordinateFrame::Scanner) return;
        placed_.emplace(scan);
        cloud_.frame = frame;
        cloud_.originM = placed_->originEnhM();
    }
    [[nodiscard]] Eigen::Vector3d at(std::uint32_t k) const { return at(k, tables_.point(k)); }
    /// A point of the scanner's frame that belongs to the line and beam of cell k.
    [[nodiscard]] Eigen::Vector3d at(std::uint32_t k, const Eigen::Vector3d& point) const {
        if (!placed_) return point;
        const auto beams = static_cast<std::uint32_t>(scan_.beams());
        return placed_->inFrame(frame_, static_cast<int>(k / beams), static_cast<int>(k % beams), point);
    }
    /// One line that describes the frame of the numbers.
    [[nodiscard]] std::string text() const { return files::frameText(cloud_); }
    [[nodiscard]] int decimals() const { return frame_ == CoordinateFrame::Mine ? 4 : 6; }

private:
    const Scan& scan_;
    CartesianTables tables_;
    CoordinateFrame frame_;
    std::optional<PlacedPoints> placed_;
    files::CloudColumns cloud_; // without points
};

} // namespace edgescan::exports
