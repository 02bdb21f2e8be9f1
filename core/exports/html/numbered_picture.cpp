// Places numbers over a picture, the important ones first.
#include "core/exports/html/numbered_picture.h"

#include "core/base/number_text.h"
#include "core/exports/html/html.h"

#include <algorithm>
#include <cmath>

namespace edgescan::exports {
namespace {

constexpr double kPartOfSide = 1.0 / 58;        // height of a number, as part of the longer side of the picture
constexpr double kDigitWidth = 0.62;            // of the height
constexpr double kLineWidth = 0.2, kDot = 0.25; // of the height

struct Box {
    double x, y, halfWidth, halfHeight;
    [[nodiscard]] bool covers(const Box& other) const {
        return std::abs(x - other.x) < halfWidth + other.halfWidth && std::abs(y - other.y) < halfHeight + other.halfHeight;
    }
};

} // namespace

std::string pictureNumbers(int width, int height, const std::vector<PictureNumber>& numbers, std::size_t& leftOut,
                           const std::vector<PictureLine>& lines) {
    const double unit = std::max(width, height) * kPartOfSide;
    std::string html = "<svg class=\"numbers\" style=\"--unit:" + fixedText(unit, 2) + "px\" viewBox=\"0 0 " + std::to_string(width) + " " +
                       std::to_string(height) + "\" aria-hidden=\"true\">\n";
    for (const PictureLine& line : lines)
        html += "<line x1=\"" + fixedText(line.fromX, 1) + "\" y1=\"" + fixedText(line.fromY, 1) + "\" x2=\"" + fixedText(line.toX, 1) +
                "\" y2=\"" + fixedText(line.toY, 1) + "\" stroke=\"#78beff\" stroke-width=\"" + fixedText(kLineWidth * unit, 2) + "\"/>\n";
    std::vector<Box> placed;
    leftOut = 0;
    for (const PictureNumber& each : numbers) {
        const double y = each.dot ? each.y - unit : each.y;
        const Box box{each.x, y, 0.5 * kDigitWidth * unit * static_cast<double>(each.text.size()), 0.5 * unit};
        if (!each.always && std::ranges::any_of(placed, [&](const Box& other) { return other.covers(box); })) {
            ++leftOut;
            continue;
        }
        placed.push_back(box);
        if (each.dot)
            html += "<circle cx=\"" + fixedText(each.x, 1) + "\" cy=\"" + fixedText(each.y, 1) + "\" r=\"" + fixedText(kDot * unit, 2) +
                    "\" fill=\"#fff\"/>\n";
        html += "<text x=\"" + fixedText(each.x, 1) + "\" y=\"" + fixedText(y, 1) + "\"" + (each.always ? "" : " class=\"small\"") + ">" +
                htmlText(each.text) + "</text>\n";
    }
    return html + "</svg>\n";
}

std::string numberedFigure(const std::string& png, const char* alternative, const std::string& numbers, const std::string& caption) {
    return "<figure class=\"picture\"><div class=\"numbered\">" + htmlImage(png, alternative) + numbers + "</div><figcaption>" + caption +
           "</figcaption></figure>\n";
}

} // namespace edgescan::exports
