// Makes the images of a detection.
#include "ui/engine/worker_bridge/picture.h"

#include "core/base/bands.h"
#include "core/edges/gray/gray.h"
#include "core/edges/rock_borders/rock_borders.h"
#include "core/scan/gap_filling/gap_filling.h"

#include <QColor>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace edgescan::ui {
namespace {

// Dark violet cannot be mistaken for 0 m or 40 m; the hatch separates it without colour.
constexpr QRgb kStatus = qRgb(70, 20, 50), kStatusHatch = qRgb(120, 40, 80);
constexpr QRgb kLost = qRgb(24, 26, 30); // the views draw dashes over it, which no zoom blurs
constexpr QRgb kFilled = qRgb(20, 66, 58), kFilledHatch = qRgb(60, 160, 140);
constexpr QRgb kToCome = qRgb(30, 30, 30);
constexpr QRgb kEdge = qRgb(255, 255, 255);
constexpr QRgb kRim = qRgb(90, 170, 255); // in the edge map: differs from white edges and from violet missing data
constexpr float kRimPoints = 0.6F;        // size in the cloud, of the other edges
constexpr int kRoomAtFirst = 64;          // lines, if the expected number of lines is unknown

// What a cell without an edge shows: an index into these colours.
struct CellInk {
    enum Index : std::uint8_t { Valid, ToCome, Lost, Status, StatusHatch, Missing, MissingHatch, Filled, FilledHatch, Count };
};
using CellColours = std::array<QRgb, CellInk::Count>;
constexpr CellColours kOnGray{0, kToCome, kLost, kStatus, kStatusHatch, qRgb(40, 20, 60), qRgb(72, 40, 104), kFilled, kFilledHatch};
constexpr CellColours kOnBlack{qRgb(0, 0, 0),      kToCome, kLost,       kStatus, kStatusHatch, qRgb(112, 72, 160), // contrast 3.1
                               qRgb(136, 96, 184), kFilled, kFilledHatch};

CellInk::Index inkOfMissing(CellState state, int line, int beam) {
    if (state == CellState::Lost) return CellInk::Lost;
    const bool stripe = (line + beam) % 4 == 0;
    if (state == CellState::DeviceStatus) return stripe ? CellInk::StatusHatch : CellInk::Status;
    return stripe ? CellInk::MissingHatch : CellInk::Missing;
}

// `pixelOf` returns the pixel of a valid cell, `inks` has those of the others; filled cells have vertical stripes.
template <class Pixel, class Inks, class PixelOf>
void paintCells(QImage& image, const edges::Detection& detection, const Inks& inks, PixelOf pixelOf) {
    const Scan& scan = *detection.scan;
    const auto lineOf = [&](int line) { return reinterpret_cast<Pixel*>(image.scanLine(line)); };
    for (int row = scan.lines(); row < image.height(); ++row)
        std::fill_n(lineOf(row), scan.beams(), static_cast<Pixel>(inks[CellInk::ToCome]));
    std::size_t k = 0;
    for (int line = 0; line < scan.lines(); ++line) {
        Pixel* pixels = lineOf(line);
        for (int beam = 0; beam < scan.beams(); ++beam, ++k) {
            const CellState state = scan.state[k];
            pixels[beam] = state == CellState::Valid ? pixelOf(k) : static_cast<Pixel>(inks[inkOfMissing(state, line, beam)]);
        }
    }
    if (!detection.filled) return;
    const auto beams = static_cast<std::size_t>(scan.beams());
    for (const FilledCell& filled : detection.filled->cells) {
        const std::size_t beam = filled.cell % beams;
        lineOf(static_cast<int>(filled.cell / beams))[beam] =
            static_cast<Pixel>(inks[beam % 2 == 0 ? CellInk::FilledHatch : CellInk::Filled]);
    }
}

using InkByClass = std::array<QRgb, kEdgeClasses + 1>; // by DepthEdge

InkByClass inkOf(const EdgeColours& colours, QRgb none) {
    InkByClass ink{none};
    for (std::size_t n = 0; n < colours.size(); ++n) ink[n + 1] = colours[n].rgba();
    return ink;
}

// How a cell of an edge is drawn: by its strength, or as a gap of a dashed or dotted line. Colour is not the only sign.
struct Look {
    enum Index : std::uint8_t { Strong = kStrongEdge, Weak = kWeakEdge, Thin = kThinEdge, RimGap, ThinGap, Count };
};

int brightnessOf(std::uint8_t look, bool byClass) {
    if (look == Look::RimGap) return 50;
    if (byClass) return 100;
    return look == Look::ThinGap ? 25 : kStrengthPercent[look];
}

// The colours of a picture with a byte per cell: look by look those of the classes follow. By class, all strengths look alike.
QVector<QRgb> withEdges(QVector<QRgb> table, const InkByClass& ink, bool byClass) {
    for (std::uint8_t look = 0; look < Look::Count; ++look) {
        for (const QRgb colour : ink) table << dimmedTo(colour, brightnessOf(look, byClass)).rgb();
    }
    return table;
}

using Strengths = std::vector<std::uint8_t>; // EdgeStrength of each edge; empty: all are strong

EdgeStrength strengthOf(edges::BorderPercent percent) {
    return percent >= edges::kStrongBorder ? kStrongEdge : percent >= edges::kWeakBorder ? kWeakEdge : kThinEdge; // unknown: 255
}

Strengths strengthsOf(const edges::Detection& detection) {
    Strengths strengths;
    for (const edges::BorderPercent percent : *detection.borders) strengths.push_back(strengthOf(percent));
    return strengths;
}

Strengths strengthsOf(const edges::Detection& detection, const PictureSource& source, const KnownBorders& known) {
    if (!detection.borders) return {};
    if (detection.borders.isMade()) return strengthsOf(detection);
    const bool same = known.edges && known.source.stream == source.stream && known.source.growth.sweep == source.growth.sweep &&
                      known.beams == detection.scan->beams();
    if (!same) return {};
    Strengths strengths(detection.edges->size(), kStrongEdge);
    std::size_t at = 0;
    for (std::size_t n = 0; n < strengths.size(); ++n) {
        while (at < known.edges->size() && (*known.edges)[at] < (*detection.edges)[n]) ++at;
        if (at < known.edges->size() && (*known.edges)[at] == (*detection.edges)[n]) strengths[n] = strengthOf((*known.percents)[at]);
    }
    return strengths;
}

// Paints the pixels of the edge cells with the colours that withEdges() added. Rims of open voids are dashed and folds dotted, in every
// direction.
void paintEdges(QImage& image, const edges::Detection& detection, const Strengths& strengths) {
    constexpr std::size_t kInks = std::tuple_size_v<InkByClass>;
    const std::size_t others = static_cast<std::size_t>(image.colorCount()) - Look::Count * kInks;
    constexpr auto kVoidRim = static_cast<std::size_t>(edges::DepthEdge::VoidRim);
    const auto beams = static_cast<std::size_t>(detection.scan->beams());
    for (std::size_t n = 0; n < detection.edges->size(); ++n) {
        const std::uint32_t k = (*detection.edges)[n];
        const std::size_t line = k / beams, beam = k % beams, at = line + 2 * beam;
        const std::size_t kind = detection.classes ? static_cast<std::size_t>((*detection.classes)[k]) : 0;
        std::size_t look = strengths.empty() ? std::size_t{Look::Strong} : strengths[n];
        if (kind == kVoidRim && at % 6 >= 3) look = Look::RimGap;
        if (look == Look::Thin && at % 4 >= 2) look = Look::ThinGap;
        image.scanLine(static_cast<int>(line))[beam] = static_cast<std::uint8_t>(others + look * kInks + kind);
    }
}

EdgeCells borderCellsOf(const edges::Detection& detection, const Strengths& strengths) {
    if (std::ranges::all_of(strengths, [](std::uint8_t strength) { return strength == kStrongEdge; })) return {};
    std::array<std::vector<std::uint32_t>, kEdgeClasses> lists;
    for (std::size_t n = 0; n < strengths.size(); ++n) {
        const std::uint32_t k = (*detection.edges)[n];
        lists[(*detection.classes)[k] == edges::DepthEdge::VoidRim ? kRimClass : strengths[n]].push_back(k);
    }
    EdgeCells cells{detection.edges, {}};
    for (std::size_t n = 0; n < lists.size(); ++n)
        cells.byClass[n] = std::make_shared<const std::vector<std::uint32_t>>(std::move(lists[n]));
    std::ranges::copy(kStrengthSizes, cells.sizes.begin());
    cells.sizes[kRimClass] = kRimPoints;
    return cells;
}

EdgeCells edgeCellsOf(const edges::Detection& detection) {
    EdgeCells cells{detection.edges, {}};
    if (!detection.classes) return cells;
    std::array<std::vector<std::uint32_t>, kEdgeClasses> lists;
    for (const std::uint32_t k : *detection.edges) {
        const edges::DepthEdge kind = (*detection.classes)[k];
        if (kind != edges::DepthEdge::None) lists[static_cast<std::size_t>(kind) - 1].push_back(k);
    }
    for (std::size_t n = 0; n < lists.size(); ++n)
        cells.byClass[n] = std::make_shared<const std::vector<std::uint32_t>>(std::move(lists[n]));
    cells.sizes[kRimClass] = kRimPoints;
    return cells;
}

QImage edgeMap(const edges::Detection& detection, const Strengths& strengths, int rows) {
    QImage image(detection.scan->beams(), rows, QImage::Format_Indexed8);
    InkByClass ink;
    ink.fill(kEdge);
    ink[kRimClass + 1] = kRim;
    image.setColorTable(withEdges({kOnBlack.begin(), kOnBlack.end()}, ink, false));
    std::array<std::uint8_t, CellInk::Count> inks{};
    std::iota(inks.begin(), inks.end(), std::uint8_t{0});
    paintCells<std::uint8_t>(image, detection, inks, [](std::size_t) { return std::uint8_t{CellInk::Valid}; });
    paintEdges(image, detection, strengths); // last: without masking they can also be on cells without a range
    return image;
}

QImage overlayOf(const edges::Detection& detection, const Strengths& strengths, int rows) {
    QImage image(detection.scan->beams(), rows, QImage::Format_Indexed8);
    image.setColorTable(withEdges({qRgba(0, 0, 0, 0)}, inkOf(drawnColours(kUsualColours, false), kUsualColours.front().rgba()), false));
    image.fill(0);
    paintEdges(image, detection, strengths);
    return image;
}

std::shared_ptr<const QImage> drawn(QImage image) { return std::make_shared<const QImage>(std::move(image)); }

} // namespace

