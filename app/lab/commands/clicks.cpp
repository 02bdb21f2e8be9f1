// edgescan-lab clicks: how far lengths between clicks near edges are off, at the clicked cells and on the near side.
#include "app/lab/clicks/clicks.h"
#include "app/lab/clicks/throats.h"
#include "app/lab/commands/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ClicksAsked {
    std::vector<std::string> scenes{"hangup", "pile"};
    int clicks = 1000;
    int throats = 30, repeats = 8;
    int seeds = 3;
    int firstSeed = 7001;
    int lines = 300, beams = 381;
    std::string json;
};

Json lengthsJson(const lab::ClickedLengths& lengths) {
    return {{"measured", lengths.measured},
            {"refused", lengths.refused},
            {"off", lengths.off},
            {"off_share", lengths.shareOff()},
            {"off_without_warning", lengths.offSilently},
            {"median_tolerance_m", lengths.medianToleranceM()},
            {"warned", lengths.warned},
            {"behind", lengths.behind},
            {"behind_without_warning", lengths.silent}};
}

std::string lengthsText(const lab::ClickedLengths& lengths) {
    return fixedText(100.0 * lengths.shareOff(), 1) + " % of " + std::to_string(lengths.measured) + " off by more than their ± (median " +
           fixedText(lengths.medianToleranceM(), 3) + " m), " + std::to_string(lengths.behind) + " on a surface behind, " +
           std::to_string(lengths.silent) + " of these without a warning; " + std::to_string(lengths.warned) + " warned about, " +
           std::to_string(lengths.offSilently) + " off without a warning; " + std::to_string(lengths.refused) + " refused";
}

Json widthsJson(const lab::ThroatWidths& widths) {
    return {
        {"openings", widths.spreads.size()},      {"measured", widths.measured}, {"refused", widths.refused},     {"equal", widths.equal},
        {"median_spread", widths.medianSpread()}, {"off", widths.off},           {"off_share", widths.shareOff()}};
}

std::string widthsText(const lab::ThroatWidths& widths) {
    return std::to_string(widths.spreads.size()) + " openings, " + std::to_string(widths.equal) + " with equal ends, median spread " +
           fixedText(100.0 * widths.medianSpread(), 1) + " % of the width; " + fixedText(100.0 * widths.shareOff(), 1) + " % of " +
           std::to_string(widths.measured) + " differ from the first by more than their ±; " + std::to_string(widths.refused) + " refused";
}

Result<Done> clicks(const ClicksAsked& asked) {
    Json scenes = Json::array();
    for (const std::string& scene : asked.scenes) {
        lab::ClickScore score;
        lab::ThroatScore throats;
        for (int n = 0; n < asked.seeds; ++n) {
            sim::SimulationSettings settings;
            settings.scene = scene;
            settings.seed = static_cast<std::uint64_t>(asked.firstSeed + n);
            settings.lines = asked.lines;
            settings.beams = asked.beams;
            settings.truth = true;
            const auto simulation = sim::simulate(settings);
            if (!simulation) return simulation.error();
            score += lab::scoreClicks(*simulation, asked.clicks, settings.seed);
            throats += lab::scoreThroats(*simulation, asked.throats, asked.repeats, settings.seed);
        }
        scenes.push_back({{"scene", scene},
                          {"clicks", score.clicks},
                          {"moved", score.moved},
                          {"as_clicked", lengthsJson(score.asClicked)},
                          {"near_side", lengthsJson(score.nearSide)},
                          {"throats_of_clicks", widthsJson(throats.ofClicks)},
                          {"throats_around", widthsJson(throats.ofAround)},
                          {"throats_of_one_click", widthsJson(throats.ofOne)}});
        if (asked.json != "-")
            printResult(scene + ": " + std::to_string(score.clicks) + " clicks, " + std::to_string(score.moved) +
                        " moved\n  at the clicked cells: " + lengthsText(score.asClicked) + "\n  on the near side: " +
                        lengthsText(score.nearSide) + "\n  throats, of the two clicks: " + widthsText(throats.ofClicks) +
                        "\n  throats, with the clicks next to them: " + widthsText(throats.ofAround) +
                        "\n  throats, of one click into the opening: " + widthsText(throats.ofOne) + "\n");
    }
    if (asked.json.empty()) return Done{};
    return writeDocument(asked.json, document("clicks", {{"lines", asked.lines},
                                                         {"beams", asked.beams},
                                                         {"first_seed", asked.firstSeed},
                                                         {"seeds", asked.seeds},
                                                         {"clicks_per_scan", asked.clicks},
                                                         {"throats_per_scan", asked.throats},
                                                         {"clicks_per_throat", asked.repeats + 1},
                                                         {"scenes", std::move(scenes)}}));
}

} // namespace

void addClicks(CLI::App& app, int& code) {
    auto asked = std::make_shared<ClicksAsked>();
    CLI::App& command = *app.add_subcommand(
        "clicks",
        "Counts how many lengths between random clicks near the edges of simulated scans are off by more than their stated uncertainty");
    command.add_option("--scene", asked->scenes, "Simulated scenes")->expected(1, 20)->capture_default_str();
    command.add_option("--clicks", asked->clicks, "Clicks per scan")->check(CLI::Range(2, 1000000))->capture_default_str();
    command.add_option("--throats", asked->throats, "Openings per scan whose width is measured")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.add_option("--repeats", asked->repeats, "Further clicks on each opening, up to two cells from the first")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--seeds", asked->seeds, "Scans per scene")->check(CLI::Range(1, 1000))->capture_default_str();
    command.add_option("--seed", asked->firstSeed, "The first seed")->check(CLI::Range(0, 1000000))->capture_default_str();
    command.add_option("--lines", asked->lines, "Scan lines")->check(CLI::Range(20, 4000))->capture_default_str();
    command.add_option("--beams", asked->beams, "Beams")->check(CLI::Range(20, 4000))->capture_default_str();
    addJsonFlag(command, asked->json, "All figures");
    command.callback([asked, &code] {
        const Result<Done> result = clicks(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
