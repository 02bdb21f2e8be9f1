// Every export carries its record inside and beside itself, and can be made again from it.
#include "core/base/sha256.h"
#include "core/edges/parameters.h"
#include "core/edges/pipeline.h"
#include "core/edges/presets.h"
#include "core/files/open_scan.h"
#include "core/files/png.h"
#include "core/files/save_scan.h"
#include "core/report/provenance.h"
#include "core/report/report.h"
#include "core/report/verify.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace edgescan;
using namespace edgescan::test;
using Json = nlohmann::ordered_json;

namespace {

struct Export {
    ExportContent content;
    const char* name;
};
constexpr Export kExports[]{
    {ExportContent::EdgeCloud, "edges.pcd"}, {ExportContent::EdgeCloud, "edges.ply"}, {ExportContent::EdgeCloud, "edges.csv"},
    {ExportContent::EdgeCloud, "edges.xyz"}, {ExportContent::FullCloud, "cloud.pcd"}, {ExportContent::FullCloud, "cloud.ply"},
    {ExportContent::FullCloud, "cloud.csv"}, {ExportContent::FullCloud, "cloud.xyz"}, {ExportContent::EdgeImage, "mask.png"},
    {ExportContent::GrayImage, "gray.png"},  {ExportContent::RangeImage, "range.png"}};

/// A scan in a file of `folder`, with or without a place in the mine, and its edges.
std::shared_ptr<const Frame> frameIn(const Folder& folder, unsigned seed, bool placed) {
    Scan scan = makeScan({.axis = Axis::Sweep, .lines = 30, .beams = 40, .seed = seed});
    if (placed) scan.placement = randomPlacement(seed, seed % 2 == 0 ? 30 : 1, true);
    const auto path = folder / "scan.json";
    EXPECT_TRUE(saveScan(scan, path));
    return detectEdges(std::make_shared<const Scan>(*openScan(path)), Settings{});
}

Json sidecarOf(const std::filesystem::path& path) { return Json::parse(readText(sidecarPath(path))); }

} // namespace

TEST(Provenance, EveryExportHasItsRecordInsideAndBesideIt) {
    const Folder folder;
    const auto frame = frameIn(folder, 3, true);
    ExportOptions options{CoordinateFrame::Mine, false, "R. Operator", "blasting engineer"};
    for (const Export& one : kExports) {
        SCOPED_TRACE(one.name);
        const auto path = folder / one.name;
        const auto written = exportWithProvenance(one.content, *frame, path, options);
        ASSERT_TRUE(written) << written.error().sentence();
        const std::string bytes = readText(path);
        const Json sidecar = sidecarOf(path);
        const Json record = Json::parse(embeddedRecord(bytes));
        EXPECT_EQ(sidecar["record"].dump(), record.dump());
        EXPECT_TRUE(recordIsWhole(record));
        EXPECT_EQ(sidecar["export"]["sha256"], sha256Hex(std::as_bytes(std::span(bytes))));
        EXPECT_EQ(sidecar["export"]["bytes"], bytes.size());
        EXPECT_EQ(sidecar["export"]["file"], one.name);
        for (const char* key : {"format", "content", "scan", "cells", "scanner", "acquisition", "coordinates", "pose", "settings", "edges",
                                "edge_mask_sha256", "program", "warnings", "operator", "role", "record_sha256"})
            EXPECT_TRUE(record.contains(key)) << key;
        EXPECT_EQ(record["scan"]["sha256"], *sha256OfFile(folder / "scan.u16"));
        EXPECT_EQ(record["scan"]["input"], "scan.json");
        EXPECT_EQ(record["edge_mask_sha256"], maskSha256(*frame->mask));
        EXPECT_EQ(nlohmann::json(record["settings"]), settingsToJson(frame->settings));
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
                      one.content == ExportContent::EdgeCloud ? frame->edges->size() : countCells(*frame->scan)[0]);
        }
    }
}

TEST(Provenance, TheRecordDependsOnNeitherTimeNorFolder) {
    const Folder one, other;
    const auto a = frameIn(one, 4, false);
    const auto b = frameIn(other, 4, false);
    for (const Export& e : kExports) {
        ASSERT_TRUE(exportWithProvenance(e.content, *a, one / e.name));
        ASSERT_TRUE(exportWithProvenance(e.content, *b, other / (std::string("other-") + e.name)));
        EXPECT_EQ(readText(one / e.name), readText(other / (std::string("other-") + e.name))) << e.name;
    }
}

TEST(Provenance, ExportsOfAnySettingsFrameAndFormatVerify) {
    const Folder folder;
    std::mt19937 random(1);
    const CoordinateFrame frames[]{CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine};
    for (unsigned round = 0; round < 6; ++round) {
        auto frame = frameIn(folder, round + 1, true);
        Settings settings;
        settings.kernel = 1 + 2 * static_cast<int>(random() % 4);
        settings.lower = 1 + static_cast<double>(random() % 40);
        settings.maskMissing = random() % 2 == 0;
        frame = detectEdges(frame->scan, settings);
        for (const Export& one : kExports) {
            const ExportOptions options{frames[random() % 3], random() % 2 == 0};
            SCOPED_TRACE(std::string(one.name) + " frame " + std::to_string(static_cast<int>(options.frame)));
            const auto written = exportWithProvenance(one.content, *frame, folder / one.name, options);
            ASSERT_TRUE(written) << written.error().sentence();
            if (round % 2 == 0) std::filesystem::remove(sidecarPath(folder / one.name)); // the record inside is enough
            const auto verified = verifyExport(folder / one.name);
            ASSERT_TRUE(verified) << verified.error().sentence();
            EXPECT_TRUE(verified->identical) << verificationText(*verified);
            EXPECT_EQ(verified->scan, folder / "scan.u16");
        }
    }
}

