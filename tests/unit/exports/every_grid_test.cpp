// Every kind of grid in every format that a scan is saved in: it opens as the same grid, or a warning says what was lost.
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/provenance.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/placement_json.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

using namespace edgescan;
using namespace edgescan::exports;
using namespace edgescan::test;

namespace {

const double kMissing = std::numeric_limits<double>::quiet_NaN();

/// First line, last two lines, first beam and last three beams without a return.
Scan withEmptyBorder(Scan scan) {
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (i > 0 && i < scan.lines() - 2 && j > 0 && j < scan.beams() - 3) continue;
            scan.state.at(i, j) = CellState::NoReturn;
            scan.rangeMm.at(i, j) = 0;
            if (auto* cloud = std::get_if<PointGeometry>(&scan.geometry)) cloud->pointsM.at(i, j).setConstant(kMissing);
        }
    }
    return scan;
}

Scan spin() { return makeScan({.axis = Axis::Spin, .beamStart = -15, .beamStep = 0.5, .lineStart = 0, .lineStep = 0.5}); }
Scan tilt() { return makeScan({.beamStart = 40, .motorJitter = 0.4}); }

/// Lines of the second half between those of the first.
Scan interlaced() {
    Scan scan = tilt();
    auto& lines = std::get<PolarGeometry>(scan.geometry).lineDeg;
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = 30 - (i < 20 ? static_cast<double>(i) : static_cast<double>(i) - 19.5);
    return scan;
}

/// The second sweep goes back with half the step.
Scan twoSteps() {
    Scan scan = tilt();
    auto& lines = std::get<PolarGeometry>(scan.geometry).lineDeg;
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i] = i < 20 ? 30 - static_cast<double>(i) : 10.75 + 0.5 * static_cast<double>(i - 19);
    return scan;
}

/// A pinhole camera before a step, with its lens at `sensor`.
Scan camera(const Eigen::Vector3d& sensor) {
    Scan scan;
    scan.rangeMm = Grid<float>(60, 80);
    scan.state = Grid<CellState>(60, 80, CellState::Valid);
    PointGeometry cloud{Grid<Eigen::Vector3d>(60, 80, Eigen::Vector3d::Zero()), sensor};
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < 80; ++j) {
            const double depth = (j > 30 && j < 50 && i > 20 && i < 40 ? 1.25 : 2.0) + 0.01 * std::sin(i * 0.7) * std::cos(j * 0.4);
            const Eigen::Vector3f p = Eigen::Vector3d(depth * (j - 39.5) / 60, depth * (i - 29.5) / 60, depth).cast<float>();
            cloud.pointsM.at(i, j) = p.cast<double>() + sensor;
            scan.rangeMm.at(i, j) = static_cast<float>((cloud.pointsM.at(i, j) - sensor).norm() * 1000);
        }
    }
    scan.geometry = cloud;
    return scan;
}

/// As E57 holds a scan of a tripod: points about a sensor that is not the origin, with angles.
Scan tripod() {
    Scan scan = tilt();
    const CartesianTables tables(scan);
    PointGeometry cloud{Grid<Eigen::Vector3d>(scan.lines(), scan.beams(), Eigen::Vector3d::Zero()), Eigen::Vector3d(12.5, -3.25, 1.75)};
    cloud.angles = std::get<PolarGeometry>(scan.geometry);
    for (std::size_t k = 0; k < scan.cells(); ++k) cloud.pointsM[k] = tables.point(k) + cloud.sensorM;
    scan.geometry = cloud;
    return scan;
}

/// Points of a wall and a box before it, in no order that a scanner has.
Scan projected() {
    std::string text;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int n = 0; n < 6000; ++n) {
        const double y = 1.5 * unit(random), z = unit(random);
        const double x = std::abs(y) < 0.4 && std::abs(z) < 0.3 ? 2.5 : 4 + 0.02 * unit(random);
        text += numberText("%.6f", x) + " " + numberText("%.6f", y) + " " + numberText("%.6f", z) + "\n";
    }
    const auto scan = files::readScanBytes(std::as_bytes(std::span(text)), ".xyz", {});
    EXPECT_TRUE(scan && !scan->attached.empty()) << (scan ? "no point is attached" : scan.error().sentence());
    return scan ? *scan : Scan{};
}

