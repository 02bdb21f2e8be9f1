// The cost of the methods relative to each other, as ratios measured in one run: the source of docs/measurements/performance.md.
// edgescan-bench
// [--short] [--rounds N] [--millions 1,4,18,73] [--previous EDGESCAN-CLI] [--peers]
// edgescan-bench --write MILLIONS SCAN.json: only writes the scan of this size.
// --short: a million cells, processor time only; exits with 1 if a ratio is more than a third worse than the one on record.
#include "app/lab/peers/comparison.h"
#include "app/lab/sim/simulate.h"
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/edge_count_curve.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/edges/settings/slider_scale.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/opencv_view.h"
#include "tests/bench/goals.h"
#include "tests/bench/naive_thesis.h"
#include "tests/bench/programs.h"
#include "tests/bench/sliders.h"
#include "tests/bench/timing.h"
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <opencv2/imgproc.hpp>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

using namespace edgescan;
using namespace edgescan::bench;

namespace {

struct Wanted {
    bool isShort = false;
    bool peers = false;
    int rounds = 9;
    std::vector<int> millions{1};
    std::string previous;
};

constexpr Goal kPlusToThesis{"EdgeScan+, one thread / thesis's recipe in plain OpenCV", Good::AtMost, 4, 6.2, 8};
constexpr Goal kPlusWallToThesis{"EdgeScan+, two threads / thesis's recipe in plain OpenCV, wall", Good::AtMost, 2.3, 3.3};
constexpr Goal kTwoThreads{"EdgeScan+, one thread / two threads, wall", Good::AtLeast, 1.6, 1.7};
constexpr Goal kCurve{"edge-count curve / full EdgeScan+", Good::AtMost, 2, 1.4};
constexpr Goal kNaive{"naive / thesis's recipe, ranges to index + XYZ + label", Good::AtLeast, 60, 22, 20};
constexpr Goal kOpenCvAvx2{"plain OpenCV / edge map, avx2", Good::AtLeast, 4, 2.2, 1.75};
constexpr Goal kOpenCvAvx512{"plain OpenCV / edge map, avx512", Good::AtLeast, 7, 2.8};
constexpr Goal kOpenCvSse{"plain OpenCV / edge map, sse4.2", Good::AtLeast, 1, 1.6, 1.4};
constexpr Goal kOpenCvAny{"plain OpenCV / edge map, plain", Good::AtLeast, 1, 1.5, 1.3};
// 26 to 47 so far: a run of 0.1 ms depends on what the caches hold.
constexpr Goal kThreshold{"threshold slider: cv::Canny on the cached blur / ours", Good::AtLeast, 15, 28};
constexpr Goal kAvx2ToAvx512{"EdgeScan+ responses, avx2 / avx512", Good::AtMost, 1.5, 1.5};
constexpr Goal kSseToAvx2{"EdgeScan+ responses, sse4.2 / avx2", Good::AtMost, 2.2, 2.2};
constexpr Goal kThesisProcess{"raw grid to edge PCD, thesis's recipe / --version", Good::AtMost, 3, 4.1};
constexpr Goal kPcdWritten{"PCD written from a raw grid / sha256sum and cp of it", Good::AtMost, 1.3, 1};
constexpr Goal kPcdRead{"PCD read / sha256sum and cp of it", Good::AtMost, 2, 0.55};
constexpr Goal kTextRead{"text cloud read / sha256sum and cp of it", Good::AtMost, 2, 0.7};
constexpr Goal kE57Read{"E57 without angles read / sha256sum and cp of it", Good::AtMost, 2, 13};
constexpr Goal kBoundary{"PCL BoundaryEstimation k=30 / EdgeScan+", Good::AtLeast, 400, 300};
constexpr Goal kOrganized{"PCL OrganizedEdgeFromNormals / EdgeScan+", Good::AtLeast, 3, 3};

const Goal& openCvGoal(const std::string& name) {
    for (const Goal* goal : {&kOpenCvAvx2, &kOpenCvAvx512, &kOpenCvSse}) {
        if (std::string(goal->what).ends_with(name)) return *goal;
    }
    return kOpenCvAny;
}

// A sweep of scale^2 million cells: the bell and its mirror images next to each other, so that a seam is never an edge.
Scan enlarged(const Scan& scan, int scale) {
    if (scale == 1) return scan;
    const auto folded = [](int i, int n) { return (i / n) % 2 == 0 ? i % n : n - 1 - i % n; };
    const auto& from = std::get<PolarGeometry>(scan.geometry);
    Scan large;
    large.rangeMm = Grid<float>(scale * scan.lines(), scale * scan.beams());
    large.state = Grid<CellState>(large.lines(), large.beams());
    PolarGeometry polar = from;
    polar.beamDeg.resize(static_cast<std::size_t>(large.beams()));
    polar.lineDeg.resize(static_cast<std::size_t>(large.lines()));
    for (std::size_t j = 0; j < polar.beamDeg.size(); ++j)
        polar.beamDeg[j] = from.beamDeg[0] + static_cast<double>(j) * (from.beamDeg[1] - from.beamDeg[0]);
    for (std::size_t i = 0; i < polar.lineDeg.size(); ++i)
        polar.lineDeg[i] = from.lineDeg[0] + static_cast<double>(i) * (from.lineDeg[1] - from.lineDeg[0]);
    large.geometry = polar;
    for (int i = 0; i < large.lines(); ++i) {
        for (int j = 0; j < large.beams(); ++j) {
            large.rangeMm.at(i, j) = scan.rangeMm.at(folded(i, scan.lines()), folded(j, scan.beams()));
            large.state.at(i, j) = scan.state.at(folded(i, scan.lines()), folded(j, scan.beams()));
        }
    }
    return large;
}

Grid<std::uint8_t> thesisMask(const Scan& scan, const edges::Settings& thesis) {
    return edges::canny(edges::smooth(edges::grayImage(scan, thesis).levels, thesis), thesis);
}

Grid<std::uint8_t> edgeMapBy(InstructionSet set, const Scan& scan, const edges::Settings& thesis) {
    Grid<std::uint8_t> levels(scan.lines(), scan.beams());
    edges::levelsBy(set, scan.rangeMm, scan.state, edges::linearLevels(edges::grayScale(scan, thesis)), levels);
    return edges::cannyBy(set, edges::smoothBy(set, levels, thesis), thesis);
}

// The thesis's recipe in as few lines of OpenCV as possible.
cv::Mat plainOpenCv(const Scan& scan, const edges::Settings& thesis) {
    const cv::Mat ranges(scan.lines(), scan.beams(), CV_32F, const_cast<float*>(scan.rangeMm.cells.data()));
    double least = 0, most = 0;
    cv::minMaxLoc(ranges, &least, &most, nullptr, nullptr, ranges > 0);
    cv::Mat gray, blurred, edges;
    ranges.convertTo(gray, CV_8U, 255.0 / (most - least));
    cv::GaussianBlur(gray, blurred, {thesis.kernel, thesis.kernel}, 0);
    cv::Canny(blurred, edges, thesis.lower, thesis.upper());
    return edges;
}

cv::Mat cvCanny(const Grid<std::uint8_t>& blurred, const edges::Settings& thesis) {
    cv::Mat edges;
    cv::Canny(asMat(blurred), edges, thesis.lower, thesis.upper());
    return edges;
}

// The valid cells: index, position and label of each. The memory is not cleared before it is written.
struct LabelledCloud {
    std::size_t points = 0;
    std::unique_ptr<std::uint32_t[]> index;
    std::unique_ptr<float[]> x, y, z;
    std::unique_ptr<std::uint8_t[]> label;

