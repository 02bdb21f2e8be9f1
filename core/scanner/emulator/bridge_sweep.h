// A scan as a robot with ROS 2 sends it: topics with their definitions, and messages in CDR.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/foxglove/protocol.h"

#include <string>
#include <vector>

namespace edgescan::scanner {

/// What is sent for one line, its time still open.
struct BridgeLine {
    double lineDeg = 0;
    std::vector<float> rangesM; ///< infinite where nothing came back
};

struct BridgeSweep {
    Axis axis = Axis::Spin;
    double firstBeamDeg = 0, beamStepDeg = 1;
    std::vector<BridgeLine> lines;
};

/// Error: the scan has no angles, or its beams are not evenly spaced.
Result<BridgeSweep> bridgeSweepOf(const Scan& scan);

enum class BridgeTopic : std::uint8_t { Lines, Transforms, Fixed, Other };
/// "/scan", "/tf", "/tf_static" and "/rosout", with their numbers as channels.
[[nodiscard]] std::vector<BridgeChannel> bridgeTopics();

[[nodiscard]] Bytes lineMessage(const BridgeSweep& sweep, const BridgeLine& line, std::int64_t ns, double periodS);
/// The frame "head" in "mast", turned about the sweep's axis.
[[nodiscard]] Bytes transformMessage(const BridgeSweep& sweep, double deg, std::int64_t ns);
/// The frame "laser" in "head".
[[nodiscard]] Bytes fixedMessage(std::int64_t ns);

} // namespace edgescan::scanner
