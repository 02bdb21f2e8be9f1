// Angles from the options, or those of an LMS511.
#include "core/formats/range_geometry.h"

namespace edgescan {
namespace {

constexpr std::size_t kLms511Beams = 1141;

} // namespace

Result<Done> checkAnglesKnown(std::size_t beams, const char* what, const Source& source) {
    if (beams == kLms511Beams) return Done{};
    const ReadingOptions& options = *source.options;
    std::string missing;
    const auto need = [&](bool given, const char* flag) {
        if (!given) missing += std::string(missing.empty() ? "" : " ") + flag;
    };
    need(options.beamStartDeg.has_value(), "--beam-start");
    need(options.beamStepDeg.has_value(), "--beam-step");
    need(options.lineStartDeg.has_value(), "--line-start");
    need(options.lineStepDeg.has_value(), "--line-step");
    need(options.axis.has_value(), "--axis");
    if (missing.empty()) return Done{};
    std::string sentence = "a ";
    sentence += what;
    sentence += " of " + std::to_string(beams) + " ranges per line does not say its angles";
    return source.refused(sentence, "give " + missing);
}

Result<AssumedAngles> assumedAngles(std::size_t lines, std::size_t beams, const char* what, const Source& source) {
    if (auto known = checkAnglesKnown(beams, what, source); !known) return known.error();
    const ReadingOptions& options = *source.options;
    AssumedAngles angles;
    const double beamStart = options.beamStartDeg.value_or(-5.0);
    const double beamStep = options.beamStepDeg.value_or(1.0 / 6.0);
    const double lineStart = options.lineStartDeg.value_or(0.0);
    const double lineStep = options.lineStepDeg.value_or(0.18);
    for (std::size_t j = 0; j < beams; ++j) angles.polar.beamDeg.push_back(beamStart + static_cast<double>(j) * beamStep);
    for (std::size_t i = 0; i < lines; ++i) angles.polar.lineDeg.push_back(lineStart + static_cast<double>(i) * lineStep);
    angles.polar.axis = options.axis.value_or(Axis::Spin);
    if (options.beamStartDeg && options.beamStepDeg && options.lineStartDeg && options.lineStepDeg && options.axis) return angles;
    angles.warning = "The ";
    angles.warning += what;
    angles.warning += " does not say its angles: those of an LMS511 were taken where none were given (beams from -5 degrees by 1/6 degree, "
                      "lines from 0 by 0.18 degree, axis spin).";
    return angles;
}

} // namespace edgescan
