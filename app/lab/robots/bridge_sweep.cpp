// CDR messages of an emulated robot.
#include "app/lab/robots/bridge_sweep.h"

#include "core/base/angles.h"
#include "core/robots/bags/bag.h"
#include "core/scan/grid/cartesian.h"

#include <bit>
#include <cmath>
#include <limits>

namespace edgescan::robots {
namespace {

/// Little-endian PLAIN_CDR.
class CdrBytes {
public:
    template <class T>
    CdrBytes& put(T value) {
        while ((bytes_.size() - kHead) % sizeof(T) != 0) bytes_.push_back(0);
        using Whole = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::conditional_t<sizeof(T) == 1, std::uint8_t, std::uint32_t>>;
        static_assert(sizeof(T) == sizeof(Whole));
        const auto whole = std::bit_cast<Whole>(value);
        for (std::size_t n = 0; n < sizeof(T); ++n) bytes_.push_back(static_cast<std::uint8_t>(std::uint64_t{whole} >> (8 * n)));
        return *this;
    }
    CdrBytes& text(std::string_view text) {
        put(static_cast<std::uint32_t>(text.size() + 1));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        bytes_.push_back(0);
        return *this;
    }
    CdrBytes& header(std::int64_t ns, std::string_view frame) {
        constexpr std::int64_t kSecond = 1'000'000'000;
        return put(static_cast<std::int32_t>(ns / kSecond)).put(static_cast<std::uint32_t>(ns % kSecond)).text(frame);
    }
    [[nodiscard]] Bytes popBytes() { return std::move(bytes_); }

private:
    static constexpr std::size_t kHead = 4;
    Bytes bytes_{0, 1, 0, 0};
};

Bytes transform(std::int64_t ns, std::string_view parent, std::string_view child, double x, double y, double w) {
    CdrBytes bytes;
    bytes.put(std::uint32_t{1}).header(ns, parent).text(child).put(0.0).put(0.0).put(0.0);
    return bytes.put(x).put(y).put(0.0).put(w).popBytes();
}

} // namespace

Result<BridgeSweep> bridgeSweepOf(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->beamDeg.size() < 2)
        return Error{"a scan without angles cannot be sent as lines of a laser", scan.path, "choose a scan with line and beam angles"};
    BridgeSweep sweep;
    sweep.axis = polar->axis;
    sweep.firstBeamDeg = polar->beamDeg.front();
    const auto beams = polar->beamDeg.size();
    sweep.beamStepDeg = (polar->beamDeg.back() - polar->beamDeg.front()) / static_cast<double>(beams - 1);
    for (std::size_t j = 0; j < beams; ++j) {
        if (std::abs(polar->beamDeg[j] - sweep.firstBeamDeg - static_cast<double>(j) * sweep.beamStepDeg) > 1e-3)
            return Error{"its beams are not evenly spaced, and a laser's message has one step", scan.path, "choose another scan"};
    }
    for (int i = 0; i < scan.lines(); ++i) {
        BridgeLine line{polar->lineDeg[static_cast<std::size_t>(i)] * polar->lineDirection, {}};
        for (int j = 0; j < scan.beams(); ++j) {
            const bool valid = scan.state.at(i, j) == CellState::Valid;
            line.rangesM.push_back(valid ? static_cast<float>(static_cast<double>(scan.rangeMm.at(i, j)) / 1000)
                                         : std::numeric_limits<float>::infinity());
        }
        sweep.lines.push_back(std::move(line));
    }
    return sweep;
}

BridgeSweep bridgeCloudOf(const Scan& scan) {
    BridgeCloud cloud{static_cast<std::uint32_t>(scan.lines()), static_cast<std::uint32_t>(scan.beams()), {}};
    const CartesianTables points(scan);
    cloud.xyzM.reserve(3 * scan.cells());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3f point = points.point(k).cast<float>();
        cloud.xyzM.insert(cloud.xyzM.end(), point.begin(), point.end());
    }
    BridgeSweep sweep;
    sweep.cloud = std::move(cloud);
    return sweep;
}

std::vector<BridgeChannel> bridgeTopics(const BridgeSweep& sweep) {
    const auto channel = [](BridgeTopic topic, const char* name, const char* package, const char* type) {
        const std::string definition(commonRosDefinition(std::string(package) + "/" + type));
        return BridgeChannel{static_cast<std::uint32_t>(topic), name, "cdr", std::string(package) + "/msg/" + type, definition, "ros2msg"};
    };
    std::vector<BridgeChannel> topics{sweep.cloud ? channel(BridgeTopic::Measured, "/points", "sensor_msgs", "PointCloud2")
                                                  : channel(BridgeTopic::Measured, "/scan", "sensor_msgs", "LaserScan"),
                                      channel(BridgeTopic::Transforms, "/tf", "tf2_msgs", "TFMessage"),
                                      channel(BridgeTopic::Fixed, "/tf_static", "tf2_msgs", "TFMessage"),
                                      channel(BridgeTopic::Other, "/rosout", "rcl_interfaces", "Log")};
    topics.back().definition = "string msg\n";
    return topics;
}

Bytes cloudMessage(const BridgeCloud& cloud, std::int64_t ns) {
    constexpr std::uint32_t kFloat = sizeof(float), kPoint = 3 * kFloat;
    constexpr std::uint8_t kFloat32 = 7; // PointField.datatype
    CdrBytes bytes;
    bytes.header(ns, "laser").put(cloud.lines).put(cloud.beams).put(std::uint32_t{3});
    std::uint32_t offset = 0;
    for (const char* name : {"x", "y", "z"}) {
        bytes.text(name).put(offset).put(kFloat32).put(std::uint32_t{1});
        offset += kFloat;
    }
    bytes.put(std::uint8_t{0}).put(kPoint).put(kPoint * cloud.beams).put(static_cast<std::uint32_t>(kFloat * cloud.xyzM.size()));
    for (const float number : cloud.xyzM) bytes.put(number);
    return bytes.put(std::uint8_t{0}).popBytes();
}

Bytes lineMessage(const BridgeSweep& sweep, const BridgeLine& line, std::int64_t ns, double periodS) {
    const double last = sweep.firstBeamDeg + sweep.beamStepDeg * (static_cast<double>(line.rangesM.size()) - 1);
    CdrBytes bytes;
    bytes.header(ns, "laser").put(static_cast<float>(radians(sweep.firstBeamDeg))).put(static_cast<float>(radians(last)));
    bytes.put(static_cast<float>(radians(sweep.beamStepDeg))).put(0.0F).put(static_cast<float>(periodS)).put(0.001F).put(1000.0F);
    bytes.put(static_cast<std::uint32_t>(line.rangesM.size()));
    for (const float range : line.rangesM) bytes.put(range);
    return bytes.put(std::uint32_t{0}).popBytes();
}

Bytes transformMessage(const BridgeSweep& sweep, double deg, std::int64_t ns) {
    const double half = radians(deg) / 2;
    const bool spin = sweep.axis == Axis::Spin; // about the beam at 90 degrees, else about that at 0
    return transform(ns, "mast", "head", spin ? 0.0 : std::sin(half), spin ? std::sin(half) : 0.0, std::cos(half));
}

Bytes fixedMessage(std::int64_t ns) { return transform(ns, "head", "laser", 0.0, 0.0, 1.0); }

} // namespace edgescan::robots