std::string scanKey(const Picture* picture) {
    if (picture == nullptr) return {};
    const Scan& scan = *picture->detection->scan;
    if (scan.sha256.empty() || picture->source.growth.sweep >= 0) return std::to_string(picture->source.stream);
    return scan.sha256 + ' ' + std::to_string(scan.lines()) + ' ' + std::to_string(scan.beams()) + ' ' + scan.name;
}

int shownLines(const Scan& scan, const Growth& growth) {
    if (growth.expectedLines > 0) return std::max(growth.expectedLines, scan.lines());
    if (!growth.growing) return scan.lines();
    int room = kRoomAtFirst;
    while (room < scan.lines()) room *= 2;
    return room;
}

QImage grayPicture(const edges::Detection& detection, const std::optional<RangeSpan>& span, int rows) {
    const Scan& scan = *detection.scan;
    const auto ink = [](int level) { return qRgb(level, level, level); };
    QImage image(scan.beams(), rows, QImage::Format_RGB32);
    if (span) {
        const double nearMm = 1000.0 * span->nearM, perMm = 255.0 / std::max(1e-6, 1000.0 * (span->farM - span->nearM));
        paintCells<QRgb>(image, detection, kOnGray, [&](std::size_t k) {
            return ink(static_cast<int>(std::clamp((static_cast<double>(scan.rangeMm[k]) - nearMm) * perMm, 0.0, 255.0)));
        });
    } else {
        paintCells<QRgb>(image, detection, kOnGray, [&](std::size_t k) { return ink(detection.gray->levels[k]); });
    }
    return image;
}

