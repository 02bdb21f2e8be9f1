// Draws a comparison as pictures.
#include "app/lab/reports/comparison_pictures.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/edges/gray/gray.h"
#include "core/edges/rock_borders/rock_borders.h"
#include "core/edges/settings/method_traits.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

constexpr std::size_t kColumns = 4;
constexpr int kTilePixels = 460;
constexpr int kLargePixels = 1100; // approximate width of a tile if there are few
constexpr int kMagnified = 5;      // pixels per cell in pictures that show the shapes of marks

// Okabe and Ito's blue and vermilion, which people with colour blindness can distinguish; dark green differs from both by its brightness.
constexpr Rgb kGreen{0, 95, 45};
constexpr Rgb kBlue{0, 114, 230};
constexpr Rgb kVermilion{226, 70, 0};
constexpr Rgb kPurple{170, 30, 140};

std::vector<exports::SheetMark> classLegend() {
    return {{"edge; jump", kGreen, exports::MarkShape::Square},
            {"convex fold", kBlue, exports::MarkShape::Cross},
            {"concave fold", kVermilion, exports::MarkShape::Ring},
            {"border of the data", kPurple, exports::MarkShape::Cross}};
}

std::vector<exports::SheetMark> truthLegend() {
    return {{"found", kGreen, exports::MarkShape::Square},
            {"missed: a true edge that was not found", kBlue, exports::MarkShape::Ring},
            {"false: an edge that is none", kVermilion, exports::MarkShape::Cross}};
}

constexpr std::size_t kMostOfAName = 60; // longest name that fits on a sheet

std::string shapeOf(const Scan& scan) {
    return printable(scan.name, kMostOfAName) + ": " + std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) + " beams";
}

int columnsOf(std::size_t tiles) { return static_cast<int>(tiles == kColumns ? kColumns / 2 : std::min(kColumns, tiles)); }

// With few tiles, a tile is large enough for a whole number of pixels per cell.
int tilePixels(std::size_t tiles, int beams) {
    if (tiles > kColumns) return kTilePixels;
    return beams * std::max(1, static_cast<int>(std::lround(static_cast<double>(kLargePixels) / beams)));
}

std::string scoreText(const EdgeCounts& all) {
    return "F " + fixedText(all.f(), 3) + ", precision " + fixedText(all.precision(), 3) + ", recall " + fixedText(all.recall(), 3);
}

std::string caption(const ComparedMethod& method) {
    if (!method.wasRun()) return "not run: see the table";
    std::string text = std::to_string(method.edges) + " edge cells, " + fixedText(method.steps.total(), 1) + " ms";
    if (method.share < 1.0) return text + " (not all points done)";
    return method.score ? text + ", F " + fixedText(method.score->score.all.f(), 3) : text;
}

Grid<std::uint8_t> marksOf(const ComparedMethod& method) {
    if (method.classes.size() > 0) return method.classes;
    Grid<std::uint8_t> marks = method.mask;
    for (std::uint8_t& mark : marks.cells) mark = mark != 0 ? 1 : 0;
    return marks;
}

Grid<std::uint8_t> middleOf(const Grid<std::uint8_t>& whole, int lines, int beams) {
    Grid<std::uint8_t> part(std::min(lines, whole.lines), std::min(beams, whole.beams));
    const int firstLine = (whole.lines - part.lines) / 2;
    const int firstBeam = (whole.beams - part.beams) / 2;
    for (int i = 0; i < part.lines; ++i) {
        for (int j = 0; j < part.beams; ++j) part.at(i, j) = whole.at(firstLine + i, firstBeam + j);
    }
    return part;
}

bool isEdgeScanPlus(const ComparedMethod& method) { return method.settings && edges::reads(method.settings->method, edges::kReadsSurface); }

} // namespace

Grid<Rgb> edgesSheet(const Scan& scan, const std::vector<ComparedMethod>& methods) {
    std::vector<exports::SheetTile> tiles{{edges::grayImage(scan, edges::Settings{}).levels, {}, "range image", "logarithmic gray levels"}};
    for (const ComparedMethod& method : methods) tiles.push_back({tiles.front().picture, marksOf(method), method.name, caption(method)});
    exports::SheetLook look{columnsOf(tiles.size()), tilePixels(tiles.size(), scan.beams()), shapeOf(scan), classLegend()};
    const bool border = std::ranges::any_of(methods, [](const ComparedMethod& m) {
        return m.classes.size() > 0 && std::ranges::find(m.classes.cells, std::uint8_t{4}) != m.classes.cells.end();
    });
    if (!border) look.legend.pop_back();
    return exports::contactSheet(tiles, look);
}