TEST(Provenance, AnAlteredByteIsNamed) {
    const Folder folder;
    const auto frame = frameIn(folder, 5, true);
    std::mt19937 random(2);
    for (const Export& one : kExports) {
        const auto path = folder / one.name;
        ASSERT_TRUE(exportWithProvenance(one.content, *frame, path, {CoordinateFrame::Mine}));
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

TEST(Provenance, AnAlteredRecordIsNoticed) {
    const Folder folder;
    const auto frame = frameIn(folder, 6, false);
    const auto path = folder / "edges.ply";
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *frame, path));
    const std::string sidecar = readText(sidecarPath(path));
    std::string altered = sidecar;
    altered.replace(altered.find("\"edges\": "), 9, "\"edges\": 9");
    writeText(sidecarPath(path), altered);
    const auto verified = verifyExport(path);
    ASSERT_TRUE(verified) << verified.error().sentence();
    EXPECT_FALSE(verified->identical);
    EXPECT_NE(verificationText(*verified).find("The record beside the export is damaged or was altered"), std::string::npos);
    // Inside and without a sidecar: nothing is left to trust.
    std::filesystem::remove(sidecarPath(path));
    std::string inside = readText(path);
    inside.replace(inside.find("\"input\":\"scan"), 13, "\"input\":\"scum");
    writeText(path, inside);
    const auto refused = verifyExport(path);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("no record of the export is left unaltered"), std::string::npos);
}

TEST(Provenance, TheScanIsFoundByItsHashWhereverItIs) {
    const Folder folder, far;
    const auto frame = frameIn(folder, 7, false);
    const auto path = folder / "edges.csv";
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *frame, path));
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
    // The same counts described otherwise are another scan.
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
    OpenOptions options;
    options.beamStartDeg = 60;
    options.beamStepDeg = 0.25;
    options.lineStartDeg = 10;
    options.lineStepDeg = 0.5;
    options.axis = Axis::Sweep;
    const auto scan = openScan(folder / "ranges.csv", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto frame = detectEdges(std::make_shared<const Scan>(*scan), Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::FullCloud, *frame, folder / "cloud.ply"));
    EXPECT_EQ(sidecarOf(folder / "cloud.ply")["record"]["scan"]["opened_with"]["beam-step"], 0.25);
    const auto verified = verifyExport(folder / "cloud.ply");
    ASSERT_TRUE(verified) << verified.error().sentence();
    EXPECT_TRUE(verified->identical) << verificationText(*verified);
}

TEST(Provenance, WhatCannotBeExportedOrVerifiedIsSaid) {
    const Folder folder;
    const auto frame = frameIn(folder, 8, false);
    const auto noPose = exportWithProvenance(ExportContent::EdgeCloud, *frame, folder / "edges.pcd", {CoordinateFrame::Mine});
    ASSERT_FALSE(noPose);
    EXPECT_NE(noPose.error().sentence().find("the scan has no pose"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "edges.pcd"));
    EXPECT_FALSE(std::filesystem::exists(sidecarPath(folder / "edges.pcd")));
    EXPECT_FALSE(exportWithProvenance(ExportContent::EdgeImage, *frame, folder / "nowhere/mask.png"));
    const auto device = exportWithProvenance(ExportContent::EdgeImage, *frame, "/dev/null");
    EXPECT_TRUE(device);
    EXPECT_FALSE(std::filesystem::exists("/dev/null.provenance.json"));
    ASSERT_TRUE(saveEdges(*frame->scan, *frame->mask, folder / "bare.pcd"));
    const auto bare = verifyExport(folder / "bare.pcd");
    ASSERT_FALSE(bare);
    EXPECT_NE(bare.error().sentence().find("there is no record in the export and none beside it"), std::string::npos);
    EXPECT_FALSE(verifyExport(folder / "missing.pcd"));
    for (const char* hostile : {"{", "[]", "{\"format\":\"edgescan-provenance/1\",\"record\":[[[[",
                                "{\"format\":\"edgescan-provenance/1\",\"record\":{\"record_sha256\":7}}"}) {
        writeText(folder / "bare.pcd.provenance.json", hostile);
        EXPECT_FALSE(verifyExport(folder / "bare.pcd"));
    }
    Scan unsaved = *frame->scan;
    unsaved.sha256.clear();
    const auto live = detectEdges(std::make_shared<const Scan>(unsaved), Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeImage, *live, folder / "mask.png"));
    const auto verified = verifyExport(folder / "mask.png");
    ASSERT_FALSE(verified);
    EXPECT_NE(verified.error().sentence().find("a scan that was in no file"), std::string::npos);
}

TEST(Provenance, NoEdgesAtAllIsAnExportToo) {
    const Folder folder;
    auto frame = frameIn(folder, 9, false);
    Settings settings = cannySettings();
    settings.lower = 340;
    frame = detectEdges(frame->scan, settings);
    ASSERT_EQ(frame->edges->size(), 0U);
    for (const char* name : {"none.pcd", "none.ply", "none.csv", "none.xyz"}) {
        const auto written = exportWithProvenance(ExportContent::EdgeCloud, *frame, folder / name);
        ASSERT_TRUE(written) << written.error().sentence();
        EXPECT_EQ(*written, 0U);
        EXPECT_TRUE(verifyExport(folder / name)->identical) << name;
    }
}
