// The points of a reading in the frame of its file.
#include "core/files/formats/reading.h"

namespace edgescan::files {

std::vector<Eigen::Vector3d> pointsAsWritten(Reading reading) {
    auto* table = std::get_if<PointTable>(&reading.content);
    if (table == nullptr) return {};
    if (reading.place) {
        std::erase_if(table->points, [](const Eigen::Vector3d& p) { return p.isZero(0.0); }); // no return
        for (Eigen::Vector3d& p : table->points) p = reading.place->turn * p + reading.place->place;
    }
    return std::move(table->points);
}

} // namespace edgescan::files
