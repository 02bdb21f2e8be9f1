// A cloud as named columns, ready for any writer.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/files/point_tables/writing_choices.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace edgescan::edges {
enum class DepthEdge : std::uint8_t;
} // namespace edgescan::edges

namespace edgescan::files {

struct CloudColumn {
    std::string name; ///< "x", "range_mm" ...
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::uint32_t>, std::vector<std::uint8_t>> values;
};

/// One value per cell of a scan, lines x beams.
using CellValues = std::variant<Grid<float>, Grid<std::uint32_t>, Grid<std::uint8_t>>;
struct CellColumn {
    const char* name; ///< of the field
    CellValues values;
};

struct CloudColumns {
    std::size_t width = 0;  ///< points per row
    std::size_t height = 1; ///< more than 1: organised, every cell is there
    std::size_t lines = 0;  ///< of the scan that the cells are of
    std::size_t beams = 0;
    std::vector<CloudColumn> columns;
    std::string description; ///< JSON for the comment lines; empty = none
    std::string record;      ///< provenance as JSON for the comment lines; empty = none
    CoordinateFrame frame = CoordinateFrame::Scanner;
    Eigen::Vector3d originM = Eigen::Vector3d::Zero();  ///< of local metres in mine coordinates; zero in the scanner's frame
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero();  ///< in the same numbers as x y z
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< scanner's axes -> those of x y z
    std::string grid;                                   ///< name of the mine grid as the pose gives it; may be empty
    std::vector<double> lineTimesS;                     ///< per line, seconds since 1970 UTC; empty where not known
    std::optional<double> startS;                       ///< of the scan, by startOfScan()
    WritingChoices choices;
    /// Where it is set, the columns have names and types only: it makes those of lines first <= line < last, from any thread. All writers
    /// but those of everyCellByLines() need makeAll() first.
    std::function<void(std::size_t first, std::size_t last, std::vector<CloudColumn>& columns)> linesLater = {};
};

/// The columns of all lines, where they were to be made later.
void makeAll(CloudColumns& cloud);

/// All cells, lines x beams: x y z (metres, NaN where not valid), line, beam, range_mm, intensity where the scan has it, state, and the
/// description. A frame other than Scanner needs the scan's placement; points that were read are then in scanner_x scanner_y scanner_z as
/// well.
[[nodiscard]] CloudColumns everyCell(const Scan& scan, CoordinateFrame frame = CoordinateFrame::Scanner);

/// The same, where possible with columns that are made as they are written (linesLater). The scan must outlive it.
[[nodiscard]] CloudColumns everyCellByLines(const Scan& scan, CoordinateFrame frame = CoordinateFrame::Scanner);

/// Valid cells: x y z, line, beam, range_mm, intensity as above, edge, those given, class where `classes` is given, and red green blue.
/// `edgeMask` may be null. With `withAttached` the points that are attached to these cells follow, marked in a column "attached".
[[nodiscard]] CloudColumns validPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask,
                                       CoordinateFrame frame = CoordinateFrame::Scanner, bool withAttached = false,
                                       const Grid<edges::DepthEdge>* classes = nullptr, std::span<const CellColumn> given = {});

/// Valid cells whose mask is not 0: x y z, line, beam, range_mm, intensity, those given, class and colours as above; and what is attached
/// to them.
[[nodiscard]] CloudColumns edgePoints(const Scan& scan, const Grid<std::uint8_t>& edgeMask,
                                      CoordinateFrame frame = CoordinateFrame::Scanner, bool withAttached = false,
                                      const Grid<edges::DepthEdge>* classes = nullptr, std::span<const CellColumn> given = {});

/// x y z alone of what edgePoints() has, or validPoints() where `edgeMask` is null.
[[nodiscard]] CloudColumns placesOfPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask, CoordinateFrame frame, bool withAttached);

/// Takes the columns out that the condition names.
void dropColumns(CloudColumns& cloud, bool (*dropped)(std::string_view name));
[[nodiscard]] inline bool isColour(std::string_view name) { return name == "red" || name == "green" || name == "blue"; }

/// What a header says of frame, unit, axis order and origin: one line of ASCII.
[[nodiscard]] std::string frameText(const CloudColumns& cloud);

/// JSON cut into lines short enough for every reader, each behind `mark`: "edgescan {...".
[[nodiscard]] std::vector<std::string> commentLines(const std::string& json, const std::string& mark = "edgescan ");

/// The mark before provenance in comment lines.
inline constexpr const char* kRecordMark = "edgescan-record ";

/// The provenance in the comment lines of a file; empty when there is none.
[[nodiscard]] std::string recordInComments(std::string_view bytes);

} // namespace edgescan::files
