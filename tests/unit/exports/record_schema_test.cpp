// Every export's record, inside and in the sidecar, conforms to docs/reference/export-record.schema.json (docs/reference/rules.md, "S7").
#include "core/base/sha256.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/exports/provenance.h"
#include "core/exports/target_files.h"
#include "core/exports/verify.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/inspect/section/section.h"
#include "core/rocks/attributes/study.h"
#include "core/scan/grid/acquisition.h"
#include "tests/support/folders.h"
#include "tests/support/json_schema.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace edgescan::test {

using namespace exports;
namespace {

const SchemaJson& schema() {
    static const SchemaJson read = SchemaJson::parse(fileText(sourceFolder() + "/docs/reference/export-record.schema.json"));
    return read;
}
const SchemaJson& recordSchema() { return schema()["$defs"]["record"]; }

Scan recordedScan(unsigned seed, bool placed) {
    Scan scan = makeScan({.axis = Axis::Sweep, .lines = 12, .beams = 16, .seed = seed});
    if (placed) scan.placement = randomPlacement(seed, 1, true);
    if (seed % 2 == 0) {
        Acquisition acquisition;
        acquisition.vendor = "SICK";
        acquisition.model = "LMS511";
        acquisition.serial = "=1+1,\x1b[31m";
        scan.acquisition = std::make_shared<const Acquisition>(acquisition);
    }
    scan.note = "=cmd|' /C calc'!A0, \x1b]0;title\x07 \u202e";
    return scan;
}

/// The first cell with a range and the first without, with texts that no format may take for its own.
TargetList targetsOn(const Scan& scan) {
    TargetList targets;
    for (const bool measured : {true, false}) {
        for (std::uint32_t k = 0; k < scan.cells(); ++k) {
            if ((scan.state[k] == CellState::Valid) != measured) continue;
            inspect::PinnedTarget target;
            target.number = measured ? 2 : 5;
            target.name = measured ? "cl\xC3\xA9, \"left\"" : "";
            target.note = measured ? "=1+1 \xE2\x96\xB2 loose" : "";
            target.cell = k;
            target.pinnedUtc = "2026-11-20T10:15:30.000Z";
            targets.push_back(target);
            break;
        }
    }
    return targets;
}

// Exports and their files: every format, every content.
struct WrittenFile {
    std::filesystem::path path;
    ExportContent content;
};

std::vector<WrittenFile> exportAll(const Folder& folder, const edges::Detection& detection, const ExportOptions& options) {
    std::vector<WrittenFile> written;
    const auto add = [&](ExportContent content, const std::string& name) {
        const auto done = exportWithProvenance(content, detection, folder / name, options);
        EXPECT_TRUE(done) << name << ": " << done.error().sentence();
        if (done) written.push_back({folder / name, content});
    };
    for (const files::Format& format : files::formats()) {
        for (const char* extension : format.writes) {
            const std::string end = extension;
            if (format.write != nullptr) {
                add(ExportContent::EdgeCloud, "edges" + end);
                add(ExportContent::FullCloud, "cloud" + end);
            }
            if (options.frame == CoordinateFrame::Scanner) add(ExportContent::WholeScan, "whole" + end);
        }
    }
    add(ExportContent::EdgeImage, "mask.png");
    add(ExportContent::GrayImage, "gray.png");
    add(ExportContent::RangeImage, "range.png");
    add(ExportContent::RockLabels, "labels.png");
    add(ExportContent::RockTable, "rocks.csv");
    add(ExportContent::RockReport, "rocks.json");
    add(ExportContent::RockCloud, "rocks.ply");
    add(ExportContent::RockOutlines, "outlines.dxf");
    if (options.frame == CoordinateFrame::Mine) add(ExportContent::RockOutlines, "outlines.geojson");
    add(ExportContent::RockPictureOutlines, "outlines.json");
    add(ExportContent::RockHulls, "hulls.ply");
    add(ExportContent::RockHulls, "hulls.obj");
    for (const char* name : {"section.dxf", "section.csv", "section.png"}) add(ExportContent::Section, name);
    for (const char* name : {"targets.csv", "targets.dxf"}) add(ExportContent::Targets, name);
    return written;
}

TEST(RecordSchema, EveryFormatsRecordsFollowIt) {
    std::size_t exports = 0;
    std::size_t inside = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Folder folder;
        ASSERT_TRUE(files::saveScan(recordedScan(seed, seed > 2), folder / "scan.json"));
        const edges::Settings settings = seed % 2 == 0 ? edges::cannySettings() : edges::Settings{};
        const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(folder / "scan.json")), settings);
        const CoordinateFrame frames[]{CoordinateFrame::Scanner, CoordinateFrame::Scanner, CoordinateFrame::MineLocal,
                                       CoordinateFrame::Mine};
        ExportOptions options{frames[seed - 1], seed == 1, seed == 1 ? "" : "=A. Operator", "blasting engineer"};
        options.rocks = std::make_shared<const rocks::Study>(rocks::studyRocks(rocks::rockInputs(*detection), {}));
        std::vector<std::uint32_t> cells(detection->scan->cells());
        std::iota(cells.begin(), cells.end(), 0U);
        options.section = std::make_shared<const inspect::SectionPlane>(*inspect::planeThroughRock(*detection->scan, cells));
        options.targets = std::make_shared<const TargetList>(targetsOn(*detection->scan));
        for (const WrittenFile& one : exportAll(folder, *detection, options)) {
            SCOPED_TRACE(one.path.filename().string() + ", seed " + std::to_string(seed));
            ++exports;
            const std::string bytes = readText(one.path);
            const auto sidecar = SchemaJson::parse(readText(files::sidecarPath(one.path)));
            EXPECT_EQ(schemaProblem(sidecar, schema(), schema()), "");
            EXPECT_EQ(sidecar["export"]["sha256"], sha256Hex(std::as_bytes(std::span(bytes))));
            std::size_t counted = 0;
            for (const auto& [state, count] : sidecar["record"]["cells"].items()) counted += count.get<std::size_t>();
            EXPECT_EQ(counted, 12U * 16U);
            if (one.content != ExportContent::WholeScan) {
                const auto& set = sidecar["record"]["default_settings"];
                EXPECT_EQ(set["name"], edges::kDefaultSet.name);
                EXPECT_EQ(set["changed"].empty(), seed % 2 != 0);
            }
            const std::string embedded = embeddedRecord(bytes);
            if (embedded.empty()) continue;
            ++inside;
            const auto record = SchemaJson::parse(embedded);
            EXPECT_EQ(schemaProblem(record, recordSchema(), schema()), "");
            EXPECT_EQ(record, sidecar["record"]);
            EXPECT_TRUE(recordIsWhole(record));
        }
    }
    EXPECT_GT(exports, 80U);
    EXPECT_GT(inside, 60U);
}

