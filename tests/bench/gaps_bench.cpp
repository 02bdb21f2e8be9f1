// Compares filled gaps with the simulator's truth, and with nearest, bilinear and OpenCV's inpainting: tables for
// docs/measurements/gaps.md. build/release/bin/edgescan_gaps_bench [SEED...]; half grids of both bells. edgescan_gaps_bench --many FIRST
// COUNT: this many seeds of both, grids of 250 lines x 286 beams.
#include "app/lab/score/evaluation.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "tests/support/scored_scene.h"

#include <opencv2/core.hpp>
#include <opencv2/photo.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace edgescan;
using edgescan::test::scoredScene;

namespace {

constexpr int kBlobs = 400;
constexpr int kWidest = 8; // cells of --fill
constexpr double kFarOffMm = 100;

// Removes the ranges of round blobs with a diameter of `size` cells; returns the blob of each cell, 0 = not in a blob.
Grid<int> dropBlobs(Scan& scan, int size, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Grid<int> blob(scan.lines(), scan.beams());
    for (int n = 1; n <= kBlobs; ++n) {
        const auto line = static_cast<int>(random() % static_cast<std::uint64_t>(scan.lines()));
        const auto beam = static_cast<int>(random() % static_cast<std::uint64_t>(scan.beams()));
        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                const double y = i - 0.5 * (size - 1), x = j - 0.5 * (size - 1);
                if (x * x + y * y > 0.27 * size * size + 0.25 || !blob.contains(line + i, beam + j)) continue;
                blob.at(line + i, beam + j) = n;
                scan.state.at(line + i, beam + j) = CellState::NoReturn;
                scan.rangeMm.at(line + i, beam + j) = 0;
            }
        }
    }
    return blob;
}

using Ranges = Grid<float>; // mm, 0 = not filled

bool measured(const Scan& scan, int line, int beam) {
    return scan.state.contains(line, beam) && scan.state.at(line, beam) == CellState::Valid;
}

Ranges nearest(const Scan& scan, const Grid<int>& blob) {
    Ranges filled(scan.lines(), scan.beams());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (blob.at(i, j) == 0) continue;
            int best = INT32_MAX;
            for (int a = i - 12; a <= i + 12; ++a) {
                for (int b = j - 12; b <= j + 12; ++b) {
                    const int far = (a - i) * (a - i) + (b - j) * (b - j);
                    if (far >= best || !measured(scan, a, b)) continue;
                    best = far;
                    filled.at(i, j) = scan.rangeMm.at(a, b);
                }
            }
        }
    }
    return filled;
}

// The mean of the straight lines in u of both directions, each weighted by its length.
Ranges bilinear(const Scan& scan, const Grid<int>& blob) {
    Ranges filled(scan.lines(), scan.beams());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (blob.at(i, j) == 0) continue;
            double sum = 0, weights = 0;
            for (const auto& [a, b] : {std::pair{0, 1}, {1, 0}}) {
                int back = 1, on = 1;
                while (back < 30 && !measured(scan, i - back * a, j - back * b)) ++back;
                while (on < 30 && !measured(scan, i + on * a, j + on * b)) ++on;
                if (!measured(scan, i - back * a, j - back * b) || !measured(scan, i + on * a, j + on * b)) continue;
                const double before = 1.0 / static_cast<double>(scan.rangeMm.at(i - back * a, j - back * b));
                const double after = 1.0 / static_cast<double>(scan.rangeMm.at(i + on * a, j + on * b));
                const double weight = 1.0 / (back + on);
                sum += weight * (on * before + back * after) / (back + on);
                weights += weight;
            }
            if (weights > 0) filled.at(i, j) = static_cast<float>(weights / sum);
        }
    }
    return filled;
}

