// Settings of a sweep as text, and back.
#include "core/scanner/sweep_assembly/sweep_settings.h"
#include "core/base/translated_text.h"

#include "core/base/bounded_json.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace edgescan::scanner {
namespace {

std::string numberText(double value) {
    std::string text;
    appendShortest(text, value);
    return text;
}

/// Takes values out of the metadata record and notes those that cannot be used.
class Keys {
public:
    Keys(const SweepMetadata& metadata, std::vector<std::string>& warnings) : metadata_(metadata), warnings_(warnings) {}

    [[nodiscard]] const std::string* text(const char* key) const {
        const auto found = metadata_.find(key);
        return found == metadata_.end() ? nullptr : &found->second;
    }
    std::optional<double> number(const char* key, double minimum, double maximum) {
        const std::string* given = text(key);
        if (given == nullptr) return std::nullopt;
        double value = 0.0;
        const char* last = given->data() + given->size();
        const auto [end, problem] = std::from_chars(given->data(), last, value);
        if (problem == std::errc{} && end == last && value >= minimum && value <= maximum) return value;
        refuse(key);
        return std::nullopt;
    }
    void refuse(const char* key) {
        warnings_.push_back(
            withValues("the recording's \"%1\" is \"%2\", which cannot be used.", {std::string(key), text(key)->substr(0, 40)}));
    }

private:
    const SweepMetadata& metadata_;
    std::vector<std::string>& warnings_;
};

constexpr const char* kAxisKey = "stepper.axis";
constexpr const char* kStepKey = "stepper.deg_per_step";
constexpr const char* kFirstKey = "stepper.phi0_deg";
constexpr const char* kAssumedKey = "assumed";

/// Values that a recording gives and does not mark as assumed.
void readAssumed(Keys& keys, SweepSettings& settings) {
    const std::string* list = keys.text(kAssumedKey);
    const auto isAssumed = [&](const char* key) { return list != nullptr && list->find(key) != std::string::npos; };
    const bool rate = keys.text("stepper.deg_per_s") != nullptr;
    const bool axisSaid = keys.text(kAxisKey) != nullptr;
    const bool stepSaid = keys.text(kStepKey) != nullptr || rate;
    settings.axisAssumed = axisSaid ? isAssumed(kAxisKey) : true;
    settings.stepAssumed = stepSaid ? isAssumed(kStepKey) : true;
    settings.firstAssumed = keys.text(kFirstKey) != nullptr ? isAssumed(kFirstKey) : guessesFirst(settings);
}

/// [0,0,1] is spin, [1,0,0] is sweep; with the opposite sign the line angles rotate against the axis.
void readAxis(Keys& keys, SweepSettings& settings) {
    const std::string* text = keys.text(kAxisKey);
    if (text == nullptr) return;
    const auto list = parseJson(*text, "", kReadingJson);
    std::array<double, 3> axis{};
    bool sound = list && list->is_array() && list->size() == axis.size();
    for (std::size_t i = 0; sound && i < axis.size(); ++i) {
        sound = (*list)[i].is_number();
        if (sound) axis[i] = (*list)[i].get<double>();
    }
    constexpr double kAligned = 0.999;
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (!sound || !(length > 0) || std::max(std::abs(axis[0]), std::abs(axis[2])) < kAligned * length) return keys.refuse(kAxisKey);
    settings.axis = std::abs(axis[2]) > std::abs(axis[0]) ? Axis::Spin : Axis::Sweep;
    settings.lineDirection = axis[settings.axis == Axis::Spin ? 2 : 0] < 0 ? -1.0 : 1.0;
}

} // namespace

SweepMetadata metadataOf(const SweepSettings& settings) {
    SweepMetadata keys{{"format", "sweep/1"}, {"units", "mm raw, deg, m, s"}};
    const std::string one = settings.lineDirection < 0 ? "-1" : "1";
    keys[kAxisKey] = settings.axis == Axis::Spin ? "[0,0," + one + "]" : "[" + one + ",0,0]";
    keys[kFirstKey] = numberText(settings.firstLineDeg);
    keys["stepper.mode"] = settings.continuous ? "continuous" : "step";
    if (settings.degPerLine) {
        keys[kStepKey] = numberText(std::abs(*settings.degPerLine));
        keys["stepper.dir"] = *settings.degPerLine < 0 ? "-1" : "1";
    } else {
        keys["stepper.deg_per_s"] = numberText(settings.degPerSecond);
    }
    if (settings.ticksPerDeg) keys["stepper.ticks_per_deg"] = numberText(*settings.ticksPerDeg);
    if (settings.encoderZero) keys["stepper.encoder_zero"] = std::to_string(*settings.encoderZero);
    keys["lidar.index_deg"] = numberText(settings.indexDeg);
    if (settings.outputInterval > 0) keys["lidar.output_interval"] = std::to_string(settings.outputInterval);
    keys["lidar.echo"] = settings.echo == Echo::First ? "first" : "last";
    keys["sweep.reversal_deg"] = numberText(settings.reversalDeg);
    if (settings.expectedLines > 0) keys["sweep.lines"] = std::to_string(settings.expectedLines);
    std::string assumed;
    for (const auto& [is, key] : {std::pair(settings.axisAssumed, kAxisKey), std::pair(settings.stepAssumed, kStepKey),
                                  std::pair(settings.firstAssumed, kFirstKey)}) {
        if (is) assumed += (assumed.empty() ? "" : " ") + std::string(key);
    }
    if (!assumed.empty()) keys[kAssumedKey] = assumed;
    return keys;
}

SettingsFound settingsOf(const SweepMetadata& metadata, const SweepSettings& otherwise) {
    SettingsFound found{otherwise, {}};
    SweepSettings& settings = found.settings;
    Keys keys(metadata, found.warnings);
    readAxis(keys, settings);
    readAssumed(keys, settings);
    settings.firstLineDeg =
        keys.number(kFirstKey, physical::kLineDeg.limits.least, physical::kLineDeg.limits.most).value_or(settings.firstLineDeg);
    if (const std::string* mode = keys.text("stepper.mode")) settings.continuous = *mode == "continuous";
    if (const auto rate = keys.number("stepper.deg_per_s", -1e4, 1e4)) {
        settings.degPerSecond = *rate;
        settings.degPerLine.reset();
    }
    if (const auto step = keys.number(kStepKey, 0.0, 360.0)) {
        settings.degPerLine = *step * (keys.number("stepper.dir", -1.0, 1.0).value_or(1.0) < 0 ? -1.0 : 1.0);
    }
    if (const auto ticks = keys.number("stepper.ticks_per_deg", -1e9, 1e9)) {
        if (*ticks != 0) settings.ticksPerDeg = ticks;
    }
    if (const auto zero = keys.number("stepper.encoder_zero", 0.0, 4294967295.0)) settings.encoderZero = static_cast<std::uint32_t>(*zero);
    settings.indexDeg = keys.number("lidar.index_deg", -720.0, 720.0).value_or(settings.indexDeg);
    settings.outputInterval = static_cast<int>(keys.number("lidar.output_interval", 0.0, 50000.0).value_or(settings.outputInterval));
    if (const std::string* echo = keys.text("lidar.echo")) settings.echo = *echo == "last" ? Echo::Last : Echo::First;
    settings.reversalDeg = keys.number("sweep.reversal_deg", 0.0, 360.0).value_or(settings.reversalDeg);
    settings.expectedLines = static_cast<int>(keys.number("sweep.lines", 0.0, settings.mostLines).value_or(settings.expectedLines));
    return found;
}

} // namespace edgescan::scanner