Scan oneOf(Scan scan, const std::function<bool(int, int)>& keeps) {
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (keeps(i, j)) continue;
            scan.state.at(i, j) = CellState::NoReturn;
            scan.rangeMm.at(i, j) = 0;
        }
    }
    return scan;
}

Scan inMine(Scan scan, unsigned seed) {
    scan.placement = randomPlacement(seed, seed % 2 == 0 ? scan.lines() : 1, seed % 2 == 0);
    return scan;
}

std::map<std::string, Scan> kinds() {
    std::map<std::string, Scan> all{{"spin", spin()},
                                    {"tilt", tilt()},
                                    {"interlaced", interlaced()},
                                    {"two steps", twoSteps()},
                                    {"camera", camera(Eigen::Vector3d::Zero())},
                                    {"camera elsewhere", camera({0.5, 0.25, -0.125})},
                                    {"tripod", tripod()},
                                    {"every return", makeScan({.beamStart = 40, .noReturns = 0})}};
    std::map<std::string, Scan> bordered;
    for (const auto& [name, scan] : all) bordered[name + ", border without return"] = withEmptyBorder(scan);
    all.merge(bordered);
    all["projected"] = projected();
    all["one line"] = makeScan({.lines = 1});
    all["one beam"] = makeScan({.beams = 1});
    all["one line with a return"] = oneOf(tilt(), [](int i, int) { return i == 7; });
    all["one beam with a return"] = oneOf(tilt(), [](int, int j) { return j == 11; });
    all["one return"] = oneOf(tilt(), [](int i, int j) { return i == 7 && j == 11; });
    all["tilt in the mine"] = inMine(withEmptyBorder(tilt()), 4);
    all["spin in the mine"] = inMine(withEmptyBorder(spin()), 3);
    all["camera in the mine"] = inMine(withEmptyBorder(camera({0.5, 0.25, -0.125})), 5);
    all["tripod in the mine"] = inMine(withEmptyBorder(tripod()), 7);
    for (auto& [name, scan] : all) scan.path = "/scans/made.pcd";
    return all;
}

/// Of coordinates in a file, in millimetres.
double roundingMm(const std::filesystem::path& path, CoordinateFrame frame) {
    if (path.extension() == ".las") return 0.9;
    if (frame == CoordinateFrame::Mine) return 0.2;       // four decimals
    if (frame == CoordinateFrame::MineLocal) return 0.03; // 4-byte floats of a hundred metres
    return 0.002;
}

/// What of `opened` is not as in `saved`; empty when it is the same grid with the same points, up to the rounding of the file.
std::string difference(const Scan& saved, const Scan& opened, double mostMm, bool exact) {
    if (saved.lines() != opened.lines() || saved.beams() != opened.beams())
        return "opens as " + std::to_string(opened.lines()) + " x " + std::to_string(opened.beams()) + " cells";
    std::size_t states = 0, ranges = 0;
    for (std::size_t k = 0; k < saved.cells(); ++k) {
        const bool valid = saved.state[k] == CellState::Valid;
        states += valid != (opened.state[k] == CellState::Valid) ? 1 : 0;
        ranges += valid && std::abs(saved.rangeMm[k] - opened.rangeMm[k]) > mostMm ? 1 : 0;
    }
    if (states > 0) return std::to_string(states) + " cells have another state";
    if (ranges > 0) return std::to_string(ranges) + " ranges differ";
    if (exact && *edges::detectEdges(std::make_shared<const Scan>(saved), {})->mask !=
                     *edges::detectEdges(std::make_shared<const Scan>(opened), {})->mask)
        return "other edges";
    return {};
}

