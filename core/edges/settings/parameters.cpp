// The one table of parameters. A new parameter is one entry here and one member of Settings.
#include "core/edges/settings/parameters.h"

#include "core/base/nearest_name.h"
#include "core/base/number_text.h"
#include "core/edges/settings/method_traits.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace edgescan::edges {
namespace {

const std::vector<Choice> kClasses{{kClassJump, "jump", "jump"},
                                   {kClassConvex, "convex", "convex fold"},
                                   {kClassConcave, "concave", "concave fold"},
                                   {kClassBorder, "border", "data border"},
                                   {kClassSilhouette, "silhouette", "outline before a void"},
                                   {kClassVoidRim, "rim", "void rim"}};
const std::vector<Choice> kOffOn{{0, "off", "off"}, {1, "on", "on"}};
const std::vector<Choice> kShownEdges{{0, "off", "All edges"}, {1, "on", "Rock borders"}};
const std::vector<Choice> kScalings{{0, "thesis", "Thesis"}, {1, "window", "Even"}, {2, "log", "Logarithmic"}};
const std::vector<Choice> kKernels{{1, "1", "1 (off)"}, {3, "3", "3"}, {5, "5", "5"}, {7, "7", "7"}, {9, "9", "9"}, {11, "11", "11"}};
const std::vector<Choice> kApertures{{3, "3", "3"}, {5, "5", "5"}, {7, "7", "7"}};
const std::vector<Choice> kNorms{{0, "l1", "L1  |gx| + |gy|"}, {1, "l2", "L2  sqrt(gx² + gy²)"}};
const std::vector<Choice> kLogMasks{{0, "four", "4 neighbours"}, {1, "eight", "8 neighbours"}, {2, "5x5", "5 x 5"}};

const std::vector<Choice> kRules{{4, "4", "of default set 4"}, {5, "5", "of today"}};
const std::vector<Choice> kNoiseKinds{{0, "measured", "as measured"}, {1, "laser", "laser"}, {2, "camera", "depth camera"}};

constexpr bool kAdvanced = true;
constexpr bool kSeveral = true;

std::vector<Choice> methodChoices() {
    std::vector<Choice> choices;
    for (const MethodTraits& m : methodTraits()) choices.push_back({static_cast<double>(m.method), m.key, m.label});
    return choices;
}

// The functions for "used by".
bool always(const Settings&) { return true; }
template <unsigned what>
bool readers(const Settings& s) {
    return reads(s.method, what);
}
constexpr auto surface = readers<kReadsSurface>;
constexpr auto gray = readers<kReadsGray>;
constexpr auto twoThresholds = readers<kReadsTwoThresholds>;
bool rockBorders(const Settings& s) { return surface(s) && s.rockBorders; }
bool roughScans(const Settings& s) { return reads(s.method, kReadsCreases) && s.rules < 5; }
bool nearFar(const Settings& s) { return gray(s) && s.scaling != Scaling::Thesis; }
bool fillEdges(const Settings& s) { return surface(s) && s.fillCells > 0; }
bool isolated(const Settings& s) { return gray(s) && s.maskMissing; }
bool sigma(const Settings& s) { return reads(s.method, kReadsSigma) || (reads(s.method, kReadsKernel) && s.kernel > 1); }

// The value of "auto"; null: the parameter cannot be automatic.
using Automatic = double (*)(const Settings&, const Measured&);
constexpr Automatic kNoAuto = nullptr;

// clang-format off
const std::vector<Parameter>& table() {
    //   key, label, unit, help, minimum, maximum, step, decimals, member, slider maximum, value of auto, advanced, choices, several, used by, feeds
    static const std::vector<Parameter> rows{
        {"method", "Method", "", "How edges are found: jumps and folds of the surface, parts of these, or Canny on gray levels as in the thesis, or one of the other detectors the thesis compares.",
         0, static_cast<double>(methodTraits().size() - 1), 1, 0, EDGESCAN_NUMBER(Settings, method), static_cast<double>(methodTraits().size() - 1), kNoAuto, !kAdvanced, methodChoices(), !kSeveral, always, Stage::Edges},
        {"rock-borders", "Edges shown", "", "Only edges that are likely the border of a rock are shown and exported; folds within a rock are left out.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, rockBorders), 1, kNoAuto, !kAdvanced, kShownEdges, !kSeveral, surface, Stage::Edges},
        {"border-from", "Border from", "%", "How likely an edge must be the border of a rock to be shown among the rock borders.",
         1, 99, 1, 0, EDGESCAN_NUMBER(Settings, borderPercent), 99, kNoAuto, !kAdvanced, {}, !kSeveral, rockBorders, Stage::Edges},
        {"sensitivity", "Edge strength", "x", "How strong an edge must be, so higher finds fewer: 1 is the jump and the crease angle below, 2 is twice that.",
         0.3, 3, 0.05, 2, EDGESCAN_NUMBER(Settings, sensitivity), 3, kNoAuto, !kAdvanced, {}, !kSeveral, surface, Stage::Threshold, "edge-strength"},
        {"jump", "Jump", "mm", "Smallest step in depth that is an edge, near the scanner; auto takes 30 mm and more where the ranges are noisy.",
         10, 300, 1, 0, EDGESCAN_NUMBER(Settings, jumpMm), 300, [](const Settings&, const Measured& m) { return m.jumpMm; }, !kAdvanced, {}, !kSeveral, surface, Stage::Responses},
        {"growth", "Jump growth", "% of range", "What the smallest step grows by with the distance.",
         0, 3, 0.05, 2, EDGESCAN_NUMBER(Settings, growthPercent), 3, kNoAuto, !kAdvanced, {}, !kSeveral, surface, Stage::Responses},
        {"crease", "Crease angle", "degrees", "Smallest fold of the surface that is an edge.",
         15, 90, 1, 0, EDGESCAN_NUMBER(Settings, creaseDeg), 90, kNoAuto, !kAdvanced, {}, !kSeveral, readers<kReadsCreases>, Stage::Responses},
        {"min-length", "Minimum length", "cells", "Shorter chains of edge cells are dropped. At a void each class is chained by itself: a rim in two classes is two chains.",
         1, 50, 1, 0, EDGESCAN_NUMBER(Settings, minimumLength), 50, kNoAuto, !kAdvanced, {}, !kSeveral, surface, Stage::Edges},
        {"classes", "Classes", "", "Which edges count: jumps in depth, convex folds (ridges), concave folds (contacts between rocks), the near side of a void with something farther behind it, and the rim of an open void; and where the data end, which is not an edge.",
         0, 63, 1, 0, EDGESCAN_NUMBER(Settings, classes), 63, kNoAuto, !kAdvanced, kClasses, kSeveral, readers<kReadsClasses>, Stage::Edges},
        {"hysteresis-low", "Hysteresis low", "% of high", "Weaker cells of this strength are edges where they continue a strong one.",
         30, 100, 1, 0, EDGESCAN_NUMBER(Settings, hysteresisPercent), 100, kNoAuto, kAdvanced, {}, !kSeveral, surface, Stage::Edges},
        {"grazing", "Grazing tolerance", "steps", "How far out of place a beam may be before a grazing surface shows a jump: 0.1 for a motor sweep, 1 for interlaced beams.",
         0, 2, 0.05, 2, EDGESCAN_NUMBER(Settings, grazing), 2, kNoAuto, kAdvanced, {}, !kSeveral, surface, Stage::Responses},
        {"slips", "Allow for slips", "", "Beams interlaced from two passes and lines at which the stepper slipped are recognised and taken into account.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, straighten), 1, kNoAuto, kAdvanced, kOffOn, !kSeveral, surface, Stage::Surface},
        {"turns", "Allow for turns", "", "At the first and last lines of a sweep a stepper may still swing back, so that every surface seems to fold there; such folds are left out.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, turns), 1, kNoAuto, kAdvanced, kOffOn, !kSeveral, surface, Stage::Responses},
        {"noise", "Range noise at 5 m", "mm", "Sigma of the ranges at 5 m; auto measures it in the scan.",
         1, 30, 0.25, 2, EDGESCAN_NUMBER(Settings, noiseMm), 30, [](const Settings&, const Measured& m) { return m.noiseMm; }, kAdvanced, {}, !kSeveral, surface, Stage::Surface},
        {"noise-kind", "Noise from cell to cell", "", "Whether each cell errs for itself, as with a laser, or neighbours err alike, as with a depth camera whose depth comes in steps: folds then have to exceed what such steps look like.",
         0, 2, 1, 0, EDGESCAN_NUMBER(Settings, noiseKind), 2, kNoAuto, kAdvanced, kNoiseKinds, !kSeveral, surface, Stage::Surface},
        {"rules", "Rules", "", "How noise is measured and where the rim of a void ends: as today, or as in default set 4, which also has a rule for rough scans.",
         4, 5, 1, 0, EDGESCAN_NUMBER(Settings, rules), 5, kNoAuto, kAdvanced, kRules, !kSeveral, surface, Stage::Surface},
        {"rough-scans", "Rough scans", "", "Only by the rules of default set 4. Where half of the folds are on surfaces that fold everywhere, such as heaps of small boulders, a fold counts only if it exceeds its surroundings.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, roughScans), 1, kNoAuto, kAdvanced, kOffOn, !kSeveral, roughScans, Stage::Responses},
        {"fill", "Fill gaps", "cells", "Gaps up to this width are filled from their surroundings, never across a jump. Filled cells are marked and never count as measured. 0 switches filling off.",
         0, 20, 1, 0, EDGESCAN_NUMBER(Settings, fillCells), 20, kNoAuto, kAdvanced, {}, !kSeveral, always, Stage::Surface},
        {"fill-edges", "Edges in gaps", "", "Filled cells take part in finding edges, and may be edges that no beam measured.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, fillEdges), 1, kNoAuto, kAdvanced, kOffOn, !kSeveral, fillEdges, Stage::Surface},
        {"lower", "Lower threshold", "levels", "A cell with a gradient above this is an edge: with Canny if a chain of such cells leads to a strong one, with detectors of one threshold always.",
         0, 20000, 1, 1, EDGESCAN_NUMBER(Settings, lower), 340, kNoAuto, !kAdvanced, {}, !kSeveral, gray, Stage::Threshold},
        {"step", "Step", "% of range", "A straight step of this share of the range is a weak edge, one of about ratio times that a strong one.",
         0.1, 100, 0.1, 2, EDGESCAN_NUMBER(Settings, stepPercent), 20, kNoAuto, !kAdvanced, {}, !kSeveral, readers<kReadsRangeStep>, Stage::Threshold},
        {"ratio", "Ratio upper : lower", "x", "Upper threshold as a multiple of the lower one; the thesis keeps 3.",
         1, 10, 0.1, 2, EDGESCAN_NUMBER(Settings, ratio), 10, kNoAuto, !kAdvanced, {}, !kSeveral, twoThresholds, Stage::Edges},
        {"kernel", "Gaussian kernel", "cells", "Size of the smoothing kernel; 1 switches smoothing off.",
         1, 11, 2, 0, EDGESCAN_NUMBER(Settings, kernel), 11, kNoAuto, !kAdvanced, kKernels, !kSeveral, readers<kReadsKernel>, Stage::Smoothing},
        {"sigma", "Gaussian sigma", "cells", "Width of the smoothing; auto takes it from the kernel size.",
         0.1, 10, 0.05, 2, EDGESCAN_NUMBER(Settings, sigma), 10, [](const Settings& s, const Measured&) { return automaticSigma(s); }, !kAdvanced, {}, !kSeveral, sigma, Stage::Smoothing},
        {"scaling", "Gray scaling", "", "How ranges become gray levels: as the thesis prints it, evenly from near to far, or by equal ratios from near to far.",
         0, 2, 1, 0, EDGESCAN_NUMBER(Settings, scaling), 2, kNoAuto, !kAdvanced, kScalings, !kSeveral, gray, Stage::Gray},
        {"near", "Near", "mm", "Range drawn as gray 0; auto takes it from the scan. Not used by thesis scaling.",
         0, 200000, 10, 0, EDGESCAN_NUMBER(Settings, nearMm), 40000, [](const Settings&, const Measured& m) { return m.nearMm; }, !kAdvanced, {}, !kSeveral, nearFar, Stage::Gray},
        {"far", "Far", "mm", "Range drawn as gray 255; auto takes it from the scan. Not used by thesis scaling.",
         0, 200000, 10, 0, EDGESCAN_NUMBER(Settings, farMm), 40000, [](const Settings&, const Measured& m) { return m.farMm; }, !kAdvanced, {}, !kSeveral, nearFar, Stage::Gray},
        {"mask-missing", "Mask missing data", "", "Keeps cells without a range out of smoothing and gradient, so that the border of a hole is not an edge.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, maskMissing), 1, kNoAuto, !kAdvanced, kOffOn, !kSeveral, gray, Stage::Mask},
        {"mask-isolated", "Mask isolated cells", "", "With missing data masked: a cell that fewer than 2 of its 8 neighbours agree with (dust) counts as missing.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, maskIsolated), 1, kNoAuto, !kAdvanced, kOffOn, !kSeveral, isolated, Stage::Mask},
        {"aperture", "Sobel aperture", "cells", "Size of the gradient operator; larger ones need thresholds many times higher.",
         3, 7, 2, 0, EDGESCAN_NUMBER(Settings, aperture), 7, kNoAuto, kAdvanced, kApertures, !kSeveral, twoThresholds, Stage::Edges},
        {"norm", "Gradient norm", "", "How the two gradient components become one magnitude.",
         0, 1, 1, 0, EDGESCAN_NUMBER(Settings, norm), 1, kNoAuto, kAdvanced, kNorms, !kSeveral, readers<kReadsNorm>, Stage::Edges},
        {"log-mask", "Laplacian mask", "", "Which mask approximates the Laplacian of Gaussian.",
         0, 2, 1, 0, EDGESCAN_NUMBER(Settings, logMask), 2, kNoAuto, !kAdvanced, kLogMasks, !kSeveral, readers<kReadsLaplacianMask>, Stage::Edges},
    };
    return rows;
}
// clang-format on

std::string choiceNames(const Parameter& parameter) {
    std::string names;
    for (const Choice& choice : parameter.choices) names += (names.empty() ? "" : ", ") + std::string(choice.name);
    return names;
}

Result<double> withinLimits(const Parameter& parameter, double value) {
    // Counts of cells have no fraction.
    Settings held;
    parameter.set(held, value);
    if (std::abs(value) < 1e9 && parameter.get(held) != value)
        return Error{shortestText(value) + " is not a whole number", flagOf(parameter),
                     "give a whole number such as " + shortestText(std::clamp(std::ceil(value), parameter.minimum, parameter.maximum))};
    if (value >= parameter.minimum && value <= parameter.maximum) return value;
    const std::string unit = *parameter.unit == '\0' ? "" : std::string(" ") + parameter.unit;
    return Error{shortestText(value) + " is outside " + shortestText(parameter.minimum) + " to " + shortestText(parameter.maximum) + unit,
                 flagOf(parameter), "give a value within these limits"};
}

// "2.5m", "2500 mm", "2500" -> 2500 for a parameter in mm; the parameter's own unit is always allowed.
bool stripUnit(const Parameter& parameter, std::string_view& text, double& factor) {
    const auto ends = [&](std::string_view unit) {
        if (unit.empty() || text.size() <= unit.size() || !text.ends_with(unit)) return false;
        text.remove_suffix(unit.size());
        while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
        return true;
    };
    factor = 1.0;
    const std::string_view unit = parameter.unit;
    if (ends(unit) || ends(unit.substr(0, unit.find(' ')))) return true; // "1%" of "% of range"
    if (std::string_view(parameter.unit) == "mm" && ends("m")) factor = 1000.0;
    return true;
}

// ", in mm, or with its unit: mm or m"
std::string unitText(const Parameter& parameter) {
    const std::string unit = parameter.unit;
    return unit.empty() || unit == "x" ? "" : ", in " + unit + (unit == "mm" ? ", or with its unit: mm or m" : "");
}

// "jump,concave" -> the sum of their values; "all" and "none" are also accepted.
Result<double> parseSet(const Parameter& parameter, std::string_view text) {
    if (text == "all") return parameter.maximum;
    if (text == "none") return parameter.minimum;
    int set = 0;
    for (std::string_view rest = text; true;) {
        const std::string_view name = rest.substr(0, rest.find(','));
        if (name.empty() || name.find(' ') != name.npos)
            return Error{"\"" + std::string(text) + "\" has a comma too many or a blank", flagOf(parameter),
                         "write the names with commas between them and no blanks, as in jump,convex"};
        const auto found = std::ranges::find_if(parameter.choices, [&](const Choice& c) { return name == c.name; });
        if (found == parameter.choices.end()) {
            return Error{"\"" + std::string(name) + "\" is not one of " + choiceNames(parameter), flagOf(parameter),
                         "give all, none, or one or several of these, separated by commas"};
        }
        if ((set & static_cast<int>(found->value)) != 0)
            return Error{"\"" + std::string(name) + "\" is given twice", flagOf(parameter), "give it once"};
        set |= static_cast<int>(found->value);
        if (name.size() == rest.size()) return set;
        rest.remove_prefix(name.size() + 1);
    }
}

std::string formatSet(const Parameter& parameter, double value) {
    if (value == parameter.maximum) return "all";
    std::string names;
    for (const Choice& choice : parameter.choices) {
        if ((static_cast<int>(value) & static_cast<int>(choice.value)) != 0) names += (names.empty() ? "" : ",") + std::string(choice.name);
    }
    return names.empty() ? "none" : names;
}

// Whether a stage uses, directly or through other stages, a parameter that is first used in stage `fed`.
bool reaches(Stage fed, Stage stage) {
    switch (stage) {
    case Stage::Smoothing:
        return fed <= Stage::Smoothing;
    case Stage::Responses:
        return fed == Stage::Surface || fed == Stage::Responses;
    case Stage::Edges:
    case Stage::Threshold:
        return fed <= stage;
    default:
        return fed == stage;
    }
}

} // namespace

bool operator==(const Settings& a, const Settings& b) { return sameUpTo(Stage::Threshold, a, b); }

bool sameUpTo(Stage stage, const Settings& a, const Settings& b) {
    return std::ranges::all_of(table(), [&](const Parameter& p) {
        const double x = p.get(a);
        const double y = p.get(b);
        return x == y || (std::isnan(x) && std::isnan(y)) || !reaches(p.feeds, stage);
    });
}

const Parameter& sweptParameter(Method method) {
    Settings settings;
    settings.method = method;
    return *std::ranges::find_if(table(), [&](const Parameter& p) { return p.feeds == Stage::Threshold && p.usedBy(settings); });
}

std::span<const Parameter> parameters() { return table(); }

std::string flagOf(const Parameter& parameter) { return std::string("--") + (parameter.name != nullptr ? parameter.name : parameter.key); }

const Parameter* findParameter(std::string_view key) {
    const auto found =
        std::ranges::find_if(table(), [&](const Parameter& p) { return key == p.key || (p.name != nullptr && key == p.name); });
    return found == table().end() ? nullptr : &*found;
}

Result<double> parseValue(const Parameter& parameter, std::string_view text) {
    if (text == "auto" && parameter.automatic != nullptr) return kAutomatic;
    if (parameter.several) return parseSet(parameter, text);
    for (const Choice& choice : parameter.choices) {
        if (text == choice.name) return choice.value;
    }
    const std::string typed(text);
    if (!parameter.choices.empty()) {
        return Error{"\"" + typed + "\" is not one of " + choiceNames(parameter), flagOf(parameter), "give one of these"};
    }
    double factor = 1.0;
    stripUnit(parameter, text, factor);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        return Error{"\"" + typed + "\" is not a number" + (parameter.automatic != nullptr ? " and not auto" : ""), flagOf(parameter),
                     "write it like 12.5" + unitText(parameter)};
    }
    return withinLimits(parameter, value * factor);
}

std::string formatValue(const Parameter& parameter, double value) {
    if (std::isnan(value)) return "auto";
    if (parameter.several) return formatSet(parameter, value);
    for (const Choice& choice : parameter.choices) {
        if (choice.value == value) return choice.name;
    }
    return shortestText(value);
}

double snapped(const Parameter& parameter, double value) {
    if (std::isnan(value)) return parameter.automatic != nullptr ? value : parameter.minimum;
    if (!parameter.choices.empty() && !parameter.several) {
        const auto nearest = std::ranges::min_element(
            parameter.choices, [&](const Choice& a, const Choice& b) { return std::abs(a.value - value) < std::abs(b.value - value); });
        return nearest->value;
    }
    const double tens = std::pow(10.0, parameter.decimals);
    return std::clamp(std::round(value * tens) / tens, parameter.minimum, parameter.maximum);
}

Result<Done> checkSettings(const Settings& s) {
    if (reads(s.method, kReadsGray | kReadsTwoThresholds) && s.scaling != Scaling::Thesis && s.nearMm >= s.farMm) {
        return Error{"near " + shortestText(s.nearMm) + " mm is not smaller than far " + shortestText(s.farMm) + " mm", "--near --far",
                     "give a near that is smaller than far"};
    }
    return Done{};
}

std::string choiceLabel(const Parameter& parameter, const Settings& settings) {
    if (parameter.several) {
        std::string labels;
        for (const Choice& choice : parameter.choices) {
            if ((static_cast<unsigned>(parameter.get(settings)) & static_cast<unsigned>(choice.value)) != 0)
                labels += (labels.empty() ? "" : ", ") + std::string(choice.label);
        }
        return labels.empty() ? formatValue(parameter, parameter.get(settings)) : labels;
    }
    const auto found = std::ranges::find_if(parameter.choices, [&](const Choice& c) { return c.value == parameter.get(settings); });
    return found == parameter.choices.end() ? formatValue(parameter, parameter.get(settings)) : found->label;
}

nlohmann::json settingsToJson(const Settings& settings) {
    nlohmann::json object = nlohmann::json::object();
    for (const Parameter& p : table()) {
        const double value = p.get(settings);
        const bool asNumber = !std::isnan(value) && (p.choices.empty() || (p.choices.front().name[0] <= '9' && !p.several));
        if (asNumber && value == std::floor(value))
            object[p.key] = static_cast<std::int64_t>(value);
        else if (asNumber)
            object[p.key] = value;
        else
            object[p.key] = formatValue(p, value);
    }
    return object;
}

Result<Settings> settingsFromJson(const nlohmann::json& object, Settings settings, const std::string& where) {
    if (!object.is_object()) return Error{"the settings are not a JSON object", where, "write {\"kernel\": 3, ...}"};
    std::vector<const Parameter*> named;
    for (const auto& [key, value] : object.items()) {
        const Parameter* parameter = findParameter(key);
        if (parameter == nullptr) {
            std::vector<std::string> known;
            for (const Parameter& p : table()) {
                known.emplace_back(p.key);
                if (p.name != nullptr) known.emplace_back(p.name);
            }
            const std::string meant = nearestName(key, known);
            return Error{"there is no parameter \"" + key + "\"", where,
                         (meant.empty() ? "" : "did you mean " + meant + "? ") + "see edgescan-cli detect --help for the names"};
        }
        if (std::ranges::find(named, parameter) != named.end())
            return Error{"two names of one setting are given", where, std::string("give ") + parameter->key + " or " + parameter->name};
        named.push_back(parameter);
        std::string text;
        if (value.is_string())
            text = value.get<std::string>();
        else if (value.is_boolean())
            text = value.get<bool>() ? "on" : "off";
        else if (value.is_number())
            text = shortestText(value.get<double>());
        else
            return Error{key + ": this is neither a number nor a text", where, "write it like 12.5, or like \"jump,convex\""};
        const Result<double> parsed = parseValue(*parameter, text);
        if (!parsed) return Error{key + ": " + parsed.error().what, where, parsed.error().hint};
        parameter->set(settings, *parsed);
    }
    return settings;
}

} // namespace edgescan::edges
