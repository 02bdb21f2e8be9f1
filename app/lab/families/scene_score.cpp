// Runs a method on a scene and scores its mask.
#include "app/lab/families/scene_score.h"

#include "app/lab/peers/peers.h"
#include "core/base/json_fields.h"
#include "core/edges/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;

struct FoundEdges {
    Grid<std::uint8_t> mask;
    std::shared_ptr<const Grid<edges::DepthEdge>> classes; ///< null for methods without classes
};

Result<FoundEdges> foundEdges(const MadeScene& scene, const Contestant& contestant) {
    if (contestant.settings) {
        const auto detection = edges::detectEdges(scene.scan, *contestant.settings);
        return FoundEdges{*detection->mask, detection->classes};
    }
    Result<PclEdges> found = runPclMethod(PclMethod::OrganizedEdgeUnrolled, pclScan(*scene.scan), {});
    if (!found) return found.error();
    if (found->share < 1.0) return Error{"it did not end in time", pclMethodName(PclMethod::OrganizedEdgeUnrolled), ""};
    return FoundEdges{std::move(found->mask), nullptr};
}

bool nearTruth(const Grid<std::uint8_t>& edgeClass, int line, int beam) {
    const int reach = static_cast<int>(std::ceil(kFamilyTolerance));
    for (int di = -reach; di <= reach; ++di) {
        for (int dj = -reach; dj <= reach; ++dj) {
            if (di * di + dj * dj > kFamilyTolerance * kFamilyTolerance || !edgeClass.contains(line + di, beam + dj)) continue;
            if (edgeClass.at(line + di, beam + dj) != 0) return true;
        }
    }
    return false;
}

Json cellsJson(const CellsByClass& cells) {
    Json json = Json::object();
    for (std::size_t n = 0; n < cells.size(); ++n) {
        if (cells[n] > 0) json[kCellClassNames[n]] = cells[n];
    }
    return json;
}

constexpr std::uint64_t kMostCells = 1'000'000'000;

CellsByClass cellsFrom(JsonFields object) {
    CellsByClass cells{};
    for (std::size_t n = 0; n < cells.size(); ++n) {
        if (object.has(kCellClassNames[n])) cells[n] = object.wholeNumber(kCellClassNames[n], 0, kMostCells);
    }
    return cells;
}

} // namespace

SceneScore sceneScore(const MadeScene& scene, const Contestant& contestant) {
    SceneScore score;
    const Result<FoundEdges> found = foundEdges(scene, contestant);
    if (!found) {
        score.note = found.error().sentence();
        return score;
    }
    const auto classOf = [&found](std::size_t k) { return found->classes ? static_cast<std::size_t>((*found->classes)[k]) : 0; };
    for (std::size_t k = 0; k < found->mask.size(); ++k) {
        if (found->mask[k] != 0) ++score.cells[classOf(k)];
    }
    if (!scene.truth) return score;
    const sim::EdgeTruth& truth = scene.truth->edges;
    const EdgeMatches matches = matchWithTruth(found->mask, truth, kFamilyTolerance);
    score.edges = scoreMatches(matches, truth);
    for (int i = 0; i < matches.thin.lines; ++i) {
        for (int j = 0; j < matches.thin.beams; ++j) {
            const std::size_t k = matches.thin.index(i, j);
            if (matches.thin[k] != 0 && truth.ignore[k] == 0 && !nearTruth(truth.edgeClass, i, j)) ++score.away[classOf(k)];
        }
    }
    return score;
}

Json sceneScoreJson(const SceneScore& score) {
    if (!score.note.empty()) return {{"note", score.note}};
    Json json = Json::object();
    if (score.edges) {
        for (const ScoreGroup& group : kScoreGroups) {
            const EdgeCounts& counts = (*score.edges).*group.counts;
            json[group.key] = {{"f", counts.f()}, {"truth", counts.truth}, {"found", counts.found}, {"false", counts.false_}};
        }
        json["away"] = cellsJson(score.away);
    }
    json["cells"] = cellsJson(score.cells);
    return json;
}

Result<SceneScore> sceneScoreFrom(const nlohmann::json& json, const std::string& where) {
    JsonFields fields(json, where, "make the results again");
    SceneScore score;
    score.note = fields.text("note");
    score.cells = cellsFrom(fields.object("cells"));
    score.away = cellsFrom(fields.object("away"));
    if (fields.has(kScoreGroups[0].key)) {
        score.edges.emplace();
        for (const ScoreGroup& group : kScoreGroups) {
            JsonFields counts = fields.object(group.key);
            (*score.edges).*group.counts = {counts.wholeNumber("truth", 0, kMostCells), counts.wholeNumber("found", 0, kMostCells),
                                            counts.wholeNumber("false", 0, kMostCells)};
        }
    }
    if (fields.problem()) return *fields.problem();
    return score;
}

} // namespace edgescan::lab
