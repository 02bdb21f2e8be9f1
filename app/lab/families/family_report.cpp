// Writes families as tables and JSON, and reads earlier ones.
#include "app/lab/families/family_report.h"

#include "core/base/json_fields.h"
#include "core/base/number_text.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>

namespace edgescan::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kMeasureNames{"edges", "false cells", "counts"};

double fOfGroup(const SceneScore& score, const ScoreGroup& group) { return ((*score.edges).*group.counts).f(); }

Json figuresJson(const ScoredFamily& family, std::size_t contestant) {
    Json json = Json::object();
    for (const ScoreGroup& group : kScoreGroups) {
        const FamilyFigure figure = familyFigure(family, contestant, group);
        json[group.key] = {{"scenes", figure.scenes}, {"mean", figure.mean}, {"worst_tenth", figure.worstTenth}};
    }
    return json;
}

Json sceneJson(const ScoredScene& scene, const std::vector<Contestant>& contestants) {
    Json json{{"name", scene.name}, {"seed", scene.seed}};
    for (std::size_t n = 0; n < contestants.size(); ++n) json["scores"][contestants[n].name] = sceneScoreJson(scene.scores[n]);
    return json;
}

std::string cell(const std::string& text) { return " " + rightAligned(text, std::max<std::size_t>(13, text.size())); }

std::string leftAligned(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

constexpr std::size_t kNameWidth = 18;

std::string headText(const std::string& title, const std::vector<Contestant>& contestants) {
    std::string text = title + "\n" + leftAligned("family", kNameWidth) + " scenes";
    for (const Contestant& contestant : contestants) text += cell(contestant.name);
    return text + "\n";
}

// Edge cells or false cells per scene: jumps / folds / others.
std::string cellsText(const ScoredFamily& family, std::size_t contestant) {
    using edges::DepthEdge;
    const auto cells = family.family->measure == Measure::FalseCells ? &SceneScore::away : &SceneScore::cells;
    std::array<double, 3> sums{};
    for (const ScoredScene& scene : family.scenes) {
        for (std::size_t n = 0; n < edges::kDepthEdges; ++n) {
            const auto one = static_cast<DepthEdge>(n);
            const std::size_t place = one == DepthEdge::Jump ? 0 : one == DepthEdge::Convex || one == DepthEdge::Concave ? 1 : 2;
            sums[place] += static_cast<double>((scene.scores[contestant].*cells)[n]) / static_cast<double>(family.scenes.size());
        }
    }
    return fixedText(sums[0], 0) + "/" + fixedText(sums[1], 0) + "/" + fixedText(sums[2], 0);
}

} // namespace

FamilyFigure familyFigure(const ScoredFamily& family, std::size_t contestant, const ScoreGroup& group) {
    std::vector<double> values;
    for (const ScoredScene& scene : family.scenes) {
        if (scene.scores[contestant].edges) values.push_back(fOfGroup(scene.scores[contestant], group));
    }
    return {values.size(), meanOf(values), worstTenth(values)};
}

Json familiesJson(const std::vector<ScoredFamily>& families, const std::vector<Contestant>& contestants) {
    Json json;
    json["tolerance"] = kFamilyTolerance;
    json["contestants"] = Json::array();
    for (const Contestant& contestant : contestants) {
        Json one{{"name", contestant.name}, {"flags", contestant.flags}};
        if (contestant.settings) one["settings"] = edges::settingsToJson(*contestant.settings);
        json["contestants"].push_back(std::move(one));
    }
    json["families"] = Json::array();
    for (const ScoredFamily& family : families) {
        Json one{{"name", family.family->name},   {"source", family.family->source->name},
                 {"kind", family.family->kind},   {"grid", family.family->full ? "full" : "half"},
                 {"noise", family.family->noise}, {"measure", kMeasureNames[static_cast<std::size_t>(family.family->measure)]}};
        if (!family.skipped.empty()) one["skipped"] = family.skipped;
        for (std::size_t n = 0; n < contestants.size() && family.family->measure == Measure::Edges && !family.scenes.empty(); ++n)
            one["figures"][contestants[n].name] = figuresJson(family, n);
        one["scenes"] = Json::array();
        for (const ScoredScene& scene : family.scenes) one["scenes"].push_back(sceneJson(scene, contestants));
        json["families"].push_back(std::move(one));
    }
    return json;
}

Json verdictJson(const Verdict& verdict) {
    Json json{{"passes", verdict.passes}};
    for (std::size_t n = 0; n < kScoreGroups.size(); ++n) {
        const GroupChange& change = verdict.groups[n];
        json["groups"][kScoreGroups[n].key] = {
            {"before", change.before}, {"after", change.after}, {"low", change.low}, {"high", change.high}};
    }
    json["sentences"] = verdict.sentences;
    return json;
}

