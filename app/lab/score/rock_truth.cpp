// Reads the true rocks of a simulated scene.
#include "app/lab/score/rock_truth.h"

#include "app/lab/sim/truth/truth_files.h"
#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/whole_file.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace edgescan::lab {
namespace {

constexpr const char* kHint = "write the truth again with simulate --truth";

/// Converts numbers of object.png to indices of the list of rocks; objects that are not rocks become background.
Grid<std::uint32_t> placesOf(const Grid<std::uint16_t>& object, const std::vector<TrueRock>& rocks) {
    std::vector<std::uint32_t> place(65536);
    for (std::size_t n = 0; n < rocks.size(); ++n) place[rocks[n].object] = static_cast<std::uint32_t>(n + 1);
    Grid<std::uint32_t> rock(object.lines, object.beams);
    for (std::size_t k = 0; k < rock.size(); ++k) rock[k] = place[object[k]];
    return rock;
}

Result<std::vector<TrueRock>> readRockList(const std::filesystem::path& path) {
    const auto bytes = readWholeFile(path, std::uint64_t{64} << 20U);
    if (!bytes) return bytes.error();
    const auto json = parseJson(textOf(*bytes), path.string());
    if (!json) return json.error();
    const Error wrong{"it holds no list of rocks", path.string(), kHint};
    if (!json->is_array()) return wrong;
    std::vector<TrueRock> rocks;
    for (const nlohmann::json& one : *json) {
        if (!one.is_object()) return wrong;
        JsonFields fields(one, path.string(), kHint);
        TrueRock rock;
        rock.object = static_cast<std::uint32_t>(fields.wholeNumber("object", 1, 65535));
        rock.centreM = fields.neededVector("centre_m");
        const std::vector<double> spans = fields.numbers("spans_m", 3);
        if (fields.problem()) return *fields.problem();
        std::ranges::copy(spans, rock.spansM.begin());
        rocks.push_back(rock);
    }
    return rocks;
}

} // namespace

Result<TrueRocks> readTrueRocks(const std::filesystem::path& folder) {
    TrueRocks truth;
    auto rocks = readRockList(folder / "rocks.json");
    if (!rocks) return rocks.error();
    truth.rocks = std::move(*rocks);
    Grid<std::uint16_t> object;
    struct Picture {
        const char* name;
        Grid<std::uint16_t>* grid;
        bool needed;
    };
    for (const Picture& picture :
         {Picture{"object.png", &object, true}, Picture{"range_clean.png", &truth.cleanMm, true},
          Picture{"tear_beam.png", &truth.tearToBeamMm, false}, Picture{"tear_line.png", &truth.tearToLineMm, false}}) {
        auto grid = sim::readTruthNumbers(folder / picture.name);
        if (!grid) return grid.error();
        *picture.grid = std::move(*grid);
        if (picture.grid->size() == 0 && picture.needed) return Error{"it is not there", (folder / picture.name).string(), kHint};
        if (picture.grid->size() > 0 && (picture.grid->lines != object.lines || picture.grid->beams != object.beams))
            return Error{"the pictures of the truth have different sizes", folder.string(), kHint};
    }
    if ((truth.tearToBeamMm.size() > 0) != (truth.tearToLineMm.size() > 0))
        return Error{"of tear_beam.png and tear_line.png only one is there", folder.string(), kHint};
    truth.rock = placesOf(object, truth.rocks);
    return truth;
}

TrueRocks trueRocksOf(const sim::Simulation& simulation) {
    const sim::SimulationTruth& known = *simulation.truth;
    const sim::TruthSet set = sim::truthSetOf(simulation);
    TrueRocks truth{{}, set.cleanMm, sim::wholeTears(known.toNextBeam), sim::wholeTears(known.toNextLine), {}};
    for (const auto& rock : known.rocks)
        truth.rocks.push_back(
            {static_cast<std::uint32_t>(rock.object), rock.centreM.cast<double>(), {rock.spansM[0], rock.spansM[1], rock.spansM[2]}});
    truth.rock = placesOf(known.object, truth.rocks);
    return truth;
}

VisibleSpans spansAcrossSight(const std::vector<Eigen::Vector3d>& pointsM) {
    if (pointsM.size() < 3) return {};
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : pointsM) mean += p;
    mean /= static_cast<double>(pointsM.size());
    const Eigen::Vector3d right = mean.unitOrthogonal();
    const Eigen::Vector3d up = mean.normalized().cross(right);
    std::vector<cv::Point2f> flat;
    for (const Eigen::Vector3d& p : pointsM)
        flat.emplace_back(static_cast<float>((p - mean).dot(right)), static_cast<float>((p - mean).dot(up)));
    std::vector<cv::Point2f> hull;
    cv::convexHull(flat, hull);
    VisibleSpans spans;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < hull.size(); ++n) {
        const cv::Point2f side = hull[(n + 1) % hull.size()] - hull[n];
        const double length = std::hypot(static_cast<double>(side.x), static_cast<double>(side.y));
        double farthest = 0.0; // distance from the line through this side: the smallest calipers touch a side of the hull
        for (const cv::Point2f& other : hull) {
            const cv::Point2f way = other - hull[n];
            spans.aM = std::max(spans.aM, std::hypot(static_cast<double>(way.x), static_cast<double>(way.y)));
            if (length > 0.0) farthest = std::max(farthest, std::abs(static_cast<double>(side.x * way.y - side.y * way.x)) / length);
        }
        if (length > 0.0) least = std::min(least, farthest);
    }
    spans.bM = std::isfinite(least) ? least : 0.0;
    return spans;
}

std::vector<VisibleSpans> trueSpans(const Scan& scan, const TrueRocks& truth) {
    const CartesianTables tables(scan);
    std::vector<std::vector<Eigen::Vector3d>> points(truth.rocks.size());
    for (int i = 0; i < truth.rock.lines; ++i) {
        for (int j = 0; j < truth.rock.beams; ++j) {
            const std::uint32_t rock = truth.rock.at(i, j);
            if (rock > 0) points[rock - 1].push_back(tables.direction(i, j) * (0.001 * truth.cleanMm.at(i, j)));
        }
    }
    std::vector<VisibleSpans> spans;
    for (const auto& one : points) spans.push_back(spansAcrossSight(one));
    return spans;
}

Grid<std::uint32_t> visibleParts(const Grid<std::uint32_t>& rock) {
    Grid<std::uint32_t> part(rock.lines, rock.beams);
    std::uint32_t parts = 0;
    std::vector<std::pair<int, int>> pending;
    for (int i = 0; i < rock.lines; ++i) {
        for (int j = 0; j < rock.beams; ++j) {
            if (rock.at(i, j) == 0 || part.at(i, j) != 0) continue;
            part.at(i, j) = ++parts;
            pending.emplace_back(i, j);
            while (!pending.empty()) {
                const auto [line, beam] = pending.back();
                pending.pop_back();
                for (int n = 0; n < 9; ++n) {
                    const int l = line + n / 3 - 1;
                    const int b = beam + n % 3 - 1;
                    if (!rock.contains(l, b) || rock.at(l, b) != rock.at(i, j) || part.at(l, b) != 0) continue;
                    part.at(l, b) = parts;
                    pending.emplace_back(l, b);
                }
            }
        }
    }
    return part;
}

} // namespace edgescan::lab
