// Bags that were not written for a test: random names, namespaces, orders of fields, byte orders, containers, sources of angles, jitter,
// gaps, other lasers and other topics, clocks that were set. The scan and its edges are those of the grid that was sent.
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <sstream>

using namespace edgescan;
using namespace edgescan::test;

namespace {

using Field = std::pair<std::string, std::function<void(RosWriter&)>>;

/// Bounded random numbers, the same on every machine.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}
    int upTo(int most) { return static_cast<int>(random_() % static_cast<std::uint32_t>(most + 1)); }
    bool coin() { return upTo(1) == 1; }
    template <class T>
    const T& of(const std::vector<T>& all) {
        return all[static_cast<std::size_t>(upTo(static_cast<int>(all.size()) - 1))];
    }
    template <class T>
    void shuffle(std::vector<T>& all) {
        for (std::size_t n = all.size(); n > 1; --n) std::swap(all[n - 1], all[static_cast<std::size_t>(upTo(static_cast<int>(n) - 1))]);
    }

private:
    std::mt19937 random_;
};

/// One robot: its names, the orders of the fields in its definitions, and what else it records.
struct Robot {
    Wire wire = Wire::Ros1;
    std::string space, laser, mount, mast, joint, topic;
    std::vector<std::string> headerOrder, lineOrder, jointOrder;
    AngleFrom from = AngleFrom::Transform;
    Axis axis = Axis::Sweep;
    bool clockwise = false, intensities = false, idleLaser = false, otherJoints = false, loop = false, stray = false;
    double shiftDeg = 0, stepDeg = 0.5, noReturn = 0;
    std::int64_t setBackNs = 0; ///< of the recorder's clock, in the middle
    std::vector<std::int64_t> jitterNs;
    std::vector<int> left;
    int container = 0; ///< bag of ROS 1 where the wire is; MCAP, or a database with and without definitions

    [[nodiscard]] std::string text() const {
        std::ostringstream text;
        text << "wire " << static_cast<int>(wire) << ", container " << container << ", topic " << topic << ", laser " << laser << ", joint "
             << joint << ", from " << static_cast<int>(from) << ", axis " << static_cast<int>(axis) << ", clockwise " << clockwise
             << ", shift " << shiftDeg << ", step " << stepDeg << ", idle " << idleLaser << ", loop " << loop << ", left " << left.size()
             << ", jitter " << jitterNs.size();
        return text.str();
    }
};

Robot robotOf(Dice& dice) {
    Robot robot;
    robot.wire = dice.of<Wire>({Wire::Ros1, Wire::CdrLittle, Wire::CdrBig, Wire::Cdr2Little, Wire::Cdr2Big});
    robot.space = dice.of<std::string>({"", "robot/", "mine/lhd_07/", "r2/"});
    robot.laser = robot.space + dice.of<std::string>({"laser", "laser_tilt_link", "hokuyo_node/fan", "sick"});
    robot.mount = robot.space + "mount";
    robot.mast = robot.space + dice.of<std::string>({"mast", "base_link", "torso_lift_link"});
    robot.joint = robot.space + dice.of<std::string>({"laser_tilt_mount_joint", "hokuyo_joint", "nod", "scan_axis"});
    robot.topic = "/" + robot.space + dice.of<std::string>({"scan", "tilt_scan", "hokuyo_node/scan", "lidar/front"});
    robot.headerOrder = {"stamp", "frame_id"};
    robot.lineOrder = {"header",    "angle_min", "angle_max", "angle_increment", "time_increment", "scan_time",
                       "range_min", "range_max", "ranges",    "intensities",     "note",           "extra"};
    robot.jointOrder = {"header", "name", "position", "velocity", "effort"};
    robot.container = dice.upTo(2);
    if (robot.container != 2 && dice.coin()) // a database without definitions has the usual order
        for (auto* order : {&robot.headerOrder, &robot.lineOrder, &robot.jointOrder}) dice.shuffle(*order);
    if (robot.container == 2) robot.lineOrder.resize(10);
    robot.from = dice.coin() ? AngleFrom::Transform : AngleFrom::Joint;
    robot.axis = dice.coin() ? Axis::Sweep : Axis::Spin;
    robot.clockwise = dice.coin();
    robot.intensities = dice.coin();
    robot.idleLaser = dice.coin();
    robot.otherJoints = dice.coin();
    robot.loop = dice.coin();
    robot.stray = dice.coin();
    robot.shiftDeg = robot.from == AngleFrom::Transform ? 10.0 * dice.upTo(6) - 30 : 0;
    robot.stepDeg = dice.of<double>({0.5, -0.25, 0.7});
    robot.setBackNs = dice.upTo(2) == 0 ? 3'600'000'000'000 : 0;
    if (dice.coin()) robot.jitterNs = {0, 7'000'000, 2'000'000, 11'000'000, 0, 4'000'000};
    if (dice.coin()) robot.left = {9, 10, 25};
    robot.noReturn = dice.upTo(3);
    return robot;
}

