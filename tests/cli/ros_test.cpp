// Simulated draw-bells that were sent through ROS bags: the programs see the same scan, cell by cell; and the commands of
// docs/guide/ros.md.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <sstream>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;
using test::runLab;

void write(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::string maskOf(const std::filesystem::path& path, const std::string& flags = "") {
    const auto run = runCli("detect --json - " + path.string() + " " + flags);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.code == 0 ? json::parse(run.out)["edge_mask_sha256"].get<std::string>() : run.err;
}

/// The scan with its last line first, as a laser measures it that sweeps back.
Scan turnedBack(const Scan& scan) {
    Scan back = scan;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            back.rangeMm.at(i, j) = scan.rangeMm.at(scan.lines() - 1 - i, j);
            back.state.at(i, j) = scan.state.at(scan.lines() - 1 - i, j);
        }
    }
    std::ranges::reverse(std::get<PolarGeometry>(back.geometry).lineDeg);
    return back;
}

} // namespace

TEST(RosBags, SimulatedDrawBellsGiveTheSameMask) {
    const test::TemporaryFolder folder;
    for (const std::string axis : {"spin", "sweep"}) {
        ASSERT_EQ(runLab("simulate -o " + (folder / "bell.json").string() + " --lines 100 --beams 191 --axis " + axis).code, 0);
        const auto bell = files::openScan(folder / "bell.json");
        ASSERT_TRUE(bell) << bell.error().sentence();
        for (const bool down : {false, true}) {
            const Scan scan = down ? turnedBack(*bell) : *bell;
            ASSERT_TRUE(files::saveScan(scan, folder / "sent.json"));
            const std::string expected = maskOf(folder / "sent.json");
            using test::Wire;
            test::RosSweep sent{.axis = axis == "spin" ? Axis::Spin : Axis::Sweep, .clockwise = down};
            write(folder / "bell.bag", test::bag1Of(test::rosMessagesOf(scan, sent)));
            EXPECT_EQ(maskOf(folder / "bell.bag"), expected) << axis << down;
            sent.wire = Wire::CdrBig;
            sent.shiftDeg = -20;
            write(folder / "bell.mcap", test::mcapOf(test::rosMessagesOf(scan, sent)));
            EXPECT_EQ(maskOf(folder / "bell.mcap"), expected) << axis << down;
#ifdef EDGESCAN_TESTS_SQLITE
            sent = {.from = test::AngleFrom::Joint, .wire = Wire::CdrLittle};
            std::filesystem::create_directories(folder / "bell");
            write(folder / "bell/bell_0.db3", test::databaseOf(test::rosMessagesOf(scan, sent)));
            write(folder / "bell/metadata.yaml", {});
            EXPECT_EQ(maskOf(folder / "bell", "--axis " + axis), expected) << axis << down;
            EXPECT_EQ(maskOf(folder / "bell/metadata.yaml", "--axis " + axis), expected) << axis << down;
#endif
        }
    }
}

TEST(RosBags, TheCommandsOfThePageRun) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(runLab("simulate -o " + (folder / "bell.json").string() + " --lines 60 --beams 191").code, 0);
    const auto bell = files::openScan(folder / "bell.json");
    ASSERT_TRUE(bell);
    test::RosMessages messages = test::rosMessagesOf(*bell);
    const auto joints = messages.topic("/joint_states", "sensor_msgs/JointState", test::Wire::Ros1);
    for (int i = 0; i < bell->lines() + 2; ++i) {
        const double deg = std::get<PolarGeometry>(bell->geometry).lineDeg[static_cast<std::size_t>(std::min(i, bell->lines() - 1))];
        messages.message(joints, 0, test::rosJoint(deg, test::kRosStartNs + i * test::kRosLineNs, {}));
    }
    const auto fixed = messages.topic("/tf_static", "tf2_msgs/TFMessage", test::Wire::Ros1);
    test::RosWriter place(test::Wire::Ros1);
    place.count(1).header(test::kRosStartNs, "map").text("mast").put(498765.25).put(5150123.5).put(287.5);
    messages.message(fixed, 0, place.put(0.0).put(0.0).put(0.0).put(1.0).bytes());
    write(folder / "BELL.bag", test::bag1Of(messages));
    std::istringstream page(test::fileText(test::sourceFolder() + "/docs/guide/ros.md"));
    int commands = 0;
    for (std::string line; std::getline(page, line);) {
        const std::size_t at = line.find("edgescan-cli ");
        if (at == std::string::npos || line.find_first_not_of(' ') != at) continue;
        if (line.find("ws://") != std::string::npos) continue; // a robot: tests/cli/live_test.cpp has one
        std::string arguments = line.substr(at + std::string("edgescan-cli ").size());
        for (const char* name : {" BELL", " EDGES"})
            arguments = std::regex_replace(arguments, std::regex(name), ' ' + (folder / (name + 1)).string());
        const auto run = runCli(arguments);
        EXPECT_EQ(run.code, 0) << line << run.err;
        if (arguments.starts_with("info")) {
            const json bag = json::parse(run.out)["bag"];
            EXPECT_EQ(bag["kind"], "ROS 1 bag");
            EXPECT_EQ(bag["topics"][0]["gives"], "scan lines of 191 beams");
            EXPECT_EQ(bag["topics"][0]["messages"], 60);
            EXPECT_EQ(bag["topics"][1]["gives"], "transforms: robot/laser in mast");
            EXPECT_EQ(bag["topics"][2]["gives"], "joints: wheel, arm/tilt");
        }
        ++commands;
    }
    EXPECT_GE(commands, 4);
}

} // namespace edgescan
