// Runs the method. Repeats only the stages whose inputs changed since the last run.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/swept_edges.h"

namespace edgescan::edges {

class StoredFolds;

/// The results that a pipeline stores in addition to the edges.
enum class KeepFor : std::uint8_t {
    Edges, ///< no others
    Rocks, ///< Detection::cracks, 20 bytes per cell
};

/// Not for several threads at once, but the detections that it returns are.
class Pipeline {
public:
    /// Switches off OpenCV's thread pool for the process: one worker thread is enough, and the pool makes run times vary.
    explicit Pipeline(KeepFor keep = KeepFor::Edges);

    /// The same scan pointer and settings return the last detection again. `scan` must not be null.
    std::shared_ptr<const Detection> run(const std::shared_ptr<const Scan>& scan, const Settings& settings);

private:
    /// The result of a stage for the scan of last_, and the settings used for it; null until it is needed.
    template <class T>
    struct Kept {
        std::shared_ptr<const T> made;
        Settings with;
    };
    template <class T, class Make>
    static std::shared_ptr<const T> upToDate(Kept<T>& kept, Stage stage, const char* name, Detection& detection, Make make);
    void runStages(Detection& detection);
    [[nodiscard]] DepthResponses responsesOf(const Detection& detection);
    void decide(Detection& detection);

    KeepFor keep_;
    std::shared_ptr<const Detection> last_;
    Kept<Grid<std::uint8_t>> masked_, smoothed_;
    Kept<GapFilling> filled_;
    Kept<DepthSurface> surface_;
    Kept<DepthResponses> responses_;
    std::shared_ptr<const DepthCracks> cracks_; // of responses_
    std::shared_ptr<const StoredFolds> folds_;  // of responses_ at any crease angle, once that was changed alone
    Kept<SweptEdges> thresholds_;               // used while only the threshold changes
};

/// One run without earlier results.
[[nodiscard]] std::shared_ptr<const Detection> detectEdges(const std::shared_ptr<const Scan>& scan, const Settings& settings,
                                                           KeepFor keep = KeepFor::Edges);

} // namespace edgescan::edges
