// All figures of one mask, or of a method over its thresholds, compared with the truth.
#pragma once

#include "app/lab/score/places.h"
#include "app/lab/score/score.h"
#include "app/lab/sim/truth/truth_files.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace edgescan::lab {

/// The score of the outline of one rock.
struct ScoredOutline {
    int scan = 0;          ///< index of its scan among the scans that were added up
    int object = 0;        ///< its number in object.png and rocks.json
    std::size_t cells = 0; ///< scored outline cells, at least 10
    std::size_t found = 0; ///< number of these that were found
    [[nodiscard]] double share() const { return static_cast<double>(found) / static_cast<double>(cells); }
};

/// Figures that can be added over scans.
struct Evaluation {
    EdgeScore score;
    std::vector<ScoredOutline> rocks; ///< rocks with at least 10 scored outline cells
    /// per match, mm: distance of the detection's measured 3D point from the true one; empty without a scan
    std::vector<double> errorsMm;
    double pratt = 0.0; ///< sum over scans of Pratt's figure of merit, each 0..1
    int scans = 0;
    PlacesByClass places{};

    Evaluation& operator+=(const Evaluation& other);
};

/// `scan` may be null: then there are no errors in 3D. `mask`: 255 = edge. `tolerance`: cells.
[[nodiscard]] Evaluation evaluateMask(const Grid<std::uint8_t>& mask, const sim::TruthSet& truth, const Scan* scan, double tolerance);

/// Pratt's figure of merit (1978): sum over the detections of 1 / (1 + d^2 / 9) divided by the larger of the two counts; d is the distance
/// to the nearest true cell, in cells. Cells that are not scored are left out. 1 if there are no true cells and no detections.
[[nodiscard]] double prattMerit(const Grid<std::uint8_t>& thin, const sim::EdgeTruth& truth);

/// A method over its thresholds, on several scans.
struct ThresholdSweep {
    std::vector<double> thresholds;               ///< ascending
    std::vector<std::vector<Evaluation>> perScan; ///< [scan][threshold]
};

/// "precision", "recall", "f" per group, rocks, 3D error, Pratt, and per class where the detections are.
[[nodiscard]] nlohmann::ordered_json evaluationJson(const Evaluation& evaluation);

/// One entry per rock: index of its file, object number, outline cells, found ones and their share.
[[nodiscard]] nlohmann::ordered_json rocksJson(const Evaluation& evaluation);

/// Per group of classes: ODS (best F with one threshold for all scans), OIS (every scan at its own best threshold), AP (area under
/// precision over recall, counts summed over the scans); and the whole evaluation at the ODS threshold of all edges.
[[nodiscard]] nlohmann::ordered_json sweepJson(const ThresholdSweep& sweep);

} // namespace edgescan::lab
