// A picture in which each cell differs from its neighbours.
#pragma once

#include <QImage>

#include <memory>

namespace edgescan::ui {

/// Gray, beams wide and lines high.
inline std::shared_ptr<const QImage> ramp(int beams, int lines) {
    auto image = std::make_shared<QImage>(beams, lines, QImage::Format_Grayscale8);
    for (int y = 0; y < lines; ++y) {
        for (int x = 0; x < beams; ++x) image->scanLine(y)[x] = static_cast<uchar>((x * 7 + y * 13) % 200);
    }
    return image;
}

} // namespace edgescan::ui
