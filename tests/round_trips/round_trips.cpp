// Prints which cells of a scan are recovered from a bare list of its points: format x rounding x order x thinning
// (docs/measurements/round-trips.md).
#include "tests/support/point_round_trip.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace edgescan;
using namespace edgescan::test;

namespace {

/// A scan with every second line or beam left out.
Scan thinnedGrid(const Scan& scan, int everyLine, int everyBeam) {
    Scan half = scan;
    auto& polar = std::get<PolarGeometry>(half.geometry);
    const auto from = std::get<PolarGeometry>(scan.geometry);
    const int lines = (scan.lines() + everyLine - 1) / everyLine;
    const int beams = (scan.beams() + everyBeam - 1) / everyBeam;
    half.rangeMm = Grid<float>(lines, beams);
    half.state = Grid<CellState>(lines, beams);
    polar.lineDeg.clear();
    polar.beamDeg.clear();
    for (int i = 0; i < lines; ++i) polar.lineDeg.push_back(from.lineDeg[static_cast<std::size_t>(i * everyLine)]);
    for (int j = 0; j < beams; ++j) polar.beamDeg.push_back(from.beamDeg[static_cast<std::size_t>(j * everyBeam)]);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            half.rangeMm.at(i, j) = scan.rangeMm.at(i * everyLine, j * everyBeam);
            half.state.at(i, j) = scan.state.at(i * everyLine, j * everyBeam);
        }
    }
    return half;
}

/// A scan with a place is written where it is; 4-byte floats hold metres from an origin.
CoordinateFrame frameOf(const Scan& scan, const std::string& format) {
    if (!scan.placement) return CoordinateFrame::Scanner;
    return format == "pcd" ? CoordinateFrame::MineLocal : CoordinateFrame::Mine;
}

void print(const std::string& name, const Scan& scan, const std::vector<const char*>& formats, const std::vector<int>& decimals,
           const Eigen::Vector3d& sensorM, bool verbose) {
    for (const char* format : formats) {
        for (const int places : decimals) {
            for (const bool shuffled : {false, true}) {
                if (shuffled && scan.placement) continue; // without an order the axis is not found
                for (const double thinned : {0.0, 0.05}) {
                    const CameBack back = roundTrip(scan, {format, places, shuffled, thinned, sensorM, frameOf(scan, format)});
                    std::printf("| %s | %s | %g mm | %s | %g %% | ", name.c_str(), format, 1000 * std::pow(10.0, -places),
                                shuffled ? "shuffled" : "in order", 100 * thinned);
                    if (!back.problem.empty())
                        std::printf("%s |\n", back.problem.c_str());
                    else
                        std::printf("%d x %d | %zu of %zu | %zu | %zu | %zu | %zu of %zu (%.3f %%) | %zu |", back.lines, back.beams,
                                    back.lost, back.written, back.unclear, back.moved, back.movedClear, back.differ, back.edges,
                                    100.0 * static_cast<double>(back.differ) / static_cast<double>(std::max<std::size_t>(1, scan.cells())),
                                    back.differRounded);
                    if (verbose && back.problem.empty()) {
                        std::printf(" %.2f s", back.seconds);
                        std::printf("%s%s", back.turnedLines ? " lines turned" : "", back.turnedBeams ? " beams turned" : "");
                        for (std::size_t e = 0; e < back.examples.size() && e < 12; ++e)
                            std::printf(" (%g,%g: %g->%g)", back.examples[e][0], back.examples[e][1], back.examples[e][2],
                                        back.examples[e][3]);
                        for (const std::string& w : back.warnings) std::printf("\n      %s", w.c_str());
                    }
                    if (back.problem.empty()) std::printf("\n");
                    std::fflush(stdout);
                }
            }
        }
    }
}

std::vector<std::string> wordsIn(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

} // namespace

// Scans with a place are written in the mine grid.
// round_trips [-v] [--formats xyz,las] [--decimals 3,4] [--half] [--sensor X,Y,Z] SCAN...
int main(int argc, char** argv) {
    bool verbose = false;
    int everyLine = 1, everyBeam = 1;
    std::vector<std::string> formatNames{"xyz", "csv", "las", "pcd", "ply"};
    std::vector<int> decimals{3, 4, 5};
    Eigen::Vector3d sensorM = Eigen::Vector3d::Zero();
    std::vector<std::string> files;
    for (int a = 1; a < argc; ++a) {
        const std::string word = argv[a];
        const auto next = [&] { return std::string(a + 1 < argc ? argv[++a] : ""); };
        if (word == "-v") {
            verbose = true;
        } else if (word == "--formats") {
            formatNames = wordsIn(next());
        } else if (word == "--decimals") {
            decimals.clear();
            for (const std::string& places : wordsIn(next())) decimals.push_back(std::atoi(places.c_str()));
        } else if (word == "--every") {
            const auto every = wordsIn(next());
            everyLine = std::atoi(every.at(0).c_str());
            everyBeam = std::atoi(every.at(1).c_str());
        } else if (word == "--sensor") {
            const auto place = wordsIn(next());
            for (int axis = 0; axis < 3; ++axis) sensorM[axis] = std::atof(place.at(static_cast<std::size_t>(axis)).c_str());
        } else {
            files.push_back(word);
        }
    }
    std::vector<const char*> formats;
    for (const std::string& name : formatNames) formats.push_back(name.c_str());
    if (!verbose)
        std::puts(
            "| scan | format | rounded to | order | thinned by | grid found | points without a cell | points whose line rounding hides | "
            "cells with another range | avoidable | mask cells that differ, of edge cells (share of all cells) | by rounding alone |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|---|");
    for (const std::string& file : files) {
        auto scan = files::openScan(file);
        if (!scan) {
            std::fprintf(stderr, "%s\n", scan.error().sentence().c_str());
            return 1;
        }
        const bool polar = std::holds_alternative<PolarGeometry>(scan->geometry);
        const std::string name =
            scan->name + (everyLine * everyBeam > 1 ? " /" + std::to_string(everyLine) + "," + std::to_string(everyBeam) : "");
        print(name, polar ? thinnedGrid(*scan, everyLine, everyBeam) : *scan, formats, decimals, sensorM, verbose);
    }
    return 0;
}
