// Writes a comparison as tables and as JSON.
#include "app/lab/reports/comparison_report.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/edges/settings/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;

// As printed in the thesis, milliseconds on its i7.
struct PrintedStep {
    const char* name;
    double milliseconds;
    double ComparedSteps::*step;
};
constexpr std::array<PrintedStep, 4> kTable61{{{"conversion", 62, &ComparedSteps::conversion},
                                               {"noise removal", 90, &ComparedSteps::noiseRemoval},
                                               {"edges", 16, &ComparedSteps::edges},
                                               {"merge", 129, &ComparedSteps::merge}}};
constexpr std::size_t kNameWidth = 34;
constexpr double kPrintedTotal = 297;
constexpr double kPrintedBoundary = 1852880;
constexpr double kPrintedRangeImage = 4510; // on 83,000 points

/// The numbers of one row, each in a column of fixed width.
struct Column {
    double value;
    std::size_t width;
    int decimals = 1;
};
std::string columns(std::initializer_list<Column> row) {
    std::string text;
    for (const Column& column : row) text += rightAligned(fixedText(column.value, column.decimals), column.width);
    return text;
}

std::string leftAligned(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

const ComparedMethod* find(const std::vector<ComparedMethod>& methods, const std::string& key) {
    const auto found = std::ranges::find(methods, key, &ComparedMethod::key);
    return found == methods.end() ? nullptr : &*found;
}

std::size_t validCells(const Scan& scan) { return countCells(scan)[static_cast<std::size_t>(CellState::Valid)]; }

std::string milliseconds(const ComparedMethod* method) {
    if (method == nullptr || !method->wasRun()) return "-";
    return method->share < 1.0 ? "~" + fixedText(method->steps.total(), 0) : fixedText(method->steps.total(), 1);
}

std::string methodRow(const ComparedMethod& method) {
    std::string row = leftAligned(method.name, kNameWidth);
    if (!method.wasRun()) return row + "  not run\n";
    const ComparedSteps& s = method.steps;
    row += columns({{s.conversion, 9}, {s.noiseRemoval, 10}, {s.edges, 11}, {s.merge, 9}, {s.total(), 11}}) +
           rightAligned(std::to_string(method.edges), 10);
    if (method.score) {
        const EdgeScore& score = method.score->score;
        for (const EdgeCounts& counts : {score.occluding, score.outline, score.crease, score.all}) row += "  " + fixedText(counts.f(), 3);
    }
    if (method.best)
        row += "  " + fixedText(method.best->score.score.all.f(), 3) + " at " + method.best->parameter + " " +
               significantText(method.best->value, 3);
    return row + "\n";
}

// Null unless both methods of the thesis's table were compared.
Json printedReport(const std::vector<ComparedMethod>& methods) {
    const ComparedMethod* thesis = find(methods, "thesis");
    const ComparedMethod* plus = find(methods, "edgescan+");
    if (thesis == nullptr || plus == nullptr) return nullptr;
    Json table = Json::object();
    for (const PrintedStep& step : kTable61)
        table[step.name] = {{"thesis_printed_ms", step.milliseconds},
                            {"thesis_today_ms", thesis->steps.*step.step},
                            {"edgescan_plus_ms", plus->steps.*step.step}};
    table["total"] = {
        {"thesis_printed_ms", kPrintedTotal}, {"thesis_today_ms", thesis->steps.total()}, {"edgescan_plus_ms", plus->steps.total()}};
    return table;
}

} // namespace

