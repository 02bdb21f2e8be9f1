// One small complete file per reader and kind, made in memory: seeds for the fuzzers, and for the test with damaged files.
#pragma once

#include "core/containers/png/png.h"
#include "core/edges/settings/presets.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/save_recording.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/selection/preset.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/range_image.h"
#include "tests/support/bytes.h"
#include "tests/support/e57_writer.h"
#include "tests/support/example_session.h"
#include "tests/support/live_lines.h"
#include "tests/support/packed_files.h"
#include "tests/support/packet_writer.h"
#include "tests/support/point_lists.h"
#include "tests/support/robot_files.h"
#include "tests/support/ros_sweeps.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace edgescan::test {

struct SeedFile {
    std::string reader;    ///< "pcd": the fuzzer is reader + "_fuzz"
    std::string extension; ///< ".pcd"
    std::string bytes;
};

/// Pictures and tables of ranges have no angles of their own.
inline ReadingOptions seedOptions() {
    ReadingOptions options;
    options.beamStartDeg = 0;
    options.beamStepDeg = 0.5;
    options.lineStartDeg = 0;
    options.lineStepDeg = 0.5;
    options.axis = Axis::Sweep;
    return options;
}

/// 16-bit gray TIFF, one strip, uncompressed.
inline std::string smallTiff(const Scan& scan) {
    const auto width = static_cast<std::uint32_t>(scan.beams());
    const auto height = static_cast<std::uint32_t>(scan.lines());
    std::string tiff("II*\0\x08\0\0\0", 8);
    const std::vector<std::array<std::uint32_t, 3>> entries{{256, 4, width}, {257, 4, height}, {258, 3, 16},
                                                            {259, 3, 1},     {262, 3, 1},      {273, 4, 8 + 2 + 10 * 12 + 4},
                                                            {277, 3, 1},     {278, 4, height}, {279, 4, width * height * 2},
                                                            {339, 3, 1}};
    putAt(tiff, tiff.size(), static_cast<std::uint16_t>(entries.size()));
    for (const auto& [tag, type, value] : entries) {
        putAt(tiff, tiff.size(), static_cast<std::uint16_t>(tag));
        putAt(tiff, tiff.size(), static_cast<std::uint16_t>(type));
        putAt(tiff, tiff.size(), std::uint32_t{1});
        putAt(tiff, tiff.size(), value);
    }
    putAt(tiff, tiff.size(), std::uint32_t{0});
    for (const float mm : scan.rangeMm.cells) putAt(tiff, tiff.size(), static_cast<std::uint16_t>(mm));
    return tiff;
}

/// A LAS 1.2 file of point format 0, as old programs write it.
inline std::string smallLas(const std::vector<Eigen::Vector3d>& points) {
    std::string las(227, '\0');
    las.replace(0, 4, "LASF");
    las[24] = 1;
    las[25] = 2;
    putAt(las, 94, std::uint16_t{227});
    putAt(las, 96, std::uint32_t{227});
    putAt(las, 105, std::uint16_t{20});
    putAt(las, 107, static_cast<std::uint32_t>(points.size()));
    for (std::size_t axis = 0; axis < 3; ++axis) putAt(las, 131 + 8 * axis, 0.001);
    for (const auto& p : points) {
        for (int axis = 0; axis < 3; ++axis) putAt(las, las.size(), static_cast<std::int32_t>(std::lround(p[axis] * 1000)));
        las.resize(las.size() + 8, '\0');
    }
    return las;
}

/// A grid by row and column, with a pose.
inline std::string smallE57(const Scan& scan) {
    E57Part part{e57Cartesian(listOf(scan, {}), E57Column::As::Scaled, 1e-5),
                 "<pose type=\"Structure\"><translation type=\"Structure\"><x type=\"Float\">5</x></translation></pose>"};
    std::vector<double> lines, beams;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        lines.push_back(static_cast<double>(k / static_cast<std::size_t>(scan.beams())));
        beams.push_back(static_cast<double>(k % static_cast<std::size_t>(scan.beams())));
    }
    part.columns.push_back(e57Whole("rowIndex", beams));
    part.columns.push_back(e57Whole("columnIndex", lines));
    return e57Bytes({part});
}

