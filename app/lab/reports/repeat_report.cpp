// Writes the rows of the methods.
#include "app/lab/reports/repeat_report.h"

#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMethodWidth = 38;

std::string cells(const RepeatCount& count) {
    return rightAligned(std::to_string(count.edges), 9) + rightAligned(std::to_string(count.visible), 9) +
           rightAligned(fixedText(100 * count.share(), 1) + " %", 10);
}

Json countJson(const RepeatCount& count) {
    return {{"edges", count.edges}, {"visible", count.visible}, {"found", count.found}, {"repeatability", count.share()}};
}

Json alignmentJson(const inspect::ScanAlignment& alignment) {
    const RigidTransform& t = alignment.correction;
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({t.rotation(i, 0), t.rotation(i, 1), t.rotation(i, 2), t.translationM[i]});
    return {{"pairs", alignment.pairs},
            {"residual_before_m", alignment.residualBeforeM},
            {"residual_m", alignment.residualM},
            {"correction", std::move(rows)}};
}

} // namespace

std::string repeatText(const RepeatRun& run) {
    std::string text;
    if (run.alignment) {
        text += "Poses refined on " + std::to_string(run.alignment->pairs) + " points: surfaces lie " +
                fixedText(1000 * run.alignment->residualM, 1) + " mm apart, " + fixedText(1000 * run.alignment->residualBeforeM, 1) +
                " mm before (medians).\n";
    }
    text += "An edge is repeated when the other scan has one within " + fixedText(1000 * run.radiusM, 0) +
            " mm; counted where the other scan could see.\nAt equal number: with the threshold that gives as many edges as EdgeScan+. By "
            "places: with lines thinned to one cell, as many of them.\n";
    std::string head = "method";
    head.resize(kMethodWidth, ' ');
    text += head + rightAligned("edges", 9) + rightAligned("visible", 9) + rightAligned("repeated", 10) + " |" +
            rightAligned("at equal", 9) + rightAligned("visible", 9) + rightAligned("repeated", 10) + " |" + rightAligned("by places", 10) +
            "\n";
    for (const MethodRepeatability& row : run.methods) {
        std::string name = row.name;
        name.resize(std::max(kMethodWidth, name.size()), ' ');
        text += name + cells(row.withFixedSettings) + " |" + (row.atEqual ? cells(*row.atEqual) : rightAligned("-", 28)) + " |" +
                (row.atEqualPlaces ? rightAligned(fixedText(100 * row.atEqualPlaces->share(), 1) + " %", 10) : rightAligned("-", 10)) +
                "\n";
        if (!row.note.empty()) text += "  " + row.note + "\n";
    }
    text.pop_back();
    return text;
}

Json repeatReport(const RepeatRun& run) {
    Json methods = Json::array();
    for (const MethodRepeatability& row : run.methods) {
        Json one{{"name", row.name}, {"method", row.key}, {"as_set", countJson(row.withFixedSettings)}};
        one["at_equal_number"] = row.atEqual ? countJson(*row.atEqual) : Json(nullptr);
        one["at_equal_places"] = row.atEqualPlaces ? countJson(*row.atEqualPlaces) : Json(nullptr);
        if (!row.note.empty()) one["note"] = row.note;
        methods.push_back(std::move(one));
    }
    return {{"match_radius_m", run.radiusM},
            {"alignment", run.alignment ? alignmentJson(*run.alignment) : Json(nullptr)},
            {"methods", std::move(methods)}};
}

} // namespace edgescan::lab
