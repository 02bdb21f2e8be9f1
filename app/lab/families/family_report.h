// Families as tables and JSON, in pairs with an earlier run, and compared with recorded figures.
#pragma once

#include "app/lab/families/family_run.h"
#include "app/lab/families/protocol.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace edgescan::lab {

struct FamilyFigure {
    std::size_t scenes = 0; ///< with a result
    double mean = 0.0, worstTenth = 0.0;
};
[[nodiscard]] FamilyFigure familyFigure(const ScoredFamily& family, std::size_t contestant, const ScoreGroup& group);

/// "contestants" and "families": figures of each family, and every scene with its scores.
[[nodiscard]] nlohmann::ordered_json familiesJson(const std::vector<ScoredFamily>& families, const std::vector<Contestant>& contestants);
[[nodiscard]] nlohmann::ordered_json verdictJson(const Verdict& verdict);

/// A table per group of edges, one of cells where there is no F, and the skipped families.
[[nodiscard]] std::string familiesText(const std::vector<ScoredFamily>& families, const std::vector<Contestant>& contestants);

/// The scores of one contestant by the names of the scenes.
using NamedScores = std::map<std::string, SceneScore>;
[[nodiscard]] NamedScores namedScores(const std::vector<ScoredFamily>& families, std::size_t contestant);
/// From the JSON of an earlier run. Error: it is not one, or it does not have the contestant.
[[nodiscard]] Result<NamedScores> namedScoresFrom(const nlohmann::json& run, const std::string& contestant, const std::string& where);

/// The verdict on `contestant` after `before`. It fails also if a scene of `before` is missing: with fewer scenes no change is proven.
[[nodiscard]] Verdict verdictAgainst(const std::vector<ScoredFamily>& families, std::size_t contestant, const NamedScores& before,
                                     const std::vector<std::string>& named);

/// How far a recorded F of a scene may fall.
inline constexpr double kMostRecordedFall = 0.03;
/// F of the judged groups of the first contestant, by scene.
[[nodiscard]] nlohmann::ordered_json recordedFigures(const std::vector<ScoredFamily>& families);
/// One sentence per figure that fell by kMostRecordedFall or more, and per recorded scene without a score though its family is not skipped.
/// Error: not such a record, or no scene is in both.
[[nodiscard]] Result<std::vector<std::string>> fallenFigures(const std::vector<ScoredFamily>& families, const nlohmann::json& record,
                                                             const std::string& where);

} // namespace edgescan::lab
