// edgescan-lab learn-confidence: makes the weights of the confidence of rocks from simulated scans.
#include "core/lab/learning/learn_confidence.h"
#include "app/lab/commands.h"
#include "app/lab/lesson_flags.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/whole_file.h"
#include "core/sim/wall_kinds.h"

#include <functional>
#include <memory>

namespace edgescan::cli {
namespace {

struct LearnConfidence {
    std::string output;
    LessonFlags scans{.firstSeed = 8201};
};

using Change = std::function<void(sim::SimulationSettings&)>;

// Both scenes with rocks, as they are and with their failings; then each kind of wall with and without rocks.
std::vector<sim::SimulationSettings> lessonScans(const LessonFlags& asked) {
    std::vector<sim::SimulationSettings> scans;
    const auto add = [&](const char* scene, const Change& change) {
        sim::SimulationSettings settings;
        settings.scene = scene;
        settings.lines = asked.lines;
        settings.beams = asked.beams;
        settings.truth = true;
        settings.seed = static_cast<std::uint64_t>(asked.firstSeed) + scans.size();
        change(settings);
        scans.push_back(settings);
    };
    using Settings = sim::SimulationSettings;
    const std::vector<Change> failings{
        [](Settings&) {},
        [](Settings&) {},
        [](Settings& s) { s.noise = 3; },
        [](Settings& s) { s.axis = Axis::Spin; },
        [](Settings& s) { s.wallRoughnessMm = 80; },
        [](Settings& s) { s.rockLumpsMm = 20; },
        [](Settings& s) { s.rockLumpsMm = 20, s.rockLumpM = 0.175; },
    };
    for (const Change& failing : failings) {
        for (const char* scene : {"hangup", "pile"}) add(scene, failing);
    }
    add("hangup", [](Settings& s) { s.lines *= 2, s.beams = 2 * s.beams - 1; });
    for (const sim::WallKind& kind : sim::wallKinds()) {
        const Change wall = [&kind](Settings& s) { s.wallKind = kind.name; };
        add("pile", wall);
        if (kind.archFits) add("hangup", wall);
        const bool onGround = kind.groundM != nullptr;
        add(onGround ? "pile" : "empty", [&](Settings& s) { s.wallKind = kind.name, s.rocks = onGround ? 0 : s.rocks; });
    }
    return scans;
}

Result<Done> learn(const LearnConfidence& asked) {
    std::vector<lab::ConfidenceLesson> samples;
    for (const sim::SimulationSettings& settings : lessonScans(asked.scans)) {
        const auto simulation = sim::simulate(settings);
        if (!simulation) return simulation.error();
        if (const auto added = lab::addConfidenceSamples(*simulation, samples); !added) return added.error();
    }
    if (samples.empty()) return Error{"nothing is called a rock in these scans", "--lines --beams", "give finer scans"};
    printResult(std::to_string(samples.size()) + " rocks");
    return writeWholeFile(asked.output,
                          lab::confidenceWeightsText(lab::fittedConfidence(samples), madeBy("learn-confidence", asked.scans)));
}

} // namespace

void addLearnConfidence(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnConfidence>();
    CLI::App& command =
        *app.add_subcommand("learn-confidence", "Makes the weights by which the confidence of a rock is reported, from simulated scans");
    command.add_option("-o,--output", asked->output, "File of the weights (core/rocks/selection/confidence_weights.inc)")->required();
    addLessonFlags(command, asked->scans, "one of the scans has");
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
