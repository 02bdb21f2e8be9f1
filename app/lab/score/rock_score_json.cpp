// Figures of rocks as JSON.
#include "app/lab/score/rock_evaluation.h"
#include "core/base/order_statistic.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;
using Scores = std::vector<RockSceneScore>;

constexpr std::size_t kBins = 10;
constexpr std::array<const char*, kMisses> kMissNames{"called_no_rock", "with_wall", "merged", "split", "other"};

Json shareOrNull(std::size_t part, std::size_t whole) {
    return whole == 0 ? Json(nullptr) : Json(static_cast<double>(part) / static_cast<double>(whole));
}

Json quantileOrNull(std::vector<double> values, double share) { return values.empty() ? Json(nullptr) : Json(quantile(values, share)); }

Json meanOrNull(const std::vector<double>& values) {
    if (values.empty()) return nullptr;
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

Json countsJson(const Scores& scenes, RockMatch RockSceneScore::*which) {
    RockCounts total;
    std::array<std::vector<double>, 3> each;
    for (const RockSceneScore& scene : scenes) {
        const RockCounts& counts = (scene.*which).counts;
        total += counts;
        if (counts.found + counts.missed == 0) continue; // without rocks there is no figure
        each[0].push_back(counts.pq());
        each[1].push_back(counts.sq());
        each[2].push_back(counts.f1());
    }
    Json missed;
    for (std::size_t n = 0; n < kMisses; ++n) missed[kMissNames[n]] = total.missedBy[n];
    return {{"pq", total.pq()},
            {"sq", total.sq()},
            {"f1", total.f1()},
            {"mean_pq", meanOrNull(each[0])},
            {"mean_sq", meanOrNull(each[1])},
            {"mean_f1", meanOrNull(each[2])},
            {"pq_of_scenes", each[0]},
            {"rocks", total.found + total.missed},
            {"found", total.found},
            {"missed", total.missed},
            {"false", total.falseRegions},
            {"missed_by", missed}};
}

Json byCellsJson(const Scores& scenes) {
    std::array<CellClass, 4> total = byCells({});
    for (const RockSceneScore& scene : scenes) {
        const auto classes = byCells(scene.lenient);
        for (std::size_t n = 0; n < classes.size(); ++n) {
            total[n].rocks += classes[n].rocks;
            total[n].found += classes[n].found;
        }
    }
    Json list = Json::array();
    for (const CellClass& one : total)
        list.push_back(
            {{"from_cells", one.fromCells}, {"rocks", one.rocks}, {"found", one.found}, {"share", shareOrNull(one.found, one.rocks)}});
    return list;
}

/// For one span: reported against visible and reported against whole, as shares of the true one.
Json spanJson(const std::vector<SpanSample>& samples, double SpanSample::*reported, double SpanSample::*seen, double SpanSample::*whole) {
    std::vector<double> bias, error, againstWhole;
    std::size_t within1 = 0;
    std::size_t within2 = 0;
    for (const SpanSample& s : samples) {
        if (s.*seen > 0.0) {
            bias.push_back(s.*reported / s.*seen - 1.0);
            error.push_back(std::abs(bias.back()));
        }
        if (s.*whole > 0.0) againstWhole.push_back(s.*reported / s.*whole - 1.0);
        const double off = std::abs(s.*reported - s.*seen);
        within1 += off <= s.u ? 1 : 0;
        within2 += off <= 2.0 * s.u ? 1 : 0;
    }
    return {{"median_bias", quantileOrNull(bias, 0.5)},
            {"median_error", quantileOrNull(error, 0.5)},
            {"p90_error", quantileOrNull(error, 0.9)},
            {"within_1_u", shareOrNull(within1, samples.size())},
            {"within_2_u", shareOrNull(within2, samples.size())},
            {"median_against_whole_rock", quantileOrNull(againstWhole, 0.5)}};
}

Json spansJson(const Scores& scenes) {
    std::vector<SpanSample> all;
    for (const RockSceneScore& scene : scenes) all.insert(all.end(), scene.spans.begin(), scene.spans.end());
    return {{"rocks", all.size()},
            {"a", spanJson(all, &SpanSample::a, &SpanSample::trueA, &SpanSample::wholeA)},
            {"b", spanJson(all, &SpanSample::b, &SpanSample::trueB, &SpanSample::wholeB)}};
}

/// P50 and P80 of the visible b by number: mean deviation over the scenes, as a share.
Json sizeCurveJson(const Scores& scenes) {
    Json json;
    for (const auto& [name, share] : {std::pair{"p50", 0.5}, std::pair{"p80", 0.8}}) {
        std::vector<double> bias, error;
        for (const RockSceneScore& scene : scenes) {
            if (scene.shownB.empty() || scene.trueB.empty()) continue;
            std::vector<double> shown = scene.shownB;
            std::vector<double> truth = scene.trueB;
            bias.push_back(quantile(shown, share) / quantile(truth, share) - 1.0);
            error.push_back(std::abs(bias.back()));
        }
        json[name] = {{"mean_error", meanOrNull(error)}, {"mean_bias", meanOrNull(bias)}};
    }
    return json;
}

/// Probability that a right region has a higher reported confidence than a wrong one; ties count one half.
Json areaUnderCurve(std::vector<ConfidenceSample> samples) {
    std::ranges::sort(samples, {}, &ConfidenceSample::reported);
    double wins = 0.0;
    std::size_t wrong = 0;
    std::size_t right = 0;
    for (std::size_t from = 0; from < samples.size();) {
        std::array<std::size_t, 2> here{};
        std::size_t to = from;
        for (; to < samples.size() && samples[to].reported == samples[from].reported; ++to) ++here[samples[to].right ? 1 : 0];
        wins += static_cast<double>(here[1]) * (static_cast<double>(wrong) + 0.5 * static_cast<double>(here[0]));
        wrong += here[0];
        right += here[1];
        from = to;
    }
    return wrong == 0 || right == 0 ? Json(nullptr) : Json(wins / (static_cast<double>(wrong) * static_cast<double>(right)));
}

Json confidenceJson(const Scores& scenes) {
    std::vector<ConfidenceSample> all;
    for (const RockSceneScore& scene : scenes) all.insert(all.end(), scene.confidence.begin(), scene.confidence.end());
    struct Bin {
        std::size_t count = 0, right = 0;
        double reported = 0.0;
    };
    std::array<Bin, kBins> bins;
    for (const ConfidenceSample& sample : all) {
        Bin& bin = bins[std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, sample.reported) * kBins))];
        ++bin.count;
        bin.right += sample.right ? 1 : 0;
        bin.reported += sample.reported;
    }
    double error = 0.0;
    Json list = Json::array();
    for (std::size_t n = 0; n < kBins; ++n) {
        const Bin& bin = bins[n];
        const auto count = static_cast<double>(bin.count);
        error += std::abs(bin.reported - static_cast<double>(bin.right));
        list.push_back({{"from", static_cast<double>(n) / kBins},
                        {"regions", bin.count},
                        {"reported", bin.count == 0 ? Json(nullptr) : Json(bin.reported / count)},
                        {"right", shareOrNull(bin.right, bin.count)}});
    }
    return {{"regions", all.size()},
            {"auc", areaUnderCurve(all)},
            {"calibration_error", all.empty() ? Json(nullptr) : Json(error / static_cast<double>(all.size()))},
            {"bins", list}};
}