class RobotBag {
public:
    RobotBag(const Robot& robot, const Scan& scan) : robot_(robot), scan_(scan) {}

    RosMessages messages() {
        const bool byTransform = robot_.from == AngleFrom::Transform;
        lines_ = topic(robot_.topic, "sensor_msgs/LaserScan", lineText());
        tf_ = topic(robot_.stray ? "/tf" : "/" + robot_.space + "tf", "tf2_msgs/TFMessage", transformText());
        joints_ = topic("/" + robot_.space + "joint_states", "sensor_msgs/JointState", jointText());
        if (robot_.idleLaser) idle_ = topic("/" + robot_.space + "base_scan", "sensor_msgs/LaserScan", lineText());
        const int last = scan_.lines() - 1;
        const auto& lineDeg = std::get<PolarGeometry>(scan_.geometry).lineDeg;
        const auto degAt = [&](double line) {
            const double at = std::clamp(line, 0.0, static_cast<double>(last));
            const auto row = static_cast<std::size_t>(std::min(static_cast<int>(at), last - 1));
            return lineDeg[row] + (lineDeg[row + 1] - lineDeg[row]) * (line - static_cast<double>(row));
        };
        for (int i = -6; i < 2 * scan_.lines() + 6; ++i) {
            const std::int64_t ns = kRosStartNs + i * kRosLineNs / 2;
            const double deg = degAt(i / 2.0);
            if (byTransform) add(tf_, ns, transform(robot_.mast, robot_.mount, deg, ns));
            if (byTransform && i % 8 == 0) add(tf_, ns, fixed(robot_.mount, robot_.laser, ns));
            if (!byTransform || robot_.otherJoints) add(joints_, ns, jointState(byTransform ? 0.0 : deg, i, ns));
            if (robot_.loop && i % 10 == 0) {
                add(tf_, ns, fixed("wheel_a", "wheel_b", ns));
                add(tf_, ns, fixed("wheel_b", "wheel_a", ns));
            }
            if (robot_.idleLaser) add(idle_, ns, line(0, ns, "idle"));
            if (i % 2 != 0 || i < 0 || i / 2 > last || std::ranges::find(robot_.left, i / 2) != robot_.left.end()) continue;
            const std::int64_t jitter =
                robot_.jitterNs.empty() ? 0 : robot_.jitterNs[static_cast<std::size_t>(i / 2) % robot_.jitterNs.size()];
            add(lines_, ns + 3'000'000, line(i / 2, ns + jitter, robot_.laser));
        }
        return std::move(messages_);
    }

private:
    std::uint32_t topic(const std::string& name, const std::string& type, const std::string& definition) {
        messages_.topics.push_back({name, type, definition});
        return static_cast<std::uint32_t>(messages_.topics.size() - 1);
    }
    void add(std::uint32_t topic, std::int64_t ns, const Bytes& bytes) {
        if (robot_.setBackNs != 0 && ns > kRosStartNs + 20 * kRosLineNs) ns -= robot_.setBackNs; // the stamps are right
        messages_.message(topic, ns, bytes);
    }
    [[nodiscard]] std::string named(const std::string& frame) const {
        return (robot_.wire == Wire::Ros1 && robot_.stray ? "/" : "") + frame;
    }