    explicit LabelledCloud(std::size_t most)
        : index(new std::uint32_t[most]), x(new float[most]), y(new float[most]), z(new float[most]), label(new std::uint8_t[most]) {}
};
constexpr int kAtOnce = 16; // cells

// Adds a line's valid cells; many at once if all of them are valid.
void addLine(LabelledCloud& cloud, const std::vector<float>& xyz, const CellState* states, const std::uint8_t* labels, int beams,
             std::uint32_t first) {
    const float *const x = xyz.data(), *const y = x + beams, *const z = y + beams;
    std::size_t n = cloud.points;
    const auto add = [&](int j) {
        cloud.x[n] = x[j];
        cloud.y[n] = y[j];
        cloud.z[n] = z[j];
        cloud.label[n] = labels[j];
        cloud.index[n] = first + static_cast<std::uint32_t>(j);
        n += states[j] == CellState::Valid ? 1U : 0U;
    };
    int j = 0;
    for (; j + kAtOnce <= beams; j += kAtOnce) {
        std::array<std::uint64_t, 2> eight;
        std::memcpy(eight.data(), states + j, kAtOnce);
        static_assert(static_cast<int>(CellState::Valid) == 0);
        if ((eight[0] | eight[1]) != 0) {
            for (int m = j; m < j + kAtOnce; ++m) add(m);
            continue;
        }
        std::memcpy(cloud.x.get() + n, x + j, kAtOnce * sizeof(float));
        std::memcpy(cloud.y.get() + n, y + j, kAtOnce * sizeof(float));
        std::memcpy(cloud.z.get() + n, z + j, kAtOnce * sizeof(float));
        std::memcpy(cloud.label.get() + n, labels + j, kAtOnce);
        std::uint32_t* const index = cloud.index.get() + n;
        for (int m = 0; m < kAtOnce; ++m) index[m] = first + static_cast<std::uint32_t>(j + m);
        n += kAtOnce;
    }
    for (; j < beams; ++j) add(j);
    cloud.points = n;
}

LabelledCloud labelledCloud(const Scan& scan, const edges::Settings& thesis) {
    const Grid<std::uint8_t> mask = thesisMask(scan, thesis);
    const CartesianTables tables(scan);
    LabelledCloud cloud(scan.cells() + 1); // cells that are not valid are written behind the last entry
    const auto beams = static_cast<std::size_t>(scan.beams());
    std::vector<float> xyz(3 * beams);
    for (int i = 0; i < scan.lines(); ++i) {
        tables.pointsOfLine(i, xyz.data(), xyz.data() + beams, xyz.data() + 2 * beams);
        addLine(cloud, xyz, scan.state.line(i), mask.line(i), scan.beams(), static_cast<std::uint32_t>(scan.rangeMm.index(i, 0)));
    }
    return cloud;
}

// Measures full runs and the gray path at one size.
void measureSize(const Scan& scan, int rounds, bool walls, Table& table) {
    const edges::Settings thesis = edges::findPreset("thesis")->settings;
    const edges::Settings plus;
    const Grid<std::uint8_t> blurred = edges::smooth(edges::grayImage(scan, thesis).levels, thesis);
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(scan), thesis);
    const edges::SweptEdges swept(edges::thresholdMapOf(*detection));
    const auto plusDetection = edges::detectEdges(std::make_shared<const Scan>(scan), plus);
    enum { kThesis, kOneThread, kTwo, kPlain, kSweptCanny, kSweptOurs, kCloud, kCounts };
    std::vector<Candidate> runs{{"thesis's recipe, ours", [&] { (void)edges::edgeCells(thesisMask(scan, thesis)); }},
                                {"EdgeScan+, one thread", [&] { runPlus(scan, 1); }},
                                {"EdgeScan+, two threads", [&] { runPlus(scan, 2); }},
                                {"plain OpenCV", [&] { (void)plainOpenCv(scan, thesis); }},
                                {"cv::Canny on the cached blur", [&] { (void)cvCanny(blurred, thesis); }},
                                {"sorted threshold map at a threshold", [&] { (void)swept.at(thesis.lower); }},
                                {"thesis's recipe, to labelled points", [&] { (void)labelledCloud(scan, thesis); }},
                                {"edge-count curve of EdgeScan+", [&] {
                                     (void)edges::edgeCountCurve(*plusDetection, edges::sliderValues(edges::sweptParameter(plus.method)));
                                 }}};
    const std::size_t firstLoops = runs.size(); // by each instruction set; the limits of the ranges by the widest
    for (const InstructionSet set : kInstructionSets) {
        if (!isHere(set)) continue;
        runs.push_back({std::string("edge map, ") + nameOf(set), [&, set] { (void)edgeMapBy(set, scan, thesis); }});
    }
    const std::size_t naive = runs.size();
    if (scan.cells() < 2000000) runs.push_back({"naive, to labelled points", [&] { (void)naiveThesis(scan, 10); }});
    measureInTurn(runs, rounds);
    const auto cpu = [&](std::size_t n) { return medianOf(runs[n].cpuMs); };
    const auto wall = [&](std::size_t n) { return medianOf(runs[n].wallMs); };
    const std::string title = std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams";
    table.begin(title.c_str());
    table.row(kPlusToThesis, cpu(kOneThread) / cpu(kPlain));
    if (walls) { // other processes on the machine would disturb wall times
        table.row(kPlusWallToThesis, wall(kTwo) / wall(kPlain));
        table.row(kTwoThreads, wall(kOneThread) / wall(kTwo));
    }
    table.row(kCurve, cpu(kCounts) / cpu(kOneThread));
    for (std::size_t n = firstLoops; n < naive; ++n) table.row(openCvGoal(runs[n].name), cpu(kPlain) / cpu(n));
    table.row(kThreshold, cpu(kSweptCanny) / cpu(kSweptOurs));
    if (runs.size() > naive) table.row(kNaive, cpu(naive) / cpu(kCloud));
    printCandidates(runs, scan);
}