Json pairsJson(const PairCounts& counts) {
    return {{"reported", counts.reported},
            {"known", counts.known},
            {"precision", shareOrNull(counts.reportedKnown, counts.reported)},
            {"recall", shareOrNull(counts.reportedKnown, counts.known)},
            {"right_where_both_decide", shareOrNull(counts.right, counts.reportedKnown)},
            {"rocks_within_one", shareOrNull(counts.rocksClose, counts.rocks)}};
}

} // namespace

Json rockScoreJson(const std::vector<RockSceneScore>& scenes) {
    PairScore pairs;
    double milliseconds = 0.0;
    for (const RockSceneScore& scene : scenes) {
        pairs += scene.pairs;
        milliseconds += scene.milliseconds;
    }
    return {
        {"scenes", scenes.size()},
        {"at_least_100_cells",
         {{"lenient", countsJson(scenes, &RockSceneScore::lenient)}, {"strict", countsJson(scenes, &RockSceneScore::strict)}}},
        {"at_least_400_cells",
         {{"lenient", countsJson(scenes, &RockSceneScore::lenientLarge)}, {"strict", countsJson(scenes, &RockSceneScore::strictLarge)}}},
        {"visible_parts", countsJson(scenes, &RockSceneScore::parts)},
        {"by_cells", byCellsJson(scenes)},
        {"spans", spansJson(scenes)},
        {"size_curve", sizeCurveJson(scenes)},
        {"confidence", confidenceJson(scenes)},
        {"order", pairsJson(pairs.order)},
        {"contacts", pairsJson(pairs.contacts)},
        {"ms_per_scene", scenes.empty() ? 0.0 : milliseconds / static_cast<double>(scenes.size())}};
}

} // namespace edgescan::lab
