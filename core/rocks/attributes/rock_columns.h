// The columns of the table of rocks: every file, Python, the report and the window read these rows.
#pragma once

#include "core/rocks/attributes/size_curve.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/georef/placed_points.h"

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace edgescan::rocks {

/// A rock, and what its values need besides.
struct RockRow {
    const Rock* rock = nullptr;
    int line = 0, beam = 0;                            ///< of its measured cell closest to its centre
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< in the frame of the table
    double finerShare = 0.0;                           ///< 0..1: share of the rocks that are not wider than it
    std::string names{};                               ///< of the named cells on it, separated by "; "
    bool upAssumed = true;                             ///< as in UpDirection
};

/// Nothing, a truth, a whole number, a number, numbers of rocks, or a text.
using RockValue = std::variant<std::monostate, bool, std::uint32_t, double, std::span<const std::uint32_t>, const char*>;

struct RockColumn {
    const char* key;                         ///< with unit and, for coordinates, frame: "visible_long_m", "easting_m"
    const char* title;                       ///< of the report and the window; null: in files only
    const char* help;                        ///< one sentence without a stop
    RockValue (*value)(const RockRow& row);  ///< rounded as files have it
    std::string (*text)(const RockRow& row); ///< null without a title
    bool inWindow;                           ///< the window shows coordinates on the card of a target
};

/// In the order of every table. The names and titles of the coordinates are those of the frame.
[[nodiscard]] std::span<const RockColumn> rockColumns(CoordinateFrame frame);

/// The value as a number for sorting: the count of a list, -1 for nothing.
[[nodiscard]] double sortingNumber(const RockValue& value);

/// Cells that the operator named.
using NamedCells = std::vector<std::pair<std::uint32_t, std::string>>;

/// The rows of a study. Frames other than Scanner need a scan with a placement. The study must outlive it.
class RockRows {
public:
    RockRows(const Study& study, CoordinateFrame frame, const NamedCells& names = {});
    [[nodiscard]] RockRow of(const Rock& rock) const;
    [[nodiscard]] const SizeCurve& curve() const { return curve_; }
    [[nodiscard]] CoordinateFrame frame() const { return frame_; }

private:
    CoordinateFrame frame_;
    std::uint32_t beams_;
    bool upAssumed_;
    SizeCurve curve_;
    std::optional<PlacedPoints> placed_;
    std::map<std::uint32_t, std::string> names_; // by label
};

} // namespace edgescan::rocks
