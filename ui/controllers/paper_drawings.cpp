// Paints the few elements of SVG that reports use.
#include "ui/controllers/paper_drawings.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QRectF>
#include <QRegularExpression>
#include <QStringList>
#include <QXmlStreamReader>

namespace edgescan::ui {
namespace {

constexpr double kOutline = 0.22; // of the height of a number: its dark rim

/// The attributes of an element.
class Element {
public:
    explicit Element(const QXmlStreamReader& xml) : attributes_(xml.attributes()) {}
    [[nodiscard]] QString text(const char* name) const { return attributes_.value(QLatin1String(name)).toString(); }
    [[nodiscard]] double number(const char* name) const { return text(name).toDouble(); }
    [[nodiscard]] QPen pen() const {
        const QString width = text("stroke-width"), dashes = text("stroke-dasharray");
        QPen pen(QColor(text("stroke")), width.isEmpty() ? 1.0 : width.toDouble());
        QVector<qreal> pattern;
        for (const QString& each : dashes.split(' ', Qt::SkipEmptyParts)) pattern << each.toDouble() / pen.widthF();
        if (!pattern.isEmpty()) pen.setDashPattern(pattern);
        return pen;
    }

private:
    QXmlStreamAttributes attributes_;
};

/// "M88.0 202.0 H90.5 V187.3 ...".
QPainterPath pathOf(const QString& steps) {
    QPainterPath path;
    static const QRegularExpression step("([MHV])([-0-9.]+)(?: ([-0-9.]+))?");
    for (auto all = step.globalMatch(steps); all.hasNext();) {
        const auto found = all.next();
        const double value = found.captured(2).toDouble();
        if (found.captured(1) == "M")
            path.moveTo(value, found.captured(3).toDouble());
        else if (found.captured(1) == "H")
            path.lineTo(value, path.currentPosition().y());
        else
            path.lineTo(path.currentPosition().x(), value);
    }
    return path;
}

/// `unit`: height of the numbers over a picture; 0: a text of a drawing on white.
void drawText(QPainter& painter, const Element& element, const QString& words, double unit) {
    QFont font("Noto Sans");
    constexpr int kDrawn = 100; // px: then scaled to its height, which may be less than a pixel
    const double high = unit > 0 ? unit : element.number("font-size");
    font.setPixelSize(kDrawn);
    font.setBold(unit > 0);
    const QFontMetricsF metrics(font);
    const QString anchor = unit > 0 ? QStringLiteral("middle") : element.text("text-anchor");
    const double wide = metrics.horizontalAdvance(words);
    const double left = anchor == "middle" ? -wide / 2 : anchor == "end" ? -wide : 0.0;
    QPainterPath path;
    path.addText(left, unit > 0 ? metrics.capHeight() / 2 : 0.0, font, words);
    painter.save();
    painter.translate(element.number("x"), element.number("y"));
    if (element.text("transform").startsWith("rotate(-90")) painter.rotate(-90);
    painter.scale(high / kDrawn, high / kDrawn);
    if (unit > 0) painter.strokePath(path, QPen(Qt::black, kOutline * kDrawn, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, unit > 0 ? Qt::white : Qt::black);
    painter.restore();
}

void draw(QPainter& painter, const QString& svg) {
    static const QRegularExpression unitOf("--unit:([0-9.]+)px");
    const double unit = unitOf.match(svg).captured(1).toDouble();
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const Element element(xml);
        if (xml.name() == QLatin1String("line")) {
            painter.setPen(element.pen());
            painter.drawLine(QPointF(element.number("x1"), element.number("y1")), QPointF(element.number("x2"), element.number("y2")));
        } else if (xml.name() == QLatin1String("path")) {
            painter.strokePath(pathOf(element.text("d")), element.pen());
        } else if (xml.name() == QLatin1String("circle")) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(QColor(element.text("fill")));
            painter.drawEllipse(QPointF(element.number("cx"), element.number("cy")), element.number("r"), element.number("r"));
        } else if (xml.name() == QLatin1String("text")) {
            drawText(painter, element, xml.readElementText(), unit);
        }
    }
}

QSizeF sizeOf(const QString& svg) {
    static const QRegularExpression box("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"");
    const auto found = box.match(svg);
    return {found.captured(1).toDouble(), found.captured(2).toDouble()};
}

} // namespace

QImage imageOfDrawing(const QString& svg, double scale) {
    QImage image((sizeOf(svg) * scale).toSize(), QImage::Format_RGB32);
    if (image.isNull()) return image;
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    draw(painter, svg);
    return image;
}

void drawOver(QImage& picture, const QString& svg) {
    const QSizeF size = sizeOf(svg);
    if (picture.isNull() || size.isEmpty()) return;
    picture = picture.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(picture.width() / size.width(), picture.height() / size.height());
    draw(painter, svg);
}

} // namespace edgescan::ui
