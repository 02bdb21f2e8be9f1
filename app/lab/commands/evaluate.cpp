// edgescan-lab evaluate: a mask, or a method over its thresholds, against ground truth.
#include "app/lab/commands/commands.h"
#include "app/lab/commands/evaluate_rocks.h"
#include "app/lab/score/evaluation.h"
#include "app/lab/score/truth_fit.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Evaluate {
    std::vector<std::string> files, truths, ranges;
    std::string json;
    double tolerance = 2.0;
    bool sweep = false;
    bool facets = false;
    bool rocks = false;
    EvaluateRocks ofRocks; ///< what only --rocks reads
    std::vector<std::string> typedThresholds;
    std::vector<double> thresholds; ///< those typed, once they are checked
    MethodFlags method;
    ReadFlags read;
};

// `own`, the threshold of the settings, is among them: the best of a sweep is never worse than what the settings give.
std::vector<double> usualThresholds(const edges::Parameter& parameter, double own) {
    std::vector<double> thresholds{own};
    const std::string key = parameter.key;
    // Steps fine enough that the best F is missed by less than a thousandth where F is flat, wide enough for all noises.
    const double from = key == "lower" ? 0.5 : key == "step" ? 0.25 : 0.5;
    const double to = key == "lower" ? 4096.0 : key == "step" ? 64.0 : 2.6;
    const double factor = key == "sensitivity" ? 1.1 : std::sqrt(2.0);
    for (double value = from; value <= to; value *= factor) thresholds.push_back(edges::snapped(parameter, value));
    std::ranges::sort(thresholds);
    thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
    return thresholds;
}

/// A scan or a mask, and its truth.
struct Case {
    std::shared_ptr<const Scan> scan; ///< null for a mask without ranges
    Grid<std::uint8_t> mask;          ///< empty for a scan
    sim::TruthSet truth;
};

bool isMask(const std::string& file) { return fs::path(file).extension() == ".png"; }

Result<Done> checkShape(const std::string& file, int lines, int beams, const Grid<std::uint8_t>& wanted) {
    if (lines == wanted.lines && beams == wanted.beams) return Done{};
    return Error{"it has " + std::to_string(lines) + " x " + std::to_string(beams) + " cells and its truth " +
                     std::to_string(wanted.lines) + " x " + std::to_string(wanted.beams),
                 file, "give each file the truth that was written with it"};
}

Result<Case> openCase(const Evaluate& evaluate, std::size_t n) {
    Case one;
    Result<sim::TruthSet> truth = sim::readTruth(evaluate.truths[n], evaluate.facets ? sim::Facets::Folds : sim::Facets::None);
    if (!truth) return truth.error();
    one.truth = std::move(*truth);
    const Grid<std::uint8_t>& wanted = one.truth.edges.edgeClass;
    if (isMask(evaluate.files[n])) {
        auto mask = containers::readPng8(evaluate.files[n]);
        if (!mask) return mask.error();
        if (auto fits = checkShape(evaluate.files[n], mask->lines, mask->beams, wanted); !fits) return fits.error();
        std::array<bool, 256> occurs{};
        for (const std::uint8_t value : mask->cells) occurs[value] = true;
        if (std::ranges::count(occurs, true) > 2)
            printError(evaluate.files[n] +
                       ": this picture has more than two gray values, so it may not be an edge mask; every value but 0 counts as an edge.");
        one.mask = std::move(*mask);
        if (evaluate.ranges.empty()) return one;
    }
    const std::string& file = evaluate.ranges.empty() ? evaluate.files[n] : evaluate.ranges[n];
    Result<Scan> scan = openAndWarn(file, evaluate.read);
    if (!scan) return scan.error();
    if (auto fits = checkShape(file, scan->lines(), scan->beams(), wanted); !fits) return fits.error();
    if (auto fits = lab::checkTruthFits(*scan, one.truth, evaluate.truths[n]); !fits) return fits.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
    one.scan = std::make_shared<const Scan>(std::move(*scan));
    return one;
}

void show(const Json& evaluation) {
    const auto text = [](const Json& number, int decimals) { return fixedText(number.get<double>(), decimals); };
    std::string lines = "                precision  recall      F\n";
    for (const char* group : {"occluding", "outline", "strict_outline", "crease", "all"})
        lines += rightAligned(group, 15) + "      " + text(evaluation[group]["precision"], 3) + "   " +
                 text(evaluation[group]["recall"], 3) + "  " + text(evaluation[group]["f"], 3) + "\n";
    lines += "true cells with a detection within 1 / 2 / 3 cells, and its mean offset across the edge (+: on the farther side)\n";
    for (const auto& [name, place] : evaluation["places"].items())
        lines += rightAligned(name, 15) + "      " + text(place["within_1"], 3) + " / " + text(place["within_2"], 3) + " / " +
                 text(place["within_3"], 3) + "   " + text(place["offset"], 2) + "\n";
    const Json& rocks = evaluation["rocks"];
    if (rocks["count"] == 0)
        lines += "no rock with an outline to find";
    else
        lines += "rocks with 80 / 90 % of their outline: " + fixedText(100 * rocks["at_least_80_percent"].get<double>(), 0) + " / " +
                 fixedText(100 * rocks["at_least_90_percent"].get<double>(), 0) + " % of " + fixedText(rocks["count"].get<double>(), 0);
    if (evaluation.contains("error_mm"))
        lines += ", 3D error P50 / P95 " + text(evaluation["error_mm"]["p50"], 0) + " / " + text(evaluation["error_mm"]["p95"], 0) + " mm";
    printResult(lines + ", Pratt " + text(evaluation["pratt"], 3));
}

