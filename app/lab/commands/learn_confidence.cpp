// edgescan-lab learn-confidence: makes the weights of the confidence of rocks from simulated scans and real stones.
#include "app/lab/learning/learn_confidence.h"
#include "app/lab/commands/commands.h"
#include "app/lab/commands/lesson_flags.h"
#include "app/lab/commands/lesson_scenes.h"
#include "app/lab/sim/simulate.h"
#include "app/lab/sim/wall_kinds.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/whole_file.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace edgescan::cli {
namespace {

struct LearnConfidence {
    std::string output;
    LessonFlags scans{.firstSeed = 8201};
    LessonSceneFlags stones{.draw = "learn-confidence",
                            .only = {"real bench", "real hangup", "real pile", "real bench x3", "real hangup x3", "real pile x3"},
                            .scenes = 3,
                            .views = 4};
};

constexpr int kWallsWithoutRocks = 3; // scans of each kind
// Of a region of a scan without rocks: these regions are few, and what they show is false.
constexpr double kConfidenceWeight = 3, kScoreWeight = 2;

using Change = std::function<void(sim::SimulationSettings&)>;

// Both scenes with rocks, as they are and with their failings, and with few; then each kind of wall with and without rocks.
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
    for (const char* scene : {"hangup", "pile"}) add(scene, [](Settings& s) { s.lines *= 2, s.beams = 2 * s.beams - 1; });
    for (const int rocks : {3, 5, 8, 12, 20, 40}) {
        for (const char* scene : {"hangup", "pile", "hangup", "pile"}) add(scene, [rocks](Settings& s) { s.rocks = rocks; });
    }
    for (const sim::WallKind& kind : sim::wallKinds()) {
        const Change wall = [&kind](Settings& s) { s.wallKind = kind.name; };
        add("pile", wall);
        if (kind.archFits) add("hangup", wall);
        const bool onGround = kind.groundM != nullptr;
        for (int n = 0; n < kWallsWithoutRocks; ++n)
            add(onGround ? "pile" : "empty", [&](Settings& s) { s.wallKind = kind.name, s.rocks = onGround ? 0 : s.rocks; });
    }
    return scans;
}

Result<Done> learn(const LearnConfidence& asked) {
    std::vector<lab::ConfidenceLesson> samples;
    std::vector<lab::RegionSample> regions;
    const auto add = [&](const lab::RockLesson& lesson) {
        const bool hasRocks = std::ranges::any_of(lesson.rock.cells, [](std::uint32_t rock) { return rock != 0; });
        const rocks::MergeTree tree = rocks::mergeTree(lesson.segments);
        lab::addConfidenceSamples(lesson, tree, hasRocks ? 1.0 : kConfidenceWeight, samples);
        lab::addRegionSamples(lesson, tree, hasRocks ? 1.0 : kScoreWeight, regions);
    };
    for (const sim::SimulationSettings& settings : lessonScans(asked.scans)) {
        const auto simulation = sim::simulate(settings);
        if (!simulation) return simulation.error();
        add(lab::rockLesson(std::make_shared<const Scan>(simulation->scan), simulation->truth->object));
    }
    const Result<std::vector<LessonScene>> scenes = lessonScenes(asked.stones);
    if (!scenes) return scenes.error();
    const Result<std::vector<lab::RockLesson>> stones = rockLessons(asked.stones, *scenes);
    if (!stones) return stones.error();
    for (const lab::RockLesson& lesson : *stones) {
        if (lesson.rock.size() > 0) add(lesson);
    }
    if (samples.empty()) return Error{"nothing is called a rock in these scans", "--lines --beams", "give finer scans"};
    printResult(std::to_string(samples.size()) + " rocks; " + std::to_string(regions.size()) + " regions, " + scoreText(regions));
    return writeWholeFile(asked.output, lab::confidenceWeightsText(lab::fittedConfidence(samples),
                                                                   madeBy("learn-confidence", asked.scans, drawFlags(asked.stones))));
}

} // namespace

void addLearnConfidence(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnConfidence>();
    CLI::App& command = *app.add_subcommand(
        "learn-confidence",
        "Makes the weights by which the confidence of a rock is reported, from simulated scans and real stones, and prints those of R");
    command.add_option("-o,--output", asked->output, "File of the weights (core/rocks/selection/confidence_weights.inc)")->required();
    addLessonFlags(command, asked->scans, "one of the scans has");
    addLessonSceneFlags(command, asked->stones);
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