std::string comparisonText(const Scan& scan, const std::vector<ComparedMethod>& methods) {
    const bool scored = std::ranges::any_of(methods, [](const ComparedMethod& m) { return m.score.has_value(); });
    const bool best = std::ranges::any_of(methods, [](const ComparedMethod& m) { return m.best.has_value(); });
    std::string text = printable(scan.name) + ": " + std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) +
                       " beams, " + std::to_string(validCells(scan)) + " points; milliseconds of thread CPU time\n\n";
    text += leftAligned("", kNameWidth) + "  convert   denoise      edges    merge      total     cells";
    if (scored) text += "  occl.  outl.  crease all  ";
    if (best) text += "  all, best threshold";
    text += "\n";
    for (const ComparedMethod& method : methods) text += methodRow(method);
    for (const ComparedMethod& method : methods) {
        if (!method.note.empty()) text += "  " + method.name + ": " + method.note + "\n";
        if (method.kinds.size() < 2) continue;
        text += "  " + method.name + ":";
        for (const auto& [kind, cells] : method.kinds)
            text += (kind == method.kinds.front().first ? " " : ", ") + std::to_string(cells) + " " + kind;
        text += "\n";
    }

    const ComparedMethod* thesis = find(methods, "thesis");
    const ComparedMethod* plus = find(methods, "edgescan+");
    if (thesis == nullptr || plus == nullptr) return text;
    text += "\nThesis, table 6.1        as printed its recipe now    EdgeScan+\n";
    const auto step61 = [&](const char* name, double printed, double then, double now) {
        text += "  " + leftAligned(name, 20) + columns({{printed, 10, 0}}) + " ms" + columns({{then, 12}}) + " ms" + columns({{now, 10}}) +
                " ms\n";
    };
    for (const PrintedStep& step : kTable61) step61(step.name, step.milliseconds, thesis->steps.*step.step, plus->steps.*step.step);
    step61("total", kPrintedTotal, thesis->steps.total(), plus->steps.total());
    text += "\nThesis, table 6.2        as printed            now\n";
    const auto row62 = [&](const char* name, const std::string& printed, const ComparedMethod* method) {
        text += "  " + leftAligned(name, 20) + rightAligned(printed, 13) + rightAligned(milliseconds(method), 12) + " ms\n";
    };
    row62("PCL boundary", fixedText(kPrintedBoundary, 0) + " ms", find(methods, pclMethodName(PclMethod::BoundaryNeighbours)));
    row62("PCL range image", fixedText(kPrintedRangeImage, 0) + " ms", find(methods, pclMethodName(PclMethod::RangeImageBorder)));
    row62("thesis", fixedText(kPrintedTotal, 0) + " ms", thesis);
    row62("EdgeScan+", "", plus);
    return text + "  as printed: the thesis's i7; its range image had 83,000 points. ~ = worked out from a part.\n";
}

nlohmann::ordered_json comparisonReport(const Scan& scan, const std::vector<ComparedMethod>& methods, const ComparisonSettings& settings) {
    Json report{{"input", scan.path},          {"sha256", scan.sha256},          {"lines", scan.lines()},
                {"beams", scan.beams()},       {"points", validCells(scan)},     {"clock", "thread CPU time"},
                {"repeats", settings.repeats}, {"tolerance", settings.tolerance}};
    report["methods"] = Json::array();
    for (const ComparedMethod& method : methods) {
        Json row{{"name", method.name}, {"method", method.key}, {"run", method.wasRun()}};
        if (method.wasRun()) {
            const ComparedSteps& s = method.steps;
            row["ms"] = {{"conversion", s.conversion},
                         {"noise_removal", s.noiseRemoval},
                         {"edges", s.edges},
                         {"merge", s.merge},
                         {"total", s.total()}};
            row["edges"] = method.edges;
            for (const auto& [kind, cells] : method.kinds) row["kinds"][kind] = cells;
            row["share_of_points_done"] = method.share;
        }
        if (method.settings) row["settings"] = edges::settingsToJson(*method.settings);
        row["score"] = method.score ? evaluationJson(*method.score) : Json(nullptr);
        if (method.best)
            row["best"] = {
                {"parameter", method.best->parameter}, {"value", method.best->value}, {"score", evaluationJson(method.best->score)}};
        if (!method.note.empty()) row["note"] = method.note;
        report["methods"].push_back(std::move(row));
    }
    report["table_6_1"] = printedReport(methods);
    const auto today = [&](const std::string& key) -> Json {
        const ComparedMethod* method = find(methods, key);
        if (method == nullptr || !method->wasRun()) return nullptr;
        return method->steps.total();
    };
    report["table_6_2"] = {
        {"pcl_boundary", {{"thesis_printed_ms", kPrintedBoundary}, {"today_ms", today(pclMethodName(PclMethod::BoundaryNeighbours))}}},
        {"pcl_range_image", {{"thesis_printed_ms", kPrintedRangeImage}, {"today_ms", today(pclMethodName(PclMethod::RangeImageBorder))}}},
        {"thesis", {{"thesis_printed_ms", kPrintedTotal}, {"today_ms", today("thesis")}}},
        {"edgescan_plus", {{"today_ms", today("edgescan+")}}}};
    report["version"] = version();
    return report;
}

} // namespace edgescan::lab
