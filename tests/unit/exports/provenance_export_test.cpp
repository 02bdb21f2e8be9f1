// Every export carries its record inside and in its sidecar, and can be made again from it.
#include "core/base/sha256.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/exports/provenance.h"
#include "core/exports/record_parts.h"
#include "core/exports/report.h"
#include "core/exports/verify.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/cell_sets.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/save_clouds.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <fstream>
#include <map>
#include <random>

using namespace edgescan;
using namespace edgescan::exports;
using namespace edgescan::test;
using Json = nlohmann::ordered_json;

namespace {

struct Export {
    ExportContent content;
    const char* name;
    bool inside = true; ///< the format can hold the record
};
constexpr Export kExports[]{{ExportContent::EdgeCloud, "edges.pcd"},        {ExportContent::EdgeCloud, "edges.ply"},
                            {ExportContent::EdgeCloud, "edges.csv", false}, {ExportContent::EdgeCloud, "edges.xyz", false},
                            {ExportContent::FullCloud, "cloud.pcd"},        {ExportContent::FullCloud, "cloud.ply"},
                            {ExportContent::FullCloud, "cloud.csv", false}, {ExportContent::FullCloud, "cloud.xyz", false},
                            {ExportContent::EdgeImage, "mask.png"},         {ExportContent::GrayImage, "gray.png"},
                            {ExportContent::RangeImage, "range.png"},       {ExportContent::EdgeCloud, "edges.las"},
                            {ExportContent::FullCloud, "cloud.las"},        {ExportContent::EdgeCloud, "edges.dxf"},
                            {ExportContent::FullCloud, "cloud.dxf"},        {ExportContent::EdgeCloud, "edges.obj"},
                            {ExportContent::FullCloud, "cloud.obj"},        {ExportContent::EdgeCloud, "edges.ptx", false},
                            {ExportContent::FullCloud, "cloud.ptx", false}};

/// A scan in a file of `folder`, with or without a placement in the mine, and its edges.
std::shared_ptr<const edges::Detection> detectionIn(const Folder& folder, unsigned seed, bool placed) {
    Scan scan = makeScan({.axis = Axis::Sweep, .lines = 30, .beams = 40, .seed = seed});
    if (placed) scan.placement = randomPlacement(seed, seed % 2 == 0 ? 30 : 1, true);
    const auto path = folder / "scan.json";
    EXPECT_TRUE(files::saveScan(scan, path));
    return edges::detectEdges(std::make_shared<const Scan>(*files::openScan(path)), edges::Settings{});
}

std::string bigEndian(std::uint32_t value) {
    return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U & 255U), static_cast<char>(value >> 8U & 255U),
            static_cast<char>(value & 255U)};
}

std::string pngChunk(const std::string& kind, const std::string& content) {
    const std::string body = kind + content;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return bigEndian(static_cast<std::uint32_t>(content.size())) + body + bigEndian(static_cast<std::uint32_t>(crc));
}

/// A gray picture without filters, its rows stored without compression, and a record.
std::string storedPng(const Grid<std::uint16_t>& values, int depth, const std::string& record) {
    std::string rows;
    for (int line = 0; line < values.lines; ++line) {
        rows += '\0';
        for (int beam = 0; beam < values.beams; ++beam) {
            if (depth == 16) rows += static_cast<char>(values.at(line, beam) >> 8);
            rows += static_cast<char>(values.at(line, beam) & 255);
        }
    }
    std::string packed(compressBound(static_cast<uLong>(rows.size())) + 64, '\0');
    auto size = static_cast<uLongf>(packed.size());
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()), static_cast<uLong>(rows.size()),
              0);
    packed.resize(size);
    using namespace std::string_literals;
    return "\x89PNG\r\n\x1a\n"s +
           pngChunk("IHDR", bigEndian(static_cast<std::uint32_t>(values.beams)) + bigEndian(static_cast<std::uint32_t>(values.lines)) +
                                static_cast<char>(depth) + "\0\0\0\0"s) +
           pngChunk("tEXt", "edgescan-record\0"s + record) + pngChunk("IDAT", packed) + pngChunk("IEND", "");
}

