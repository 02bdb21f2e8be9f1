// A cloud as named columns, ready for any writer.
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/scan/scan.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace edgescan {

struct CloudColumn {
    std::string name; ///< "x", "range_mm" ...
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::uint32_t>, std::vector<std::uint8_t>> values;
};

struct CloudColumns {
    std::size_t width = 0;  ///< points per row
    std::size_t height = 1; ///< more than 1: organised, every cell is there
    std::vector<CloudColumn> columns;
    std::string description; ///< JSON for the comment lines; empty = none
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero();
};

/// All cells, lines x beams: x y z (metres, NaN where not valid), range_mm, line, beam, state, and the description.
[[nodiscard]] CloudColumns everyCell(const Scan& scan);

/// Valid cells: x y z, line, beam, range_mm, edge. `edgeMask` may be null.
[[nodiscard]] CloudColumns validPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask);

/// Valid cells whose mask is not 0: x y z, line, beam, range_mm.
[[nodiscard]] CloudColumns edgePoints(const Scan& scan, const Grid<std::uint8_t>& edgeMask);

Result<Done> savePcd(const CloudColumns& cloud, const std::filesystem::path& path, bool ascii);
Result<Done> savePly(const CloudColumns& cloud, const std::filesystem::path& path, bool ascii);
/// Header line with names, then rows; the separator is ' ' or ','.
Result<Done> savePointText(const CloudColumns& cloud, const std::filesystem::path& path, char separator);

/// The description cut into lines short enough for every reader: "edgescan {...".
[[nodiscard]] std::vector<std::string> commentLines(const std::string& description);

} // namespace edgescan