// A schema that accepts everything would be useless.
TEST(RecordSchema, ItRefusesWhatIsMissingOrOfAnotherType) {
    const Folder folder;
    ASSERT_TRUE(files::saveScan(recordedScan(3, true), folder / "scan.json"));
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(folder / "scan.json")), edges::Settings{});
    const auto record = SchemaJson::parse(exportRecord(ExportContent::EdgeCloud, *detection, {CoordinateFrame::MineLocal}));
    ASSERT_EQ(schemaProblem(record, recordSchema(), schema()), "");
    ExportOptions selected;
    selected.selection = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{3, 4, 9});
    EXPECT_EQ(schemaProblem(SchemaJson::parse(exportRecord(ExportContent::FullCloud, *detection, selected)), recordSchema(), schema()), "");
    const std::set<std::string> free{"note", "reason", "boom"}; // these may be missing in the record of a whole scan
    const SchemaJson values = record.flatten();
    for (const auto& flat : values.items()) {
        SchemaJson bad = record;
        bad[SchemaJson::json_pointer(flat.key())] = SchemaJson::array({SchemaJson::object()});
        if (flat.key().find("/opened_with") != std::string::npos) continue;
        EXPECT_NE(schemaProblem(bad, recordSchema(), schema()), "") << flat.key() << " of another type passes";
    }
    for (const auto& [key, value] : record.items()) {
        SchemaJson bad = record;
        bad.erase(key);
        EXPECT_NE(schemaProblem(bad, recordSchema(), schema()), "") << key << " can be missing";
        if (!value.is_object() || key == "settings") continue;
        for (const auto& [inner, ignored] : value.items()) {
            if (free.contains(inner)) continue;
            bad = record;
            bad[key].erase(inner);
            EXPECT_NE(schemaProblem(bad, recordSchema(), schema()), "") << key << "." << inner << " can be missing";
        }
        bad = record;
        bad[key]["unheard_of"] = 1;
        EXPECT_NE(schemaProblem(bad, recordSchema(), schema()), "") << key << " takes any member";
    }
    // No pose, and no reason for it.
    SchemaJson bad = record;
    bad["pose"] = nullptr;
    EXPECT_NE(schemaProblem(bad, recordSchema(), schema()), "");
    bad["pose_reason"] = "there is none";
    EXPECT_EQ(schemaProblem(bad, recordSchema(), schema()), "");
}

// A spreadsheet computes no cell of any table that the program writes, split at commas, semicolons or tabs.
TEST(RecordSchema, NoCellOfATableIsAFormula) {
    const Folder folder;
    ASSERT_TRUE(files::saveScan(recordedScan(2, false), folder / "scan.json"));
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(folder / "scan.json")), edges::Settings{});
    ASSERT_TRUE(exportWithProvenance(ExportContent::EdgeCloud, *detection, folder / "e.csv",
                                     {.operatorName = "@SUM(1),-2+3", .role = "+1", .choices = {.comments = true}}));
    ASSERT_TRUE(exportWithProvenance(ExportContent::WholeScan, *detection, folder / "w.csv", {.choices = {.comments = true}}));
    for (const char* name : {"e.csv", "w.csv"}) {
        const std::string text = readText(folder / name);
        EXPECT_NE(text.find("calc"), std::string::npos) << name; // the text itself is there
        for (std::size_t at = 0, end = 0; end < text.size(); at = end + 1) {
            end = std::min(text.find_first_of(",;\t\r\n", at), text.size());
            std::string cell = text.substr(at, end - at);
            cell.erase(0, std::min(cell.find_first_not_of(" \"[{"), cell.size()));
            if (cell.empty()) continue;
            EXPECT_EQ(std::string("=@").find(cell[0]), std::string::npos) << name << ": " << cell;
            const bool sign = cell[0] == '-' || cell[0] == '+';
            EXPECT_TRUE(!sign || (cell[1] >= '0' && cell[1] <= '9')) << name << ": " << cell;
        }
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << name;
        EXPECT_TRUE(verifyExport(folder / name)->identical) << name;
    }
    EXPECT_EQ(files::openScan(folder / "w.csv")->note, recordedScan(2, false).note);
}

} // namespace
} // namespace edgescan::test
