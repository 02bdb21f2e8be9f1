// Draws several pictures on one sheet.
#include "app/lab/reports/titled_tiles.h"

#include "core/scan/grid/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan::exports {
namespace {

constexpr int kGap = 10;
constexpr int kTextHeight = 22;
constexpr double kTextSize = 0.5;
constexpr int kSampleCell = 12; // pixels of a cell in the legend
constexpr int kShapePixels = 3;
constexpr int kTallest = 4;    // times the width of a tile: otherwise a sweep of one beam would give an extremely high sheet
constexpr int kNarrowest = 20; // least width, in pixels, of a picture limited to that height
const cv::Scalar kPaper(40, 40, 40);
const cv::Scalar kInk(235, 235, 235);
const cv::Scalar kFaintInk(190, 190, 190);
// Background of marks: bright enough for three colours, with visible surfaces.
constexpr double kPaleFrom = 165.0;
constexpr double kPaleSpan = 0.33;

cv::Scalar scalarOf(const Rgb& colour) { return {double(colour.red), double(colour.green), double(colour.blue)}; }

int widthOf(const std::string& text) {
    int baseline = 0;
    return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kTextSize, 1, &baseline).width;
}

// Text that is cut off before it reaches its neighbour.
void write(cv::Mat& sheet, std::string text, cv::Point at, int width, const cv::Scalar& ink) {
    while (!text.empty() && widthOf(text) > width) text.pop_back();
    cv::putText(sheet, text, {at.x, at.y + kTextHeight - 7}, cv::FONT_HERSHEY_SIMPLEX, kTextSize, ink, 1, cv::LINE_AA);
}

void drawMark(cv::Mat& sheet, const cv::Rect& cell, const SheetMark& mark) {
    const cv::Scalar colour = scalarOf(mark.colour);
    const MarkShape shape = std::min(cell.width, cell.height) < kShapePixels ? MarkShape::Square : mark.shape;
    const cv::Point last(cell.x + cell.width - 1, cell.y + cell.height - 1);
    const cv::Point middle(cell.x + cell.width / 2, cell.y + cell.height / 2);
    if (shape == MarkShape::Cross || shape == MarkShape::Slash) {
        cv::line(sheet, {last.x, cell.y}, {cell.x, last.y}, colour);
        if (shape == MarkShape::Cross) cv::line(sheet, cell.tl(), last, colour);
    } else if (shape == MarkShape::Plus) {
        cv::line(sheet, {middle.x, cell.y}, {middle.x, last.y}, colour);
        cv::line(sheet, {cell.x, middle.y}, {last.x, middle.y}, colour);
    } else {
        cv::rectangle(sheet, cell, colour, shape == MarkShape::Square ? cv::FILLED : 1);
    }
}

// Draws the kinds of the legend in a row, with line breaks if the sheet is narrow. Returns the height used.
int drawLegend(cv::Mat* sheet, const std::vector<SheetMark>& legend, cv::Point at, int width) {
    const int left = at.x;
    const int top = at.y;
    for (const SheetMark& mark : legend) {
        const int needed = kSampleCell + kGap + widthOf(mark.name) + 3 * kGap;
        if (at.x > left && at.x + needed > left + width) at = {left, at.y + kTextHeight};
        if (sheet != nullptr) {
            drawMark(*sheet, {at.x, at.y + (kTextHeight - kSampleCell) / 2, kSampleCell, kSampleCell}, mark);
            write(*sheet, mark.name, {at.x + kSampleCell + kGap, at.y}, width, kInk);
        }
        at.x += needed;
    }
    return legend.empty() ? 0 : at.y + kTextHeight - top;
}

// Pixels of cell `n` of `count` along `pixels`.
std::pair<int, int> pixelsOf(int n, int count, int pixels) {
    const auto edge = [&](int i) { return static_cast<int>(static_cast<std::int64_t>(i) * pixels / count); };
    return {edge(n), std::max(1, edge(n + 1) - edge(n))};
}

