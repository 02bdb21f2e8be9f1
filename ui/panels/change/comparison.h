// What the views show of two pictures that are compared, made off the GUI thread.
#pragma once

#include "core/base/result.h"
#include "core/inspect/change_detection/scene_change.h"
#include "core/scan/grid/reading_options.h"
#include "ui/engine/worker_bridge/picture.h"

#include <QImage>
#include <QString>

#include <array>
#include <memory>
#include <optional>

namespace edgescan::ui {

/// Rows of the legend; each can be switched off.
enum class ChangeRow : std::uint8_t { Gained, Lost, Kept, Unseen, Nearer, Farther };
inline constexpr int kChangeRows = 6;
using ChangeRows = std::array<bool, kChangeRows>;

struct ComparisonAsked {
    std::shared_ptr<const Picture> before, now;
    ChangeRows rows{true, true, true, true, true, true};
};

/// Never changed after it is made.
struct Comparison {
    ComparisonAsked asked;
    SceneChange change;
    std::shared_ptr<const Picture> earlier; ///< A; of another scan with the settings of the picture now: a slider is no blast
    std::shared_ptr<const Picture> before;  ///< on the grid of the picture now: what is shown while the two are flipped
    EdgeCells edges;                        ///< by class: gained, lost, kept, unseen
    std::shared_ptr<const QImage> map;      ///< beams x lines: edges by their change on black
    std::shared_ptr<const QImage> overlay;  ///< the same and the surfaces that changed, transparent elsewhere
    std::shared_ptr<const std::vector<std::uint32_t>>
        points; ///< by cell, bytes red, green, blue, 255; the cloud dimmed where nothing changed

    [[nodiscard]] std::size_t count(ChangeRow row) const;
    [[nodiscard]] bool isOfTwoScans() const { return change.earlier.how.by != LinedUpBy::OneScan; }
};

/// Of EdgeCells::byClass above.
[[nodiscard]] const EdgeColours& changeColours();
[[nodiscard]] QColor changeColour(ChangeRow row);

/// `last`, which may be null, spares what the two have in common. Error: as sceneChange().
[[nodiscard]] Result<std::shared_ptr<const Comparison>> compared(const ComparisonAsked& asked, const Comparison* last);

/// A scan with edges by these settings, to compare with. Error: what opening it says, or too little memory.
[[nodiscard]] Result<std::shared_ptr<const Picture>> earlierPicture(const QString& path, const ReadingOptions& reading,
                                                                    const Settings& settings);
[[nodiscard]] Result<std::shared_ptr<const Picture>> earlierDemo(bool afterBlast, const Settings& settings);
[[nodiscard]] Result<std::shared_ptr<const Picture>> pictureOf(const std::shared_ptr<const Scan>& scan, const Settings& settings);

} // namespace edgescan::ui
