// edgescan-lab learn-edges: makes the trees by which an edge is the border of a rock or a fold, from real stones and simulated scans.
#include "core/lab/learning/learn_edges.h"
#include "app/lab/commands.h"
#include "app/shared/interrupt.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/lab/families/families.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace edgescan::cli {
namespace {

struct LearnEdges {
    std::string output, draw = "learn-edges";
    lab::FamilyPlaces places{.stoneSet = "free"}; // what is learnt from these stones may be shipped
    std::vector<std::string> only;
    int scenes = 6, each = 4000, threads = 0;
    lab::BoostingChoices choices;
};

// A family of the lesson, and the kind that is left out together with it in a trial.
struct LessonFamily {
    const char* family;
    const char* kind;
};
constexpr std::array<LessonFamily, 13> kLesson{{{"real bench", "real bench"},
                                                {"real hangup", "real hang-up"},
                                                {"real pile", "real pile"},
                                                {"real bench x3", "real bench"},
                                                {"real hangup x3", "real hang-up"},
                                                {"real pile x3", "real pile"},
                                                {"real hangup full", "real hang-up"},
                                                {"hangup", "simulated"},
                                                {"pile", "simulated"},
                                                {"hangup x3", "simulated"},
                                                {"spin", "simulated"},
                                                {"hangup full", "simulated"},
                                                {"pile full", "simulated"}}};

struct Lesson {
    const lab::Family* family = nullptr;
    std::string kind;
    lab::SceneOrder order;
    lab::TreeSamples samples;
};

Result<std::vector<Lesson>> ordersOf(const LearnEdges& asked) {
    std::vector<Lesson> lessons;
    for (const LessonFamily& row : kLesson) {
        if (!asked.only.empty() && std::ranges::find(asked.only, row.family) == asked.only.end()) continue;
        const lab::Family& family = *lab::findFamily(row.family);
        const std::size_t all = static_cast<std::size_t>(asked.scenes);
        // Noisy and full scenes teach what the others do not, with half and a third as many.
        const std::size_t fresh = family.full        ? std::max<std::size_t>(1, all / 3)
                                  : family.noise > 1 ? std::max<std::size_t>(1, all / 2)
                                                     : all;
        const auto orders = lab::drawnScenes(family, {.text = asked.draw, .fresh = fresh}, asked.places);
        if (!orders) return orders.error();
        for (const lab::SceneOrder& order : *orders) {
            if (order.file.empty()) lessons.push_back({&family, row.kind, order, {}});
        }
    }
    return lessons;
}

Result<Done> take(const LearnEdges& asked, Lesson& lesson) {
    const auto scene = lab::makeScene(*lesson.family, lesson.order, asked.places, [] { return !interrupted(); });
    if (!scene) return scene.error();
    if (scene->truth) lab::addEdgeSamples(scene->scan, *scene->truth, static_cast<std::size_t>(asked.each), lesson.samples);
    return Done{};
}

Result<Done> makeScenes(const LearnEdges& asked, int threads, std::vector<Lesson>& lessons) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    Result<Done> result = Done{};
    std::size_t made = 0;
    const auto work = [&] {
        for (std::size_t n = next++; n < lessons.size(); n = next++) {
            const Result<Done> taken = take(asked, lessons[n]);
            const std::lock_guard lock(mutex);
            if (!taken) {
                result = taken.error();
                next = lessons.size();
                return;
            }
            ++made;
            showProgress(std::to_string(made) + " of " + std::to_string(lessons.size()) + " scenes", made == lessons.size());
        }
    };
    std::vector<std::jthread> workers;
    for (int n = 1; n < threads; ++n) workers.emplace_back(work);
    work();
    workers.clear();
    return result;
}

std::string qualityText(const lab::AnswerQuality& quality) {
    return "AUC " + fixedText(quality.auc, 3) + ", precision " + fixedText(quality.precisionAt90, 3) + " at recall .9, calibration error " +
           fixedText(quality.calibration, 3);
}

// Samples of all lessons but, or only, those of a kind.
lab::TreeSamples samplesOf(const std::vector<Lesson>& lessons, const std::string& kind, bool only) {
    lab::TreeSamples samples;
    for (const Lesson& lesson : lessons) {
        if ((lesson.kind == kind) == only) samples.add(lesson.samples);
    }
    return samples;
}

Result<Done> learn(const LearnEdges& asked) {
    const int threads = asked.threads > 0 ? asked.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    Result<std::vector<Lesson>> lessons = ordersOf(asked);
    if (!lessons) return lessons.error();
    if (lessons->empty()) return Error{"no family of the lesson has these names", "--only", "use names of edgescan-lab families"};
    catchInterrupt();
    if (const auto made = makeScenes(asked, threads, *lessons); !made) return made.error();
    std::vector<std::string> kinds;
    for (const Lesson& lesson : *lessons) {
        if (std::ranges::find(kinds, lesson.kind) == kinds.end()) kinds.push_back(lesson.kind);
    }
    for (const std::string& kind : kinds) {
        if (kinds.size() == 1) break;
        const lab::LearntTrees without = lab::learntTrees(samplesOf(*lessons, kind, false), asked.choices, threads);
        printResult(kind + " left out: " + qualityText(lab::qualityOf(samplesOf(*lessons, kind, true), without)));
    }
    const lab::TreeSamples all = samplesOf(*lessons, "", false);
    const lab::LearntTrees trees = lab::learntTrees(all, asked.choices, threads);
    printResult(std::to_string(all.count()) + " edges of " + std::to_string(lessons->size()) +
                " scenes; on themselves: " + qualityText(lab::qualityOf(all, trees)));
    return writeWholeFile(asked.output, lab::treesText(trees, "edgescan-lab learn-edges --draw " + asked.draw + " --scenes " +
                                                                  std::to_string(asked.scenes) + " --each " + std::to_string(asked.each)));
}

} // namespace

void addLearnEdges(CLI::App& app, int& code) {
    auto asked = std::make_shared<LearnEdges>();
    CLI::App& command =
        *app.add_subcommand("learn-edges", "Makes the trees that distinguish the border of a rock from a fold within one, from "
                                           "real stones and simulated scans, and tries them on each kind left out");
    command.add_option("-o,--output", asked->output, "File of the trees (core/edges/rock_borders/border_trees.inc)")->required();
    command.add_option("--draw", asked->draw, "Text from which the seeds of the scenes are drawn")->capture_default_str();
    command.add_option("--scenes", asked->scenes, "Scenes per family")->check(CLI::Range(1, 1000))->capture_default_str();
    command.add_option("--each", asked->each, "Edges of a scene")->check(CLI::Range(10, 1000000))->capture_default_str();
    command.add_option("--trees", asked->choices.trees, "Trees")->check(CLI::Range(1, 1000))->capture_default_str();
    command.add_option("--only", asked->only, "Only these families")->delimiter(',')->type_name("NAME,...");
    command.add_option("--stones", asked->places.stones, "Folder of the real stones; those in ../shared without it")->type_name("DIR");
    command.add_option("--settled", asked->places.settled, "Folder of settled heaps, read and written")->type_name("DIR");
    command.add_option("--threads", asked->threads, "0 = one per core; the result is the same")->check(CLI::Range(0, 1024));
    command.callback([asked, &code] {
        const Result<Done> result = learn(*asked);
        code = result ? kDone : kRefused;
        if (!result) printError(result.error());
    });
}

} // namespace edgescan::cli
