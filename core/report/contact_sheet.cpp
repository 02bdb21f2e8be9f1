// Small pictures side by side.
#include "core/report/contact_sheet.h"

#include "core/edges/opencv_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr int kGap = 10;
constexpr int kTextHeight = 18;
constexpr double kTextSize = 0.42;
constexpr std::uint8_t kPaper = 40;
constexpr double kInk = 235;
constexpr double kFaintInk = 170;

// Text that is cut off rather than run into its neighbour.
void write(cv::Mat& sheet, std::string text, int x, int y, int width, double ink) {
    int baseline = 0;
    while (!text.empty() && cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kTextSize, 1, &baseline).width > width) text.pop_back();
    cv::putText(sheet, text, {x, y + kTextHeight - 5}, cv::FONT_HERSHEY_SIMPLEX, kTextSize, cv::Scalar(ink), 1, cv::LINE_AA);
}

// The brightest cell that falls into each pixel: an edge one cell wide must not fade away.
cv::Mat brightest(const cv::Mat& picture, cv::Size size) {
    cv::Mat result(size, CV_8U, cv::Scalar(0));
    for (int i = 0; i < picture.rows; ++i) {
        const int y = std::min(i * size.height / picture.rows, size.height - 1);
        for (int j = 0; j < picture.cols; ++j) {
            std::uint8_t& pixel = result.at<std::uint8_t>(y, std::min(j * size.width / picture.cols, size.width - 1));
            pixel = std::max(pixel, picture.at<std::uint8_t>(i, j));
        }
    }
    return result;
}

cv::Mat scaled(const SheetTile& tile, cv::Size size) {
    const cv::Mat picture = asMat(tile.picture);
    const bool smaller = size.width < picture.cols;
    if (tile.mask && smaller) return brightest(picture, size);
    cv::Mat result;
    cv::resize(picture, result, size, 0, 0, smaller ? cv::INTER_AREA : cv::INTER_NEAREST);
    return result;
}

} // namespace

Grid<std::uint8_t> contactSheet(const std::vector<SheetTile>& tiles, int columns, int tilePixels, const std::string& title) {
    if (tiles.empty() || tiles.front().picture.size() == 0) return {};
    const Grid<std::uint8_t>& first = tiles.front().picture;
    const int count = static_cast<int>(tiles.size());
    const int across = std::clamp(columns, 1, count);
    const int tileHeight = std::max(1, static_cast<int>(std::lround(static_cast<double>(tilePixels) * first.lines / first.beams)));
    const int pitch = tileHeight + 2 * kTextHeight + kGap;
    const int rows = (count + across - 1) / across;
    Grid<std::uint8_t> sheet(kGap + kTextHeight + kGap + rows * pitch, kGap + across * (tilePixels + kGap), kPaper);
    cv::Mat whole = asMat(sheet);
    write(whole, title, kGap, kGap, sheet.beams - 2 * kGap, kInk);
    for (int n = 0; n < count; ++n) {
        const SheetTile& tile = tiles[static_cast<std::size_t>(n)];
        const int x = kGap + (n % across) * (tilePixels + kGap);
        const int y = 2 * kGap + kTextHeight + (n / across) * pitch;
        write(whole, tile.title, x, y, tilePixels, kInk);
        write(whole, tile.line, x, y + kTextHeight, tilePixels, kFaintInk);
        if (tile.picture.size() == 0) continue;
        scaled(tile, {tilePixels, tileHeight}).copyTo(whole(cv::Rect(x, y + 2 * kTextHeight, tilePixels, tileHeight)));
    }
    return sheet;
}

} // namespace edgescan
