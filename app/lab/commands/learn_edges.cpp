// edgescan-lab learn-edges: makes the trees by which an edge is the border of a rock or a fold, from real stones and simulated scans.
#include "app/lab/learning/learn_edges.h"
#include "app/lab/commands/commands.h"
#include "app/lab/commands/lesson_scenes.h"
#include "app/shared/exits.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/whole_file.h"

#include <memory>
#include <vector>

namespace edgescan::cli {
namespace {

struct LearnEdges {
    std::string output;
    LessonSceneFlags scenes;
    int each = 4000;
    lab::BoostingChoices choices;
};

// Samples of all scenes but, or only, those of a kind.
lab::TreeSamples samplesOf(const std::vector<LessonScene>& scenes, const std::vector<lab::TreeSamples>& each, const std::string& kind,
                           bool only) {
    lab::TreeSamples samples;
    for (std::size_t n = 0; n < scenes.size(); ++n) {
        if ((scenes[n].kind == kind) == only) samples.add(each[n]);
    }
    return samples;
}

Result<Done> learn(const LearnEdges& asked) {
    const int threads = threadsOf(asked.scenes);
    const Result<std::vector<LessonScene>> scenes = lessonScenes(asked.scenes);
    if (!scenes) return scenes.error();
    catchInterrupt();
    std::vector<lab::TreeSamples> each(scenes->size());
    const auto made = makeLessonScenes(asked.scenes, *scenes, [&](std::size_t n, const lab::MadeScene& scene) {
        if (scene.truth) lab::addEdgeSamples(scene.scan, *scene.truth, static_cast<std::size_t>(asked.each), each[n]);
    });
    if (!made) return made.error();
    const std::vector<std::string> kinds = kindsOf(*scenes);
    for (const std::string& kind : kinds) {
        if (kinds.size() == 1) break;
        const lab::LearntTrees without = lab::learntTrees(samplesOf(*scenes, each, kind, false), asked.choices, threads);
        printResult(kind + " left out: " + lab::qualityText(lab::qualityOf(samplesOf(*scenes, each, kind, true), without)));
    }
    const lab::TreeSamples all = samplesOf(*scenes, each, "", false);
    const lab::LearntTrees trees = lab::learntTrees(all, asked.choices, threads);
    printResult(std::to_string(all.count()) + " edges of " + std::to_string(scenes->size()) +
                " scenes; on themselves: " + lab::qualityText(lab::qualityOf(all, trees)));
    return writeWholeFile(asked.output, lab::treesText(trees, "edgescan-lab learn-edges" + drawFlags(asked.scenes) + " --each " +
                                                                  std::to_string(asked.each)));
}

} // namespace

void addLearnEdges(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnEdges>();
    CLI::App& command =
        *app.add_subcommand("learn-edges", "Makes the trees that distinguish the border of a rock from a fold within one, from "
                                           "real stones and simulated scans, and tries them on each kind left out");
    command.add_option("-o,--output", asked->output, "File of the trees (core/edges/rock_borders/border_trees.inc)")->required();
    addLessonSceneFlags(command, asked->scenes);
    command.add_option("--each", asked->each, "Edges of a scene")->check(CLI::Range(10, 1000000))->capture_default_str();
    command.add_option("--trees", asked->choices.trees, "Trees")->check(CLI::Range(1, 1000))->capture_default_str();
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
