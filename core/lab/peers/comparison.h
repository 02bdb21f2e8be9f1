// Every method of the thesis, every PCL peer and EdgeScan+ on one scan in one run (thesis, tables 6.1 and 6.2).
#pragma once

#include "core/lab/peers/peers.h"
#include "core/lab/score/evaluation.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgescan {

/// Thread CPU time of the four steps of the thesis's table 6.1, milliseconds. A step that a method does not have is 0.
struct ComparedSteps {
    double conversion = 0.0;   ///< ranges to gray levels, or to PCL's cloud
    double noiseRemoval = 0.0; ///< missing and isolated cells, Gaussian
    double edges = 0.0;
    double merge = 0.0; ///< edge cells to 3D points
    [[nodiscard]] double total() const { return conversion + noiseRemoval + edges + merge; }
};

struct BestThreshold {
    std::string parameter; ///< key of the table
    double value = 0.0;
    Evaluation score;
    Grid<std::uint8_t> mask; ///< lines x beams, 255 = edge
};

struct ComparedMethod {
    std::string name;
    std::string key;                  ///< value of --method, "thesis", or the peer's name
    std::optional<Settings> settings; ///< null for a peer
    ComparedSteps steps;
    Grid<std::uint8_t> mask;    ///< lines x beams, 255 = edge
    Grid<std::uint8_t> classes; ///< lines x beams, DepthEdge; empty where the method tells no classes apart
    std::size_t edges = 0;
    double share = 1.0;                                       ///< of the points that a peer did before its time was up
    std::optional<Evaluation> score;                          ///< with its fixed settings; null without truth or when not all was done
    std::optional<BestThreshold> best;                        ///< of all edges, with the threshold that suits this scan best
    std::string note;                                         ///< why there is no result, or what to know about it
    std::vector<std::pair<std::string, std::size_t>> kinds{}; ///< cells of each kind of edge that a peer tells apart

    [[nodiscard]] bool wasRun() const { return edges > 0 || note.empty(); }
};

struct ComparisonSettings {
    int repeats = 5; ///< of our own methods, interleaved; medians are told
    bool peers = true;
    std::vector<std::string> only{}; ///< comparedKeys() of our own methods; empty = all
    PeerLimits peerLimits;
    double tolerance = 2.0; ///< of the score, cells
    bool bestThreshold = false;
};

/// "edgescan+as-measured": EdgeScan+ that takes neither interlaced beams nor slipped lines into account. Unless `only` names it, it is a
/// row where the scan has some.
inline constexpr const char* kAsMeasuredKey = "edgescan+as-measured";

/// Keys of our own methods, in the order of the comparison: "thesis", kAsMeasuredKey, and values of --method (with that of --log-mask
/// behind it for the other two masks of LoG).
[[nodiscard]] std::vector<std::string> comparedKeys();

/// Called before each method with its name and the finished share; false stops.
using ComparisonProgress = std::function<bool(const char* name, double fraction)>;

/// `truth` may be null. Peers that cannot run say why in their note.
[[nodiscard]] std::vector<ComparedMethod> compareMethods(const std::shared_ptr<const Scan>& scan, const TruthSet* truth,
                                                         const ComparisonSettings& settings, const ComparisonProgress& progress = {});

} // namespace edgescan
