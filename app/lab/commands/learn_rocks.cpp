// edgescan-lab learn-rocks: makes the trees that price the merge of two bodies, from real stones and simulated scans.
#include "app/lab/learning/learn_rocks.h"
#include "app/lab/commands/commands.h"
#include "app/lab/commands/lesson_scenes.h"
#include "app/shared/exits.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"

#include <memory>
#include <vector>

namespace edgescan::cli {
namespace {

struct LearnRocks {
    std::string output;
    LessonSceneFlags scenes{.scenes = 4, .views = 3};
    int rounds = 2;
    lab::BoostingChoices choices{.trees = 80, .rate = 0.15, .least = 20, .ridge = 2};
};

// The share of its pairs that is learnt from: simulated scenes are many pairs of a few forms, and what is rare has half the say.
double shareOf(const lab::Family& family) { return lab::hasViews(family) && !family.full && family.noise == 1 ? 1.0 : 0.5; }

class Lesson {
public:
    Lesson(const LearnRocks& asked, const std::vector<LessonScene>& scenes, const std::vector<lab::RockLesson>& lessons)
        : asked_(asked), scenes_(scenes), lessons_(lessons) {}

    /// The trees of all rounds but the last one price the merges from which the last one learns.
    [[nodiscard]] lab::LearntTrees without(const std::string& kind) const {
        lab::TreeSamples samples;
        lab::LearntTrees trees;
        for (int round = 0; round < asked_.rounds; ++round) {
            for (std::size_t n = 0; n < scenes_.size(); ++n) {
                if (scenes_[n].kind != kind)
                    lab::addPairSamples(lessons_[n], round == 0 ? nullptr : &trees, shareOf(*scenes_[n].family), samples);
            }
            trees = lab::learntTrees(samples, asked_.choices, threadsOf(asked_.scenes));
            showProgress("round " + std::to_string(round + 1) + ", " + std::to_string(samples.count()) + " pairs", false);
        }
        return trees;
    }
    /// One line per family of the kind.
    void printScores(const std::string& kind, const lab::LearntTrees& trees, std::vector<lab::RegionSample>& regions) const {
        for (const lab::Family& family : lab::families()) {
            lab::RockCounts before, byTruth, asSet;
            std::size_t count = 0;
            for (std::size_t n = 0; n < scenes_.size(); ++n) {
                if (scenes_[n].kind != kind || scenes_[n].family != &family) continue;
                const rocks::MergeTree tree = lab::treeBy(lessons_[n], &trees);
                before += lab::scoreByTruth(lessons_[n], lab::treeBy(lessons_[n], nullptr), 0);
                byTruth += lab::scoreByTruth(lessons_[n], tree, 0);
                asSet += lab::scoreAsSet(lessons_[n], tree);
                lab::addRegionSamples(lessons_[n], tree, 1.0, regions);
                ++count;
            }
            if (count == 0) continue;
            const auto text = [](const lab::RockCounts& counts) {
                return fixedText(counts.pq(), 3) + "/" + fixedText(counts.sq(), 3) + "/" + fixedText(counts.f1(), 3);
            };
            printResult(std::string(family.name) + ", " + std::to_string(count) + " scenes, PQ/SQ/F1 by truth: mean z " + text(before) +
                        ", trees " + text(byTruth) + ", as set " + text(asSet));
        }
    }

private:
    const LearnRocks& asked_;
    const std::vector<LessonScene>& scenes_;
    const std::vector<lab::RockLesson>& lessons_;
};

Result<Done> learn(const LearnRocks& asked) {
    const Result<std::vector<LessonScene>> scenes = lessonScenes(asked.scenes);
    if (!scenes) return scenes.error();
    catchInterrupt();
    const Result<std::vector<lab::RockLesson>> lessons = rockLessons(asked.scenes, *scenes);
    if (!lessons) return lessons.error();
    const Lesson lesson(asked, *scenes, *lessons);
    const std::vector<std::string> kinds = kindsOf(*scenes);
    std::vector<lab::RegionSample> regions;
    for (const std::string& kind : kinds) {
        if (kinds.size() == 1) break;
        printResult(kind + " left out:");
        lesson.printScores(kind, lesson.without(kind), regions);
    }
    if (!regions.empty()) printResult(scoreText(regions));
    const lab::LearntTrees trees = lesson.without("");
    return writeWholeFile(asked.output, lab::treesText(trees, "edgescan-lab learn-rocks" + drawFlags(asked.scenes)));
}

} // namespace

void addLearnRocks(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnRocks>();
    CLI::App& command =
        *app.add_subcommand("learn-rocks", "Makes the trees that say whether two bodies are two rocks, from real stones and "
                                           "simulated scans, and tries them on each kind left out");
    command.add_option("-o,--output", asked->output, "File of the trees (core/rocks/segmentation/merge_trees.inc)")->required();
    addLessonSceneFlags(command, asked->scenes);
    command.add_option("--rounds", asked->rounds, "Rounds; each learns also from the merges by the trees of the round before")
        ->check(CLI::Range(1, 10))
        ->capture_default_str();
    command.add_option("--trees", asked->choices.trees, "Trees")->check(CLI::Range(1, 1000))->capture_default_str();
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
