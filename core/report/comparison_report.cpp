// A comparison as tables and as JSON.
#include "core/report/comparison_report.h"

#include "core/base/version.h"
#include "core/settings/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace edgescan {
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
constexpr double kPrintedTotal = 297;
constexpr double kPrintedBoundary = 1852880;
constexpr double kPrintedRangeImage = 4510; // on 83,000 points

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

const ComparedMethod* find(const std::vector<ComparedMethod>& methods, const std::string& key) {
    const auto found = std::ranges::find(methods, key, &ComparedMethod::key);
    return found == methods.end() ? nullptr : &*found;
}

std::size_t validCells(const Scan& scan) { return countCells(scan)[static_cast<std::size_t>(CellState::Valid)]; }

std::string milliseconds(const ComparedMethod* method) {
    if (method == nullptr || !method->wasRun()) return "-";
    return formatted(method->share < 1.0 ? "~%.0f" : "%.1f", method->steps.total());
}

std::string methodRow(const ComparedMethod& method) {
    std::string row = formatted("%-34s", method.name.c_str());
    if (!method.wasRun()) return row + "  not run\n";
    const ComparedSteps& s = method.steps;
    row += formatted("%9.1f %9.1f %10.1f %8.1f %10.1f %9zu", s.conversion, s.noiseRemoval, s.edges, s.merge, s.total(), method.edges);
    if (method.score) {
        const EdgeScore& score = method.score->score;
        row += formatted("  %.3f  %.3f  %.3f  %.3f", score.occluding.f(), score.outline.f(), score.crease.f(), score.all.f());
    }
    if (method.best)
        row += formatted("  %.3f at %s %.3g", method.best->score.score.all.f(), method.best->parameter.c_str(), method.best->value);
    return row + "\n";
}

// Null unless both of the methods that the table holds were compared.
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
    std::string text = formatted("%s: %d lines x %d beams, %zu points; milliseconds of thread CPU time\n\n", scan.name.c_str(),
                                 scan.lines(), scan.beams(), validCells(scan));
    text += formatted("%-34s%9s %9s %10s %8s %10s %9s", "", "convert", "denoise", "edges", "merge", "total", "cells");
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
    text += formatted("\nThesis, table 6.1      %12s %14s %12s\n", "as printed", "its recipe now", "EdgeScan+");
    for (const PrintedStep& step : kTable61)
        text += formatted("  %-20s %9.0f ms %11.1f ms %9.1f ms\n", step.name, step.milliseconds, thesis->steps.*step.step,
                          plus->steps.*step.step);
    text += formatted("  %-20s %9.0f ms %11.1f ms %9.1f ms\n", "total", kPrintedTotal, thesis->steps.total(), plus->steps.total());
    const ComparedMethod* boundary = find(methods, peerName(Peer::BoundaryNeighbours));
    const ComparedMethod* borders = find(methods, peerName(Peer::RangeImageBorder));
    text += formatted("\nThesis, table 6.2      %12s %14s\n", "as printed", "now");
    text += formatted("  %-20s %9.0f ms %11s ms\n", "PCL boundary", kPrintedBoundary, milliseconds(boundary).c_str());
    text += formatted("  %-20s %9.0f ms %11s ms\n", "PCL range image", kPrintedRangeImage, milliseconds(borders).c_str());
    text += formatted("  %-20s %9.0f ms %11s ms\n", "thesis", kPrintedTotal, milliseconds(thesis).c_str());
    text += formatted("  %-20s %12s %11s ms\n", "EdgeScan+", "", milliseconds(plus).c_str());
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
        if (method.settings) row["settings"] = settingsToJson(*method.settings);
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
        {"pcl_boundary", {{"thesis_printed_ms", kPrintedBoundary}, {"today_ms", today(peerName(Peer::BoundaryNeighbours))}}},
        {"pcl_range_image", {{"thesis_printed_ms", kPrintedRangeImage}, {"today_ms", today(peerName(Peer::RangeImageBorder))}}},
        {"thesis", {{"thesis_printed_ms", kPrintedTotal}, {"today_ms", today("thesis")}}},
        {"edgescan_plus", {{"today_ms", today("edgescan+")}}}};
    report["version"] = version();
    return report;
}

} // namespace edgescan
