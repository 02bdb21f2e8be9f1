// Images of half, quarter ... size for zooming out.
#include "ui/views/image/pyramid.h"

#include "core/base/bands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace edgescan::ui {
namespace {

constexpr int kMostLight = 255 * 255;

/// The level with this light, of 0 to kMostLight.
const std::vector<std::uint8_t>& levelsOfLight() {
    static const std::vector<std::uint8_t> levels = [] {
        std::vector<std::uint8_t> made(kMostLight + 1);
        for (int light = 0; light <= kMostLight; ++light)
            made[static_cast<std::size_t>(light)] = static_cast<std::uint8_t>(std::lround(std::sqrt(light)));
        return made;
    }();
    return levels;
}

/// Twice the mean, at most the brightest: a line through 2 x 2 is two of them.
int lineLight(int a, int b, int c, int d) {
    const int most = std::max({a, b, c, d});
    return levelsOfLight()[static_cast<std::size_t>(std::min(most * most, (a * a + b * b + c * c + d * d + 1) / 2))];
}

int meanLevel(int a, int b, int c, int d) { return (a + b + c + d + 2) / 4; }

template <class Mean>
QRgb channels(QRgb a, QRgb b, QRgb c, QRgb d, Mean mean) {
    if (a == b && a == c && a == d) return a; // most of an edge map
    const auto of = [&](int (*channel)(QRgb)) { return mean(channel(a), channel(b), channel(c), channel(d)); };
    return qRgba(of(qRed), of(qGreen), of(qBlue), of(qAlpha));
}

template <class Pixel, class Half = Pixel, class Merge>
QImage halve(const QImage& from, Merge merge) {
    const bool isGray = from.format() == QImage::Format_Grayscale8;
    QImage to((from.width() + 1) / 2, (from.height() + 1) / 2, isGray ? from.format() : QImage::Format_ARGB32_Premultiplied);
    std::uint8_t* const pixels = to.bits(); // once: it is not for several threads
    const auto perLine = static_cast<std::ptrdiff_t>(to.bytesPerLine());
    const int width = to.width();
    const auto cells = static_cast<std::size_t>(from.width()) * static_cast<std::size_t>(from.height());
    runInBands(to.height(), bandsFor(cells, 0), [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const auto* upper = reinterpret_cast<const Pixel*>(from.constScanLine(2 * y));
            const auto* lower = reinterpret_cast<const Pixel*>(from.constScanLine(std::min(2 * y + 1, from.height() - 1)));
            auto* out = reinterpret_cast<Half*>(pixels + y * perLine);
            for (int x = 0; x < width; ++x) {
                const int left = 2 * x;
                const int right = std::min(left + 1, from.width() - 1);
                out[x] = merge(upper[left], upper[right], lower[left], lower[right]);
            }
        }
    });
    return to;
}

} // namespace

QImage halved(const QImage& image, Shrink shrink) {
    if (image.isNull()) return image;
    const auto mean = shrink == Shrink::Lines ? lineLight : meanLevel;
    if (image.format() == QImage::Format_Grayscale8) {
        using Gray = std::uint8_t;
        return halve<Gray>(image, [mean](Gray a, Gray b, Gray c, Gray d) { return static_cast<Gray>(mean(a, b, c, d)); });
    }
    if (image.format() == QImage::Format_Indexed8) { // its colours are opaque, or one is transparent
        const QVector<QRgb> colours = image.colorTable();
        const auto merged = [&](std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
            return channels(colours[a], colours[b], colours[c], colours[d], mean);
        };
        return halve<std::uint8_t, QRgb>(image, merged);
    }
    constexpr QRgb kOpaque = 0xFF000000;
    if (image.format() == QImage::Format_RGB32) // without a converted copy of a large picture
        return halve<QRgb>(image, [mean](QRgb a, QRgb b, QRgb c, QRgb d) { return kOpaque | channels(a, b, c, d, mean); });
    // Premultiplied: no channel is above alpha, before and after.
    const QImage colour = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    return halve<QRgb>(colour, [mean](QRgb a, QRgb b, QRgb c, QRgb d) { return channels(a, b, c, d, mean); });
}

int pyramidLevel(double scale) {
    if (!(scale > 0.0) || scale >= 1.0) return 0;
    // 1e-6: a scale of exactly one half gives level 1 in spite of rounding.
    return static_cast<int>(std::floor(1e-6 - std::log2(scale)));
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