void drawMarks(cv::Mat& sheet, const Grid<std::uint8_t>& marks, const cv::Rect& place, const std::vector<SheetMark>& legend) {
    for (std::size_t kind = 1; kind <= legend.size(); ++kind) {
        for (int i = 0; i < marks.lines; ++i) {
            const auto [y, height] = pixelsOf(i, marks.lines, place.height);
            for (int j = 0; j < marks.beams; ++j) {
                if (marks.at(i, j) != kind) continue;
                const auto [x, width] = pixelsOf(j, marks.beams, place.width);
                drawMark(sheet, {place.x + x, place.y + y, width, height}, legend[kind - 1]);
            }
        }
    }
}

void drawTile(cv::Mat& sheet, const SheetTile& tile, const cv::Rect& place, const std::vector<SheetMark>& legend) {
    const bool smaller = place.width < tile.picture.beams || place.height < tile.picture.lines;
    cv::Mat gray;
    cv::resize(asMat(tile.picture), gray, place.size(), 0, 0, smaller ? cv::INTER_AREA : cv::INTER_NEAREST);
    if (tile.marks.size() > 0) gray.convertTo(gray, CV_8U, kPaleSpan, kPaleFrom);
    cv::Mat onSheet = sheet(place);
    cv::cvtColor(gray, onSheet, cv::COLOR_GRAY2RGB);
    if (tile.marks.lines == tile.picture.lines && tile.marks.beams == tile.picture.beams) drawMarks(sheet, tile.marks, place, legend);
}

// As wide as a tile, unless it would then be too high.
cv::Size sizeOf(const Grid<std::uint8_t>& picture, int tilePixels) {
    const double ratio = static_cast<double>(picture.lines) / picture.beams;
    if (ratio <= kTallest) return {tilePixels, std::max(1, static_cast<int>(std::lround(tilePixels * ratio)))};
    const int height = kTallest * tilePixels;
    return {std::clamp(static_cast<int>(std::lround(height / ratio)), std::min(kNarrowest, tilePixels), tilePixels), height};
}

} // namespace

Grid<Rgb> contactSheet(const std::vector<SheetTile>& tiles, const SheetLook& look) {
    if (tiles.empty() || tiles.front().picture.size() == 0) return {};
    const Grid<std::uint8_t>& first = tiles.front().picture;
    const int count = static_cast<int>(tiles.size());
    const int across = std::clamp(look.columns, 1, count);
    const cv::Size size = sizeOf(first, look.tilePixels);
    const int pitch = size.height + 2 * kTextHeight + kGap;
    const int width = kGap + across * (look.tilePixels + kGap);
    const int top = 2 * kGap + kTextHeight + drawLegend(nullptr, look.legend, {kGap, 0}, width - 2 * kGap);
    cv::Mat sheet(top + (count + across - 1) / across * pitch, width, CV_8UC3, kPaper);
    write(sheet, look.title, {kGap, kGap}, width - 2 * kGap, kInk);
    drawLegend(&sheet, look.legend, {kGap, kGap + kTextHeight}, width - 2 * kGap);
    for (int n = 0; n < count; ++n) {
        const SheetTile& tile = tiles[static_cast<std::size_t>(n)];
        const cv::Point at(kGap + (n % across) * (look.tilePixels + kGap), top + (n / across) * pitch);
        write(sheet, tile.title, at, look.tilePixels, kInk);
        write(sheet, tile.line, {at.x, at.y + kTextHeight}, look.tilePixels, kFaintInk);
        if (tile.picture.size() > 0) drawTile(sheet, tile, {cv::Point(at.x, at.y + 2 * kTextHeight), size}, look.legend);
    }
    Grid<Rgb> pixels(sheet.rows, sheet.cols);
    for (int i = 0; i < sheet.rows; ++i) {
        for (int j = 0; j < sheet.cols; ++j) {
            const auto& pixel = sheet.at<cv::Vec3b>(i, j);
            pixels.at(i, j) = {pixel[0], pixel[1], pixel[2]};
        }
    }
    return pixels;
}

} // namespace edgescan::exports
