// edgescan-lab evaluate --rocks.
#include "app/lab/commands/evaluate_rocks.h"

#include "app/lab/commands/commands.h"
#include "app/lab/reports/rock_pictures.h"
#include "app/lab/score/truth_fit.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/edges/settings/parameters.h"

#include <filesystem>
#include <memory>

namespace edgescan::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct OpenScene {
    std::shared_ptr<const Scan> scan;
    lab::RockScene scene;
};

Result<OpenScene> openScene(const EvaluateRocks& evaluate, std::size_t n) {
    Result<lab::TrueRocks> truth = lab::readTrueRocks(evaluate.truths[n]);
    if (!truth) return truth.error();
    Result<Scan> scan = openAndWarn(evaluate.files[n], evaluate.read);
    if (!scan) return scan.error();
    const Grid<std::uint16_t> clean = truth->cleanMm;
    Result<lab::RockScene> scene = lab::rockScene(*scan, std::move(*truth), evaluate.files[n]);
    if (!scene) return scene.error();
    if (auto fits = lab::checkTruthFits(*scan, sim::TruthSet{{}, {}, clean}, evaluate.truths[n]); !fits) return fits.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *scan); !enough) return enough.error();
    return OpenScene{std::make_shared<const Scan>(std::move(*scan)), std::move(*scene)};
}

/// One way on all scenes.
struct Column {
    const lab::RockMethod* way;
    std::vector<lab::RockSceneScore> scores;
    std::string note;
};

Json missesJson(const lab::RockScene& scene, const lab::RockSceneScore& score, std::size_t file) {
    constexpr std::array<const char*, lab::kMisses> kNames{"called_no_rock", "with_wall", "merged", "split", "other"};
    Json rocks = Json::array();
    for (const lab::RockVerdict& rock : score.strict.rocks)
        rocks.push_back({{"file", file},
                         {"object", scene.truth.rocks[rock.rock - 1].object},
                         {"cells", rock.cells},
                         {"iou", rock.iou},
                         {"found", rock.found},
                         {"miss", rock.found ? Json(nullptr) : Json(kNames[static_cast<std::size_t>(rock.miss)])}});
    return rocks;
}

Result<Done> savePicture(const EvaluateRocks& evaluate, std::size_t n, const OpenScene& open, const lab::RockDetection& answer,
                         const lab::RockSceneScore& score) {
    if (evaluate.pictures.empty()) return Done{};
    if (auto made = makeFolder(evaluate.pictures); !made) return made;
    return containers::savePngRgb(lab::rockSheet(*open.scan, open.scene, answer, score),
                                  fs::path(evaluate.pictures) / ("rocks-" + std::to_string(n + 1) + ".png"));
}

Result<Json> evaluateAll(const EvaluateRocks& evaluate) {
    std::vector<Column> columns;
    for (const lab::RockMethod& way : lab::rockMethods()) {
        if (!way.isPcl || evaluate.peers) columns.push_back({&way, {}, {}});
    }
    Json rocks = Json::array();
    for (std::size_t n = 0; n < evaluate.files.size(); ++n) {
        const Result<OpenScene> open = openScene(evaluate, n);
        if (!open) return open.error();
        for (Column& column : columns) {
            const lab::RockDetection answer = column.way->find(open->scan, evaluate.choices);
            if (!answer.note.empty()) {
                column.note = answer.note;
                continue;
            }
            column.scores.push_back(lab::scoreRocks(open->scene, answer));
            if (&column != columns.data()) continue;
            for (Json& rock : missesJson(open->scene, column.scores.back(), n)) rocks.push_back(std::move(rock));
            if (const auto saved = savePicture(evaluate, n, *open, answer, column.scores.back()); !saved) return saved.error();
        }
    }
    Json json = document("evaluate-rocks", Json::object());
    json["files"] = evaluate.files;
    json["settings"] = edges::settingsToJson(evaluate.choices.edges);
    json["rock_settings"] = rocks::rockSettingsToJson(evaluate.choices.rocks);
    json["answers"] = Json::array();
    for (const Column& column : columns) {
        Json one{{"answer", column.way->key}, {"name", column.way->name}};
        one["note"] = column.note.empty() ? Json(nullptr) : Json(column.note);
        one.update(lab::rockScoreJson(column.scores));
        json["answers"].push_back(std::move(one));
    }
    json["rocks"] = std::move(rocks);
    return json;
}