Json sidecarOf(const std::filesystem::path& path) { return Json::parse(readText(files::sidecarPath(path))); }

} // namespace

TEST(Provenance, EveryExportHasItsRecordInsideAndInASidecar) {
    const Folder folder;
    const auto detection = detectionIn(folder, 3, true);
    ExportOptions options{CoordinateFrame::Mine, false, "R. Operator", "blasting engineer"};
    for (const Export& one : kExports) {
        SCOPED_TRACE(one.name);
        const auto path = folder / one.name;
        const auto written = exportWithProvenance(one.content, *detection, path, options);
        ASSERT_TRUE(written) << written.error().sentence();
        const std::string bytes = readText(path);
        const Json sidecar = sidecarOf(path);
        const Json record = one.inside ? Json::parse(embeddedRecord(bytes)) : sidecar["record"];
        EXPECT_EQ(sidecar["record"].dump(), record.dump());
        EXPECT_TRUE(recordIsWhole(record));
        EXPECT_EQ(sidecar["export"]["sha256"], sha256Hex(std::as_bytes(std::span(bytes))));
        EXPECT_EQ(sidecar["export"]["bytes"], bytes.size());
        EXPECT_EQ(sidecar["export"]["file"], one.name);
        EXPECT_TRUE(sidecarIsWhole(sidecar));
        EXPECT_EQ(sidecar.contains("grid"), isCloud(one.content));
        for (const char* key : {"format", "content", "scan", "cells", "scanner", "acquisition", "coordinates", "pose", "settings", "edges",
                                "edge_mask_sha256", "program", "warnings", "operator", "role", "record_sha256"})
            EXPECT_TRUE(record.contains(key)) << key;
        EXPECT_EQ(record["scan"]["sha256"], *sha256OfFile(folder / "scan.u16"));
        EXPECT_EQ(record["scan"]["input"], "scan.json");
        EXPECT_EQ(record["edge_mask_sha256"], maskSha256(*detection->mask));
        EXPECT_EQ(nlohmann::json(record["settings"]), edges::settingsToJson(detection->settings));
        EXPECT_EQ(record["scanner"]["serial"], nullptr);
        EXPECT_EQ(record["scanner"]["reason"], "the scan file does not say");
        EXPECT_EQ(record["operator"], "R. Operator");
        for (const char* key : {"version", "commit", "libraries"}) EXPECT_TRUE(record["program"].contains(key)) << key;
        EXPECT_FALSE(record["program"]["libraries"]["OpenCV"].get<std::string>().empty());
        std::size_t sum = 0;
        for (const auto& [state, count] : record["cells"].items()) sum += count.get<std::size_t>();
        EXPECT_EQ(sum, 1200U);
        if (isCloud(one.content)) {
            EXPECT_EQ(record["coordinates"]["axis_order"], Json({"easting", "northing", "elevation"}));
            EXPECT_EQ(sidecar["export"]["points"],
                      one.content == ExportContent::EdgeCloud ? detection->edges->size() : countCells(*detection->scan)[0]);
        }
    }
}

TEST(Provenance, TheRecordDependsOnNeitherTimeNorFolder) {
    const Folder one, other;
    const auto a = detectionIn(one, 4, false);
    const auto b = detectionIn(other, 4, false);
    for (const Export& e : kExports) {
        ASSERT_TRUE(exportWithProvenance(e.content, *a, one / e.name));
        ASSERT_TRUE(exportWithProvenance(e.content, *b, other / (std::string("other-") + e.name)));
        EXPECT_EQ(readText(one / e.name), readText(other / (std::string("other-") + e.name))) << e.name;
    }
}