// The loops of a process are of one instruction set: this program measures the scan of a file and prints its milliseconds.
int printResponses(const char* path) {
    const auto scan = files::openScan(path);
    if (!scan) return 2;
    const edges::Settings plus;
    std::vector<Candidate> runs{{"", [&] { (void)edges::depthResponses(edges::depthSurface(*scan, plus, 1), plus, nullptr, 1); }}};
    measureInTurn(runs, 5);
    std::printf("%.6f\n", medianOf(runs[0].cpuMs));
    return 0;
}

std::optional<double> responsesMs(InstructionSet set, const std::string& path) {
    const std::string command =
        std::string("EDGESCAN_LOOPS=") + nameOf(set) + " " + test::programFolder() + "/edgescan-bench --responses " + path;
    FILE* const program = popen(command.c_str(), "r");
    double ms = 0;
    const bool isRead = program != nullptr && std::fscanf(program, "%lf", &ms) == 1;
    if (program != nullptr) pclose(program);
    return isRead ? std::optional(ms) : std::nullopt;
}

void measureInstructionSets(const Scan& scan, int rounds, Table& table) {
    const test::TemporaryFolder folder;
    const std::string path = (folder / "scan.json").string();
    if (!files::saveScan(scan, path)) return;
    std::array<std::vector<double>, kInstructionSets.size()> all;
    for (int round = 0; round < rounds; ++round) {
        for (const InstructionSet set : kInstructionSets) {
            if (!isHere(set)) continue;
            if (const auto ms = responsesMs(set, path)) all[static_cast<std::size_t>(set)].push_back(*ms);
        }
    }
    const auto ms = [&](InstructionSet set) { return medianOf(all[static_cast<std::size_t>(set)]); };
    table.begin("EdgeScan+ responses by instruction set");
    if (isHere(InstructionSet::Avx512)) table.row(kAvx2ToAvx512, ms(InstructionSet::Avx2) / ms(InstructionSet::Avx512));
    if (isHere(InstructionSet::Avx2)) table.row(kSseToAvx2, ms(InstructionSet::Sse42) / ms(InstructionSet::Avx2));
    std::printf("\n| instruction set | thread CPU, ms |\n|---|---|\n");
    for (const InstructionSet set : kInstructionSets)
        if (isHere(set)) std::printf("| %s | %.2f |\n", nameOf(set), ms(set));
}