QImage classPicture(const Picture& picture, const EdgeColours& colours) {
    QImage image = *picture.edges;
    if (picture.detection->classes) image.setColorTable(withEdges(image.colorTable().mid(0, CellInk::Count), inkOf(colours, kEdge), true));
    return image;
}

QImage edgeOverlay(const Picture& picture, const EdgeColours& colours, bool byClass) {
    QImage image = *picture.overlay;
    image.setColorTable(withEdges({qRgba(0, 0, 0, 0)}, inkOf(drawnColours(colours, byClass), colours.front().rgba()), byClass));
    return image;
}

std::vector<QRect> lostAreas(const Scan& scan) {
    constexpr std::size_t kMostAreas = 4000;
    std::vector<QRect> areas;
    std::size_t lastRow = 0; // the areas of the line before begin here
    for (int line = 0; line < scan.lines() && areas.size() < kMostAreas; ++line) {
        const std::size_t row = areas.size();
        const CellState* states = &scan.state.cells[scan.state.index(line, 0)];
        for (int beam = 0; beam < scan.beams(); ++beam) {
            if (states[beam] != CellState::Lost) continue;
            const int first = beam;
            while (beam < scan.beams() && states[beam] == CellState::Lost) ++beam;
            areas.emplace_back(first, line, beam - first, 1);
        }
        // The same cells as in the line before: one area.
        const bool alike =
            row > lastRow && areas.size() - row == row - lastRow &&
            std::equal(areas.begin() + static_cast<std::ptrdiff_t>(row), areas.end(), areas.begin() + static_cast<std::ptrdiff_t>(lastRow),
                       [line](const QRect& now, const QRect& before) {
                           return now.left() == before.left() && now.right() == before.right() && before.bottom() + 1 == line;
                       });
        if (!alike) {
            lastRow = row;
            continue;
        }
        for (std::size_t n = lastRow; n < row; ++n) areas[n].setBottom(line);
        areas.resize(row);
    }
    return areas;
}

