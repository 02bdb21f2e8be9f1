// Icons as paths on a grid of 24 x 24.
#include "ui/base/icons.h"

#include "ui/base/themes.h"

#include <QIconEngine>
#include <QPainter>
#include <QString>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>

namespace edgescan::ui {
namespace {

struct Sign {
    const char* name;
    const char* path;
};

// Drawn for the project.
constexpr Sign kSigns[] = {
    {"alone", "M3.5 9V3.5H9M15 3.5h5.5V9M20.5 15v5.5H15M9 20.5H3.5V15"},
    {"ab", "M2.5 18L6 6l3.5 12M3.7 14h4.6M12 3v18M15.5 12V6h2.5a3 3 0 0 1 0 6h-2.5M15.5 12v6h3a3 3 0 0 0 0-6"},
    {"cab-mode", "M3 12a9 9 0 1 0 18 0a9 9 0 1 0 -18 0zM9.5 12a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0zM3.2 10.5h6.6M14.2 10.5h6.6"
                 "M12 14.5V21"},
    {"connect", "M9 16h6a1 1 0 0 1 1 1v3a1 1 0 0 1 -1 1h-6a1 1 0 0 1 -1 -1v-3a1 1 0 0 1 1 -1zM8 12.5a5.7 5.7 0 0 1 8 0"
                "M5 9.2a10 10 0 0 1 14 0M2.5 5.7a14 14 0 0 1 19 0"},
    {"demo", "M4 3.5l4 9v8M20 3.5l-4 9v8M9.5 8.5l2.5-2.5 3 2.5-1 3.5h-3.5z"},
    {"export", "M4 14v6h16v-6M12 15.5V3.5M7.5 8L12 3.5 16.5 8"},
    {"fit", "M3.5 8V3.5H8M16 3.5h4.5V8M8 20.5H3.5V16M20.5 16v4.5H16M8 14.5l1-5 4-1.5 3.5 3.5-1 4z"},
    {"fold", "M5.5 5.5L12 12l-6.5 6.5M12.5 5.5L19 12l-6.5 6.5"},
    {"hold", "M8 4.5v15M16 4.5v15"},
    {"images", "M4 3.5h16a1 1 0 0 1 1 1v15a1 1 0 0 1 -1 1h-16a1 1 0 0 1 -1 -1v-15a1 1 0 0 1 1 -1zM3 16l5-6 4 5 3-3 6 6"},
    {"layers", "M12 3.5l9 4.5-9 4.5-9-4.5zM3 12l9 4.5 9-4.5M3 16l9 4.5 9-4.5"},
    {"lock", "M6.5 11h11a1.5 1.5 0 0 1 1.5 1.5v6.5a1.5 1.5 0 0 1 -1.5 1.5h-11a1.5 1.5 0 0 1 -1.5 -1.5v-6.5a1.5 1.5 0 0 1 1.5"
             " -1.5zM8 11V8a4 4 0 0 1 8 0v3"},
    {"measure", "M2.8 16.2L16.2 2.8l5 5L7.8 21.2zM6.5 12.5l2 2M9.5 9.5l3 3M12.5 6.5l2 2"},
    {"menu", "M4 6.5h16M4 12h16M4 17.5h16"},
    {"next", "M9 4.5l7.5 7.5L9 19.5"},
    {"open", "M3 18.5V6a1 1 0 0 1 1-1h5l2 3h9a1 1 0 0 1 1 1v9.5a1 1 0 0 1-1 1H4a1 1 0 0 1-1-1zM3 12h18"},
    {"panel", "M4 4h16a1 1 0 0 1 1 1v14a1 1 0 0 1 -1 1h-16a1 1 0 0 1 -1 -1v-14a1 1 0 0 1 1 -1zM15 4v16"},
    {"pin", "M12 21.5c0 0 6.5-6.3 6.5-11.5a6.5 6.5 0 0 0-13 0c0 5.2 6.5 11.5 6.5 11.5z"
            "M9.8 10a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0 -4.4 0z"},
    {"play", "M7 4.5l12 7.5-12 7.5z"},
    {"previous", "M15 4.5L7.5 12l7.5 7.5"},
    {"record", "M3 12a9 9 0 1 0 18 0a9 9 0 1 0 -18 0zM8 12a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z"},
    {"redo", "M15.5 4.5L20 9l-4.5 4.5M20 9H9.5a5.5 5.5 0 0 0 0 11H15"},
    {"remove", "M4.5 6.5h15M9 6.5V3.5h6v3M6.5 6.5l1 14h9l1-14M10 10.5v6M14 10.5v6"},
    {"report", "M5.5 3h9l4 4v14h-13zM14.5 3v4h4M8.5 17v-3M12 17v-6M15.5 17v-4"},
    {"rock", "M3.5 16.5l2-8 6.5-4.5 6.5 3.5 2 8.5-6 4-7.5-.5zM5.5 8.5l6.5 4 6.5-5M12 12.5l2.5 7.5"},
    {"rocks", "M2.5 19.5l1.5-6.5 5-2.5 4.5 3 .5 6zM9 10.5l1-6 6-1.5 5 4.5.5 7-7.5 1.5M10 4.5l5.5 4.5 6 5.5M14 19.5h7.5"},
    {"select", "M3.5 8V3.5H8M16 3.5h4.5V8M8 20.5H3.5V16M12 11l9 3.5-4 1.7-1.7 4z"},
    {"session", "M4 4h12l4 4v12H4zM8 4v5h7V4M8 20v-6h8v6"},
    {"table", "M4 4.5h16a1 1 0 0 1 1 1v13a1 1 0 0 1 -1 1h-16a1 1 0 0 1 -1 -1v-13a1 1 0 0 1 1 -1zM3 9.5h18M3 14.5h18M9 9.5v10"},
    {"tune", "M4 7h9M17 7h3M13 7a2 2 0 1 0 4 0a2 2 0 1 0 -4 0zM4 16.5h3M11 16.5h9M7 16.5a2 2 0 1 0 4 0a2 2 0 1 0 -4 0z"},
    {"undo", "M8.5 4.5L4 9l4.5 4.5M4 9h10.5a5.5 5.5 0 0 1 0 11H9"},
    {"usual", "M5 12a7 7 0 1 0 2.3-5.2M7 2.5v4.8h4.8"},
    {"view-from-scanner", "M10 18L2.5 7c6-4.6 13-4.6 19 0L14 18M9.5 19a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0zM12 13V9"
                          "M9.8 10.8L12 8.5l2.2 2.3"},
    {"why", "M5 3h14a2 2 0 0 1 2 2v14a2 2 0 0 1 -2 2h-14a2 2 0 0 1 -2 -2v-14a2 2 0 0 1 2 -2z"
            "M9.3 9.5a2.7 2.7 0 1 1 4 2.4c-.9.5-1.3 1.1-1.3 2.1M12 17.3v.2"},
};

constexpr double kGrid = 24.0;
constexpr double kStroke = 1.75;

/// Converts an arc from end points to centre and angles as in the SVG specification (appendix B.2.4). The ellipse is not rotated.
void addArc(QPainterPath& path, double rx, double ry, bool large, bool clockwise, QPointF to) {
    const QPointF from = path.currentPosition();
    const QPointF half = (from - to) / 2.0;
    if (half.isNull()) return;
    const double tooSmall = std::hypot(half.x() / rx, half.y() / ry);
    if (tooSmall > 1.0) {
        rx *= tooSmall;
        ry *= tooSmall;
    }
    const double a = half.x() * half.x() * ry * ry + half.y() * half.y() * rx * rx;
    const double k = std::sqrt(std::max(0.0, rx * rx * ry * ry / a - 1.0)) * (large == clockwise ? -1.0 : 1.0);
    const QPointF centre = (from + to) / 2.0 + QPointF(k * rx * half.y() / ry, -k * ry * half.x() / rx);
    const auto angle = [&](QPointF at) { return std::atan2((at.y() - centre.y()) / ry, (at.x() - centre.x()) / rx); };
    double sweep = angle(to) - angle(from);
    if (clockwise && sweep < 0) sweep += 2.0 * std::numbers::pi;
    if (!clockwise && sweep > 0) sweep -= 2.0 * std::numbers::pi;
    const double degrees = 180.0 / std::numbers::pi;
    path.arcTo(QRectF(centre.x() - rx, centre.y() - ry, 2 * rx, 2 * ry), -angle(from) * degrees, -sweep * degrees);
}

// ASCII only: <cctype> depends on the locale.
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
constexpr bool isLetter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

int numbersOf(char command) {
    switch (upper(command)) {
    case 'M':
    case 'L':
        return 2;
    case 'H':
    case 'V':
        return 1;
    case 'C':
        return 6;
    case 'A':
        return 7;
    default:
        return 0;
    }
}

void add(QPainterPath& path, char command, const std::array<double, 7>& n) {
    const QPointF at = path.currentPosition();
    const QPointF base = upper(command) != command ? at : QPointF();
    switch (upper(command)) {
    case 'M':
        return path.moveTo(base + QPointF(n[0], n[1]));
    case 'L':
        return path.lineTo(base + QPointF(n[0], n[1]));
    case 'H':
        return path.lineTo(base.x() + n[0], at.y());
    case 'V':
        return path.lineTo(at.x(), base.y() + n[0]);
    case 'C':
        return path.cubicTo(base + QPointF(n[0], n[1]), base + QPointF(n[2], n[3]), base + QPointF(n[4], n[5]));
    default:
        return addArc(path, n[0], n[1], n[3] != 0.0, n[4] != 0.0, base + QPointF(n[5], n[6]));
    }
}

class SignEngine : public QIconEngine {
public:
    explicit SignEngine(QPainterPath path) : path_(std::move(path)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const Theme& theme = themeInUse();
        const QColor ink = mode == QIcon::Disabled ? theme.unusable : state == QIcon::On ? QColor(Qt::white) : theme.text;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const double scale = std::min(rect.width(), rect.height()) / kGrid;
        painter->translate(QRectF(rect).center());
        painter->scale(scale, scale);
        painter->translate(-kGrid / 2, -kGrid / 2);
        painter->strokePath(path_, QPen(ink, kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap made(size);
        made.fill(Qt::transparent);
        QPainter painter(&made);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return made;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new SignEngine(path_); }

private:
    QPainterPath path_;
};

} // namespace

QPainterPath pathOf(const char* words) {
    QPainterPath path;
    QPointF start;
    char command = 0;
    while (*words != '\0') {
        if (*words == ' ' || *words == ',') {
            ++words;
            continue;
        }
        if (isLetter(*words)) command = *words++;
        if (upper(command) == 'Z') {
            path.lineTo(start);
            path.moveTo(start);
            command = 0;
            continue;
        }
        std::array<double, 7> n{};
        const int count = numbersOf(command);
        if (count == 0) return path;
        for (int k = 0; k < count; ++k) {
            while (*words == ' ' || *words == ',') ++words;
            // a flag has one digit; a number may follow without a space
            const bool flag = upper(command) == 'A' && (k == 3 || k == 4);
            if (flag) {
                n[static_cast<std::size_t>(k)] = *words == '1' ? 1.0 : 0.0;
                if (*words != '\0') ++words;
                continue;
            }
            const auto read = std::from_chars(words, words + std::strlen(words), n[static_cast<std::size_t>(k)]);
            if (read.ec != std::errc()) return path;
            words = read.ptr;
        }
        add(path, command, n);
        if (upper(command) == 'M') {
            start = path.currentPosition();
            command = command == 'M' ? 'L' : 'l'; // further coordinate pairs are lines
        }
    }
    return path;
}

QIcon toolIcon(const char* name) {
    const auto* sign =
        std::find_if(std::begin(kSigns), std::end(kSigns), [&](const Sign& each) { return std::strcmp(each.name, name) == 0; });
    return sign == std::end(kSigns) ? QIcon() : QIcon(new SignEngine(pathOf(sign->path)));
}

} // namespace edgescan::ui
