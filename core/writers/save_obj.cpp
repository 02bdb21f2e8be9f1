// OBJ vertices; edges also as lines along the edge map would hide the points in many viewers, so they are points only.
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/writers/column_rows.h"
#include "core/writers/save_formats.h"

namespace edgescan {

Result<std::string> objBytes(const CloudColumns& cloud, const std::string& where) {
    if (auto enough = checkMemory(std::uint64_t{rowsOf(cloud)} * 40, where); !enough) return enough.error();
    std::string text = "# " + frameText(cloud) + "\n";
    for (const std::string& line : commentLines(cloud.record, kRecordMark)) text += "# " + line + "\n";
    const CloudColumn* edge = columnNamed(cloud, "edge");
    const CloudColumn* state = columnNamed(cloud, "state");
    const int decimals = cloud.frame == CoordinateFrame::Mine ? 4 : 6;
    for (std::size_t row = 0; row < rowsOf(cloud); ++row) {
        if (state != nullptr && numberIn(*state, row) != 0) continue; // no point there
        text += 'v';
        const Eigen::Vector3d point = pointIn(cloud, row);
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            appendFixed(text, point[axis], decimals);
        }
        // Vertex colours are the common extension: edges green as on the screen.
        if (edge != nullptr) text += numberIn(*edge, row) != 0 ? " 0 1 0" : " 0.5 0.5 0.5";
        text += '\n';
    }
    return text;
}

} // namespace edgescan