// The counts of two scans may be the same, and their hash is that of the counts.
TEST(Provenance, OfScansWithTheSameCountsTheOneThatFitsIsTaken) {
    const Folder folder;
    Scan scan = makeScan({.axis = Axis::Sweep, .lines = 30, .beams = 40, .seed = 5});
    for (const char* name : {"b.json", "a.json", "c.json"}) {
        ASSERT_TRUE(files::saveScan(scan, folder / name));
        for (double& deg : std::get<PolarGeometry>(scan.geometry).lineDeg) deg *= 1.5; // another description
    }
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(folder / "b.json")), edges::Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / "o.ply"));
    const auto verified = verifyExport(folder / "o.ply");
    ASSERT_TRUE(verified) << verified.error().sentence();
    EXPECT_TRUE(verified->identical) << verificationText(*verified);
    EXPECT_EQ(verified->scan, folder / "b.u16");
    std::filesystem::remove(folder / "b.json");
    std::filesystem::remove(folder / "b.u16");
    const auto others = verifyExport(folder / "o.ply");
    ASSERT_TRUE(others) << others.error().sentence();
    EXPECT_FALSE(others->identical);
    EXPECT_EQ(others->scan, folder / "a.u16");
}

TEST(Provenance, TheRecordIsAsPrivateAsItsExport) {
    using std::filesystem::perms;
    const Folder folder;
    const auto detection = detectionIn(folder, 3, true);
    const auto own = perms::owner_read | perms::owner_write;
    const auto modeOf = [](const std::filesystem::path& path) { return std::filesystem::status(path).permissions(); };
    for (const bool recordIsThere : {false, true}) {
        const auto path = folder / (recordIsThere ? "old.pcd" : "new.pcd");
        const auto record = files::sidecarPath(path);
        std::ofstream(path) << "old";
        std::filesystem::permissions(path, own);
        if (recordIsThere) {
            std::ofstream(record) << R"({"format": "edgescan-provenance/1"})";
            std::filesystem::permissions(record, own | perms::group_read | perms::others_read);
        }
        ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *detection, path));
        EXPECT_EQ(modeOf(path), own);
        EXPECT_EQ(modeOf(record), own);
    }
}

TEST(Provenance, ExportsOfAnySettingsFrameAndFormatVerify) {
    const Folder folder;
    std::mt19937 random(1);
    const CoordinateFrame frames[]{CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine};
    for (unsigned round = 0; round < 6; ++round) {
        auto detection = detectionIn(folder, round + 1, true);
        edges::Settings settings;
        settings.kernel = 1 + 2 * static_cast<int>(random() % 4);
        settings.lower = 1 + static_cast<double>(random() % 40);
        settings.maskMissing = random() % 2 == 0;
        detection = edges::detectEdges(detection->scan, settings);
        for (const Export& one : kExports) {
            const ExportOptions options{frames[random() % 3], random() % 2 == 0};
            SCOPED_TRACE(std::string(one.name) + " frame " + std::to_string(static_cast<int>(options.frame)));
            const auto written = exportWithProvenance(one.content, *detection, folder / one.name, options);
            ASSERT_TRUE(written) << written.error().sentence();
            if (round % 2 == 0 && one.inside) std::filesystem::remove(files::sidecarPath(folder / one.name)); // the record inside is enough
            const auto verified = verifyExport(folder / one.name);
            ASSERT_TRUE(verified) << verified.error().sentence();
            EXPECT_TRUE(verified->identical) << verificationText(*verified);
            EXPECT_EQ(verified->scan, folder / "scan.u16");
        }
    }
}