std::string familiesText(const std::vector<ScoredFamily>& families, const std::vector<Contestant>& contestants) {
    std::string text;
    for (const ScoreGroup& group : kScoreGroups) {
        text += headText(std::string("F, ") + group.name + ": mean (worst tenth)", contestants);
        for (const ScoredFamily& family : families) {
            if (family.family->measure != Measure::Edges || family.scenes.empty()) continue;
            text += leftAligned(family.family->name, kNameWidth) + rightAligned(std::to_string(family.scenes.size()), 7);
            for (std::size_t n = 0; n < contestants.size(); ++n) {
                const FamilyFigure figure = familyFigure(family, n, group);
                text += cell(figure.scenes == 0 ? "-" : fixedText(figure.mean, 3) + " (" + fixedText(figure.worstTenth, 3) + ")");
            }
            text += "\n";
        }
        text += "\n";
    }
    std::string cells;
    for (const ScoredFamily& family : families) {
        if (family.family->measure == Measure::Edges || family.scenes.empty()) continue;
        cells += leftAligned(family.family->name, kNameWidth) + rightAligned(std::to_string(family.scenes.size()), 7);
        for (std::size_t n = 0; n < contestants.size(); ++n) cells += cell(cellsText(family, n));
        cells += "\n";
    }
    if (!cells.empty())
        text += headText("jumps / folds / other cells per scene; of walls only those away from the truth", contestants) + cells;
    for (const ScoredFamily& family : families) {
        if (!family.skipped.empty()) text += "skipped: " + std::string(family.family->name) + ": " + family.skipped + "\n";
    }
    return text;
}

NamedScores namedScores(const std::vector<ScoredFamily>& families, std::size_t contestant) {
    NamedScores scores;
    for (const ScoredFamily& family : families) {
        for (const ScoredScene& scene : family.scenes) scores.emplace(scene.name, scene.scores[contestant]);
    }
    return scores;
}

Result<NamedScores> namedScoresFrom(const nlohmann::json& run, const std::string& contestant, const std::string& where) {
    const std::string hint = "give the --json of an earlier run of edgescan-lab families";
    NamedScores scores;
    JsonFields fields(run, where, hint);
    for (JsonFields& family : fields.objects("families")) {
        for (JsonFields& scene : family.objects("scenes")) {
            JsonFields ofScene = scene.object("scores");
            const nlohmann::json& one = ofScene.value(contestant.c_str());
            if (one.is_null()) return Error{"there is no contestant \"" + contestant + "\" in it", where, "name the first --with as there"};
            Result<SceneScore> score = sceneScoreFrom(one, where);
            if (!score) return score.error();
            scores.emplace(scene.text("name"), std::move(*score));
        }
    }
    if (fields.problem()) return *fields.problem();
    if (scores.empty()) return Error{"it has no scenes", where, hint};
    return scores;
}

Verdict verdictAgainst(const std::vector<ScoredFamily>& families, std::size_t contestant, const NamedScores& before,
                       const std::vector<std::string>& named) {
    std::vector<PairedFamily> pairs;
    std::size_t paired = 0, unpaired = 0;
    for (const ScoredFamily& family : families) {
        PairedFamily pair{family.family->name, family.family->measure, {}, {}};
        for (const ScoredScene& scene : family.scenes) {
            const auto earlier = before.find(scene.name);
            const SceneScore& after = scene.scores[contestant];
            if (earlier == before.end() || !earlier->second.note.empty() || !after.note.empty()) {
                ++unpaired;
                continue;
            }
            pair.before.push_back(earlier->second);
            pair.after.push_back(after);
            ++paired;
        }
        pairs.push_back(std::move(pair));
    }
    Verdict verdict = judged(pairs, named);
    if (unpaired > 0)
        verdict.sentences.push_back(std::to_string(unpaired) + " scenes of this run have no earlier score, and they do not count.");
    if (paired < before.size()) {
        verdict.passes = false;
        verdict.sentences.push_back(std::to_string(before.size() - paired) +
                                    " scenes of the earlier run have no score here, so the change is not judged on all of them.");
    }
    return verdict;
}

Json recordedFigures(const std::vector<ScoredFamily>& families) {
    Json json = Json::object();
    for (const ScoredFamily& family : families) {
        for (const ScoredScene& scene : family.scenes) {
            if (!scene.scores.front().edges) continue;
            for (const ScoreGroup& group : kScoreGroups) {
                if (group.judged) json["scenes"][scene.name][group.key] = rounded(fOfGroup(scene.scores.front(), group), 10000);
            }
        }
    }
    return json;
}

Result<std::vector<std::string>> fallenFigures(const std::vector<ScoredFamily>& families, const nlohmann::json& record,
                                               const std::string& where) {
    const std::string hint = "record the figures again with --record";
    JsonFields fields(record, where, hint);
    JsonFields scenes = fields.object("scenes");
    std::vector<std::string> fallen;
    std::size_t compared = 0;
    for (const ScoredFamily& family : families) {
        for (const ScoredScene& scene : family.scenes) {
            if (!scene.scores.front().edges || !scenes.has(scene.name.c_str())) continue;
            JsonFields figures = scenes.object(scene.name.c_str());
            ++compared;
            for (const ScoreGroup& group : kScoreGroups) {
                if (!group.judged) continue;
                const double before = figures.neededNumber(group.key, {0, 1}), now = fOfGroup(scene.scores.front(), group);
                if (before - now < kMostRecordedFall) continue;
                fallen.push_back(scene.name + ": F " + group.name + " falls from " + fixedText(before, 4) + " to " + fixedText(now, 4) +
                                 ", by .03 or more.");
            }
        }
    }
    if (fields.problem()) return *fields.problem();
    if (compared == 0) return Error{"no scene of it was scored in this run", where, hint};
    for (const auto& [name, figures] : record.at("scenes").items()) {
        const auto explains = [&name = name](const ScoredFamily& family) {
            return (!family.skipped.empty() && name.starts_with(family.family->name)) ||
                   std::ranges::any_of(family.scenes,
                                       [&name](const ScoredScene& scene) { return scene.name == name && scene.scores.front().edges; });
        };
        if (std::ranges::none_of(families, explains)) fallen.push_back(name + ": it is recorded, but this run did not score it.");
    }
    return fallen;
}

} // namespace edgescan::lab