    /// The text of a definition, and its message in the same order.
    static std::string textOf(const std::vector<std::string>& order, const std::map<std::string, std::string>& types) {
        std::string text;
        for (const std::string& field : order) text += types.at(field) + ' ' + field + '\n';
        return text;
    }
    [[nodiscard]] std::string headerText() const {
        const bool one = robot_.wire == Wire::Ros1;
        std::string text = "===\nMSG: std_msgs/Header\n";
        text += one ? "uint32 seq\n" : "";
        text += textOf(robot_.headerOrder, {{"stamp", one ? "time" : "builtin_interfaces/Time"}, {"frame_id", "string"}});
        return text + (one ? "" : "===\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
    }
    void header(RosWriter& to, std::int64_t ns, const std::string& frame) const {
        if (robot_.wire == Wire::Ros1) to.put(std::uint32_t{7});
        for (const std::string& field : robot_.headerOrder) field == "stamp" ? to.stamp(ns) : to.text(named(frame));
    }
    [[nodiscard]] std::string lineText() const {
        return textOf(robot_.lineOrder, {{"header", "std_msgs/Header"},
                                         {"angle_min", "float32"},
                                         {"angle_max", "float32"},
                                         {"angle_increment", "float32"},
                                         {"time_increment", "float32"},
                                         {"scan_time", "float32"},
                                         {"range_min", "float32"},
                                         {"range_max", "float32"},
                                         {"ranges", "float32[]"},
                                         {"intensities", "float32[]"},
                                         {"note", "string"},
                                         {"extra", "float64[3]"}}) +
               headerText();
    }
    [[nodiscard]] Bytes line(int row, std::int64_t ns, const std::string& frame) const {
        const std::vector<float> no{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0.0F, 99.0F};
        std::vector<float> ranges;
        for (int j = 0; j < scan_.beams(); ++j) {
            const bool valid = scan_.state.at(row, j) == CellState::Valid;
            ranges.push_back(valid ? static_cast<float>(static_cast<double>(scan_.rangeMm.at(row, j)) / 1000)
                                   : no[static_cast<std::size_t>(j + static_cast<int>(robot_.noReturn)) % no.size()]);
        }
        const auto& beamDeg = std::get<PolarGeometry>(scan_.geometry).beamDeg;
        double from = (beamDeg.front() + robot_.shiftDeg) * kRadian, to = (beamDeg.back() + robot_.shiftDeg) * kRadian;
        if (robot_.clockwise) {
            std::ranges::reverse(ranges);
            std::swap(from, to);
        }
        const std::map<std::string, float> numbers{{"angle_min", static_cast<float>(from)},
                                                   {"angle_max", static_cast<float>(to)},
                                                   {"angle_increment", static_cast<float>((to - from) / (scan_.beams() - 1))},
                                                   {"time_increment", 0.0F},
                                                   {"scan_time", 0.04F},
                                                   {"range_min", 0.01F},
                                                   {"range_max", 80.0F}};
        RosWriter message(robot_.wire);
        for (const std::string& field : robot_.lineOrder) {
            if (field == "header") header(message, ns, frame);
            if (const auto number = numbers.find(field); number != numbers.end()) message.put(number->second);
            if (field == "ranges") message.array(ranges);
            if (field == "intensities") message.array(std::vector<float>(robot_.intensities ? ranges.size() : 0, 5.0F));
            if (field == "note") message.text("nothing");
            if (field == "extra") message.put(1.0).put(2.0).put(3.0);
        }
        return message.bytes();
    }
    [[nodiscard]] std::string transformText() const {
        return "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\n"
               "string child_frame_id\nTransform transform\n===\nMSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation\n"
               "===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
               "===\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" +
               headerText();
    }
    [[nodiscard]] Bytes link(const std::string& parent, const std::string& child, double x, double y, double w, std::int64_t ns) const {
        RosWriter message(robot_.wire);
        message.count(1);
        header(message, ns, parent);
        message.text(named(child)).put(0.0).put(0.0).put(0.0);
        return message.put(x).put(y).put(0.0).put(w).bytes();
    }
    [[nodiscard]] Bytes transform(const std::string& parent, const std::string& child, double deg, std::int64_t ns) const {
        const double half = deg * kRadian / 2, along = (robot_.shiftDeg + (robot_.axis == Axis::Sweep ? 0 : 90)) * kRadian;
        return link(parent, child, std::cos(along) * std::sin(half), std::sin(along) * std::sin(half), std::cos(half), ns);
    }
    [[nodiscard]] Bytes fixed(const std::string& parent, const std::string& child, std::int64_t ns) const {
        return link(parent, child, 0, 0, 1, ns);
    }
    [[nodiscard]] std::string jointText() const {
        return textOf(robot_.jointOrder, {{"header", "std_msgs/Header"},
                                          {"name", "string[]"},
                                          {"position", "float64[]"},
                                          {"velocity", "float64[]"},
                                          {"effort", "float64[]"}}) +
               headerText();
    }
    [[nodiscard]] Bytes jointState(double deg, int n, std::int64_t ns) const {
        RosWriter message(robot_.wire);
        for (const std::string& field : robot_.jointOrder) {
            if (field == "header") header(message, ns, "");
            if (field == "name") message.count(3).text(robot_.space + "wheel_left").text(robot_.joint).text(robot_.space + "lift");
            if (field == "position") message.array<double>({0.3 * n, deg * kRadian, 0.4});
            if (field == "velocity" || field == "effort") message.array<double>({});
        }
        return message.bytes();
    }

    const Robot& robot_;
    const Scan& scan_;
    RosMessages messages_;
    std::uint32_t lines_ = 0, tf_ = 0, joints_ = 0, idle_ = 0;
};

Bytes fileOf(const Robot& robot, const RosMessages& messages) {
    if (robot.wire == Wire::Ros1) return bag1Of(messages);
#ifdef EDGESCAN_TESTS_SQLITE
    if (robot.container > 0) return databaseOf(messages, robot.container == 1);
#endif
    return mcapOf(messages);
}

Grid<std::uint8_t> edgesOf(const Scan& scan) {
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
    return *detection->mask;
}

/// The grid that was sent, with the lines that were not.
Scan sentScan(const Robot& robot, Dice& dice) {
    Scan scan = boxesScan(40 + dice.upTo(20), 50 + dice.upTo(60), 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = robot.axis;
    for (int i = 0; i < scan.lines(); ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -20 + robot.stepDeg * i;
    return scan;
}

void tryRobot(std::uint32_t seed) {
    Dice dice(seed);
    const Robot robot = robotOf(dice);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + robot.text());
    Scan scan = sentScan(robot, dice);
    const Bytes file = fileOf(robot, RobotBag(robot, scan).messages());
    ReadingOptions options;
    if (robot.from == AngleFrom::Joint) options.axis = robot.axis;
    const auto back = files::readScanBytes(std::as_bytes(std::span(file)), ".bag", options);
    ASSERT_TRUE(back) << back.error().sentence();
    std::string said;
    for (const std::string& warning : back->warnings) said += warning + '\n';
    SCOPED_TRACE(said);
    for (const int line : robot.left) {
        for (int j = 0; j < scan.beams(); ++j) {
            scan.state.at(line, j) = CellState::Lost;
            scan.rangeMm.at(line, j) = back->rangeMm.lines > line && back->rangeMm.beams > j ? back->rangeMm.at(line, j) : 0.0F;
        }
    }
    EXPECT_EQ(back->state, scan.state);
    EXPECT_EQ(back->rangeMm, scan.rangeMm);
    ASSERT_EQ(back->lines(), scan.lines());
    const auto &is = std::get<PolarGeometry>(back->geometry), &was = std::get<PolarGeometry>(scan.geometry);
    EXPECT_EQ(is.axis, was.axis);
    if (robot.jitterNs.empty()) { // a line that is stamped late is where the laser was then
        EXPECT_EQ(edgesOf(*back), edgesOf(scan));
    }
}

} // namespace

// A thousand seeds take a minute: EDGESCAN_UNSEEN_BAGS=1000.
TEST(UnseenBags, AreTheGridThatWasSent) {
    const char* asked = std::getenv("EDGESCAN_UNSEEN_BAGS");
    const int seeds = asked != nullptr ? std::atoi(asked) : 60;
    for (int seed = 1; seed <= seeds && !testing::Test::HasFatalFailure(); ++seed) tryRobot(static_cast<std::uint32_t>(seed));
}