Grid<std::uint8_t> truthMarks(const Grid<std::uint8_t>& mask, const sim::EdgeTruth& truth, double tolerance) {
    const EdgeMatches matches = matchWithTruth(mask, truth, tolerance);
    Grid<std::uint8_t> marks(mask.lines, mask.beams);
    Grid<std::uint8_t> matched(mask.lines, mask.beams);
    for (const MatchedPair& pair : matches.all) matched[pair.truth] = 1;
    for (std::size_t k = 0; k < marks.size(); ++k) {
        if (truth.ignore[k] != 0) continue;
        if (matches.thin[k] != 0)
            marks[k] = kMarkFalse; // unless it was matched, see below
        else if (truth.edgeClass[k] != 0 && matched[k] == 0)
            marks[k] = kMarkMissed;
    }
    for (const MatchedPair& pair : matches.all) marks[pair.detected] = truth.ignore[pair.truth] == 0 ? kMarkFound : 0;
    return marks;
}

Grid<Rgb> sceneSheet(const edges::Detection& detection, const sim::EdgeTruth& truth, double tolerance) {
    const Scan& scan = *detection.scan;
    const Grid<std::uint8_t>& gray = detection.gray->levels;
    const std::vector<edges::BorderPercent>& borders = *detection.borders;
    constexpr std::uint8_t kStrong = 4, kWeak = 5, kFold = 6; // after the marks of truthMarks()
    Grid<std::uint8_t> marks(scan.lines(), scan.beams());
    for (std::size_t n = 0; n < detection.edges->size(); ++n) {
        const bool known = n < borders.size() && borders[n] != edges::kUnknownBorder;
        const int percent = known ? borders[n] : 100;
        marks[(*detection.edges)[n]] = percent >= edges::kStrongBorder ? kStrong : percent >= edges::kWeakBorder ? kWeak : kFold;
    }
    std::vector<exports::SheetMark> legend = truthLegend();
    legend.push_back({"likely the border of a rock", kGreen, exports::MarkShape::Square});
    legend.push_back({"perhaps", kPurple, exports::MarkShape::Plus});
    legend.push_back({"a fold within a rock", kVermilion, exports::MarkShape::Slash});
    const EdgeCounts all = scoreMatches(matchWithTruth(*detection.mask, truth, tolerance), truth).all;
    return exports::contactSheet(
        {{gray, truthMarks(*detection.mask, truth, tolerance), "against the truth", scoreText(all)},
         {gray, marks, "border or fold", std::to_string(detection.edges->size()) + " edge cells"}},
        {2, tilePixels(2, scan.beams()), shapeOf(scan) + "; all edges, tolerance " + significantText(tolerance, 3) + " cells", legend});
}

Grid<Rgb> truthSheet(const Scan& scan, const std::vector<ComparedMethod>& methods, const sim::EdgeTruth& truth, double tolerance) {
    const Grid<std::uint8_t> gray = edges::grayImage(scan, edges::Settings{}).levels;
    std::vector<exports::SheetTile> tiles;
    for (const ComparedMethod& method : methods) {
        if (!method.score) continue;
        const bool best = method.best.has_value() && !isEdgeScanPlus(method);
        const EdgeCounts all = (best ? method.best->score : *method.score).score.all;
        std::string threshold = "as set";
        if (best) threshold = "at its best threshold, " + method.best->parameter + " " + significantText(method.best->value, 3);
        tiles.push_back(
            {gray, truthMarks(best ? method.best->mask : method.mask, truth, tolerance), method.name + ", " + threshold, scoreText(all)});
    }
    if (tiles.empty()) return {};
    const std::size_t whole = tiles.size();
    exports::SheetLook look{static_cast<int>(std::min(kColumns, whole)), tilePixels(whole, scan.beams()),
                            shapeOf(scan) + "; all edges, tolerance " + significantText(tolerance, 3) + " cells", truthLegend()};
    if (whole <= kColumns && look.tilePixels < 3 * scan.beams()) {
        const int beams = look.tilePixels / kMagnified;
        for (std::size_t n = 0; n < whole; ++n)
            tiles.push_back({middleOf(gray, beams * scan.lines() / scan.beams(), beams),
                             middleOf(tiles[n].marks, beams * scan.lines() / scan.beams(), beams), "the middle of it, magnified", ""});
    }
    return exports::contactSheet(tiles, look);
}

} // namespace edgescan::lab
