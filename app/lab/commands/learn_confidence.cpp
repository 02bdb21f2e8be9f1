// edgescan-lab learn-confidence: makes the trees of the confidence of rocks from simulated scans and real stones.
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
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::cli {
namespace {

struct LearnConfidence {
    std::string output;
    lab::BoostingChoices choices{.trees = 80, .rate = 0.1, .least = 40, .ridge = 2};
    LessonFlags scans{.firstSeed = 8201};
    LessonSceneFlags stones{.draw = "learn-confidence",
                            .only = {"real bench", "real hangup", "real pile", "real bench x3", "real hangup x3", "real pile x3",
                                     "real bench full", "real hangup full", "real pile full"},
                            .scenes = 3,
                            .views = 4};
};

constexpr int kWallsWithoutRocks = 3; // scans of each kind
constexpr int kFullGrids = 4;         // of each scene
// Of a region of a scan without rocks: these regions are few, and what they show is false.
constexpr float kConfidenceWeight = 3;
constexpr double kScoreWeight = 2;
const std::string kSimulated = "simulated";

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
    for (int n = 0; n < kFullGrids; ++n) {
        for (const char* scene : {"hangup", "pile"}) add(scene, [](Settings& s) { s.lines *= 2, s.beams = 2 * s.beams - 1; });
    }
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

// Samples of all kinds but this one.
lab::TreeSamples without(const std::map<std::string, lab::TreeSamples>& samples, const std::string& kind) {
    lab::TreeSamples others;
    for (const auto& [name, each] : samples) {
        if (name != kind) others.add(each);
    }
    return others;
}

Result<Done> learn(const LearnConfidence& asked) {
    std::map<std::string, lab::TreeSamples> samples; // by kind
    std::vector<lab::RegionSample> regions;
    const auto add = [&](const std::string& kind, const lab::RockLesson& lesson) {
        const bool hasRocks = std::ranges::any_of(lesson.rock.cells, [](std::uint32_t rock) { return rock != 0; });
        const rocks::MergeTree tree = rocks::mergeTree(lesson.segments);
        lab::addConfidenceSamples(lesson, tree, hasRocks ? 1.0F : kConfidenceWeight, samples[kind]);
        lab::addRegionSamples(lesson, tree, hasRocks ? 1.0 : kScoreWeight, regions);
    };
    for (const sim::SimulationSettings& settings : lessonScans(asked.scans)) {
        const auto simulation = sim::simulate(settings);
        if (!simulation) return simulation.error();
        add(kSimulated, lab::rockLesson(std::make_shared<const Scan>(simulation->scan), simulation->truth->object));
    }
    const Result<std::vector<LessonScene>> scenes = lessonScenes(asked.stones);
    if (!scenes) return scenes.error();
    const Result<std::vector<lab::RockLesson>> stones = rockLessons(asked.stones, *scenes);
    if (!stones) return stones.error();
    for (std::size_t n = 0; n < stones->size(); ++n) {
        if ((*stones)[n].rock.size() > 0) add((*scenes)[n].kind, (*stones)[n]);
    }
    const int threads = threadsOf(asked.stones);
    for (const auto& [kind, each] : samples) {
        if (each.count() == 0) continue;
        const lab::TreeSamples others = without(samples, kind);
        if (others.count() > 0)
            printResult(kind +
                        " left out: " + lab::qualityText(lab::qualityOf(each, lab::learntConfidence(others, asked.choices, threads))));
    }
    const lab::TreeSamples all = without(samples, "");
    if (all.count() == 0) return Error{"nothing is called a rock in these scans", "--lines --beams", "give finer scans"};
    const lab::LearntConfidence learnt = lab::learntConfidence(all, asked.choices, threads);
    printResult(std::to_string(all.count()) + " rocks, on themselves: " + lab::qualityText(lab::qualityOf(all, learnt)) + "; " +
                std::to_string(regions.size()) + " regions, " + scoreText(regions));
    return writeWholeFile(asked.output, lab::confidenceText(learnt, madeBy("learn-confidence", asked.scans, drawFlags(asked.stones))));
}

} // namespace

void addLearnConfidence(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnConfidence>();
    CLI::App& command = *app.add_subcommand(
        "learn-confidence",
        "Makes the trees that give the confidence of a rock, from simulated scans and real stones, tries them on each kind left out, and "
        "prints the weights of R");
    command.add_option("-o,--output", asked->output, "File of the trees (core/rocks/selection/confidence_trees.inc)")->required();
    addLessonFlags(command, asked->scans, "one of the scans has");
    addLessonSceneFlags(command, asked->stones);
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
