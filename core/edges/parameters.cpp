// The one table of parameters. A new parameter is one entry here and one member of Settings.
#include "core/edges/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace edgescan {
namespace {

const std::vector<Choice> kOffOn{{0, "off", "off"}, {1, "on", "on"}};
const std::vector<Choice> kScalings{
    {0, "thesis", "Thesis (255 / span)"}, {1, "window", "Window (near to far)"}, {2, "log", "Logarithmic (near to far)"}};
const std::vector<Choice> kKernels{{1, "1", "1 (off)"}, {3, "3", "3"}, {5, "5", "5"}, {7, "7", "7"}, {9, "9", "9"}, {11, "11", "11"}};
const std::vector<Choice> kApertures{{3, "3", "3"}, {5, "5", "5"}, {7, "7", "7"}};
const std::vector<Choice> kNorms{{0, "l1", "L1  |gx| + |gy|"}, {1, "l2", "L2  sqrt(gx² + gy²)"}};

constexpr bool kAuto = true;
constexpr bool kAdvanced = true;

// Reads and writes one member of Settings.
#define EDGESCAN_MEMBER(member)                                                                                                            \
    [](const Settings& s) { return static_cast<double>(s.member); },                                                                       \
        [](Settings& s, double v) { s.member = static_cast<decltype(s.member)>(v); }

// clang-format off
const std::vector<Parameter>& table() {
    //   key, label, unit, help, minimum, maximum, slider maximum, step, decimals, can be automatic, advanced, choices, member
    static const std::vector<Parameter> rows{
        {"lower", "Lower threshold", "levels", "A cell with a gradient above this is an edge if a chain of such cells leads to a strong one.",
         0, 20000, 340, 1, 1, !kAuto, !kAdvanced, {}, EDGESCAN_MEMBER(lower)},
        {"ratio", "Ratio upper : lower", "x", "Upper threshold as a multiple of the lower one; the thesis keeps 3.",
         1, 10, 10, 0.1, 2, !kAuto, !kAdvanced, {}, EDGESCAN_MEMBER(ratio)},
        {"kernel", "Gaussian kernel", "cells", "Size of the smoothing kernel; 1 switches smoothing off.",
         1, 11, 11, 2, 0, !kAuto, !kAdvanced, kKernels, EDGESCAN_MEMBER(kernel)},
        {"sigma", "Gaussian sigma", "cells", "Width of the smoothing; auto takes it from the kernel size.",
         0.1, 10, 10, 0.05, 2, kAuto, !kAdvanced, {}, EDGESCAN_MEMBER(sigma)},
        {"scaling", "Gray scaling", "", "How ranges become gray levels: as the thesis prints it, evenly from near to far, or by equal ratios from near to far.",
         0, 2, 2, 1, 0, !kAuto, !kAdvanced, kScalings, EDGESCAN_MEMBER(scaling)},
        {"near", "Near", "mm", "Range drawn as gray 0; auto takes it from the scan. Not used by thesis scaling.",
         0, 200000, 40000, 10, 0, kAuto, !kAdvanced, {}, EDGESCAN_MEMBER(nearMm)},
        {"far", "Far", "mm", "Range drawn as gray 255; auto takes it from the scan. Not used by thesis scaling.",
         0, 200000, 40000, 10, 0, kAuto, !kAdvanced, {}, EDGESCAN_MEMBER(farMm)},
        {"mask-missing", "Mask missing data", "", "Keeps cells without a range out of smoothing and gradient, so that the border of a hole is not an edge.",
         0, 1, 1, 1, 0, !kAuto, !kAdvanced, kOffOn, EDGESCAN_MEMBER(maskMissing)},
        {"mask-isolated", "Mask isolated cells", "", "With missing data masked: a cell that fewer than 2 of its 8 neighbours agree with (dust) counts as missing.",
         0, 1, 1, 1, 0, !kAuto, !kAdvanced, kOffOn, EDGESCAN_MEMBER(maskIsolated)},
        {"aperture", "Sobel aperture", "cells", "Size of the gradient operator; larger ones need thresholds many times higher.",
         3, 7, 7, 2, 0, !kAuto, kAdvanced, kApertures, EDGESCAN_MEMBER(aperture)},
        {"norm", "Gradient norm", "", "How the two gradient components become one magnitude.",
         0, 1, 1, 1, 0, !kAuto, kAdvanced, kNorms, EDGESCAN_MEMBER(norm)},
    };
    return rows;
}
// clang-format on

std::string shortest(double value) {
    std::array<char, 64> buffer{}; // values are within the limits of the table
    const auto format = std::abs(value) < 1e15 ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr;
    return {buffer.data(), end};
}

std::string choiceNames(const Parameter& parameter) {
    std::string names;
    for (const Choice& choice : parameter.choices) names += (names.empty() ? "" : ", ") + std::string(choice.name);
    return names;
}

std::string flag(const Parameter& parameter) { return std::string("--") + parameter.key; }

Result<double> withinLimits(const Parameter& parameter, double value) {
    if (value >= parameter.minimum && value <= parameter.maximum) return value;
    const std::string unit = *parameter.unit == '\0' ? "" : std::string(" ") + parameter.unit;
    return Error{shortest(value) + " is outside " + shortest(parameter.minimum) + " to " + shortest(parameter.maximum) + unit,
                 flag(parameter), "give a value within these limits"};
}

// "2.5m", "2500 mm", "2500" -> 2500 for a parameter in mm; the unit's own name is always allowed.
bool stripUnit(const Parameter& parameter, std::string_view& text, double& factor) {
    const auto ends = [&](std::string_view unit) {
        if (unit.empty() || text.size() <= unit.size() || !text.ends_with(unit)) return false;
        text.remove_suffix(unit.size());
        while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
        return true;
    };
    factor = 1.0;
    if (ends(parameter.unit)) return true;
    if (std::string_view(parameter.unit) == "mm" && ends("m")) factor = 1000.0;
    return true;
}

} // namespace