void showSweep(const Json& sweep) {
    const auto number = [](const Json& value) { return significantText(value.get<double>(), 6); };
    for (const char* group : {"occluding", "outline", "strict_outline", "crease", "all"})
        printResult(rightAligned(group, 15) + "  ODS " + number(sweep[group]["ods"]) + " at " + number(sweep[group]["ods_threshold"]) +
                    ", OIS " + number(sweep[group]["ois"]) + ", AP " + number(sweep[group]["ap"]));
}

Result<Json> evaluateAll(const Evaluate& evaluate, const edges::Settings& settings) {
    const edges::Parameter& swept = edges::sweptParameter(settings.method);
    lab::ThresholdSweep sweep;
    if (evaluate.sweep) sweep.thresholds = evaluate.thresholds.empty() ? usualThresholds(swept, swept.get(settings)) : evaluate.thresholds;
    lab::Evaluation fixed;
    for (std::size_t n = 0; n < evaluate.files.size(); ++n) {
        Result<Case> one = openCase(evaluate, n);
        if (!one) return one.error();
        if (one->mask.size() > 0) {
            fixed += lab::evaluateMask(one->mask, one->truth, one->scan.get(), evaluate.tolerance);
            continue;
        }
        edges::Pipeline pipeline;
        const auto scoreAt = [&](double threshold) {
            edges::Settings turned = settings;
            swept.set(turned, threshold);
            return lab::evaluateMask(*pipeline.run(one->scan, turned)->mask, one->truth, one->scan.get(), evaluate.tolerance);
        };
        fixed += scoreAt(swept.get(settings));
        std::vector<lab::Evaluation> row;
        for (const double threshold : sweep.thresholds) row.push_back(scoreAt(threshold));
        sweep.perScan.push_back(std::move(row));
    }
    Json json = document("evaluate", Json::object());
    json["files"] = evaluate.files;
    json["tolerance"] = evaluate.tolerance;
    json["facets"] = evaluate.facets;
    if (!isMask(evaluate.files.front())) json["settings"] = edges::settingsToJson(settings);
    json["fixed"] = lab::evaluationJson(fixed);
    json["rocks"] = lab::rocksJson(fixed);
    if (sweep.thresholds.empty()) return json;
    json["swept"] = swept.key;
    json["sweep"] = lab::sweepJson(sweep);
    return json;
}

// Thresholds and flags that a person typed and that would change nothing, or not what was meant; turns the thresholds typed into numbers.
Result<Done> checkUsage(Evaluate& evaluate, const edges::Settings& settings) {
    if (std::all_of(evaluate.files.begin(), evaluate.files.end(), isMask) && anyTyped(evaluate.method))
        return Error{"a mask holds its edges already, so no method finds them", "evaluate", "leave the flags of the method out"};
    const edges::Parameter& swept = edges::sweptParameter(settings.method);
    for (std::size_t n = 0; n < evaluate.typedThresholds.size(); ++n) {
        const std::optional<double> value = numberOf(evaluate.typedThresholds[n]);
        const bool fits = value && NumberLimits{swept.minimum, swept.maximum}.hold(*value);
        if (fits && (n == 0 || *value > evaluate.thresholds.back()))
            evaluate.thresholds.push_back(*value);
        else
            return Error{"\"" + evaluate.typedThresholds[n] + "\" " +
                             (!value ? "is not a number"
                              : fits ? "does not exceed the value before it"
                                     : "is outside the limits of --" + std::string(swept.key)),
                         "--thresholds",
                         "give rising values of --" + std::string(swept.key) + ", from " + edges::formatValue(swept, swept.minimum) +
                             " to " + edges::formatValue(swept, swept.maximum)};
    }
    if (!evaluate.thresholds.empty() && !evaluate.sweep) return Error{"thresholds belong to a sweep", "--thresholds", "give --sweep too"};
    return Done{};
}

/// Flags that were typed though nothing reads them.
std::optional<Error> misplacedFlag(const CLI::App& command, bool rocks) {
    for (const char* flag : {"--scan-of-mask", "--tolerance", "--sweep", "--thresholds", "--facets"}) {
        if (rocks && command.count(flag) > 0) return Error{"it is about edges", flag, "leave it out, or --rocks"};
    }
    for (const char* flag : {"--peers", "--pictures", "--level"}) {
        if (!rocks && command.count(flag) > 0) return Error{"it is about rocks", flag, "give --rocks too, or leave it out"};
    }
    return std::nullopt;
}

