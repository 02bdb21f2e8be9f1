// The one table of parameters: it feeds sliders, command-line flags, presets, help and provenance.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::edges {

/// A named value of a parameter that is not a free number.
struct Choice {
    double value;
    const char* name;  ///< as typed on the command line and stored in presets
    const char* label; ///< as shown
};

/// What a run makes one after the other. Gray levels, mask, smoothed levels: for methods on gray levels; surface, responses: EdgeScan+.
enum class Stage : std::uint8_t {
    Gray,
    Mask,
    Smoothing, ///< of Gray, without Mask
    Surface,
    Responses, ///< of Surface
    Edges,     ///< of all others, at every threshold
    Threshold, ///< the edges at one threshold
};

/// The first stage that takes notice of a parameter. There is no default: a parameter without it does not compile.
class Feeds {
public:
    constexpr Feeds(Stage stage) : stage_(stage) {}
    constexpr operator Stage() const { return stage_; }

private:
    Stage stage_;
};

/// What automatic values came out as on a scan; NaN where that is not known.
struct Measured {
    double nearMm = kAutomatic, farMm = kAutomatic; ///< window of the gray levels
    double jumpMm = kAutomatic;                     ///< smallest jump near the scanner
    double noiseMm = kAutomatic;                    ///< range noise sigma at 5 m
};

struct Parameter {
    const char* key;   ///< flag name without "--", preset and provenance key
    const char* label; ///< as shown beside the slider
    const char* unit;  ///< "" when it has none
    const char* help;  ///< one sentence
    double minimum;
    double maximum;
    double sliderMaximum; ///< where the slider ends; larger values are typed
    double step;
    int decimals;
    double (*automatic)(const Settings&, const Measured&); ///< what "auto" came out as; null: "auto" is no value
    bool advanced;                                         ///< shown in the fold "Advanced"
    std::vector<Choice> choices;                           ///< empty: any number between minimum and maximum
    bool several; ///< the value is a set: the sum of choices (powers of two), written "jump,convex"
    double (*get)(const Settings&);
    void (*set)(Settings&, double);
    bool (*usedBy)(const Settings&); ///< false: the method chosen takes no notice of it
    Feeds feeds;
};

/// Every parameter, in the order in which they are shown.
[[nodiscard]] std::span<const Parameter> parameters();

/// Null when there is no such key.
[[nodiscard]] const Parameter* findParameter(std::string_view key);

/// The threshold that a method is mostly turned by: "lower", "step" or "sensitivity".
[[nodiscard]] const Parameter& sweptParameter(Method method);

/// What `stage` makes with settings `a` it also makes with `b`: nothing differs that it or a stage before it takes notice of.
[[nodiscard]] bool sameUpTo(Stage stage, const Settings& a, const Settings& b);

/// A typed value: a number with or without the unit (for lengths also "m"), a choice's name, or "auto".
/// Error: not a number, outside the limits, not one of the choices.
[[nodiscard]] Result<double> parseValue(const Parameter& parameter, std::string_view text);

/// The shortest text that parseValue turns back into `value`.
[[nodiscard]] std::string formatValue(const Parameter& parameter, double value);

/// The nearest value that the parameter can take; automatic stays automatic where that is allowed.
[[nodiscard]] double snapped(const Parameter& parameter, double value);

/// Error when single values are fine but do not go together (near beyond far).
[[nodiscard]] Result<Done> checkSettings(const Settings& settings);

/// The label of the choice that the parameter stands at ("Canny (thesis)").
[[nodiscard]] std::string choiceLabel(const Parameter& parameter, const Settings& settings);

/// {"kernel": 3, "sigma": "auto", "norm": "l1", ...}: every key of the table.
[[nodiscard]] nlohmann::json settingsToJson(const Settings& settings);

/// Overwrites in `settings` what `object` names. Error: unknown key, wrong type, outside the limits. `where` goes into the error.
[[nodiscard]] Result<Settings> settingsFromJson(const nlohmann::json& object, Settings settings, const std::string& where);

} // namespace edgescan::edges
