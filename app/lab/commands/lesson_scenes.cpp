// Draws the scenes of a lesson and makes them.
#include "app/lab/commands/lesson_scenes.h"

#include "app/shared/exits.h"
#include "app/shared/options.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

namespace edgescan::cli {
namespace {

struct LessonFamily {
    const char* family;
    const char* kind;
};
constexpr std::array<LessonFamily, 15> kFamilies{{{"real bench", "real bench"},
                                                  {"real hangup", "real hang-up"},
                                                  {"real pile", "real pile"},
                                                  {"real bench x3", "real bench"},
                                                  {"real hangup x3", "real hang-up"},
                                                  {"real pile x3", "real pile"},
                                                  {"real hangup full", "real hang-up"},
                                                  {"real bench full", "real bench"},
                                                  {"real pile full", "real pile"},
                                                  {"hangup", "simulated"},
                                                  {"pile", "simulated"},
                                                  {"hangup x3", "simulated"},
                                                  {"spin", "simulated"},
                                                  {"hangup full", "simulated"},
                                                  {"pile full", "simulated"}}};

} // namespace

Result<std::vector<LessonScene>> lessonScenes(const LessonSceneFlags& asked) {
    std::vector<LessonScene> scenes;
    for (const LessonFamily& row : kFamilies) {
        if (!asked.only.empty() && std::ranges::find(asked.only, row.family) == asked.only.end()) continue;
        const lab::Family& family = *lab::findFamily(row.family);
        // A kind without views has as many scenes more.
        const auto all = static_cast<std::size_t>(asked.scenes * (lab::hasViews(family) ? 1 : asked.views));
        const std::size_t fresh = family.full        ? std::max<std::size_t>(1, all / 3)
                                  : family.noise > 1 ? std::max<std::size_t>(1, all / 2)
                                                     : all;
        const auto orders = lab::drawnScenes(family, {.text = asked.draw, .fresh = fresh}, asked.places);
        if (!orders) return orders.error();
        for (lab::SceneOrder order : *orders) {
            if (!order.file.empty()) continue;
            for (order.view = 0; order.view < (lab::hasViews(family) ? asked.views : 1); ++order.view) {
                order.carved = order.view % 3 != 0;
                scenes.push_back({&family, row.kind, order});
            }
        }
    }
    if (scenes.empty()) return Error{"no family of the lesson has these names", "--only", "use names of edgescan-lab families"};
    return scenes;
}

Result<Done> makeLessonScenes(const LessonSceneFlags& asked, const std::vector<LessonScene>& scenes,
                              const std::function<void(std::size_t, const lab::MadeScene&)>& use) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::optional<Error> failure;
    std::size_t made = 0;
    const auto makeOne = [&](std::size_t n) -> Result<Done> {
        try {
            const auto scene = lab::makeScene(*scenes[n].family, scenes[n].order, asked.places, [] { return !interrupted(); });
            if (!scene) return scene.error();
            use(n, *scene);
            return Done{};
        } catch (const std::bad_alloc&) {
            return Error{"there is not enough memory", scenes[n].order.name, "use fewer --threads"};
        }
    };
    const auto work = [&] {
        for (std::size_t n = next++; n < scenes.size(); n = next++) {
            const Result<Done> done = makeOne(n);
            const std::lock_guard lock(mutex);
            if (!done) {
                if (!failure) failure = done.error();
                next = scenes.size();
                return;
            }
            ++made;
            showProgress(std::to_string(made) + " of " + std::to_string(scenes.size()) + " scenes", made == scenes.size());
        }
    };
    std::vector<std::jthread> workers;
    for (int n = 1; n < threadsOf(asked); ++n) workers.emplace_back(work);
    work();
    workers.clear();
    if (failure) return *failure;
    return Done{};
}

Result<std::vector<lab::RockLesson>> rockLessons(const LessonSceneFlags& asked, const std::vector<LessonScene>& scenes) {
    std::vector<lab::RockLesson> lessons(scenes.size());
    const auto made = makeLessonScenes(asked, scenes, [&](std::size_t n, const lab::MadeScene& scene) {
        if (scene.truth) lessons[n] = lab::rockLesson(scene.scan, scene.truth->object);
    });
    if (!made) return made.error();
    return lessons;
}

std::string scoreText(const std::vector<lab::RegionSample>& regions) {
    std::string text = "weights of R:";
    for (const double weight : lab::fittedScore(regions)) text += " " + fixedText(weight, 3);
    return text;
}

std::string drawFlags(const LessonSceneFlags& asked) {
    return " --draw " + asked.draw + " --scenes " + std::to_string(asked.scenes) + " --views " + std::to_string(asked.views);
}

std::vector<std::string> kindsOf(const std::vector<LessonScene>& scenes) {
    std::vector<std::string> kinds;
    for (const LessonScene& scene : scenes) {
        if (std::ranges::find(kinds, scene.kind) == kinds.end()) kinds.push_back(scene.kind);
    }
    return kinds;
}

int threadsOf(const LessonSceneFlags& asked) {
    return asked.threads > 0 ? asked.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void addLessonSceneFlags(CLI::App& command, LessonSceneFlags& asked) {
    command.add_option("--draw", asked.draw, "Text from which the seeds of the scenes are drawn")->capture_default_str();
    command.add_option("--scenes", asked.scenes, "Scenes per family")->check(CLI::Range(1, 1000))->capture_default_str();
    command.add_option("--views", asked.views, "Places from which each heap of stones is scanned")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command.add_option("--only", asked.only, "Only these families")->delimiter(',')->type_name("NAME,...");
    command.add_option("--stones", asked.places.stones, "Folder of the real stones; those in ../shared without it")->type_name("DIR");
    command.add_option("--settled", asked.places.settled, "Folder of settled heaps, read and written")->type_name("DIR");
    command.add_option("--threads", asked.threads, "0 = one per core; the result is the same")->check(CLI::Range(0, 1024));
}

} // namespace edgescan::cli
