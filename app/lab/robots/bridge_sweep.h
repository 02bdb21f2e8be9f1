// A scan as a robot with ROS 2 sends it: topics with their definitions, and messages in CDR.
#pragma once

#include "core/base/result.h"
#include "core/robots/bridge/protocol.h"
#include "core/scan/grid/scan.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// What is sent for one line, its time still open.
struct BridgeLine {
    double lineDeg = 0;
    std::vector<float> rangesM; ///< infinite where nothing came back
};

/// An organised cloud: a point for each cell.
struct BridgeCloud {
    std::uint32_t lines = 0, beams = 0;
    std::vector<float> xyzM; ///< three for each cell, NaN where nothing came back
};

struct BridgeSweep {
    Axis axis = Axis::Spin;
    double firstBeamDeg = 0, beamStepDeg = 1;
    std::vector<BridgeLine> lines;
    std::optional<BridgeCloud> cloud; ///< is sent instead of lines

    /// Until it begins again.
    [[nodiscard]] std::size_t messages() const { return cloud ? 1 : lines.size(); }
};

/// Error: the scan has no angles, or its beams are not evenly spaced.
Result<BridgeSweep> bridgeSweepOf(const Scan& scan);
/// The whole scan in each message.
[[nodiscard]] BridgeSweep bridgeCloudOf(const Scan& scan);

/// Measured: lines or clouds.
enum class BridgeTopic : std::uint8_t { Measured, Transforms, Fixed, Other };
/// "/scan" or "/points", "/tf", "/tf_static" and "/rosout", with their numbers as channels.
[[nodiscard]] std::vector<BridgeChannel> bridgeTopics(const BridgeSweep& sweep);

[[nodiscard]] Bytes cloudMessage(const BridgeCloud& cloud, std::int64_t ns);
[[nodiscard]] Bytes lineMessage(const BridgeSweep& sweep, const BridgeLine& line, std::int64_t ns, double periodS);
/// The frame "head" in "mast", turned about the sweep's axis.
[[nodiscard]] Bytes transformMessage(const BridgeSweep& sweep, double deg, std::int64_t ns);
/// The frame "laser" in "head".
[[nodiscard]] Bytes fixedMessage(std::int64_t ns);

} // namespace edgescan::robots