std::string figureText(const Json& number, int decimals = 3) { return number.is_null() ? "-" : fixedText(number.get<double>(), decimals); }

std::string percentText(const Json& share) { return share.is_null() ? "-" : fixedText(100.0 * share.get<double>(), 0) + " %"; }

void showTable(const Json& json) {
    std::string lines = rightAligned("", 30) + "        lenient            strict             400 cells, lenient  strict\n" +
                        rightAligned("", 30) + "  PQ    SQ    F1     PQ    SQ    F1     PQ    SQ    F1     PQ    SQ    F1\n";
    for (const Json& one : json["answers"]) {
        lines += rightAligned(one["name"].get<std::string>(), 30);
        for (const char* least : {"at_least_100_cells", "at_least_400_cells"}) {
            for (const char* kind : {"lenient", "strict"}) {
                const Json& counts = one[least][kind];
                lines += "  " + figureText(counts["pq"]) + " " + figureText(counts["sq"]) + " " + figureText(counts["f1"]);
            }
        }
        lines += one["note"].is_null() ? "\n" : "  " + one["note"].get<std::string>() + "\n";
    }
    printResult(lines);
}

/// The attributes of each rock, for the first answer.
void showClaims(const Json& one) {
    const Json& counts = one["at_least_100_cells"]["strict"];
    std::string text = fixedText(counts["rocks"].get<double>(), 0) + " rocks of 100 cells and more; missed (strict):";
    for (const auto& [name, number] : counts["missed_by"].items()) text += " " + name + " " + fixedText(number.get<double>(), 0) + ",";
    text += " false regions " + fixedText(counts["false"].get<double>(), 0) + "\nfound by cells:";
    for (const Json& size : one["by_cells"])
        text += " from " + fixedText(size["from_cells"].get<double>(), 0) + " " + percentText(size["share"]) + ",";
    text += " visible parts as rocks: PQ " + figureText(one["visible_parts"]["pq"]) + "\n";
    for (const char* span : {"a", "b"}) {
        const Json& figures = one["spans"][span];
        text += std::string("visible span ") + span + ": within u " + percentText(figures["within_1_u"]) + ", within 2 u " +
                percentText(figures["within_2_u"]) + ", median error " + percentText(figures["median_error"]) + ", P90 " +
                percentText(figures["p90_error"]) + "\n";
    }
    text += "P50 / P80 of visible b off by " + percentText(one["size_curve"]["p50"]["mean_error"]) + " / " +
            percentText(one["size_curve"]["p80"]["mean_error"]) + "; confidence: AUC " + figureText(one["confidence"]["auc"], 2) +
            ", calibration error " + figureText(one["confidence"]["calibration_error"]) + "\nin front: right " +
            percentText(one["order"]["right_where_both_decide"]) + ", found " + percentText(one["order"]["recall"]) + ", true " +
            percentText(one["order"]["precision"]) + "; contacts: true " + percentText(one["contacts"]["precision"]) + ", found " +
            percentText(one["contacts"]["recall"]);
    printResult(text);
}

} // namespace

int writeOrShow(const Result<Json>& figures, const std::string& json, const std::function<void(const Json&)>& show) {
    if (!figures) return failWith(figures.error());
    if (json.empty()) {
        show(*figures);
        return kDone;
    }
    const Result<Done> written = writeDocument(json, *figures);
    return written ? kDone : failWith(written.error());
}

int evaluateRocks(const EvaluateRocks& evaluate) {
    return writeOrShow(evaluateAll(evaluate), evaluate.json, [](const Json& figures) {
        showTable(figures);
        showClaims(figures["answers"].front());
    });
}

} // namespace edgescan::cli
