// The protocol that a change of the method passes: not tuned to a few scenes (docs/method/edges.md, "Families of scenes").
#pragma once

#include "app/lab/families/families.h"
#include "app/lab/families/scene_score.h"

#include <array>
#include <string>
#include <vector>

namespace edgescan::lab {

inline constexpr double kMostMeanFall = 0.005;  ///< of F, of any family
inline constexpr double kMostWorstFall = 0.01;  ///< of the worst tenth of any family
inline constexpr double kMostCountShare = 0.10; ///< of cells of a class, without being named

/// The mean of the lowest tenth, at least of one; 0 without values.
[[nodiscard]] double worstTenth(std::vector<double> values);
[[nodiscard]] double meanOf(const std::vector<double>& values);

/// One family before and after a change, on the same scenes in the same order.
struct PairedFamily {
    std::string name;
    Measure measure = Measure::Edges;
    std::vector<SceneScore> before, after;
};

/// The F of a group: the mean over the families, and the interval of its change.
struct GroupChange {
    double before = 0.0, after = 0.0;
    double low = 0.0, high = 0.0; ///< 95 % of the resampled changes
};

struct Verdict {
    bool passes = true;
    std::array<GroupChange, kScoreGroups.size()> groups; ///< by kScoreGroups
    std::vector<std::string> sentences;                  ///< one per fall and per changed count, and one for each group that is judged
};

/// The change of a group by resampling the scenes of each family, each scene as a pair; the same on every machine.
[[nodiscard]] GroupChange groupChange(const std::vector<PairedFamily>& families, const ScoreGroup& group);

/// Passes if, for each judged group, the mean over the families does not fall, no mean of a family falls by more than kMostMeanFall and no
/// worst tenth by more than kMostWorstFall; and if no count changes by more than kMostCountShare, except in the families of `named`. Of
/// families with Measure::FalseCells only a rise counts.
[[nodiscard]] Verdict judged(const std::vector<PairedFamily>& families, const std::vector<std::string>& named);

} // namespace edgescan::lab