TEST(Provenance, AnAlteredByteIsNamed) {
    const Folder folder;
    const auto detection = detectionIn(folder, 5, true);
    std::mt19937 random(2);
    for (const Export& one : kExports) {
        const auto path = folder / one.name;
        ASSERT_TRUE(exportWithProvenance(one.content, *detection, path, {CoordinateFrame::Mine}));
        const std::string good = readText(path);
        for (int round = 0; round < 6; ++round) {
            const std::size_t byte = round == 0 ? 0 : round == 1 ? good.size() - 1 : random() % good.size();
            SCOPED_TRACE(std::string(one.name) + " byte " + std::to_string(byte));
            std::string bad = good;
            bad[byte] = static_cast<char>(bad[byte] ^ 1);
            writeText(path, bad);
            const auto verified = verifyExport(path);
            ASSERT_TRUE(verified) << verified.error().sentence();
            EXPECT_FALSE(verified->identical);
            ASSERT_TRUE(verified->firstDifference);
            EXPECT_EQ(*verified->firstDifference, byte);
            EXPECT_NE(verificationText(*verified).find("NOT identical"), std::string::npos);
        }
        writeText(path, good.substr(0, good.size() / 2));
        EXPECT_FALSE(verifyExport(path)->identical);
        writeText(path, good + "x");
        EXPECT_EQ(*verifyExport(path)->firstDifference, good.size());
    }
}

TEST(Provenance, APicturePackedByAnotherZlibIsTheSamePicture) {
    const Folder folder;
    const auto detection = detectionIn(folder, 5, false);
    for (const char* name : {"mask.png", "range.png"}) {
        SCOPED_TRACE(name);
        const auto path = folder / name;
        const auto content = name[0] == 'm' ? ExportContent::EdgeImage : ExportContent::RangeImage;
        // As if it had been made on another machine: the record names another zlib, and the pixels are stored without compression.
        Json record = Json::parse(exportRecord(content, *detection, {}));
        record["program"]["libraries"]["zlib"] = "1.3.99";
        const auto repacked = [&](int change) {
            auto values = *containers::pngValues(exportFiles(content, *detection, path, sealed(record), {})->front().bytes, name);
            values[77] = static_cast<std::uint16_t>(values[77] ^ change);
            return storedPng(values, content == ExportContent::EdgeImage ? 8 : 16, sealed(record));
        };
        std::filesystem::remove(files::sidecarPath(path));
        writeText(path, repacked(0));
        const auto same = verifyExport(path);
        ASSERT_TRUE(same) << same.error().sentence();
        EXPECT_TRUE(same->identical) << verificationText(*same);
        EXPECT_NE(verificationText(*same).find("Every pixel is the same"), std::string::npos) << verificationText(*same);
        writeText(path, repacked(1));
        const auto other = verifyExport(path);
        ASSERT_TRUE(other) << other.error().sentence();
        EXPECT_FALSE(other->identical);
        EXPECT_NE(verificationText(*other).find("The first cell that differs is line 1, beam 37"), std::string::npos)
            << verificationText(*other);
    }
}

TEST(Provenance, AWholeScanOfEveryFormatVerifies) {
    const Folder folder;
    const auto edges = detectionIn(folder, 11, true);
    edges::Detection detection;
    detection.scan = edges->scan;
    for (const char* name : {"w.json", "w.u16", "w.pcd", "w.ply", "w.csv", "w.xyz", "w.las", "w.dxf", "w.obj", "w.ptx", "w.mcap"}) {
        for (const CoordinateFrame coordinates : {CoordinateFrame::Scanner, CoordinateFrame::Mine, CoordinateFrame::MineLocal}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(static_cast<int>(coordinates)));
            const bool ranges = files::writtenFormat(name)->write == nullptr;
            const auto written = exportWithProvenance(ExportContent::WholeScan, detection, folder / name, {coordinates, true});
            ASSERT_EQ(bool(written), !ranges || coordinates == CoordinateFrame::Scanner);
            if (!written) continue;
            EXPECT_EQ(written->count, ranges ? detection.scan->cells() : countCells(*detection.scan)[0]);
            const auto verified = verifyExport(folder / name);
            ASSERT_TRUE(verified) << verified.error().sentence();
            EXPECT_TRUE(verified->identical) << verificationText(*verified);
        }
    }
    std::filesystem::remove(folder / "w.u16");
    EXPECT_NE(verificationText(*verifyExport(folder / "w.json")).find("w.u16, which belongs to it, is missing"), std::string::npos);
}

