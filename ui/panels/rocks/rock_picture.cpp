// Faces and outlines of rocks as pictures.
#include "ui/panels/rocks/rock_picture.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/rocks/selection/region_of_interest.h"
#include "ui/base/shown_text.h"
#include "ui/panels/rocks/rock_colours.h"

#include <QColor>
#include <QObject>

#include <algorithm>
#include <array>

namespace edgescan::ui {
namespace {

constexpr int kFaceAlpha = 165;    // the picture below stays visible
constexpr int kBorderAlpha = 215;  // border between two faces
constexpr int kHatchesAcross = 70; // stripes of a rock with an uncertain outline, per width of the picture ...
constexpr int kNarrowestHatch = 6; // ... minimum width in cells
constexpr double kStripe = 0.4;    // share of a stripe period that is dark

std::uint32_t bytesOf(QRgb c) {
    return static_cast<std::uint32_t>(qRed(c)) | static_cast<std::uint32_t>(qGreen(c)) << 8U | static_cast<std::uint32_t>(qBlue(c)) << 16U |
           0xff000000U;
}

struct Paint {
    QRgb face, point;
};

// Per label: the face, the dark stripe of a hatch, and the border.
struct Paints {
    std::vector<Paint> plain, stripe;
    Paint border{qPremultiply(qRgba(8, 8, 8, kBorderAlpha)), qRgb(24, 24, 24)};
    Paint outside{qPremultiply(qRgba(0, 0, 0, 190)), qRgb(52, 52, 52)}; // outside the region of interest; striped
};

Paints paintsOf(const RockPicture& picture) {
    Paints paints;
    constexpr int gray = kOutsideRocks & 0xffU;
    paints.plain.push_back({qRgba(0, 0, 0, 0), qRgb(gray, gray, gray)});
    paints.plain.resize(picture.study.map.rocks + std::size_t{1}, paints.plain.front());
    paints.stripe = paints.plain;
    for (const rocks::Rock& rock : picture.study.rocks) {
        if (!picture.filter.shows(rock)) continue;
        const QColor colour = rockColour(picture.colours[rock.label]);
        const auto painted = [](const QColor& c) { return Paint{qPremultiply(qRgba(c.red(), c.green(), c.blue(), kFaceAlpha)), c.rgb()}; };
        paints.plain[rock.label] = painted(colour);
        paints.stripe[rock.label] = painted(isDoubtful(rock) ? colour.darker(300) : colour);
    }
    return paints;
}

} // namespace

/// By the size that the table has.
bool RockFilter::shows(const rocks::Rock& rock) const {
    return rounded(rock.shortestCaliperM, 100) >= smallestM && (!sureOnly || !isDoubtful(rock));
}

const rocks::Rock* RockPicture::rockAt(std::size_t cell) const { return rock(labelAt(cell)); }

QString RockPicture::nameOf(std::uint32_t label, const RockNames& names) const {
    QStringList all; // as in the files (RockRows)
    for (const auto& [cell, given] : names) {
        if (labelAt(cell) == label) all << given;
    }
    return all.join("; ");
}

const rocks::Region* RockPicture::regionAt(std::size_t cell) const {
    const Grid<std::uint32_t>& leaf = study.segmentation->segment;
    if (cell >= leaf.size() || leaf[cell] == rocks::kNoSegment) return nullptr;
    const std::uint32_t region = study.map.regionOfSegment[leaf[cell]];
    return region == 0 ? nullptr : &study.map.regions[region];
}

std::shared_ptr<const RockPicture> rockPicture(const std::shared_ptr<const edges::Detection>& detection, rocks::Study study,
                                               const RockFilter& filter) {
    auto picture = std::make_shared<RockPicture>();
    picture->detection = detection;
    picture->study = std::move(study);
    picture->filter = filter;
    picture->labels = rocks::rockLabels(*picture->study.segmentation, picture->study.map);
    picture->colours = rocks::rockColours(picture->study.map);
    const Grid<std::uint32_t>& labels = picture->labels;
    const Paints paints = paintsOf(*picture);
    const int hatch = std::max(kNarrowestHatch, labels.beams / kHatchesAcross);
    const int dark = std::max(1, static_cast<int>(kStripe * hatch));
    auto faces = std::make_shared<QImage>(labels.beams, labels.lines, QImage::Format_ARGB32_Premultiplied);
    auto points = std::make_shared<std::vector<std::uint32_t>>(labels.size());
    const Grid<std::uint8_t> inside = rocks::insideMask(picture->study.settings.region, labels.lines, labels.beams);
    std::size_t k = 0;
    for (int line = 0; line < labels.lines; ++line) {
        auto* pixels = reinterpret_cast<QRgb*>(faces->scanLine(line));
        for (int beam = 0; beam < labels.beams; ++beam, ++k) {
            const std::uint32_t label = labels[k];
            const bool isOutside = inside[k] == 0 && label == 0 && (line - beam + labels.beams) % hatch < dark + dark / 2;
            const Paint& paint = isOutside                                 ? paints.outside
                                 : rocks::isRockBorder(labels, line, beam) ? paints.border
                                 : (line + beam) % hatch < dark            ? paints.stripe[label]
                                                                           : paints.plain[label];
            pixels[beam] = paint.face;
            (*points)[k] = bytesOf(paint.point);
        }
    }
    picture->faces = std::move(faces);
    picture->points = std::move(points);
    return picture;
}

RockOutline outlineOf(const Grid<std::uint32_t>& labels, std::uint32_t label) {
    RockOutline outline;
    if (label == 0) return outline;
    const auto in = [&](int line, int beam) { return labels.contains(line, beam) && labels.at(line, beam) == label; };
    for (int line = 0; line < labels.lines; ++line) {
        for (int beam = 0; beam < labels.beams; ++beam) {
            if (labels.at(line, beam) != label) continue;
            const std::size_t before = outline.sides.size();
            if (!in(line - 1, beam)) outline.sides.emplace_back(beam, line, beam + 1, line);
            if (!in(line + 1, beam)) outline.sides.emplace_back(beam, line + 1, beam + 1, line + 1);
            if (!in(line, beam - 1)) outline.sides.emplace_back(beam, line, beam, line + 1);
            if (!in(line, beam + 1)) outline.sides.emplace_back(beam + 1, line, beam + 1, line + 1);
            if (outline.sides.size() > before) outline.cells.push_back(static_cast<std::uint32_t>(labels.index(line, beam)));
        }
    }
    return outline;
}

QString partsText(const rocks::Rock& rock) {
    if (rock.apart.empty()) return {};
    return QObject::tr("▲ %1 parts that do not touch, %2 m apart").arg(rock.apart.size() + 1).arg(rock.apartM(), 0, 'f', 2);
}

QString rocksText(const std::vector<std::uint32_t>& labels, QString (*one)(std::uint32_t label)) {
    QStringList texts;
    for (const std::uint32_t label : labels) texts << one(label);
    const QString last = texts.takeLast();
    return texts.isEmpty() ? last : QObject::tr("%1 and %2").arg(texts.join(", "), last);
}

QString likelyText(const rocks::Rock& rock) {
    if (rock.maybeOneWith.empty()) return {};
    return QObject::tr("≈ may be one with %1").arg(rocksText(rock.maybeOneWith, [](std::uint32_t label) {
        return QString::number(label);
    }));
}

QString rockTip(const rocks::Rock& rock) {
    QString tip = QObject::tr("%1 · visible a × b: %2 × %3 m ± %4 m · at %5 m")
                      .arg(rock.label)
                      .arg(rock.longestCaliperM, 0, 'f', 2)
                      .arg(rock.shortestCaliperM, 0, 'f', 2)
                      .arg(shownTolerance(rock.toleranceM, 2), 0, 'f', 2)
                      .arg(rock.distanceM, 0, 'f', 2);
    if (isDoubtful(rock)) tip += QObject::tr(" · ▲ uncertain outline");
    if (!rock.apart.empty()) tip += " · " + partsText(rock);
    return tip;
}

QString rockCaveat() { return QObject::tr(rocks::kRockCaveat); }

} // namespace edgescan::ui
