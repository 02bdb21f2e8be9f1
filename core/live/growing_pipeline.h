// Runs the method on scans that may grow: only the rows that new lines can reach, and with a range window that stays while they grow.
#pragma once

#include "core/live/live_edges.h"
#include "core/method/pipeline.h"

#include <cstdint>
#include <optional>

namespace edgescan {

/// What a scan does not know of itself.
struct Growth {
    std::uint64_t id = 0;  ///< SweepProgress::growth; 0: the scan continues no other
    bool growing = false;  ///< more lines are to come
    int expectedLines = 0; ///< of the whole sweep; 0: not known

    bool operator==(const Growth&) const = default;
};

/// Not for several threads at once.
class GrowingPipeline {
public:
    /// The result is that of detectEdges() with the settings that the detection names. While a scan grows, a window that depends on the
    /// ranges (automatic near and far, the scaling of the thesis) is fixed; it is looked at again only when the lines have doubled, and
    /// changes only when it is more than a tenth off. A scan that grows no more gets the settings as they are.
    std::shared_ptr<const Detection> run(const std::shared_ptr<const Scan>& scan, const Settings& settings, const Growth& growth = {});

private:
    std::shared_ptr<const Detection> grow(const std::shared_ptr<const Scan>& scan, const Settings& settings, const Growth& growth);
    Settings fixedWindow(const Scan& scan, const Settings& settings, std::uint64_t id);

    Pipeline pipeline_;
    std::shared_ptr<const Detection> last_;
    std::optional<LiveEdges> edges_;
    std::uint64_t edgesOf_ = 0; // growth

    Settings asked_, fixed_;
    std::uint64_t fixedOf_ = 0; // growth
    int fixedAt_ = 0;           // lines
};

} // namespace edgescan
