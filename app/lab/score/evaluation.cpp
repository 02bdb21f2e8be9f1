// Computes the figures of masks and threshold sweeps.
#include "app/lab/score/evaluation.h"

#include "app/lab/sim/scene.h"
#include "core/base/order_statistic.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/opencv_view.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kFewestOutlineCells = 10;

struct Group {
    const char* name;
    EdgeCounts EdgeScore::*counts;
};
constexpr std::array<Group, 5> kGroups{{{"occluding", &EdgeScore::occluding},
                                        {"outline", &EdgeScore::outline},
                                        {"crease", &EdgeScore::crease},
                                        {"all", &EdgeScore::all},
                                        {"strict_outline", &EdgeScore::strictOutline}}};

std::vector<ScoredOutline> rockOutlines(const EdgeMatches& matches, const sim::TruthSet& truth) {
    if (truth.object.size() == 0) return {};
    std::vector<std::size_t> cells(65536);
    std::vector<std::size_t> found(65536);
    const auto counts = [&](std::size_t k) {
        const std::uint8_t c = truth.edges.edgeClass[k];
        return c != 0 && c != static_cast<std::uint8_t>(sim::EdgeClass::Crease) && truth.edges.ignore[k] == 0;
    };
    for (std::size_t k = 0; k < truth.object.size(); ++k) {
        if (counts(k)) ++cells[truth.object[k]];
    }
    for (const MatchedPair& pair : matches.outline) {
        if (counts(pair.truth)) ++found[truth.object[pair.truth]];
    }
    std::vector<ScoredOutline> result;
    for (std::size_t rock = sim::kFirstRock; rock < cells.size(); ++rock) {
        if (cells[rock] >= kFewestOutlineCells) result.push_back({0, static_cast<int>(rock), cells[rock], found[rock]});
    }
    return result;
}

std::vector<double> errorsMm(const EdgeMatches& matches, const sim::TruthSet& truth, const Scan& scan) {
    if (truth.cleanMm.size() == 0) return {};
    const CartesianTables tables(scan);
    std::vector<double> errors;
    for (const MatchedPair& pair : matches.all) {
        if (truth.edges.ignore[pair.truth] != 0 || scan.state[pair.detected] != CellState::Valid || truth.cleanMm[pair.truth] == 0)
            continue;
        const int line = static_cast<int>(pair.truth / static_cast<std::uint32_t>(scan.beams()));
        const int beam = static_cast<int>(pair.truth % static_cast<std::uint32_t>(scan.beams()));
        const Eigen::Vector3d there = tables.sensor() + tables.direction(line, beam) * (0.001 * truth.cleanMm[pair.truth]);
        errors.push_back(1000.0 * (tables.point(std::size_t{pair.detected}) - there).norm());
    }
    return errors;
}

// The error that this share of the errors is below; 0 without errors.
double errorAt(std::vector<double> errors, double share) { return errors.empty() ? 0.0 : quantile(errors, share); }

Json countsJson(const EdgeCounts& counts) {
    return {{"precision", counts.precision()}, {"recall", counts.recall()}, {"f", counts.f()},
            {"truth", counts.truth},           {"found", counts.found},     {"false", counts.false_}};
}

// Names of sim::EdgeClass from 1 on.
constexpr std::array<const char*, 4> kClassNames{"occluding", "contact", "crease", "void"};

Json placesJson(const EdgePlaces& places) {
    Json json{{"truth", places.truth}};
    for (std::size_t n = 0; n < kPlaceDistances.size(); ++n) json["within_" + std::to_string(kPlaceDistances[n])] = places.share(n);
    json["offset"] = places.offset();
    json["offsets"] = places.measured;
    return json;
}

double shareOfRocks(const std::vector<ScoredOutline>& rocks, double least) {
    if (rocks.empty()) return 0.0;
    const auto count = std::count_if(rocks.begin(), rocks.end(), [&](const ScoredOutline& rock) { return rock.share() >= least; });
    return static_cast<double>(count) / static_cast<double>(rocks.size());
}

// Area under the upper envelope of precision over recall. From recall 0 to the lowest recall reached, the precision there is used.
double averagePrecision(std::vector<std::pair<double, double>> recallPrecision) {
    std::sort(recallPrecision.begin(), recallPrecision.end());
    double best = 0.0;
    for (auto point = recallPrecision.rbegin(); point != recallPrecision.rend(); ++point)
        point->second = best = std::max(best, point->second);
    double area = 0.0;
    double from = 0.0;
    for (const auto& [recall, precision] : recallPrecision) {
        area += (recall - from) * precision;
        from = recall;
    }
    return area;
}

} // namespace

Evaluation& Evaluation::operator+=(const Evaluation& other) {
    score += other.score;
    for (ScoredOutline rock : other.rocks) {
        rock.scan += scans;
        rocks.push_back(rock);
    }
    errorsMm.insert(errorsMm.end(), other.errorsMm.begin(), other.errorsMm.end());
    pratt += other.pratt;
    scans += other.scans;
    for (std::size_t n = 0; n < places.size(); ++n) places[n] += other.places[n];
    return *this;
}