TEST(Provenance, AttachedPointsAreExportedWhenAskedForAndVerify) {
    const Folder folder;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::string cloud = "ply\nformat ascii 1.0\nelement vertex 6000\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (int n = 0; n < 6000; ++n) { // a plate in front of a wall, seen from the origin
        const double y = unit(random), z = unit(random);
        const double x = std::abs(y) < 0.4 && std::abs(z) < 0.4 && n % 2 == 0 ? 3 : 5;
        cloud += numberText("%.6f ", x) + numberText("%.6f ", x * y) + numberText("%.6f\n", x * z);
    }
    writeText(folder / "cloud.ply", cloud);
    ReadingOptions coarse;
    coarse.sensorM = Eigen::Vector3d::Zero();
    coarse.gridStepDeg = 2.5;
    coarse.projection = Projection::Always;
    const auto scan = files::openScan(folder / "cloud.ply", coarse);
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_FALSE(scan->attached.empty());
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*scan), edges::Settings{});
    ASSERT_GT(detection->edges->size(), 0U);
    ExportOptions options;
    options.includeAttached = true;
    for (const char* name : {"c.pcd", "c.ply", "c.csv", "c.las", "c.dxf", "c.obj"}) {
        SCOPED_TRACE(name);
        const auto all = exportWithProvenance(ExportContent::FullCloud, *detection, folder / name, options);
        ASSERT_TRUE(all) << all.error().sentence();
        EXPECT_EQ(all->count, 6000U) << "every point of the file";
        EXPECT_TRUE(verifyExport(folder / name)->identical) << verificationText(*verifyExport(folder / name));
        const auto edges = exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / name, options);
        ASSERT_TRUE(edges) << edges.error().sentence();
        EXPECT_GT(edges->count, detection->edges->size());
        EXPECT_TRUE(verifyExport(folder / name)->identical);
    }
    const auto ptx = exportWithProvenance(ExportContent::FullCloud, *detection, folder / "c.ptx", options);
    ASSERT_FALSE(ptx);
    EXPECT_NE(ptx.error().sentence().find("PTX holds one point per cell"), std::string::npos);
    // Files of whole scans report what they leave out.
    const auto lost = files::lostOnSaving(*scan, "w.pcd");
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost[0].find(std::to_string(scan->attached.size()) + " points behind the nearest"), 0U) << lost[0];
    edges::Detection whole;
    whole.scan = detection->scan;
    const auto list = exportWithProvenance(ExportContent::WholeScan, whole, folder / "w.pcd", options);
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->count, 6000U);
    EXPECT_TRUE(verifyExport(folder / "w.pcd")->identical);
}

TEST(Provenance, ASelectionIsPartOfTheRecordAndVerifies) {
    const Folder folder;
    const auto detection = detectionIn(folder, 5, true);
    std::mt19937 random(17);
    inspect::CellSet cells;
    for (std::uint32_t k = 0; k < detection->scan->cells(); ++k) {
        if (random() % 3 == 0) cells.push_back(k);
    }
    ExportOptions options{CoordinateFrame::Mine};
    options.selection = std::make_shared<const inspect::CellSet>(cells);
    std::size_t points = 0, edges = 0;
    for (const std::uint32_t k : cells) {
        const bool valid = detection->scan->state[k] == CellState::Valid;
        points += valid ? 1 : 0;
        edges += valid && (*detection->mask)[k] != 0 ? 1 : 0;
    }
    ASSERT_GT(edges, 0U);
    for (const Export& one : kExports) {
        if (!isCloud(one.content)) continue;
        SCOPED_TRACE(one.name);
        const auto written = exportWithProvenance(one.content, *detection, folder / one.name, options);
        ASSERT_TRUE(written) << written.error().sentence();
        EXPECT_EQ(written->count, one.content == ExportContent::EdgeCloud ? edges : points);
        const auto verified = verifyExport(folder / one.name);
        ASSERT_TRUE(verified) << verified.error().sentence();
        EXPECT_TRUE(verified->identical) << verificationText(*verified);
    }
    const Json record = Json::parse(exportRecord(ExportContent::FullCloud, *detection, options));
    EXPECT_EQ(record["selection"]["cells"], cells.size());
    EXPECT_TRUE(recordIsWhole(record));
    EXPECT_EQ(*selectionOf(record["selection"], detection->scan->cells()), cells);
    EXPECT_FALSE(Json::parse(exportRecord(ExportContent::FullCloud, *detection, {})).contains("selection"));
    for (const char* wrong :
         {"null", "{}", R"({"runs": 3})", R"({"runs": [[1]]})", R"({"runs": [[-1, 2]]})", R"({"runs": [[0, 99999999999]]})"})
        EXPECT_TRUE(selectionOf(Json::parse(wrong), detection->scan->cells())->empty()) << wrong;
}

