// Any bytes as a pose or a calibration file: the result is usable numbers or an error sentence.
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/place_scan.h"
#include "tests/support/robot_files.h"

#include <cstdint>
#include <cstdlib>

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    if (const auto calibration = parseCalibration(text, "fuzz")) {
        const auto again = parseCalibration(test::calibrationText(*calibration), "fuzz");
        if (!again || !(*again == *calibration)) std::abort();
    }
    const auto poses = parsePoses(text, "fuzz");
    if (!poses) {
        if (!poses.error().sentence().ends_with(".")) std::abort();
        return 0;
    }
    Scan scan; // a cloud without angles fits every mounting
    scan.rangeMm = Grid<float>(3, 2, 1000.0F);
    scan.state = Grid<CellState>(3, 2, CellState::Valid);
    scan.geometry = PointGeometry{Grid<Eigen::Vector3d>(3, 2, Eigen::Vector3d(1, 2, 3)), Eigen::Vector3d::Zero()};
    Calibration robot;
    robot.robot = poses->robot;
    const auto placed = placeScan(scan, robot, *poses);
    if (!placed) return 0;
    for (const RigidTransform& pose : (*placed)->poses) {
        if (!pose.rotation.allFinite() || !pose.translationM.allFinite()) std::abort();
    }
    return 0;
}
