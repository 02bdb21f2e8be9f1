// The picture of edge confidence: each edge with the share of nearby settings that find it too.
#pragma once

#include "core/edges/tuning/confidence.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QImage>

#include <array>
#include <memory>

namespace edgescan::ui {

inline constexpr std::size_t kBands = edges::kConfidenceBands.size();
static_assert(kBands <= kEdgeClasses); // bands are drawn like classes

/// Immutable after construction.
struct ConfidencePicture {
    std::shared_ptr<const Picture> of;
    std::shared_ptr<const edges::EdgeConfidence> confidence;
    int leastPercent = 0;                                ///< edges below this confidence are hidden
    std::array<std::size_t, kBands> counts{};            ///< edge cells by band, hidden ones included
    EdgeCells cells;                                     ///< by band; less certain edges have smaller points
    std::array<std::shared_ptr<const QImage>, 2> images; ///< edge map, and overlay of the range image. Beams x lines

    [[nodiscard]] std::size_t shown() const { return cells.all ? cells.all->size() : 0; }
};

/// By band, each with a contrast of at least 3 : 1 to the gray of the cloud; `colourBlind`: distinct without red and green.
[[nodiscard]] const EdgeColours& bandColours(bool colourBlind);

[[nodiscard]] std::shared_ptr<const ConfidencePicture> confidencePicture(const std::shared_ptr<const Picture>& picture,
                                                                         const std::shared_ptr<const edges::EdgeConfidence>& confidence,
                                                                         int leastPercent, const EdgeColours& colours);

} // namespace edgescan::ui