TEST(Provenance, AnAlteredRecordIsNoticed) {
    const Folder folder;
    const auto detection = detectionIn(folder, 6, false);
    const auto path = folder / "edges.ply";
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *detection, path));
    const std::string sidecar = readText(files::sidecarPath(path));
    std::string altered = sidecar;
    altered.replace(altered.find("\"edges\": "), 9, "\"edges\": 9");
    writeText(files::sidecarPath(path), altered);
    const auto verified = verifyExport(path);
    ASSERT_TRUE(verified) << verified.error().sentence();
    EXPECT_FALSE(verified->identical);
    EXPECT_NE(verificationText(*verified).find("The record next to the export is damaged or was altered"), std::string::npos);
    // The record inside was altered and there is no sidecar: no record can be trusted.
    std::filesystem::remove(files::sidecarPath(path));
    std::string inside = readText(path);
    inside.replace(inside.find("\"input\":\"scan"), 13, "\"input\":\"scum");
    writeText(path, inside);
    const auto refused = verifyExport(path);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("no record of the export is left unaltered"), std::string::npos);
}

TEST(Provenance, ValuesThatAFormatCannotHoldAreRefusedAndTheOldFileStays) {
    const Folder folder;
    auto scan = std::make_shared<Scan>(makeScan({}));
    auto placement = std::make_shared<Placement>(*randomPlacement(3, 1, true));
    placement->gridScale = 1e9; // a scan with huge coordinates, which do not fit into whole millimetres of 32 bits
    scan->placement = placement;
    const auto detection = edges::detectEdges(scan, edges::Settings{});
    writeText(folder / "a.las", "what was here before");
    const auto written = exportWithProvenance(ExportContent::FullCloud, *detection, folder / "a.las", {CoordinateFrame::Mine});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().sentence().find("disk"), std::string::npos) << written.error().sentence();
    EXPECT_EQ(readText(folder / "a.las"), "what was here before");
}

TEST(Provenance, TheScanIsFoundByItsHashWhereverItIs) {
    const Folder folder, far;
    const auto detection = detectionIn(folder, 7, false);
    const auto path = folder / "edges.csv";
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *detection, path));
    std::filesystem::create_directories(far / "deep/er");
    std::filesystem::rename(folder / "scan.u16", far / "deep/er/renamed.u16");
    std::filesystem::rename(folder / "scan.json", far / "deep/er/renamed.json");
    const auto lost = verifyExport(path);
    ASSERT_FALSE(lost);
    EXPECT_NE(lost.error().sentence().find("give --scans the folder that holds it"), std::string::npos) << lost.error().sentence();
    const auto found = verifyExport(path, far.path());
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_TRUE(found->identical) << verificationText(*found);
    EXPECT_EQ(found->scan, far / "deep/er/renamed.u16");
    EXPECT_FALSE(verifyExport(path, folder / "nowhere"));
    // The same counts with another description are another scan.
    std::string json = readText(far / "deep/er/renamed.json");
    json.replace(json.find("\"sweep\""), 7, "\"spin\"");
    writeText(far / "deep/er/renamed.json", json);
    const auto other = verifyExport(path, far.path());
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_FALSE(other->identical);
    EXPECT_NE(verificationText(*other).find("opens as another grid"), std::string::npos);
}

