// Images of half, quarter ... size for zooming out: mean levels for gray; lines of edges stay as bright as they are.
#pragma once

#include <QImage>

#include <memory>
#include <vector>

namespace edgescan::ui {

enum class Shrink {
    Average, ///< mean level of 2 x 2
    Lines,   ///< twice the mean light of 2 x 2, levels are roots of light: a line of one cell keeps its light, and single cells fade
};

/// Half the size, rounded up; an odd last row or column is copied. Gray stays gray (8 bit), other formats become ARGB32 premultiplied.
[[nodiscard]] QImage halved(const QImage& image, Shrink shrink);

/// The level whose pixels cover more than half a screen pixel; it is drawn smoothly. 0 = the image itself. `scale` = screen pixels per
/// cell.
[[nodiscard]] int pyramidLevel(double scale);

/// The halved images of one image, each made at its first use.
class Pyramid {
public:
    Pyramid() = default;
    Pyramid(std::shared_ptr<const QImage> image, Shrink shrink);

    [[nodiscard]] bool empty() const { return image_ == nullptr || image_->isNull(); }
    [[nodiscard]] const std::shared_ptr<const QImage>& image() const { return image_; }
    [[nodiscard]] Shrink shrink() const { return shrink_; }
    /// The last level has 1 x 1 pixels. The reference is valid until the next call of level().
    [[nodiscard]] const QImage& level(int wanted);
    [[nodiscard]] int levelsMade() const { return static_cast<int>(halves_.size()); }

private:
    std::shared_ptr<const QImage> image_;
    Shrink shrink_ = Shrink::Average;
    std::vector<QImage> halves_; // [0] is level 1
};

} // namespace edgescan::ui