double prattMerit(const Grid<std::uint8_t>& thin, const sim::EdgeTruth& truth) {
    Grid<std::uint8_t> background(thin.lines, thin.beams, 255);
    std::size_t wanted = 0;
    for (std::size_t k = 0; k < thin.size(); ++k) {
        if (truth.edgeClass[k] == 0) continue;
        background[k] = 0;
        wanted += truth.ignore[k] == 0 ? 1 : 0;
    }
    std::size_t detected = 0;
    double sum = 0.0;
    cv::Mat distance;
    cv::distanceTransform(asMat(background), distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    for (int i = 0; i < thin.lines; ++i) {
        for (int j = 0; j < thin.beams; ++j) {
            if (thin.at(i, j) == 0 || truth.ignore.at(i, j) != 0) continue;
            const double d = wanted > 0 ? static_cast<double>(distance.at<float>(i, j)) : 1e9;
            sum += 1.0 / (1.0 + d * d / 9.0);
            ++detected;
        }
    }
    const std::size_t most = std::max(wanted, detected);
    return most == 0 ? 1.0 : sum / static_cast<double>(most);
}

Evaluation evaluateMask(const Grid<std::uint8_t>& mask, const sim::TruthSet& truth, const Scan* scan, double tolerance) {
    const EdgeMatches matches = matchWithTruth(mask, truth.edges, tolerance);
    return {scoreMatches(matches, truth.edges),
            rockOutlines(matches, truth),
            scan != nullptr ? errorsMm(matches, truth, *scan) : std::vector<double>(),
            prattMerit(matches.thin, truth.edges),
            1,
            edgePlaces(matches.thin, truth)};
}

Json evaluationJson(const Evaluation& evaluation) {
    Json json;
    for (const Group& group : kGroups) json[group.name] = countsJson(evaluation.score.*group.counts);
    json["rocks"] = {{"count", evaluation.rocks.size()},
                     {"at_least_80_percent", shareOfRocks(evaluation.rocks, 0.8)},
                     {"at_least_90_percent", shareOfRocks(evaluation.rocks, 0.9)}};
    if (!evaluation.errorsMm.empty())
        json["error_mm"] = {{"p50", errorAt(evaluation.errorsMm, 0.50)}, {"p95", errorAt(evaluation.errorsMm, 0.95)}};
    Json& places = json["places"];
    for (std::size_t n = 0; n < kClassNames.size(); ++n) places[kClassNames[n]] = placesJson(evaluation.places[n + 1]);
    places["all"] = placesJson(allPlaces(evaluation.places));
    json["pratt"] = evaluation.scans == 0 ? 0.0 : evaluation.pratt / evaluation.scans;
    return json;
}

Json rocksJson(const Evaluation& evaluation) {
    Json rocks = Json::array();
    for (const ScoredOutline& rock : evaluation.rocks)
        rocks.push_back(
            {{"file", rock.scan}, {"object", rock.object}, {"outline_cells", rock.cells}, {"found", rock.found}, {"share", rock.share()}});
    return rocks;
}

Json sweepJson(const ThresholdSweep& sweep) {
    const std::size_t count = sweep.thresholds.size();
    std::vector<Evaluation> total(count);
    for (const auto& scan : sweep.perScan) {
        for (std::size_t t = 0; t < count; ++t) total[t] += scan[t];
    }
    Json json;
    json["thresholds"] = sweep.thresholds;
    std::size_t bestOfAll = 0;
    for (const Group& group : kGroups) {
        const auto f = [&](const Evaluation& evaluation) { return (evaluation.score.*group.counts).f(); };
        const auto better = [&](const Evaluation& a, const Evaluation& b) { return f(a) < f(b); };
        const auto best = static_cast<std::size_t>(std::max_element(total.begin(), total.end(), better) - total.begin());
        if (group.counts == &EdgeScore::all) bestOfAll = best;
        EdgeCounts own;
        for (const auto& scan : sweep.perScan) own += std::max_element(scan.begin(), scan.end(), better)->score.*group.counts;
        std::vector<std::pair<double, double>> curve;
        Json points = Json::array();
        for (const Evaluation& evaluation : total) {
            const EdgeCounts& counts = evaluation.score.*group.counts;
            if (counts.found + counts.false_ > 0) curve.emplace_back(counts.recall(), counts.precision());
            points.push_back({counts.precision(), counts.recall()});
        }
        json[group.name] = {{"ods", f(total[best])},
                            {"ods_threshold", sweep.thresholds[best]},
                            {"ois", own.f()},
                            {"ap", averagePrecision(curve)},
                            {"precision_recall", points}};
    }
    json["at_ods"] = evaluationJson(total[bestOfAll]);
    return json;
}

} // namespace edgescan::lab
