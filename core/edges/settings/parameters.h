// The table of parameters: sliders, command-line flags, presets, help and provenance use it.
#pragma once

#include "core/base/result.h"
#include "core/base/table_row.h"
#include "core/edges/settings/settings.h"
#include "core/edges/settings/stage.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::edges {

/// A named value of a parameter with a fixed set of values.
struct Choice {
    double value;
    const char* name;  ///< as typed on the command line and stored in presets
    const char* label; ///< name in the window
};

/// The first stage that uses a parameter. It has no default: a parameter without it does not compile.
class Feeds {
public:
    constexpr Feeds(Stage stage) : stage_(stage) {}
    constexpr operator Stage() const { return stage_; }

private:
    Stage stage_;
};

/// Values of automatic parameters on a scan; NaN if unknown.
struct Measured {
    double nearMm = kAutomatic, farMm = kAutomatic; ///< window of the gray levels
    double jumpMm = kAutomatic;                     ///< smallest jump near the scanner
    double noiseMm = kAutomatic;                    ///< range noise sigma at 5 m
};

struct Parameter : TableRow<Settings> {
    double sliderMaximum;                                  ///< end of the slider; larger values can be typed
    double (*automatic)(const Settings&, const Measured&); ///< the value of "auto"; null: "auto" is not allowed
    bool advanced;                                         ///< shown under "Advanced"
    std::vector<Choice> choices;                           ///< empty: any number between minimum and maximum
    bool several;                    ///< the value is a set: the sum of choices (powers of two), written "jump,convex"
    bool (*usedBy)(const Settings&); ///< false: the chosen method does not use it
    Feeds feeds;
    const char* name = nullptr; ///< of its flag, where that is not the key; files and the first flag have the key
};

/// Every parameter, in the order in which they are shown.
[[nodiscard]] std::span<const Parameter> parameters();

/// "--jump": the flag as help and messages name it.
[[nodiscard]] std::string flagOf(const Parameter& parameter);

/// By key or by the name of its flag. Null for an unknown one.
[[nodiscard]] const Parameter* findParameter(std::string_view key);

/// The main threshold of a method: "lower", "step" or "sensitivity".
[[nodiscard]] const Parameter& sweptParameter(Method method);

/// True if `stage` gives the same result with settings `a` and `b`: all parameters that it or a stage before it uses are equal.
[[nodiscard]] bool sameUpTo(Stage stage, const Settings& a, const Settings& b);

/// A typed value: a number with or without the unit (for lengths also "m"), a choice's name, or "auto".
/// Error: not a number, outside the limits, not one of the choices.
[[nodiscard]] Result<double> parseValue(const Parameter& parameter, std::string_view text);

/// The shortest text that parseValue converts back to `value`.
[[nodiscard]] std::string formatValue(const Parameter& parameter, double value);

/// The nearest allowed value of the parameter; automatic stays automatic if that is allowed.
[[nodiscard]] double snapped(const Parameter& parameter, double value);

/// Error if single values are allowed but contradict each other (near beyond far).
[[nodiscard]] Result<Done> checkSettings(const Settings& settings);

/// The label of the parameter's current choice ("Canny (thesis)"), or of all of them where there may be several.
[[nodiscard]] std::string choiceLabel(const Parameter& parameter, const Settings& settings);

/// {"kernel": 3, "sigma": "auto", "norm": "l1", ...}: every key of the table.
[[nodiscard]] nlohmann::json settingsToJson(const Settings& settings);

/// Replaces the values in `settings` that `object` contains. Error: unknown key, wrong type, outside the limits. The error names `where`.
[[nodiscard]] Result<Settings> settingsFromJson(const nlohmann::json& object, Settings settings, const std::string& where);

} // namespace edgescan::edges
