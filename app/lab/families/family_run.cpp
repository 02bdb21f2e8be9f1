// Runs scenes on several threads and stores the scores of each.
#include "app/lab/families/family_run.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;

struct SceneJob {
    const Family* family;
    SceneOrder order;
    ScoredScene* result;
    bool isFirst; ///< of its family
};

// The name of a score in the store: a hash of all that it depends on.
fs::path storedName(const FamilyRunSettings& settings, const SceneJob& job, const Contestant& contestant) {
    const std::string method = contestant.settings ? jsonText(edges::settingsToJson(*contestant.settings)) : "pcl";
    std::string text;
    for (const std::string& part : {settings.program, job.order.name, job.order.file.string(), settings.places.surface.string(),
                                    settings.places.stones.string(), method})
        text += part + "\n";
    constexpr std::size_t kDigits = 32;
    return settings.store / (sha256Hex(std::as_bytes(std::span(text))).substr(0, kDigits) + ".json");
}

/// Null if the score is not in the store, or damaged there.
std::optional<SceneScore> storedScore(const fs::path& path) {
    std::error_code failed;
    if (!fs::exists(path, failed)) return std::nullopt;
    const auto bytes = readWholeFile(path);
    if (!bytes) return std::nullopt;
    const auto json = parseJson(textOf(*bytes), path.string());
    if (!json) return std::nullopt;
    Result<SceneScore> score = sceneScoreFrom(*json, path.string());
    if (!score) return std::nullopt;
    return std::move(*score);
}

Result<Done> runScene(const FamilyRunSettings& settings, const SceneJob& job, const GoOn& goOn) {
    std::optional<MadeScene> scene;
    const auto make = [&]() -> Result<Done> {
        if (scene) return Done{};
        Result<MadeScene> made = makeScene(*job.family, job.order, settings.places, goOn);
        if (!made) return made.error();
        scene = std::move(*made);
        return Done{};
    };
    if (settings.showFirst && job.isFirst) {
        if (const auto made = make(); !made) return made;
        if (const auto shown = settings.showFirst(*scene, job.order.name); !shown) return shown;
    }
    for (std::size_t n = 0; n < settings.contestants.size(); ++n) {
        const fs::path path = settings.store.empty() ? fs::path() : storedName(settings, job, settings.contestants[n]);
        if (!path.empty()) {
            if (auto stored = storedScore(path)) {
                job.result->scores[n] = std::move(*stored);
                continue;
            }
        }
        if (!goOn()) return Error{"stopped", "", ""};
        if (const auto made = make(); !made) return made;
        SceneScore score = sceneScore(*scene, settings.contestants[n]);
        if (!path.empty()) {
            if (const auto written = writeWholeFile(path, jsonText(sceneScoreJson(score)) + "\n"); !written) return written;
        }
        job.result->scores[n] = std::move(score);
    }
    return Done{};
}

class SceneThreads {
public:
    SceneThreads(const FamilyRunSettings& settings, const std::vector<SceneJob>& jobs, const GoOn& goOn, const FamilyProgress& progress)
        : settings_(settings), jobs_(jobs), goOn_(goOn), progress_(progress) {}

    Result<Done> run() {
        std::vector<std::thread> threads;
        const auto wanted = std::min<std::size_t>(jobs_.size(), static_cast<std::size_t>(std::max(1, settings_.threads)));
        for (std::size_t n = 1; n < wanted; ++n) threads.emplace_back([this] { work(); });
        work();
        for (std::thread& thread : threads) thread.join();
        if (failure_) return *failure_;
        return Done{};
    }

private:
    void work() {
        const GoOn goOn = [this] { return !stopped_ && (!goOn_ || goOn_()); };
        for (std::size_t n = next_++; n < jobs_.size() && !stopped_; n = next_++) {
            Result<Done> done = Done{};
            try {
                done = runScene(settings_, jobs_[n], goOn);
            } catch (const std::bad_alloc&) {
                done = Error{"there is not enough memory", jobs_[n].order.name, "use fewer --threads"};
            }
            const std::lock_guard lock(mutex_);
            if (!done && !failure_)
                failure_ = goOn() ? done.error() : Error{"stopped", "families", "run it again; with --store it goes on"};
            const bool more = !progress_ || progress_(jobs_[n].order.name, ++finished_, jobs_.size());
            if (done && !more && !failure_) failure_ = Error{"stopped", "families", "run it again; with --store it goes on"};
            if (failure_) stopped_ = true;
        }
    }

    const FamilyRunSettings& settings_;
    const std::vector<SceneJob>& jobs_;
    const GoOn& goOn_;
    const FamilyProgress& progress_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> stopped_{false};
    std::mutex mutex_;
    std::size_t finished_ = 0;
    std::optional<Error> failure_;
};

} // namespace

Result<std::vector<ScoredFamily>> runFamilies(const FamilyRunSettings& settings, const GoOn& goOn, const FamilyProgress& progress) {
    if (const auto made = makeFolder(settings.store); !made) return made.error();
    std::vector<ScoredFamily> results(settings.families.size());
    std::vector<SceneJob> jobs;
    for (std::size_t n = 0; n < results.size(); ++n) {
        results[n].family = settings.families[n];
        const auto orders = drawnScenes(*settings.families[n], settings.draw, settings.places);
        if (!orders) {
            results[n].skipped = orders.error().sentence();
            continue;
        }
        results[n].scenes.resize(orders->size());
        for (std::size_t k = 0; k < orders->size(); ++k) {
            const SceneOrder& order = (*orders)[k];
            results[n].scenes[k] = {order.name, order.seed, std::vector<SceneScore>(settings.contestants.size())};
            jobs.push_back({settings.families[n], order, &results[n].scenes[k], k == 0});
        }
    }
    if (const Result<Done> done = SceneThreads(settings, jobs, goOn, progress).run(); !done) return done.error();
    return results;
}

} // namespace edgescan::lab
