// Counts pixels of a picture and saves it for inspection.
#pragma once

#include <QImage>
#include <QString>

#include <functional>

namespace edgescan::ui {

/// Number of pixels for which `is` is true.
[[nodiscard]] inline int countPixels(const QImage& image, const std::function<bool(QRgb)>& is) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += is(image.pixel(x, y)) ? 1 : 0;
    }
    return count;
}

/// With EDGESCAN_PICTURES=FOLDER.
inline void keep(const QImage& image, const QString& name) {
    const QString folder = qEnvironmentVariable("EDGESCAN_PICTURES");
    if (!folder.isEmpty()) image.save(folder + "/" + name + ".png");
}

} // namespace edgescan::ui
