// What the views show of edge confidence: the edges of a picture by how many nearby settings find them too.
#pragma once

#include "core/edges/tuning/confidence.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QImage>

#include <array>
#include <memory>

namespace edgescan::ui {

inline constexpr std::size_t kBands = kConfidenceBands.size();
static_assert(kBands == kEdgeClasses); // bands are drawn as classes are

/// Never changed after it is made.
struct ConfidencePicture {
    std::shared_ptr<const Picture> of;
    std::shared_ptr<const EdgeConfidence> confidence;
    int leastPercent = 0;                                ///< edges below it are left out
    std::array<std::size_t, kBands> counts{};            ///< edge cells by band, whether they are left out or not
    EdgeCells cells;                                     ///< by band, the less sure the smaller
    std::array<std::shared_ptr<const QImage>, 2> images; ///< of the edge map; over the range image. Beams x lines

    [[nodiscard]] std::size_t shown() const { return cells.all ? cells.all->size() : 0; }
};

/// By band, each at least 3 : 1 to the gray of the cloud; `colourBlind`: told apart without red and green.
[[nodiscard]] const EdgeColours& bandColours(bool colourBlind);

[[nodiscard]] std::shared_ptr<const ConfidencePicture> confidencePicture(const std::shared_ptr<const Picture>& picture,
                                                                         const std::shared_ptr<const EdgeConfidence>& confidence,
                                                                         int leastPercent, const EdgeColours& colours);

} // namespace edgescan::ui
