// PTX: the whole grid about its sensor, column by column; 0 0 0 where a cell has no point to save.
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/writers/column_rows.h"
#include "core/writers/save_formats.h"

namespace edgescan {
namespace {

constexpr std::size_t kNoRow = ~std::size_t{0};

/// The row of each cell of the grid.
std::vector<std::size_t> rowOfCell(const CloudColumns& cloud) {
    std::vector<std::size_t> rows(cloud.lines * cloud.beams, kNoRow);
    const CloudColumn* line = columnNamed(cloud, "line");
    const CloudColumn* beam = columnNamed(cloud, "beam");
    const CloudColumn* state = columnNamed(cloud, "state");
    if (line == nullptr || beam == nullptr) return rows;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (state != nullptr && numberIn(*state, row) != 0) continue;
        rows[static_cast<std::size_t>(numberIn(*line, row)) * cloud.beams + static_cast<std::size_t>(numberIn(*beam, row))] = row;
    }
    return rows;
}

void appendThree(std::string& text, const Eigen::Vector3d& v, int decimals) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendFixed(text, v[axis], decimals);
    }
}

} // namespace

Result<std::string> ptxBytes(const CloudColumns& cloud, const std::string& where) {
    if (auto enough = checkMemory(std::uint64_t{cloud.lines * cloud.beams} * 48, where); !enough) return enough.error();
    if (const CloudColumn* attached = columnNamed(cloud, "attached"); attached != nullptr)
        return Error{"PTX holds one point per cell, and points behind the nearest of their cell were asked for", where,
                     "use .pcd, .ply, .csv, .xyz, .las or .obj for them"};
    std::string text = std::to_string(cloud.lines) + "\n" + std::to_string(cloud.beams) + "\n";
    appendThree(text, cloud.sensorM, 6);
    text += "\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
    appendThree(text, cloud.sensorM, 6);
    text += " 1\n";
    const CloudColumn* edge = columnNamed(cloud, "edge");
    for (const std::size_t row : rowOfCell(cloud)) {
        if (row == kNoRow) {
            text += "0 0 0 0.5\n";
            continue;
        }
        appendThree(text, pointIn(cloud, row) - cloud.sensorM, 6);
        text += edge != nullptr && numberIn(*edge, row) != 0 ? " 1\n" : " 0.5\n"; // intensity: edges stand out
    }
    return text;
}

} // namespace edgescan