void measurePeers(const Scan& scan, Table& table) {
    lab::ComparisonSettings settings;
    settings.only = {"edgescan+"};
    const auto methods = lab::compareMethods(std::make_shared<const Scan>(scan), nullptr, settings);
    double ours = 0;
    for (const lab::ComparedMethod& method : methods) {
        if (method.key == "edgescan+") ours = method.steps.total();
    }
    table.begin("PCL's detectors on the same scan");
    for (const lab::ComparedMethod& method : methods) {
        if (method.settings || !method.wasRun() || ours == 0) continue;
        const double ratio = method.steps.total() / method.share / ours;
        if (method.name == lab::pclMethodName(lab::PclMethod::BoundaryNeighbours))
            table.row(kBoundary, ratio);
        else if (method.name == lab::pclMethodName(lab::PclMethod::OrganizedEdge))
            table.row(kOrganized, ratio);
        else
            std::printf("| %s / EdgeScan+ | %.2f | | |\n", method.name.c_str(), ratio);
    }
}

void measurePrograms(const Scan& scan, const Wanted& wanted, Table& table) {
    const std::string present = test::programFolder() + "/edgescan-cli";
    const WholeRatios ratios = wholeRatios(present, scan, wanted.rounds);
    table.begin("Whole programs");
    table.row(kThesisProcess, ratios.thesisToVersion);
    table.row(kPcdWritten, ratios.pcdWritten);
    table.row(kPcdRead, ratios.pcdRead);
    table.row(kTextRead, ratios.textRead);
    table.row(kE57Read, ratios.e57Read);
    if (wanted.previous.empty()) return;
    std::printf("\n## Whole programs: previous / present\n\n| | CPU | wall | present, CPU ms |\n|---|---|---|---|\n");
    for (const ProgramRow& row : programRows(wanted.previous, present, scan, wanted.rounds))
        std::printf("| %s | %.2f | %.2f | %.1f |\n", row.what.c_str(), row.cpuRatio, row.wallRatio, row.presentMs);
}