bool operator==(const Settings& a, const Settings& b) {
    return std::ranges::all_of(table(), [&](const Parameter& p) {
        const double x = p.get(a);
        const double y = p.get(b);
        return x == y || (std::isnan(x) && std::isnan(y));
    });
}

std::span<const Parameter> parameters() { return table(); }

const Parameter* findParameter(std::string_view key) {
    const auto found = std::ranges::find_if(table(), [&](const Parameter& p) { return key == p.key; });
    return found == table().end() ? nullptr : &*found;
}

Result<double> parseValue(const Parameter& parameter, std::string_view text) {
    if (text == "auto" && parameter.canBeAutomatic) return kAutomatic;
    for (const Choice& choice : parameter.choices) {
        if (text == choice.name) return choice.value;
    }
    const std::string typed(text);
    if (!parameter.choices.empty()) {
        return Error{"\"" + typed + "\" is not one of " + choiceNames(parameter), flag(parameter), "give one of these"};
    }
    double factor = 1.0;
    stripUnit(parameter, text, factor);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        return Error{"\"" + typed + "\" is not a number" + (parameter.canBeAutomatic ? " and not auto" : ""), flag(parameter),
                     "write it like 12.5"};
    }
    return withinLimits(parameter, value * factor);
}

std::string formatValue(const Parameter& parameter, double value) {
    if (std::isnan(value)) return "auto";
    for (const Choice& choice : parameter.choices) {
        if (choice.value == value) return choice.name;
    }
    return shortest(value);
}

double snapped(const Parameter& parameter, double value) {
    if (std::isnan(value)) return parameter.canBeAutomatic ? value : parameter.minimum;
    if (!parameter.choices.empty()) {
        const auto nearest = std::ranges::min_element(
            parameter.choices, [&](const Choice& a, const Choice& b) { return std::abs(a.value - value) < std::abs(b.value - value); });
        return nearest->value;
    }
    const double tens = std::pow(10.0, parameter.decimals);
    return std::clamp(std::round(value * tens) / tens, parameter.minimum, parameter.maximum);
}

Result<Done> checkSettings(const Settings& s) {
    if (s.scaling != Scaling::Thesis && !std::isnan(s.nearMm) && !std::isnan(s.farMm) && s.nearMm >= s.farMm) {
        return Error{"near " + shortest(s.nearMm) + " mm is not smaller than far " + shortest(s.farMm) + " mm", "--near --far",
                     "give a near that is smaller than far"};
    }
    return Done{};
}

nlohmann::json settingsToJson(const Settings& settings) {
    nlohmann::json object = nlohmann::json::object();
    for (const Parameter& p : table()) {
        const double value = p.get(settings);
        const bool asNumber = !std::isnan(value) && (p.choices.empty() || p.choices.front().name[0] <= '9');
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
    for (const auto& [key, value] : object.items()) {
        const Parameter* parameter = findParameter(key);
        if (parameter == nullptr)
            return Error{"there is no parameter \"" + key + "\"", where, "see edgescan-cli detect --help for the names"};
        std::string text;
        if (value.is_string())
            text = value.get<std::string>();
        else if (value.is_boolean())
            text = value.get<bool>() ? "on" : "off";
        else if (value.is_number())
            text = shortest(value.get<double>());
        const Result<double> parsed = parseValue(*parameter, text);
        if (!parsed) return Error{key + ": " + parsed.error().what, where, parsed.error().todo};
        parameter->set(settings, *parsed);
    }
    return settings;
}

} // namespace edgescan