Ranges inpainted(const Scan& scan, const Grid<int>& blob, int how) {
    cv::Mat ranges(scan.lines(), scan.beams(), CV_32F), holes(scan.lines(), scan.beams(), CV_8U), result;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            ranges.at<float>(i, j) = measured(scan, i, j) ? scan.rangeMm.at(i, j) : 0.0F;
            holes.at<std::uint8_t>(i, j) = measured(scan, i, j) ? 0 : 255;
        }
    }
    cv::inpaint(ranges, holes, result, 3, how);
    Ranges filled(scan.lines(), scan.beams());
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) filled.at(i, j) = blob.at(i, j) != 0 ? result.at<float>(i, j) : 0.0F;
    }
    return filled;
}

Ranges ours(const Scan& scan, const Grid<int>& blob) {
    Ranges filled(scan.lines(), scan.beams());
    for (const FilledCell& cell : fillGaps(scan, kWidest).cells) {
        if (blob[cell.cell] != 0) filled[cell.cell] = cell.rangeMm;
    }
    return filled;
}

// Whether a blob and the cells next to it are on one surface: one object, without steps of 50 mm. -1 for blobs with cells that hit no
// surface.
std::vector<int> onOneSurface(const Grid<int>& blob, const sim::SimulationTruth& truth) {
    constexpr double kTornMm = 50;
    const Grid<std::uint16_t> tornBeam = sim::wholeTears(truth.toNextBeam), tornLine = sim::wholeTears(truth.toNextLine);
    std::vector<int> one(kBlobs + 1, 1), object(kBlobs + 1, 0);
    for (int i = 1; i + 1 < blob.lines; ++i) {
        for (int j = 1; j + 1 < blob.beams; ++j) {
            for (const auto& [a, b] : {std::pair{0, 0}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
                const auto n = static_cast<std::size_t>(blob.at(i + a, j + b));
                if (n == 0) continue;
                const int here = truth.object.at(i, j);
                if (here == 0 || truth.absorbed.at(i, j) != 0) one[n] = -1;
                if (object[n] == 0) object[n] = here;
                const bool torn = (b >= 0 && a >= 0) && (tornBeam.at(i, j) > kTornMm || tornLine.at(i, j) > kTornMm);
                if ((object[n] != here || torn) && one[n] == 1) one[n] = 0;
            }
        }
    }
    return one;
}

struct Errors {
    std::vector<double> mm;
    std::size_t wanted = 0;

    void print(bool surface) {
        std::ranges::sort(mm);
        double squares = 0;
        for (const double e : mm) squares += e * e;
        const auto at = [&](double share) {
            return mm.empty() ? 0.0 : mm[static_cast<std::size_t>(share * static_cast<double>(mm.size() - 1))];
        };
        const auto count = static_cast<double>(std::max<std::size_t>(mm.size(), 1));
        const auto off = static_cast<double>(mm.end() - std::ranges::upper_bound(mm, kFarOffMm));
        std::printf(" %.1f %%, %.1f, ", 100.0 * static_cast<double>(mm.size()) / static_cast<double>(std::max<std::size_t>(wanted, 1)),
                    std::sqrt(squares / count));
        if (surface)
            std::printf("%.1f, %.1f |", at(0.5), at(0.95));
        else
            std::printf("%.0f, %.1f %% |", at(0.95), 100.0 * off / count);
    }
};

struct Filler {
    const char* name;
    std::function<Ranges(const Scan&, const Grid<int>&)> fill;
};

const std::vector<Filler>& fillers() {
    static const std::vector<Filler> all{
        {"nearest", nearest},
        {"bilinear in u", bilinear},
        {"OpenCV inpaint, Telea", [](const Scan& s, const Grid<int>& b) { return inpainted(s, b, cv::INPAINT_TELEA); }},
        {"OpenCV inpaint, Navier-Stokes", [](const Scan& s, const Grid<int>& b) { return inpainted(s, b, cv::INPAINT_NS); }},
        {"**EdgeScan**", ours}};
    return all;
}

class Methods {
public:
    explicit Methods(int size) : size_(size), errors_(fillers().size()) {}

    void add(const sim::Simulation& one, std::uint64_t m) {
        Scan scan = one.scan;
        const Grid<int> blob = dropBlobs(scan, size_, 7000 + m);
        const std::vector<int> surface = onOneSurface(blob, *one.truth);
        for (std::size_t f = 0; f < fillers().size(); ++f) {
            const Ranges filled = fillers()[f].fill(scan, blob);
            for (std::size_t k = 0; k < blob.size(); ++k) {
                const int kind = surface[static_cast<std::size_t>(blob[k])];
                if (blob[k] == 0 || kind < 0 || one.truth->cleanMm[k] <= 0) continue;
                Errors& e = errors_[f][kind == 1 ? 0 : 1];
                ++e.wanted;
                if (filled[k] > 0) e.mm.push_back(std::abs(static_cast<double>(filled[k] - one.truth->cleanMm[k])));
            }
        }
    }

    void print() {
        std::printf(
            "| method, blobs of %d cells | one surface: filled, RMS, P50, P95 mm | over an outline: filled, RMS, P95 mm, off by over "
            "100 mm |\n|---|---|---|\n",
            size_);
        for (std::size_t f = 0; f < fillers().size(); ++f) {
            std::printf("| %s |", fillers()[f].name);
            errors_[f][0].print(true);
            errors_[f][1].print(false);
            std::printf("\n");
        }
        std::printf("\n");
    }

private:
    int size_;
    std::vector<std::array<Errors, 2>> errors_;
};

class Sizes {
public:
    void add(const sim::Simulation& one, std::uint64_t m) {
        for (std::size_t n = 0; n < kSizes.size(); ++n) {
            Scan scan = one.scan;
            const Grid<int> blob = dropBlobs(scan, kSizes[n], 8000 + m);
            const std::vector<int> surface = onOneSurface(blob, *one.truth);
            for (const FilledCell& cell : fillGaps(scan, std::max(kWidest, kSizes[n])).cells) {
                if (blob[cell.cell] == 0 || surface[static_cast<std::size_t>(blob[cell.cell])] != 1) continue;
                const double e = std::abs(static_cast<double>(cell.rangeMm - one.truth->cleanMm[cell.cell]));
                mm_[n].push_back(e);
                if (cell.by != FilledBy::Plane) continue;
                ++planes_[n];
                within_[n] += e <= 2 * static_cast<double>(cell.sdMm) ? 1 : 0;
            }
        }
    }

    void print() {
        std::printf("| blobs of | RMS mm | P95 mm | within 2 sd, planes |\n|---|---|---|---|\n");
        for (std::size_t n = 0; n < kSizes.size(); ++n) {
            std::vector<double>& mm = mm_[n];
            std::ranges::sort(mm);
            double squares = 0;
            for (const double e : mm) squares += e * e;
            std::printf("| %d cells | %.1f | %.1f | %.2f |\n", kSizes[n], std::sqrt(squares / static_cast<double>(mm.size())),
                        mm[static_cast<std::size_t>(0.95 * static_cast<double>(mm.size() - 1))], within_[n] / planes_[n]);
        }
        std::printf("\n");
    }

private:
    static constexpr std::array<int, 4> kSizes{1, 4, 8, 12};
    std::array<std::vector<double>, kSizes.size()> mm_;
    std::array<double, kSizes.size()> within_{}, planes_{};
};

struct Voids {
    std::size_t open = 0, filled = 0;

    void add(const sim::Simulation& one) {
        const GapFilling filling = fillGaps(one.scan, kWidest);
        for (std::size_t k = 0; k < one.truth->object.size(); ++k) open += one.truth->object[k] == 0 ? 1 : 0;
        for (const FilledCell& cell : filling.cells) filled += one.truth->object[cell.cell] == 0 ? 1 : 0;
    }
    void print() const { std::printf("Of %zu cells whose beam hit nothing, %zu were filled.\n\n", open, filled); }
};

double fOf(const Scan& scan, const sim::TruthSet& truth, bool fill) {
    edges::Settings settings;
    settings.fillCells = fill ? kWidest : 0;
    settings.fillEdges = fill;
    return lab::evaluateMask(*edges::detectEdges(std::make_shared<const Scan>(scan), settings)->mask, truth, nullptr, 3).score.all.f();
}

struct EdgeScores {
    std::string name;
    double asIs, asIsFilled, holes, holesFilled;
};

EdgeScores edgeScores(const sim::Simulation& one, std::uint64_t m) {
    const sim::TruthSet truth = sim::truthSetOf(one);
    Scan holes = one.scan;
    dropBlobs(holes, 7, 9000 + m);
    return {one.scan.name, fOf(one.scan, truth, false), fOf(one.scan, truth, true), fOf(holes, truth, false), fOf(holes, truth, true)};
}

void printEach(const std::vector<EdgeScores>& scores) {
    std::printf("| scene | as it is | filled | 400 blobs of 7 cells | filled |\n|---|---|---|---|---|\n");
    for (const EdgeScores& s : scores)
        std::printf("| %s | %.3f | %.3f | %.3f | %.3f |\n", s.name.c_str(), s.asIs, s.asIsFilled, s.holes, s.holesFilled);
    std::printf("\n");
}

/// Gain by filling: mean, least, and the number of scenes with a gain below -0.003.
void printGains(const std::vector<EdgeScores>& scores) {
    const auto row = [&](const char* name, double EdgeScores::*before, double EdgeScores::*after) {
        double sum = 0, least = 1;
        int lost = 0;
        for (const EdgeScores& s : scores) {
            const double gain = s.*after - s.*before;
            sum += gain;
            least = std::min(least, gain);
            lost += gain < -0.003 ? 1 : 0;
        }
        std::printf("| %s | %+.4f | %+.4f | %d of %zu |\n", name, sum / static_cast<double>(scores.size()), least, lost, scores.size());
    };
    std::printf("| F by filling | mean gain | least | lower by over .003 |\n|---|---|---|---|\n");
    row("scene as it is", &EdgeScores::asIs, &EdgeScores::asIsFilled);
    row("with 400 blobs of 7 cells", &EdgeScores::holes, &EdgeScores::holesFilled);
}

void time() {
    Scan scan = scoredScene("pile", 1, 1000, 1141).scan;
    dropBlobs(scan, 7, 1);
    const RangeNoise noise = rangeNoise(inverseRange(scan));
    double best = 1e9;
    for (int n = 0; n < 9; ++n) {
        const auto start = std::chrono::steady_clock::now();
        const GapFilling filling = fillGaps(scan, noise, kWidest);
        best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        if (filling.cells.empty()) std::abort();
    }
    std::printf("1.14 million cells with 400 blobs: %.0f ms (best of 9, one thread).\n", best);
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::uint64_t> seeds;
    const bool many = argc == 4 && std::string(argv[1]) == "--many";
    if (many) {
        const std::uint64_t first = std::strtoull(argv[2], nullptr, 10), count = std::strtoull(argv[3], nullptr, 10);
        for (std::uint64_t n = 0; n < count; ++n) seeds.push_back(first + n);
    }
    for (int n = 1; n < argc && !many; ++n) seeds.push_back(std::strtoull(argv[n], nullptr, 10));
    if (seeds.empty()) seeds = {301, 302};
    Methods methods(8);
    Sizes sizes;
    Voids voids;
    std::vector<EdgeScores> scores;
    std::uint64_t m = 0;
    for (const std::uint64_t seed : seeds) {
        for (const char* scene : {"hangup", "pile"}) {
            const sim::Simulation one = many ? scoredScene(scene, seed, 250, 286) : scoredScene(scene, seed, 500, 571);
            methods.add(one, m);
            sizes.add(one, m);
            voids.add(one);
            scores.push_back(edgeScores(one, m++));
        }
    }
    methods.print();
    sizes.print();
    voids.print();
    if (many) return printGains(scores), 0;
    printEach(scores);
    time();
}