std::optional<Wanted> wantedOf(int argc, char** argv) {
    Wanted wanted;
    for (int n = 1; n < argc; ++n) {
        const std::string word = argv[n];
        const bool hasValue = n + 1 < argc;
        if (word == "--short") {
            wanted.isShort = true;
        } else if (word == "--peers") {
            wanted.peers = true;
        } else if (word == "--previous" && hasValue) {
            wanted.previous = argv[++n];
        } else if (word == "--rounds" && hasValue) {
            wanted.rounds = std::max(1, std::atoi(argv[++n]));
        } else if (word == "--millions" && hasValue) {
            wanted.millions.clear();
            const char* at = argv[++n];
            const char* const end = at + std::strlen(at);
            for (int value = 0; at < end; ++at) {
                at = std::from_chars(at, end, value).ptr;
                wanted.millions.push_back(value);
            }
        } else {
            return std::nullopt;
        }
    }
    return wanted;
}

// For the viewer's table of make-performance: with smaller steps, so that all angles are those of one turn.
int writeScan(int scale, const char* path) {
    const auto simulated = sim::simulate(sim::SimulationSettings{});
    if (!simulated) return 2;
    Scan large = enlarged(simulated->scan, scale);
    auto& polar = std::get<PolarGeometry>(large.geometry);
    for (std::vector<double>* angles : {&polar.beamDeg, &polar.lineDeg}) {
        for (double& angle : *angles) angle = angles->front() + (angle - angles->front()) / scale;
    }
    return files::saveScan(large, path) ? 0 : 2;
}

int scaleOf(int millions) { return millions >= 73 ? 8 : millions >= 18 ? 4 : millions >= 4 ? 2 : 1; }

} // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string(argv[1]) == "--responses") return printResponses(argv[2]);
    if (argc == 4 && std::string(argv[1]) == "--write") return writeScan(scaleOf(std::atoi(argv[2])), argv[3]);
    const auto wanted = wantedOf(argc, argv);
    if (!wanted) {
        std::fprintf(stderr, "edgescan-bench [--short] [--rounds N] [--millions 1,4,18,73] [--previous EDGESCAN-CLI] [--peers]\n");
        return 2;
    }
    if (const auto set = wantedInstructionSet(); !set) {
        std::fprintf(stderr, "edgescan-bench: %s\n", set.error().sentence().c_str());
        return 2;
    }
    cv::setNumThreads(0);
    const auto simulated = sim::simulate(sim::SimulationSettings{});
    if (!simulated) {
        std::fprintf(stderr, "edgescan-bench: %s\n", simulated.error().sentence().c_str());
        return 2;
    }
    Table table;
    for (const int millions : wanted->isShort ? std::vector<int>{1} : wanted->millions) {
        const int scale = scaleOf(millions);
        const int rounds = std::max(std::min(3, wanted->rounds), wanted->rounds / scale);
        const Scan scan = enlarged(simulated->scan, scale);
        measureSize(scan, rounds, !wanted->isShort, table);
        measureSliders(scan, rounds, table);
    }
    measureInstructionSets(simulated->scan, wanted->isShort ? 3 : wanted->rounds, table);
    if (!wanted->isShort && wanted->peers) measurePeers(simulated->scan, table);
    if (!wanted->isShort) measurePrograms(simulated->scan, *wanted, table);
    return wanted->isShort && !table.areAllHeld() ? 1 : 0;
}