/// numpy: ranges, points, and an archive of both.
inline std::vector<SeedFile> smallArrays(const Scan& scan) {
    std::vector<double> ranges, points;
    for (const float mm : scan.rangeMm.cells) ranges.push_back(static_cast<double>(mm));
    for (const auto& p : listOf(scan, {})) points.insert(points.end(), {p.x(), p.y(), p.z()});
    const std::string shape = "(" + std::to_string(scan.lines()) + ", " + std::to_string(scan.beams());
    const std::string table = npyBytes(npyHeader("'>u2'", false, shape + ")"), npyData(ranges, ">u2"));
    const std::string grid = npyBytes(npyHeader("'<f4'", false, shape + ", 3)"), npyData(points, "<f4"));
    const std::string list = npyBytes(
        npyHeader("[('x', '<f8'), ('y', '<f8'), ('z', '<f8')]", false, "(" + std::to_string(scan.cells()) + ",)"), npyData(points, "<f8"));
    return {{"numpy", ".npy", table}, {"numpy", ".npy", grid}, {"numpy", ".npy", list}};
}

/// A few telegrams as other programs store them.
inline std::vector<SeedFile> smallCaptures(int lines, int beams) {
    std::string stream;
    for (int line = 0; line < lines; ++line) {
        const Bytes frame =
            scanner::framed(scanner::encodeScanTelegram(telegramOfLine(line, {.beams = beams}), scanner::Dialect::B), scanner::Dialect::B);
        stream.append(frame.begin(), frame.end());
    }
    std::vector<TcpPart> parts{{99, "", true, kEpochNs}};
    for (std::size_t at = 0; at < stream.size(); at += 100)
        parts.push_back(
            {static_cast<std::uint32_t>(100 + at), stream.substr(at, 100), false, kEpochNs + static_cast<std::int64_t>(at) * 100'000});
    return {{"capture", ".bin", stream},
            {"capture", ".pcap", captureOf(parts, {})},
            {"capture", ".pcapng", captureOf(parts, {.ipv6 = true, .vlans = 1, .bigEndian = true, .pcapng = true})}};
}

/// The lines of a scan as a laser on ROS sends them.
inline std::vector<SeedFile> smallBags(const Scan& scan) {
    std::vector<SeedFile> seeds;
    const auto add = [&](const char* reader, const char* extension, const Bytes& bytes, std::size_t from = 0) {
        seeds.push_back({reader, extension, std::string(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end())});
    };
    for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
        const RosSweep sent{.from = from, .intensities = true, .beamS = 1e-4, .wire = Wire::CdrLittle};
        add("mcap", ".mcap", mcapOf(rosMessagesOf(scan, sent)));
#ifdef EDGESCAN_TESTS_SQLITE
        add("ros_database", ".db3", databaseOf(rosMessagesOf(scan, sent)));
#endif
    }
    return seeds;
}

/// Seeds for a scan with this many lines and beams.
inline std::vector<SeedFile> seedFiles(int lines = 6, int beams = 11) {
    const Scan scan = makeScan({.lines = lines, .beams = beams, .beamStart = 20});
    const Grid<std::uint8_t> mask(scan.lines(), scan.beams(), 255);
    std::vector<SeedFile> seeds;
    const Folder folder;
    const auto saved = [&](const char* reader, const char* extension, bool ascii = false) {
        files::SaveOptions options;
        options.ascii = ascii;
        const auto path = folder / (std::string("seed") + extension);
        if (files::saveScan(scan, path, options)) seeds.push_back({reader, extension, readText(path)});
        if (const auto cloud = files::cloudBytes(scan, path, &mask, options)) seeds.push_back({reader, extension, *cloud});
    };
    for (const bool ascii : {false, true}) {
        saved("pcd", ".pcd", ascii);
        saved("ply", ".ply", ascii);
    }
    saved("text", ".xyz");
    saved("text", ".csv");
    saved("ptx", ".ptx");
    saved("las", ".las");
    saved("obj", ".obj");
    seeds.push_back({"las", ".las", smallLas(listOf(scan, {}))});
    seeds.push_back({"text", ".3d", textOf(listOf(scan, {.perMetre = 100}), {})});
    seeds.push_back({"text", ".pts", std::to_string(scan.cells()) + "\n" + textOf(listOf(scan, {}), {})});
    std::string strings = "bell,21-Nov-26,,\n0, 0.000, 0.000, 0.000\n";
    for (const auto& p : listOf(scan, {}))
        strings += "1, " + numberText("%.4f", p[1]) + ", " + numberText("%.4f", p[0]) + ", " + numberText("%.4f", p[2]) + ",\n";
    seeds.push_back({"surpac", ".str", strings + "0, 0.000, 0.000, 0.000,\n0, 0.000, 0.000, 0.000, END\n"});
    std::string cloud;
    for (int n = 0; n < 300; ++n)
        cloud += numberText("%.3f", 3 + n % 7 * 0.1) + " " + numberText("%.3f", n * 0.013 - 2) + " " +
                 numberText("%.3f", n * 37 % 300 * 0.011) + "\n";
    seeds.push_back({"text", ".xyz", cloud}); // no grid: it will be projected
    seeds.push_back({"range_csv", ".csv", "1200,1300,1400,0,1500,1600\n1210,1310,,0,1510,1610\n1205,1305,1400,7,1505,1605\n"});
    if (files::saveScan(scan, folder / "grid.json"))
        seeds.push_back({"raw_grid", ".json", readText(folder / "grid.json") + '\0' + readText(folder / "grid.u16")});
    if (containers::savePng16(rangePicture(scan), folder / "range.png"))
        seeds.push_back({"picture", ".png", readText(folder / "range.png")});
    seeds.push_back({"picture", ".tif", smallTiff(scan)});
    seeds.push_back({"e57", ".e57", smallE57(scan)});
    for (SeedFile& seed : smallArrays(scan)) seeds.push_back(std::move(seed));
    for (SeedFile& seed : smallCaptures(lines, beams)) seeds.push_back(std::move(seed));
    for (SeedFile& seed : smallBags(scan)) seeds.push_back(std::move(seed));
    seeds.push_back({"packed", ".xyz.gz", gzipBytes(textOf(listOf(scan, {}), {}))});
    return seeds;
}

/// Every kind of edit on a grid of 6 x 11 cells.
inline std::string smallRockFile() {
    using rocks::EditKind;
    rocks::Preset preset;
    preset.settings.emplace();
    preset.settings->region = {{0, 0}, {5, 9}};
    preset.edits = {{EditKind::Join, {3, 17, 30}}, {EditKind::Part, {1, 40}}, {EditKind::Cut, {2, 13, 24}},
                    {EditKind::Rock, {7}},         {EditKind::NotRock, {65}}, {EditKind::Whole, {5, 19}}};
    preset.sha256 = std::string(64, 'a');
    return rocks::rockPresetText(preset, 6, 11);
}

inline std::string smallNotebook() {
    inspect::Notebook notebook;
    notebook.targets = {{1, "keystone", 5, true, "2026-11-21T08:00:00Z", {{"Distance", "4.2 m"}}},
                        {2, "", 60, false, "2026-11-21T08:01:00Z", {}}};
    notebook.measures = {{.kind = inspect::MeasureKind::Distance, .cells = {5, 60}, .number = 1}};
    return inspect::notebookText(notebook, {std::string(64, 'a'), "bell", 6, 11});
}

/// Two scans, one of them twice, and a line that a crash tore.
inline std::string smallJournal() {
    const auto row = [](const char* input, const char* finished) {
        return nlohmann::ordered_json{{"input", input}, {"times", {{"finished_utc", finished}}}, {"picture", {"pictures.bin", 0, 7}}}
                   .dump() +
               "\n";
    };
    return row("a.json", "2026-11-21T08:00:00.000Z") + row("b.pcd", "2026-11-21T08:00:01.000Z") +
           row("a.json", "2026-11-21T09:00:00.000Z") + row("c.las", "2026-11-21T09:00:01.000Z").substr(0, 40);
}

/// Messages of a robot's bridge: lines and transforms, a list of topics, a message of one of them.
inline void addBridgeSeeds(std::vector<SeedFile>& seeds, const Scan& scan) {
    std::string messages = "\2";
    for (const RosMessages::Message& message : rosMessagesOf(scan, {.wire = Wire::CdrLittle}).messages) {
        const std::size_t length = message.bytes.size();
        messages += {static_cast<char>(length % 256), static_cast<char>(length / 256), static_cast<char>(message.topic)};
        messages.append(message.bytes.begin(), message.bytes.end());
    }
    seeds.push_back({"bridge", "", messages});
    seeds.push_back({"bridge", "",
                     std::string(1, '\0') + R"({"op":"advertise","channels":[{"id":3,"topic":"/scan","encoding":"cdr",)" +
                         R"("schemaName":"sensor_msgs/msg/LaserScan","schema":"float32[] ranges"}]})"});
    seeds.push_back({"bridge", "", std::string("\1\1\3\0\0\0\0\0\0\0\0\0\0\0payload", 21)});
}

/// A VLP-16's datagram, an Ouster's metadata, and a datagram of two columns of three pixels.
inline void addSpinningSeeds(std::vector<SeedFile>& seeds) {
    std::string velodyne(1, '\0');
    for (int block = 0; block < 12; ++block) {
        putAt(velodyne, velodyne.size(), std::uint16_t{0xEEFF});
        putAt(velodyne, velodyne.size(), static_cast<std::uint16_t>(40 * block)); // hundredths of a degree
        for (int shot = 0; shot < 32; ++shot) {
            putAt(velodyne, velodyne.size(), static_cast<std::uint16_t>(3000 + 10 * shot)); // 2 mm
            velodyne += '\x20';
        }
    }
    putAt(velodyne, velodyne.size(), std::uint32_t{1000000}); // microseconds of the hour
    seeds.push_back({"spinning", "", velodyne + "\x37\x22"});
    seeds.push_back(
        {"spinning", "", R"({"beam_altitude_angles":[2,1,0],"beam_azimuth_angles":[0,0,0],"lidar_mode":"1024x10","prod_line":"OS-1"})"});
    seeds.back().bytes.insert(0, 1, '\1');
    std::string ouster(1, '\2');
    for (std::uint16_t column = 0; column < 2; ++column) {
        putAt(ouster, ouster.size(), std::uint64_t{100000} * column); // ns
        putAt(ouster, ouster.size(), column);
        putAt(ouster, ouster.size(), std::uint16_t{0});
        putAt(ouster, ouster.size(), std::uint32_t{88} * column);
        for (std::uint32_t pixel = 0; pixel < 3; ++pixel)
            for (const std::uint32_t word : {5000 + pixel, 20U, 0U}) putAt(ouster, ouster.size(), word);
        putAt(ouster, ouster.size(), std::uint32_t{0xFFFFFFFF});
    }
    seeds.push_back({"spinning", "", ouster});
}

/// The same, and seeds of files that are not scans: telegrams, recordings (without their magic bytes), poses, calibrations, and the files
/// that the programs write for themselves.
inline std::vector<SeedFile> seedsOfEveryFuzzer(int lines = 6, int beams = 11) {
    std::vector<SeedFile> seeds = seedFiles(lines, beams);
    const auto text = [](const auto& bytes) { return std::string(bytes.begin(), bytes.end()); };
    const Scan scan = makeScan({.lines = lines, .beams = beams, .beamStart = 20});
    if (const auto recording = files::recordingOf(scan, "seed"))
        seeds.push_back({"mcap", "", text(*recording).substr(containers::kMcapMagic.size())});
    for (const scanner::Dialect dialect : {scanner::Dialect::A, scanner::Dialect::B}) {
        const Bytes telegram = scanner::encodeScanTelegram(telegramOfLine(3, {.beams = 9}), dialect);
        seeds.push_back({"scan_telegram", "", (dialect == scanner::Dialect::A ? '\0' : '\1') + text(telegram)});
        const Bytes frame = scanner::framed(telegram, dialect);
        seeds.push_back({"cola_stream", "", std::string("\0\x10", 2) + text(frame) + text(frame)});
    }
    seeds.push_back({"place", "", calibrationText(exampleCalibration())});
    PoseTrack poses;
    poses.robot = "example robot";
    poses.inclinometer = {{1.7e9, 14.25, -3.4}, {1.7e9 + 1, 14.3, -3.4}};
    poses.talin = {{1.7e9, {498765.432, 5150123.456, 287.654}, 217.4, true, 5.75, -2.1}};
    seeds.push_back({"place", "", posesText(poses)});
    seeds.push_back({"session", "", inspect::sessionText(exampleSession("/scans/bell.json"), "/sessions", "2026-11-21T08:00:00Z")});
    for (const edges::Preset& preset : edges::builtInPresets()) seeds.push_back({"preset", "", edges::presetText(preset)});
    seeds.push_back({"preset", "", nlohmann::json{{"method", "canny"}, {"lower", 7}, {"near", "auto"}}.dump()});
    seeds.push_back({"rock_file", "", smallRockFile()});
    seeds.push_back({"rock_file", "", "0,1 3,4 5,10"});
    for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint})
        seeds.push_back(
            {"ros_bag", "", text(bag1Of(rosMessagesOf(scan, {.from = from}))).substr(std::string_view("#ROSBAG V2.0\n").size())});
    for (const bool cdr : {false, true}) {
        const RosMessages messages = rosMessagesOf(scan, {.wire = cdr ? Wire::CdrLittle : Wire::Ros1});
        const std::string& definition = messages.topics.front().definition;
        const std::string length{static_cast<char>(definition.size() % 256), static_cast<char>(definition.size() / 256)};
        seeds.push_back({"ros_message", "", (cdr ? '\1' : '\0') + length + definition + text(messages.messages.back().bytes)});
    }
    addBridgeSeeds(seeds, scan);
    addSpinningSeeds(seeds);
    seeds.push_back({"notebook", "", smallNotebook()});
    seeds.push_back({"journal", "", smallJournal()});
    return seeds;
}

/// The options that a seed opens with: the angles of a picture or table of ranges, otherwise those of the file.
inline ReadingOptions optionsOf(const SeedFile& seed) {
    const bool ranges = seed.reader == "picture" || seed.reader == "range_csv" || seed.reader == "numpy";
    return ranges ? seedOptions() : ReadingOptions{};
}

} // namespace edgescan::test