/// How far a point is from where it was, in millimetres.
double farthestMm(const Scan& saved, const Scan& opened) {
    const CartesianTables a(saved), b(opened);
    double farthest = 0;
    for (std::size_t k = 0; k < saved.cells(); ++k) {
        if (saved.state[k] == CellState::Valid) farthest = std::max(farthest, (a.point(k) - b.point(k)).norm() * 1000);
    }
    return farthest;
}

/// Files that hold every cell, its state and the place of the scan hold them in every frame.
void expectSameScan(const Scan& saved, const Scan& opened, const ExportOptions& options, bool exact) {
    EXPECT_EQ(saved.state, opened.state);
    for (std::size_t k = 0; k < saved.cells(); ++k) {
        if (saved.state[k] != CellState::Valid) continue;
        ASSERT_EQ(saved.rangeMm[k], opened.rangeMm[k]) << "cell " << k;
    }
    ASSERT_EQ(bool(saved.placement), bool(opened.placement));
    if (saved.placement) {
        EXPECT_EQ(placementToJson(*saved.placement).dump(), placementToJson(*opened.placement).dump());
    }
    if (options.frame != CoordinateFrame::Scanner || exact) {
        EXPECT_EQ(farthestMm(saved, opened), 0);
    }
}

bool beamsStartApart(const Scan& scan) {
    const PlacedPoints placed(scan);
    const Eigen::Vector3d first = placed.local(0, 0, Eigen::Vector3d::Zero());
    for (int line = 0; line < scan.lines(); ++line) {
        if ((placed.local(line, 0, Eigen::Vector3d::Zero()) - first).norm() > 0.0005) return true;
    }
    return false;
}

bool speaksOfGrid(const std::vector<std::string>& warnings) {
    return std::ranges::any_of(warnings, [](const std::string& text) {
        return text.find("grid") != std::string::npos || text.find("projected") != std::string::npos ||
               text.find("not in it") != std::string::npos;
    });
}

struct Count {
    int same = 0, warned = 0, refusedToOpen = 0, refusedToSave = 0;
};

void saveAndOpen(const Scan& scan, const std::filesystem::path& path, const ExportOptions& options, Count& count) {
    edges::Detection detection;
    detection.scan = std::make_shared<const Scan>(scan);
    if (const auto saved = exportWithProvenance(ExportContent::WholeScan, detection, path, options); !saved) {
        EXPECT_FALSE(saved.error().hint.empty()) << saved.error().sentence();
        ++count.refusedToSave;
        return;
    }
    if (path.extension() == ".dxf") return; // a drawing, which is not opened as a scan
    // A micrometre more or less decides on an edge here and there.
    const bool exact =
        options.frame == CoordinateFrame::Scanner && path.extension() != ".las" && path.extension() != ".ptx" && path.extension() != ".obj";
    for (const bool record : {true, false}) {
        // PTX alone holds one place of the scanner for all lines, and says so when it is written.
        if (!record && path.extension() == ".ptx" && options.frame != CoordinateFrame::Scanner) {
            const auto lost = files::lostOnSaving(scan, path, {.frame = options.frame, .includeAttached = options.includeAttached});
            EXPECT_EQ(
                std::ranges::any_of(lost, [](const std::string& s) { return s.find("one place of the scanner") != std::string::npos; }),
                scan.placement && beamsStartApart(scan));
            continue;
        }
        SCOPED_TRACE(record ? "with its record" : "without its record");
        if (!record) std::filesystem::remove(files::sidecarPath(path));
        const auto opened = files::openScan(path);
        if (!opened) {
            EXPECT_FALSE(record) << opened.error().sentence();
            EXPECT_FALSE(opened.error().hint.empty()) << opened.error().sentence();
            ++count.refusedToOpen;
            continue;
        }
        const bool list = options.includeAttached && !scan.attached.empty();
        if (files::writtenFormat(path)->keeps == files::Keeps::States && !list) expectSameScan(scan, *opened, options, exact);
        const std::string other = difference(scan, *opened, roundingMm(path, options.frame), exact);
        if (other.empty()) {
            ++count.same;
            if (record) {
                EXPECT_LT(farthestMm(scan, *opened), 0.01 + roundingMm(path, options.frame));
            }
            continue;
        }
        EXPECT_FALSE(record) << other;
        EXPECT_TRUE(speaksOfGrid(opened->warnings)) << other << ", and no warning says so";
        ++count.warned;
    }
}

} // namespace

