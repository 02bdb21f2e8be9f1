// Fresh scenes of families, made on several threads, from which the commands `learn-...` learn.
#pragma once

#include "app/lab/families/families.h"
#include "app/lab/learning/learn_rocks.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgescan::cli {

struct LessonSceneFlags {
    std::string draw = "learn-edges";             ///< the heaps of one draw are settled once for all lessons
    lab::FamilyPlaces places{.stoneSet = "free"}; ///< what is learnt from these stones may be shipped
    std::vector<std::string> only{};
    int scenes = 6, threads = 0;
    int views = 1; ///< of each heap of stones; two of three have stones with other surfaces, lab::carvedStone()
};

struct LessonScene {
    const lab::Family* family = nullptr;
    std::string kind; ///< is left out as a whole in a trial
    lab::SceneOrder order;
};

/// Fresh scenes of each family of the lesson: half as many of noisy and a third as many of full ones, because they teach what the others do
/// not. Error: as lab::drawnScenes(); no family has these names.
Result<std::vector<LessonScene>> lessonScenes(const LessonSceneFlags& asked);

/// Makes the scenes in any order; `use` is called with the index of a scene, on several threads. Error: the first one; interrupted.
Result<Done> makeLessonScenes(const LessonSceneFlags& asked, const std::vector<LessonScene>& scenes,
                              const std::function<void(std::size_t, const lab::MadeScene&)>& use);

/// makeLessonScenes() as lessons of rocks, in the order of `scenes`; one without truth is empty.
Result<std::vector<lab::RockLesson>> rockLessons(const LessonSceneFlags& asked, const std::vector<LessonScene>& scenes);

/// "weights of R: 1.000 2.000 ...".
[[nodiscard]] std::string scoreText(const std::vector<lab::RegionSample>& regions);

/// The kinds in the order of their scenes.
[[nodiscard]] std::vector<std::string> kindsOf(const std::vector<LessonScene>& scenes);

/// The flags that draw the same scenes again: " --draw learn-edges --scenes 6 --views 1".
[[nodiscard]] std::string drawFlags(const LessonSceneFlags& asked);

/// asked.threads, or one per core.
[[nodiscard]] int threadsOf(const LessonSceneFlags& asked);

/// `asked` must live until the command has run.
void addLessonSceneFlags(CLI::App& command, LessonSceneFlags& asked);

} // namespace edgescan::cli
