// Draws shares upwards over widths to the right.
#include "core/exports/html/size_drawing.h"

#include "core/base/number_text.h"
#include "core/exports/html/html.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::exports {
namespace {

constexpr int kWidth = 700, kHeight = 280;                       // in units of the drawing
constexpr int kLeft = 88, kRight = 150, kTop = 30, kBottom = 52; // on the right: room for a label

std::string number(double value) { return fixedText(value, 1); }
std::string metresOf(double m) { return fixedText(m, 2) + " m"; }

class Drawing {
public:
    explicit Drawing(const rocks::SizeCurve& curve)
        : curve_(curve), rightM_(std::max(0.5, std::ceil(2 * 1.02 * std::max(curve.topM, curve.oversizeM)) / 2)) {}

    [[nodiscard]] std::string svg() const {
        return "<svg id=\"sizes\" class=\"picture\" viewBox=\"0 0 " + std::to_string(kWidth) + " " + std::to_string(kHeight) +
               "\" role=\"img\" aria-label=\"Size curve of the visible rocks: share of the rocks over their visible width b\">\n" + axes() +
               oversize() + path() + marks() + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double wideM) const { return kLeft + wideM / rightM_ * (kWidth - kLeft - kRight); }
    [[nodiscard]] static double y(double share) { return kHeight - kBottom - share * (kHeight - kTop - kBottom); }
    static std::string line(double x1, double y1, double x2, double y2, const std::string& look) {
        return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\" " + look +
               "/>\n";
    }
    static std::string text(double x, double y, const char* anchor, const std::string& words, const std::string& turn = {}) {
        return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"13\" text-anchor=\"" + anchor + "\"" + turn + ">" +
               htmlText(words) + "</text>\n";
    }

    [[nodiscard]] std::string axes() const {
        std::string html;
        for (const int percent : {0, 20, 40, 60, 80, 100}) {
            const double at = y(percent / 100.0);
            html += line(x(0), at, x(rightM_), at, "stroke=\"#d5d9dc\"") + text(x(0) - 6, at + 4, "end", std::to_string(percent) + " %");
        }
        const double step = rightM_ > 6 ? 2 : rightM_ > 3 ? 1 : 0.5;
        for (int n = 0; n * step <= rightM_; ++n)
            html += line(x(n * step), y(0), x(n * step), y(0) + 5, "stroke=\"#5b6268\"") +
                    text(x(n * step), y(0) + 19, "middle", fixedText(n * step, 1));
        const double middle = (y(0) + y(1)) / 2;
        return html + text((x(0) + x(rightM_)) / 2, kHeight - 8, "middle", "visible width b [m]") +
               text(16, middle, "middle", "rocks that are not wider", " transform=\"rotate(-90 16 " + number(middle) + ")\"");
    }

    [[nodiscard]] std::string path() const {
        std::string d = "M" + number(x(0)) + " " + number(y(0));
        const auto count = static_cast<double>(curve_.rocks());
        for (std::size_t n = 0; n < curve_.rocks(); ++n)
            d += " H" + number(x(curve_.widthsM[n])) + " V" + number(y(static_cast<double>(n + 1) / count));
        return "<path d=\"" + d + " H" + number(x(rightM_)) + "\" fill=\"none\" stroke=\"#1c1f22\" stroke-width=\"1.6\"/>\n";
    }

    // The labels are below one another, at the heights of their shares.
    [[nodiscard]] std::string marks() const {
        struct Mark {
            const char* name;
            double wideM, share;
        };
        std::string html;
        for (const auto& [name, wideM, share] : {Mark{"P20", curve_.p20M, 0.2}, Mark{"P50", curve_.p50M, 0.5},
                                                 Mark{"P80", curve_.p80M, 0.8}, Mark{"largest", curve_.topM, 1.0}}) {
            html += line(x(wideM), y(share), x(wideM), y(0), "stroke=\"#9a4a12\" stroke-dasharray=\"2 3\"");
            html += "<circle cx=\"" + number(x(wideM)) + "\" cy=\"" + number(y(share)) + "\" r=\"3.5\" fill=\"#9a4a12\"/>\n";
            html += text(x(wideM) + 7, y(share) + 16, "start", std::string(name) + " " + metresOf(wideM));
        }
        return html;
    }

    // Its label is above the curve, where there is no other.
    [[nodiscard]] std::string oversize() const {
        if (curve_.oversizeM <= 0) return {};
        const double at = x(curve_.oversizeM);
        const char* anchor = at < kWidth / 3.0 ? "start" : at > 2 * kWidth / 3.0 ? "end" : "middle";
        return line(at, y(1) - 8, at, y(0), "stroke=\"#1c1f22\" stroke-dasharray=\"7 4\"") +
               text(at, y(1) - 13, anchor, fixedText(100 * curve_.oversizeShare, 0) + " % over " + metresOf(curve_.oversizeM));
    }

    const rocks::SizeCurve& curve_;
    double rightM_;
};

} // namespace

std::string sizeDrawing(const rocks::SizeCurve& curve) { return Drawing(curve).svg(); }

} // namespace edgescan::exports
