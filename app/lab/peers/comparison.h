// Runs every method of the thesis, every PCL method and EdgeScan+ on one scan (thesis, tables 6.1 and 6.2).
#pragma once

#include "app/lab/peers/peers.h"
#include "app/lab/score/evaluation.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgescan::lab {

/// Thread CPU time of the four steps of the thesis's table 6.1, milliseconds. 0 for a step that a method does not have.
struct ComparedSteps {
    double conversion = 0.0;   ///< from ranges to gray levels, or to PCL's cloud
    double noiseRemoval = 0.0; ///< missing and isolated cells, Gaussian
    double edges = 0.0;
    double merge = 0.0; ///< from edge cells to 3D points
    [[nodiscard]] double total() const { return conversion + noiseRemoval + edges + merge; }
};

struct BestThreshold {
    std::string parameter; ///< key in the parameter table
    double value = 0.0;
    Evaluation score;
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge
};

struct ComparedMethod {
    std::string name;
    std::string key;                         ///< value of --method, "thesis", or the name of the PCL method
    std::optional<edges::Settings> settings; ///< null for a PCL method
    ComparedSteps steps;
    Grid<std::uint8_t> mask;    ///< lines x beams, 255 = edge
    Grid<std::uint8_t> classes; ///< lines x beams, DepthEdge; empty if the method does not distinguish classes
    std::size_t edges = 0;
    double share = 1.0; ///< share of the points that a PCL method processed within its time limit
    /// with its fixed settings; null without truth, or if not all points were processed
    std::optional<Evaluation> score;
    std::optional<BestThreshold> best;                        ///< for all edges, with the threshold that is best for this scan
    std::string note;                                         ///< why there is no result, or a remark about it
    std::vector<std::pair<std::string, std::size_t>> kinds{}; ///< number of cells of each kind of edge that a PCL method distinguishes

    [[nodiscard]] bool wasRun() const { return edges > 0 || note.empty(); }
};

struct ComparisonSettings {
    int repeats = 5;                 ///< runs of our own methods, interleaved; the median counts
    bool withPcl = true;             ///< also run the methods of PCL
    std::vector<std::string> only{}; ///< comparedKeys() of our own methods; empty = all
    PclLimits pclLimits;
    double tolerance = 2.0; ///< tolerance of the score, cells
    bool bestThreshold = false;
};

/// "edgescan+as-measured": EdgeScan+ without correction of interlaced beams and slipped lines. It is a row if `only` names it, or if the
/// scan has such beams or lines.
inline constexpr const char* kAsMeasuredKey = "edgescan+as-measured";

/// Keys of our own methods, in the order of the comparison: "thesis", kAsMeasuredKey, and values of --method (for the other two masks of
/// LoG followed by the value of --log-mask).
[[nodiscard]] std::vector<std::string> comparedKeys();

/// Called before each method with its name and the share done; false stops.
using ComparisonProgress = std::function<bool(const char* name, double fraction)>;

/// `truth` may be null. A PCL method that cannot run gives the reason in its note.
[[nodiscard]] std::vector<ComparedMethod> compareMethods(const std::shared_ptr<const Scan>& scan, const sim::TruthSet* truth,
                                                         const ComparisonSettings& settings, const ComparisonProgress& progress = {});

} // namespace edgescan::lab
