// Lists and images by confidence band.
#include "ui/panels/confidence/confidence_picture.h"

#include <vector>

namespace edgescan::ui {
namespace {

constexpr std::array<float, kEdgeClasses> kSizes{1.3F, 1.1F, 0.85F, 0.65F, 0.5F}; // relative to the size of an edge point
constexpr std::size_t kFirstDashed = 3;                                           // band; below 70 %

/// In the images all cells have one size; therefore less certain edges are dashed: every third cell is dark, then every second.
QRgb inkAt(const QColor& colour, std::size_t band, int line, int beam) {
    if (band < kFirstDashed) return colour.rgba();
    const int period = band == kFirstDashed ? 3 : 2;
    return (line + beam) % period == 0 ? colour.darker(250).rgba() : colour.rgba();
}

} // namespace

const EdgeColours& bandColours(bool colourBlind) {
    static const EdgeColours usual{QColor(0, 255, 0),     QColor(200, 255, 90),  QColor(240, 228, 66),
                                   QColor(255, 215, 160), QColor(255, 204, 212), QColor(255, 204, 212)};
    static const EdgeColours withoutRedAndGreen{QColor(240, 228, 66),  QColor(250, 242, 170), QColor(255, 255, 255),
                                                QColor(215, 235, 255), QColor(170, 226, 255), QColor(170, 226, 255)};
    return colourBlind ? withoutRedAndGreen : usual;
}

std::shared_ptr<const ConfidencePicture> confidencePicture(const std::shared_ptr<const Picture>& picture,
                                                           const std::shared_ptr<const edges::EdgeConfidence>& confidence, int leastPercent,
                                                           const EdgeColours& colours) {
    auto made = std::make_shared<ConfidencePicture>();
    made->of = picture;
    made->confidence = confidence;
    made->leastPercent = leastPercent;
    QImage map = picture->edges->convertToFormat(QImage::Format_RGB32);
    QImage overlay(map.size(), QImage::Format_ARGB32_Premultiplied);
    overlay.fill(Qt::transparent);
    std::vector<std::uint32_t> all;
    std::array<std::vector<std::uint32_t>, kEdgeClasses> lists;
    const Grid<std::uint8_t>& percent = confidence->percent;
    const auto pixel = [](QImage& image, int line, int beam) -> QRgb& { return reinterpret_cast<QRgb*>(image.scanLine(line))[beam]; };
    for (const std::uint32_t k : *picture->detection->edges) {
        const std::size_t band = edges::confidenceBand(percent[k]);
        ++made->counts[band];
        const int line = static_cast<int>(k) / percent.beams, beam = static_cast<int>(k) % percent.beams;
        if (percent[k] < leastPercent) {
            pixel(map, line, beam) = qRgb(0, 0, 0);
            continue;
        }
        pixel(map, line, beam) = pixel(overlay, line, beam) = inkAt(colours[band], band, line, beam);
        lists[band].push_back(k);
        all.push_back(k);
    }
    made->cells.all = std::make_shared<const std::vector<std::uint32_t>>(std::move(all));
    for (std::size_t n = 0; n < lists.size(); ++n)
        made->cells.byClass[n] = std::make_shared<const std::vector<std::uint32_t>>(std::move(lists[n]));
    made->cells.sizes = kSizes;
    made->images = {std::make_shared<const QImage>(std::move(map)), std::make_shared<const QImage>(std::move(overlay))};
    return made;
}

} // namespace edgescan::ui