QRect linesToCome(const Picture& picture) {
    const int lines = picture.detection->scan->lines();
    return {0, lines, picture.gray->width(), picture.gray->height() - lines};
}

std::shared_ptr<const Picture> makePicture(const std::shared_ptr<const edges::Detection>& detection, const PictureSource& source,
                                           const edges::Settings& asked, const std::shared_ptr<const CloudGeometry>& cloud,
                                           const std::shared_ptr<const Picture>& last, const KnownBorders& known) {
    auto picture = std::make_shared<Picture>();
    picture->source = source;
    picture->asked = asked;
    picture->detection = detection;
    picture->cloud = cloud;
    const int rows = shownLines(*detection->scan, source.growth);
    const bool grayHolds = last && last->detection->gray == detection->gray && last->detection->filled == detection->filled &&
                           last->detection->scan == detection->scan && last->gray->height() == rows;
    const Strengths strengths = strengthsOf(*detection, source, known);
    runParts(bandsFor(detection->scan->cells(), 0),
             {[&] { picture->edges = drawn(edgeMap(*detection, strengths, rows)); },
              [&] { picture->overlay = drawn(overlayOf(*detection, strengths, rows)); },
              [&] { picture->gray = grayHolds ? last->gray : drawn(grayPicture(*detection, std::nullopt, rows)); },
              [&] {
                  picture->edgeCells = edgeCellsOf(*detection);
                  picture->borderCells = borderCellsOf(*detection, strengths);
                  picture->lost = lostAreas(*detection->scan);
              }});
    return picture;
}

KnownBorders knownBordersOf(const Picture& picture) {
    const edges::Detection& detection = *picture.detection;
    return {picture.source, detection.scan->beams(), detection.edges, detection.borders};
}

std::shared_ptr<const Picture> withBorders(const std::shared_ptr<const Picture>& picture) {
    const edges::Detection& detection = *picture->detection;
    if (!detection.borders) return picture;
    const Strengths strengths = strengthsOf(detection);
    auto made = std::make_shared<Picture>(*picture);
    for (std::shared_ptr<const QImage>* image : {&made->edges, &made->overlay}) {
        QImage painted = **image;
        paintEdges(painted, detection, strengths);
        *image = drawn(std::move(painted));
    }
    made->borderCells = borderCellsOf(detection, strengths);
    return made;
}

} // namespace edgescan::ui