int runRocks(Evaluate& evaluate, const edges::Settings& settings) {
    if (std::any_of(evaluate.files.begin(), evaluate.files.end(), isMask))
        return failWith({"a mask holds no rocks", "evaluate --rocks", "give the scans"}, kWrongUsage);
    if (!edges::reads(settings.method, edges::kReadsSurface))
        return failWith({"rocks follow from the surface, which this method does not measure", "--method", "leave it out with --rocks"},
                        kWrongUsage);
    evaluate.ofRocks.choices.edges = settings;
    evaluate.ofRocks.files = evaluate.files;
    evaluate.ofRocks.truths = evaluate.truths;
    evaluate.ofRocks.json = evaluate.json;
    evaluate.ofRocks.read = evaluate.read;
    return evaluateRocks(evaluate.ofRocks);
}

int run(Evaluate& evaluate, const CLI::App& command) {
    if (const auto idle = misplacedFlag(command, evaluate.rocks)) return failWith(*idle, kWrongUsage);
    const Result<edges::Settings> settings = settingsOf(evaluate.method);
    if (!settings) return failWith(settings.error(), kWrongUsage);
    if (const Result<Done> usage = checkUsage(evaluate, *settings); !usage) return failWith(usage.error(), kWrongUsage);
    const bool masks = std::any_of(evaluate.files.begin(), evaluate.files.end(), isMask);
    if (evaluate.files.size() != evaluate.truths.size())
        return failWith({"there are " + std::to_string(evaluate.files.size()) + " files and " + std::to_string(evaluate.truths.size()) +
                             " folders with truth",
                         "evaluate", "give --truth once per file, in the same order"},
                        kWrongUsage);
    if (evaluate.rocks) return runRocks(evaluate, *settings);
    if (evaluate.facets && std::ranges::none_of(evaluate.truths, sim::hasFacets))
        return failWith({"this truth has no facets (gt_class_facets.png)", evaluate.truths.front(), "leave --facets out"}, kWrongUsage);
    const bool allMasks = std::all_of(evaluate.files.begin(), evaluate.files.end(), isMask);
    if (!evaluate.ranges.empty() && (!allMasks || evaluate.ranges.size() != evaluate.files.size()))
        return failWith({"such scans belong to masks, one to each", "--scan-of-mask",
                         "give --scan-of-mask once per mask, in the same order, or leave it out"},
                        kWrongUsage);
    if (evaluate.sweep && masks)
        return failWith({"a mask has no threshold to sweep over", "evaluate", "give the scan and --method instead"}, kWrongUsage);
    return writeOrShow(evaluateAll(evaluate, *settings), evaluate.json, [](const Json& figures) {
        show(figures["fixed"]);
        if (figures.contains("sweep")) showSweep(figures["sweep"]);
    });
}

} // namespace

void addEvaluate(CLI::App& app, int& code) {
    auto evaluate = std::make_shared<Evaluate>();
    CLI::App& command = *app.add_subcommand("evaluate", "Scores edges against ground truth that simulate --truth wrote");
    command.add_option("FILE", evaluate->files, "Edge masks (.png, 255 = edge), or scans to run the method on; figures of all together")
        ->required();
    command.add_option("--truth", evaluate->truths, "Folder with the truth of each file, in the same order")->type_name("DIR")->required();
    command
        .add_option("--scan-of-mask", evaluate->ranges,
                    "Scan that each mask was made from, in the same order: also the 3D error of its edges")
        ->type_name("FILE");
    addNumber(command, "--tolerance", evaluate->tolerance, {0, 20}, "How far a detection may lie from a true edge [cells]");
    command.add_flag("--facets", evaluate->facets,
                     "Folds between the facets of re-scanned surfaces are true edges; without it no fold of theirs is one");
    command.add_flag("--sweep", evaluate->sweep, "Also the best threshold for all scans (ODS), for each (OIS), and average precision");
    command
        .add_option("--thresholds", evaluate->typedThresholds,
                    "Thresholds of the sweep, ascending, instead of the usual ones; within the limits of the method's threshold")
        ->delimiter(',')
        ->type_name("NUMBER,...");
    addJsonFlag(command, evaluate->json, "All figures", {"evaluate", "evaluate-rocks"});
    const char* rocks = "Rocks";
    command.add_flag("--rocks", evaluate->rocks, "Scores the rocks found in simulated scans instead of the edges")->group(rocks);
    const auto level =
        std::ranges::find_if(rocks::rockParameters(), [](const rocks::RockParameter& p) { return p.key == std::string_view("level"); });
    addNumber(command, "--level", evaluate->ofRocks.choices.rocks.level, {level->minimum, level->maximum}, level->help).group(rocks);
    command.add_flag("--peers", evaluate->ofRocks.peers, "Also PCL's RegionGrowing and LCCP")->group(rocks);
    command.add_option("--pictures", evaluate->ofRocks.pictures, "Folder for a picture per scan: rocks found, merged, split and missed")
        ->type_name("DIR")
        ->group(rocks);
    addMethodFlags(command, evaluate->method);
    addReadFlags(command, evaluate->read);
    command.callback([evaluate, &command, &code] { code = run(*evaluate, command); });
}

} // namespace edgescan::cli
