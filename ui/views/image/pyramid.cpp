// Images of half, quarter ... size for zooming out.
#include "ui/views/image/pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace edgescan::ui {
namespace {

int brightness(QRgb p) { return 2 * qRed(p) + 5 * qGreen(p) + qBlue(p); }

QRgb brightest(QRgb a, QRgb b) {
    if (qAlpha(a) != qAlpha(b)) return qAlpha(a) > qAlpha(b) ? a : b;
    return brightness(a) >= brightness(b) ? a : b;
}

QRgb average(QRgb a, QRgb b, QRgb c, QRgb d) {
    const auto mean = [&](int (*channel)(QRgb)) { return (channel(a) + channel(b) + channel(c) + channel(d) + 2) / 4; };
    return qRgba(mean(qRed), mean(qGreen), mean(qBlue), mean(qAlpha));
}

template <class Pixel, class Merge>
QImage halve(const QImage& from, Merge merge) {
    QImage to((from.width() + 1) / 2, (from.height() + 1) / 2, from.format());
    for (int y = 0; y < to.height(); ++y) {
        const auto* upper = reinterpret_cast<const Pixel*>(from.constScanLine(2 * y));
        const auto* lower = reinterpret_cast<const Pixel*>(from.constScanLine(std::min(2 * y + 1, from.height() - 1)));
        auto* out = reinterpret_cast<Pixel*>(to.scanLine(y));
        for (int x = 0; x < to.width(); ++x) {
            const int left = 2 * x;
            const int right = std::min(left + 1, from.width() - 1);
            out[x] = merge(upper[left], upper[right], lower[left], lower[right]);
        }
    }
    return to;
}

} // namespace

QImage halved(const QImage& image, Shrink shrink) {
    if (image.isNull()) return image;
    const bool keep = shrink == Shrink::KeepBrightest;
    if (image.format() == QImage::Format_Grayscale8) {
        using Gray = std::uint8_t;
        if (keep) return halve<Gray>(image, [](Gray a, Gray b, Gray c, Gray d) { return std::max({a, b, c, d}); });
        return halve<Gray>(image, [](Gray a, Gray b, Gray c, Gray d) { return static_cast<Gray>((a + b + c + d + 2) / 4); });
    }
    const QImage colour = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    if (keep) return halve<QRgb>(colour, [](QRgb a, QRgb b, QRgb c, QRgb d) { return brightest(brightest(a, b), brightest(c, d)); });
    return halve<QRgb>(colour, average);
}

int pyramidLevel(double scale, Shrink shrink) {
    if (!(scale > 0.0) || scale >= 1.0) return 0;
    // 1e-6: a scale of exactly one half gives level 1 in spite of rounding.
    const double halvings = -std::log2(scale);
    return static_cast<int>(shrink == Shrink::KeepBrightest ? std::ceil(halvings - 1e-6) : std::floor(halvings + 1e-6));
}

Pyramid::Pyramid(std::shared_ptr<const QImage> image, Shrink shrink) : image_(std::move(image)), shrink_(shrink) {}

const QImage& Pyramid::level(int wanted) {
    if (wanted <= 0 || empty()) return *image_;
    while (static_cast<int>(halves_.size()) < wanted) {
        const QImage& last = halves_.empty() ? *image_ : halves_.back();
        if (last.width() == 1 && last.height() == 1) return last;
        halves_.push_back(halved(last, shrink_));
    }
    return halves_[static_cast<std::size_t>(wanted) - 1];
}

} // namespace edgescan::ui