TEST(EveryGrid, OpensAsTheSameGridFromEveryFormatOrAWarningSaysWhatWasLost) {
    const Folder folder;
    for (const auto& [name, scan] : kinds()) {
        Count count;
        for (const files::Format& format : files::formats()) {
            for (const char* extension : format.writes) {
                for (const CoordinateFrame frame : {CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine}) {
                    if (frame != CoordinateFrame::Scanner && !scan.placement) continue;
                    for (const bool comments : {false, true}) {
                        if (comments && format.keeps != files::Keeps::Sidecar) continue;
                        for (const bool attached : {false, true}) {
                            if (attached && scan.attached.empty()) continue;
                            SCOPED_TRACE(name + " as " + extension + " in frame " + std::to_string(static_cast<int>(frame)) +
                                         (comments ? " with comments" : "") + (attached ? " with attached points" : ""));
                            const auto path = folder / (std::string("scan") + extension);
                            saveAndOpen(scan, path, {.frame = frame, .includeAttached = attached, .choices = {.comments = comments}},
                                        count);
                            std::filesystem::remove(path);
                        }
                    }
                }
            }
        }
        EXPECT_GT(count.same, 12) << name;
        RecordProperty(name, std::to_string(count.same) + " same, " + std::to_string(count.warned) + " warned, " +
                                 std::to_string(count.refusedToOpen) + " refused, " + std::to_string(count.refusedToSave) + " not saved");
    }
}

TEST(EveryGrid, PointsOfEdgesOpenInTheirCells) {
    const Folder folder;
    for (const auto& [name, scan] : kinds()) {
        const auto detection = edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
        if (detection->edges->empty()) continue;
        for (const char* extension : {".pcd", ".ply", ".csv", ".xyz", ".obj", ".las"}) {
            for (const CoordinateFrame frame : {CoordinateFrame::Scanner, CoordinateFrame::Mine}) {
                if (frame != CoordinateFrame::Scanner && !scan.placement) continue;
                SCOPED_TRACE(name + " as " + extension + " in frame " + std::to_string(static_cast<int>(frame)));
                const auto path = folder / (std::string("edges") + extension);
                const auto saved = exportWithProvenance(ExportContent::EdgeCloud, *detection, path, {.frame = frame});
                ASSERT_TRUE(saved) << saved.error().sentence();
                const auto opened = files::openScan(path);
                ASSERT_TRUE(opened) << opened.error().sentence();
                ASSERT_EQ(opened->cells(), scan.cells());
                std::size_t others = 0;
                for (std::size_t k = 0; k < scan.cells(); ++k)
                    others += ((*detection->mask)[k] != 0) != (opened->state[k] == CellState::Valid) ? 1 : 0;
                EXPECT_EQ(others, 0U);
            }
        }
    }
}

TEST(EveryGrid, CloudsOfARealCameraKeepTheirEdges) {
    EDGESCAN_NEEDS_SHARED("data/mosd_kinect");
    const Folder folder;
    const auto scan = files::openScan(sharedFolder() / "data/mosd_kinect/test16.pcd");
    ASSERT_TRUE(scan) << scan.error().sentence();
    Count count;
    for (const char* extension : {".csv", ".xyz", ".obj", ".pcd"}) {
        SCOPED_TRACE(extension);
        saveAndOpen(*scan, folder / (std::string("camera") + extension), {}, count);
    }
    EXPECT_GE(count.same, 5);
}
