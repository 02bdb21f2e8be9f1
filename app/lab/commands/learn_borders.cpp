// edgescan-lab learn-borders: makes the weights of the network of borders from simulated scans and real stones.
#include "app/lab/learning/learn_borders.h"
#include "app/lab/commands/commands.h"
#include "app/lab/commands/lesson_flags.h"
#include "app/lab/commands/lesson_scenes.h"
#include "app/lab/sim/simulate.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"

#include <functional>
#include <memory>
#include <optional>

namespace edgescan::cli {
namespace {

struct LearnBorders {
    std::string output;
    int rounds = 3;
    LessonFlags scans{.firstSeed = 8101};
    LessonSceneFlags stones{
        .only = {"real bench", "real hangup", "real pile", "real bench x3", "real hangup x3", "real pile x3", "real hangup full"},
        .scenes = 4,
        .views = 3};
};

// The scans of the lesson. A fine one has twice the lines and beams.
struct LessonScan {
    const char* scene;
    int scans;
    int fine;
    std::function<void(sim::SimulationSettings&)> set;
};

const std::vector<LessonScan>& lessonScans() {
    using Settings = sim::SimulationSettings;
    static const std::vector<LessonScan> scans{
        {"hangup", 13, 1, [](Settings&) {}},
        {"pile", 13, 1, [](Settings&) {}},
        {"hangup", 2, 2, [](Settings&) {}},
        {"pile", 2, 2, [](Settings&) {}},
        {"hangup", 1, 1, [](Settings& s) { s.noise = 3; }},
        {"pile", 1, 1, [](Settings& s) { s.noise = 2; }},
        {"hangup", 1, 1, [](Settings& s) { s.wallRoughnessMm = 80; }},
        {"pile", 1, 1, [](Settings& s) { s.wallRoughnessMm = 60, s.dropouts = 0.01; }},
        {"hangup", 1, 1, [](Settings& s) { s.rockLumpsMm = 20; }},
        {"pile", 1, 1, [](Settings& s) { s.rockLumpsMm = 20, s.rockLumpM = 0.175; }},
        {"hangup", 1, 1, [](Settings& s) { s.axis = Axis::Spin; }},
        {"pile", 1, 1, [](Settings& s) { s.axis = Axis::Spin; }},
        {"hangup", 1, 1, [](Settings& s) { s.rockRounding = 0.6; }},
        {"pile", 1, 1, [](Settings& s) { s.rockSize = 0.5, s.rocks = 1800; }},
        {"pile", 1, 1, [](Settings& s) { s.profile = sim::DeviceProfile::Standard; }},
    };
    return scans;
}

Result<Done> addStones(const LearnBorders& asked, std::vector<lab::BorderLesson>& lessons) {
    const Result<std::vector<LessonScene>> scenes = lessonScenes(asked.stones);
    if (!scenes) return scenes.error();
    std::vector<std::optional<lab::BorderLesson>> stones(scenes->size());
    auto made = makeLessonScenes(asked.stones, *scenes, [&](std::size_t n, const lab::MadeScene& scene) {
        if (scene.truth) stones[n].emplace(scene.scan, scene.truth->object);
    });
    for (std::optional<lab::BorderLesson>& stone : stones) {
        if (stone) lessons.push_back(std::move(*stone));
    }
    return made;
}

Result<Done> learn(const LearnBorders& asked) {
    std::vector<lab::BorderLesson> lessons;
    auto seed = static_cast<std::uint64_t>(asked.scans.firstSeed);
    for (const LessonScan& row : lessonScans()) {
        for (int n = 0; n < row.scans; ++n) {
            sim::SimulationSettings settings;
            settings.scene = row.scene;
            settings.seed = seed++;
            settings.lines = row.fine * asked.scans.lines;
            settings.beams = row.fine * (asked.scans.beams - 1) + 1;
            settings.truth = true;
            row.set(settings);
            const auto simulation = sim::simulate(settings);
            if (!simulation) return simulation.error();
            lessons.emplace_back(std::make_shared<const Scan>(simulation->scan), simulation->truth->object);
        }
    }
    if (const auto added = addStones(asked, lessons); !added) return added;
    constexpr int kEvery = 6; // neighbouring cells of a border say nearly the same
    lab::BorderSamples samples;
    rocks::BorderNetwork network; // moves nothing
    for (int round = 1; round <= asked.rounds; ++round) {
        for (const lab::BorderLesson& lesson : lessons) lesson.ask(network, kEvery, samples);
        if (samples.count() == 0) return Error{"no border of two rocks is in these scans", "--lines --beams", "give finer scans"};
        network = lab::trainedBorders(samples, {});
        printResult("round " + std::to_string(round) + ": " + std::to_string(samples.count()) + " samples, " +
                    fixedText(100 * lab::rightShare(network, samples), 1) + " % right\n");
    }
    const std::string command = madeBy("learn-borders", asked.scans, " --rounds " + std::to_string(asked.rounds) + drawFlags(asked.stones));
    return writeWholeFile(asked.output, lab::borderWeightsText(network, command));
}

} // namespace

void addLearnBorders(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnBorders>();
    CLI::App& command = *app.add_subcommand("learn-borders", "Makes the weights by which rocks decide to which of two segments a cell on "
                                                             "their border belongs, from simulated scans and real stones");
    command.add_option("-o,--output", asked->output, "File of the weights (core/rocks/segmentation/border_weights.inc)")->required();
    command.add_option("--rounds", asked->rounds, "Trainings; each one after the first also sees the borders that the one before leaves")
        ->check(CLI::Range(1, 10))
        ->capture_default_str();
    addLessonFlags(command, asked->scans, "four of the scans have");
    addLessonSceneFlags(command, asked->stones);
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