TEST(Provenance, WhatTheUserSaidOnOpeningIsPartOfTheRecord) {
    const Folder folder;
    std::string table;
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 30; ++j) table += std::to_string(1000 + 100 * ((i / 5 + j / 7) % 3)) + (j == 29 ? "\n" : ",");
    }
    writeText(folder / "ranges.csv", table);
    ReadingOptions options;
    options.beamStartDeg = 60;
    options.beamStepDeg = 0.25;
    options.lineStartDeg = 10;
    options.lineStepDeg = 0.5;
    options.axis = Axis::Sweep;
    const auto scan = files::openScan(folder / "ranges.csv", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*scan), edges::Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::FullCloud, *detection, folder / "cloud.ply"));
    EXPECT_EQ(sidecarOf(folder / "cloud.ply")["record"]["scan"]["opened_with"]["beam-step"], 0.25);
    const auto verified = verifyExport(folder / "cloud.ply");
    ASSERT_TRUE(verified) << verified.error().sentence();
    EXPECT_TRUE(verified->identical) << verificationText(*verified);
}

TEST(Provenance, WhatCannotBeExportedOrVerifiedIsSaid) {
    const Folder folder;
    const auto detection = detectionIn(folder, 8, false);
    const auto noPose = exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / "edges.pcd", {CoordinateFrame::Mine});
    ASSERT_FALSE(noPose);
    EXPECT_NE(noPose.error().sentence().find("the scan has no pose"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "edges.pcd"));
    EXPECT_FALSE(std::filesystem::exists(files::sidecarPath(folder / "edges.pcd")));
    EXPECT_FALSE(exportWithProvenance(ExportContent::EdgeImage, *detection, folder / "nowhere/mask.png"));
    const auto device = exportWithProvenance(ExportContent::EdgeImage, *detection, "/dev/null");
    EXPECT_TRUE(device);
    EXPECT_FALSE(std::filesystem::exists("/dev/null.provenance.json"));
    ASSERT_TRUE(saveEdges(*detection->scan, *detection->mask, folder / "bare.pcd"));
    const auto bare = verifyExport(folder / "bare.pcd");
    ASSERT_FALSE(bare);
    EXPECT_NE(bare.error().sentence().find("there is no record in the export and none next to it"), std::string::npos);
    EXPECT_FALSE(verifyExport(folder / "missing.pcd"));
    for (const char* hostile : {"{", "[]", "{\"format\":\"edgescan-provenance/1\",\"record\":[[[[",
                                "{\"format\":\"edgescan-provenance/1\",\"record\":{\"record_sha256\":7}}"}) {
        writeText(folder / "bare.pcd.provenance.json", hostile);
        EXPECT_FALSE(verifyExport(folder / "bare.pcd"));
    }
    Scan unsaved = *detection->scan;
    unsaved.sha256.clear();
    const auto live = edges::detectEdges(std::make_shared<const Scan>(unsaved), edges::Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeImage, *live, folder / "mask.png"));
    const auto verified = verifyExport(folder / "mask.png");
    ASSERT_FALSE(verified);
    EXPECT_NE(verified.error().sentence().find("a scan that was in no file"), std::string::npos);
}

TEST(Provenance, NoEdgesAtAllIsAnExportToo) {
    const Folder folder;
    auto detection = detectionIn(folder, 9, false);
    edges::Settings settings = edges::cannySettings();
    settings.lower = 340;
    detection = edges::detectEdges(detection->scan, settings);
    ASSERT_EQ(detection->edges->size(), 0U);
    for (const char* name : {"none.pcd", "none.ply", "none.csv", "none.xyz"}) {
        const auto written = exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / name);
        ASSERT_TRUE(written) << written.error().sentence();
        EXPECT_EQ(written->count, 0U);
        EXPECT_TRUE(verifyExport(folder / name)->identical) << name;
    }
}
