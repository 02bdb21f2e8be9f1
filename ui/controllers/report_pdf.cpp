// Lays the page of a report out on paper.
#include "ui/controllers/report_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QRectF>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextLayout>
#include <QTextTable>
#include <QThread>
#include <QUrl>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kMostMoves = 500;

/// The first and last place of the lines of a paragraph or a table.
struct Extent {
    double top = 0.0, bottom = 0.0;
};

Extent extentOf(const QTextBlock& block) {
    const double top = block.document()->documentLayout()->blockBoundingRect(block).top();
    const QTextLayout& lines = *block.layout();
    if (lines.lineCount() == 0) return {top, top};
    const QTextLine first = lines.lineAt(0), last = lines.lineAt(lines.lineCount() - 1);
    return {top + first.y(), top + last.y() + last.height()};
}

Extent extentOf(const QTextBlock& first, const QTextBlock& last) {
    Extent whole = extentOf(first);
    for (QTextBlock each = first; each.isValid(); each = each.next()) {
        const Extent of = extentOf(each);
        whole = {std::min(whole.top, of.top), std::max(whole.bottom, of.bottom)};
        if (each == last) break;
    }
    return whole;
}

/// A paragraph or a table of the document.
struct Part {
    QTextBlock block; // of a table: its first one
    QTextTable* table = nullptr;
    Extent extent;

    [[nodiscard]] bool leads() const { // to what follows it; empty ones are around tables
        return table == nullptr && (block.blockFormat().headingLevel() > 0 || block.text().trimmed().isEmpty());
    }
};

std::vector<Part> partsOf(const QTextDocument& document) {
    std::vector<Part> parts;
    for (auto each = document.rootFrame()->begin(); !each.atEnd(); ++each) {
        if (auto* table = qobject_cast<QTextTable*>(each.currentFrame())) {
            const QTextBlock first = table->firstCursorPosition().block();
            parts.push_back({first, table, extentOf(first, table->lastCursorPosition().block())});
        } else if (each.currentFrame() == nullptr && each.currentBlock().isValid()) {
            parts.push_back({each.currentBlock(), nullptr, extentOf(each.currentBlock())});
        }
    }
    return parts;
}

bool beginsPage(const Part& part) {
    const auto policy = part.table != nullptr ? part.table->format().pageBreakPolicy() : part.block.blockFormat().pageBreakPolicy();
    return (policy & QTextFormat::PageBreak_AlwaysBefore) != 0;
}

void beginPage(const Part& part) {
    if (part.table != nullptr) {
        QTextTableFormat format = part.table->format();
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        part.table->setFormat(format);
    } else {
        QTextBlockFormat format = part.block.blockFormat();
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        QTextCursor(part.block).setBlockFormat(format);
    }
}

/// A row on two pages begins on the second one: the head of its cells is as high as what is left of the first. False: there is none.
bool moveSplitRow(const QTextDocument& document, QTextTable& table) {
    for (int row = 0; row < table.rows(); ++row) {
        Extent whole{1e12, 0.0};
        for (int column = 0; column < table.columns(); ++column) {
            const QTextTableCell cell = table.cellAt(row, column);
            const Extent of = extentOf(cell.firstCursorPosition().block(), cell.lastCursorPosition().block());
            whole = {std::min(whole.top, of.top), std::max(whole.bottom, of.bottom)};
        }
        const int page = pageOf(document, whole.top);
        if (page == pageOf(document, whole.bottom - 1) || whole.bottom - whole.top > document.pageSize().height() / 2) continue;
        const double left = (page + 1) * document.pageSize().height() - whole.top;
        for (int column = 0; column < table.columns(); ++column) {
            QTextTableCell cell = table.cellAt(row, column);
            QTextTableCellFormat format = cell.format().toTableCellFormat();
            if (format.topPadding() >= left) return false; // it did not help
            format.setTopPadding(left);
            cell.setFormat(format);
        }
        return true;
    }
    return false;
}

/// Moves the first part that must not be where it is. False: there is none.
bool moveOne(const QTextDocument& document) {
    const double high = document.pageSize().height();
    const std::vector<Part> parts = partsOf(document);
    for (std::size_t n = 0; n < parts.size(); ++n) {
        const Part& part = parts[n];
        const int page = pageOf(document, part.extent.top), last = pageOf(document, part.extent.bottom - 1);
        const double length = part.extent.bottom - part.extent.top;
        const bool flows = part.table != nullptr && part.table->format().headerRowCount() > 0 && length > high / 4; // its head is repeated
        const double room = (page + 1) * high - part.extent.top;
        const bool split =
            page != last && (flows ? room < high / (length < high ? 3 : 8) : length < (part.table != nullptr ? high : high / 2));
        const bool alone = part.leads() && n + 1 < parts.size() && page != pageOf(document, parts[n + 1].extent.top) && length < high / 2 &&
                           !beginsPage(parts[n + 1]);
        if (split || alone) {
            std::size_t first = n; // a heading goes with it
            while (first > 0 && parts[first - 1].leads() && pageOf(document, parts[first - 1].extent.top) == page) --first;
            const bool isTop = beginsPage(parts[first]) || first == 0 || pageOf(document, parts[first - 1].extent.top) != page;
            if (!isTop) return beginPage(parts[first]), true;
        }
        if (part.table != nullptr && page != last && moveSplitRow(document, *part.table)) return true;
    }
    return false;
}

} // namespace

int pageOf(const QTextDocument& document, double y) { return static_cast<int>(std::floor(y / document.pageSize().height())); }

bool isSplit(const QTextBlock& block) {
    const Extent extent = extentOf(block);
    return pageOf(*block.document(), extent.top) != pageOf(*block.document(), extent.bottom - 1);
}

void keepTogether(QTextDocument& document) {
    for (int moves = 0; moves < kMostMoves && moveOne(document); ++moves) {
    }
}

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

namespace {

constexpr int kMarginMm = 15;
constexpr int kWide = 676, kHigh = 385; // px of 1/96 inch: a page is as wide
constexpr int kNumberedHigh = 500;      // one with numbers, which must be read
constexpr int kLegibleWide = 1200;      // px of such a picture, at least
constexpr int kLogoHigh = 90;
constexpr int kNumberMargin = 24; // px of 1/96 inch, below: for the page number
constexpr int kResolution = 300;

/// Removes each part from `begin` to `end`, both included.
void cut(QString& html, const QString& begin, const QString& end) {
    for (int from = static_cast<int>(html.indexOf(begin)); from >= 0; from = static_cast<int>(html.indexOf(begin, from))) {
        const int to = static_cast<int>(html.indexOf(end, from));
        if (to < 0) return;
        html.remove(from, to + end.size() - from);
    }
}

/// `attributes`: of the element, each with a space behind it.
QString elementOf(const QImage& image, const QString& attributes = {}) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return "<img " + attributes + "src=\"data:image/png;base64," + QString::fromLatin1(png.toBase64()) + "\">";
}

const QString kBar = QStringLiteral("class=\"bar\" "); // its width is that below a picture of the width kWide

/// Gray ramp and scale bar, which are backgrounds of empty elements on the page for browsers, as pictures.
void drawBars(QString& html) {
    constexpr int kRampWide = 160, kRampHigh = 12, kScaleHigh = 4;
    static const QRegularExpression bar(R"re(<span class="bar" style="([^"]*)"></span>)re"), percent("width:([0-9.]+)%");
    for (auto found = bar.match(html); found.hasMatch(); found = bar.match(html)) {
        const auto share = percent.match(found.captured(1));
        QImage drawn(share.hasMatch() ? std::max(1, static_cast<int>(share.captured(1).toDouble() * kWide / 100)) : kRampWide,
                     share.hasMatch() ? kScaleHigh : kRampHigh, QImage::Format_RGB32);
        for (int x = 0; x < drawn.width(); ++x) {
            const int level = share.hasMatch() ? 0x44 : 255 * x / std::max(1, drawn.width() - 1);
            for (int y = 0; y < drawn.height(); ++y) drawn.setPixel(x, y, qRgb(level, level, level));
        }
        html.replace(found.capturedStart(), found.capturedLength(), "<span>" + elementOf(drawn, kBar) + "</span>");
    }
}

/// The drawing of the sizes as a picture.
void drawSizes(QString& html) {
    constexpr double kScale = 3.0; // sharp enough on paper
    const QString begin = "<svg id=\"sizes\"", end = "</svg>";
    const int from = static_cast<int>(html.indexOf(begin)), to = from < 0 ? -1 : static_cast<int>(html.indexOf(end, from));
    if (to < 0) return;
    const QString drawing = html.mid(from, to + end.size() - from);
    html.replace(from, drawing.size(), "<p>" + elementOf(imageOfDrawing(drawing, kScale)) + "</p>");
}

bool isWithin(const QString& html, int at, const QString& begin, const QString& end) {
    const int from = static_cast<int>(html.lastIndexOf(begin, at));
    return from >= 0 && html.indexOf(end, from) > at;
}

const QString kPlain = QStringLiteral(" width=\"100%\" cellpadding=\"0\" cellspacing=\"0\">");
const QString kHalf = QStringLiteral("<td width=\"50%\">"), kWider = QStringLiteral("<td width=\"64%\">"),
              kSmaller = QStringLiteral("<td width=\"36%\">"); // the drawing of the sizes, and the rocks on the points

/// The facts, which a browser shows in columns, two in each row of a table.
void tabulateFacts(QString& html) {
    static const QRegularExpression list(R"(<dl class="facts">(.*?)</dl>)", QRegularExpression::DotMatchesEverythingOption),
        fact("<div><dt>(.*?)</dt><dd[^>]*>(.*?)</dd></div>");
    for (auto found = list.match(html); found.hasMatch(); found = list.match(html)) {
        QString rows;
        bool isLeft = true;
        for (auto all = fact.globalMatch(found.captured(1)); all.hasNext(); isLeft = !isLeft) {
            const auto each = all.next();
            rows += QString(isLeft ? "<tr>" : "") + "<td class=\"name\" width=\"18%\">" + each.captured(1) + "</td><td width=\"32%\">" +
                    each.captured(2) + "</td>" + (isLeft ? "" : "</tr>");
        }
        html.replace(found.capturedStart(), found.capturedLength(), "<table" + kPlain + rows + (isLeft ? "" : "</tr>") + "</table>");
    }
}

/// Two pictures in a row, or one: with its legend and its caption in one cell, which is on one page.
void tabulateFigures(QString& html) {
    const QString begin = "<section class=\"pictures\">", end = "</section>", figure = "<figure class=\"picture\">";
    for (int from = static_cast<int>(html.indexOf(begin)); from >= 0; from = static_cast<int>(html.indexOf(begin, from))) {
        const int to = static_cast<int>(html.indexOf(end, from));
        QString pair = html.mid(from + begin.size(), to - from - begin.size());
        pair.replace(figure, kHalf)
            .replace("<figure class=\"picture sizes\">", kWider)
            .replace("<figure class=\"picture second\">", kSmaller);
        html.replace(from, to + end.size() - from, "<table" + kPlain + "<tr>" + pair.replace("</figure>", "</td>") + "</tr></table>");
    }
    html.replace(figure, "<table" + kPlain + "<tr><td>").replace("</figure>", "</td></tr></table>");
    html.replace("<figcaption>", "<p class=\"note\">").replace("</figcaption>", "</p>");
}

/// The width that the picture at `at` may have.
int widthFor(const QString& html, int at) {
    for (const auto& [cell, percent] : {std::pair{kHalf, 49}, {kWider, 62}, {kSmaller, 35}}) {
        if (isWithin(html, at, cell, "</td>")) return kWide * percent / 100;
    }
    return kWide;
}

/// The pictures become resources of the document, no larger than the page.
QString withResources(const QString& html, QTextDocument& document) {
    const QString begin = "src=\"data:image/png;base64,";
    QString made;
    int from = 0, number = 0;
    double pictureWide = kWide; // of the last picture, px: a bar below it belongs to it
    for (int at = static_cast<int>(html.indexOf(begin)); at >= 0; at = static_cast<int>(html.indexOf(begin, from))) {
        const int data = at + static_cast<int>(begin.size()), end = static_cast<int>(html.indexOf('"', data));
        if (end < 0) break;
        QImage image = QImage::fromData(QByteArray::fromBase64(html.mid(data, end - data).toLatin1()), "PNG");
        // "...">\n<svg class="numbers" ...": the numbers of the picture are drawn on it, and the drawing goes.
        const bool numbered = html.indexOf("<svg class=\"numbers\"", end) == end + 3;
        if (numbered && image.width() > 0) image = image.scaledToWidth(image.width() * (1 + kLegibleWide / image.width())); // whole pixels
        if (numbered && !isWithin(html, at, kSmaller, "</td>"))
            drawOver(image, html.mid(end + 3, html.indexOf("</svg>", end) + 6 - (end + 3)));
        const bool isLogo = isWithin(html, at, "<p class=\"logo\">", "</p>");
        const int high = isLogo ? kLogoHigh : numbered ? kNumberedHigh : kHigh;
        const bool isBar = html.mid(at - kBar.size(), kBar.size()) == kBar;
        const double scale =
            image.isNull() ? 1.0
            : isBar        ? pictureWide / kWide
                           : std::min(static_cast<double>(widthFor(html, at)) / image.width(), static_cast<double>(high) / image.height());
        if (!isBar) pictureWide = scale * image.width();
        const QString name = QString("picture-%1").arg(number++);
        document.addResource(QTextDocument::ImageResource, QUrl(name), image);
        made += html.mid(from, at - from) + QString("src=\"%1\" width=\"%2\" height=\"%3\"")
                                                .arg(name)
                                                .arg(std::lround(scale * image.width()))
                                                .arg(std::lround(scale * image.height()));
        from = end + 1;
    }
    return made + html.mid(from);
}

/// As QTextDocument::print(), which lays the pages out itself and splits what belongs together.
void print(QTextDocument& document, QPdfWriter& writer) {
    QPainter painter(&writer);
    QAbstractTextDocumentLayout& layout = *document.documentLayout();
    layout.setPaintDevice(&writer);
    QTextFrameFormat edge = document.rootFrame()->frameFormat();
    edge.setMargin(2); // what rises above its line
    edge.setBottomMargin(kNumberMargin);
    document.rootFrame()->setFrameFormat(edge);
    const QSizeF page(writer.width(), writer.height());
    document.setPageSize(page);
    keepTogether(document);
    painter.setFont(QFont(document.defaultFont(), &writer));
    for (int n = 0; n < document.pageCount(); ++n) {
        if (n > 0) writer.newPage();
        painter.drawText(QRectF(QPointF(), page), Qt::AlignRight | Qt::AlignBottom, QString::number(n + 1));
        painter.save();
        painter.translate(0, -n * page.height());
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = QRectF(QPointF(0, n * page.height()), page);
        context.palette.setColor(QPalette::Text, Qt::black);
        painter.setClipRect(context.clip);
        layout.draw(&painter, context);
        painter.restore();
    }
}

QByteArray laidOut(const std::string& html) {
    QString page = QString::fromStdString(html);
    cut(page, "<script", "</script>");
    cut(page, "<style", "</style>");
    drawSizes(page);
    drawBars(page);
    cut(page, "<section class=\"onscreen\">", "</section>");
    cut(page, "<details class=\"onscreen\">", "</details>");
    for (const char* kind : {"narrow", "onscreen"}) cut(page, QString("<span class=\"%1\">").arg(kind), "</span>");
    page.replace("\"></i>", "\">&nbsp;&nbsp;&nbsp;</i>&nbsp;");
    page.replace(QRegularExpression(" (?=[^<>]*</span>)"), "&nbsp;"); // an entry of a legend is on one line
    page.replace("</span><span", "</span>&nbsp;&nbsp; <span");
    tabulateFacts(page);
    tabulateFigures(page);
    QTextDocument document;
    QFont font("Noto Sans");
    font.setPointSize(9);
    document.setDefaultFont(font);
    document.setDefaultStyleSheet(
        "h1 { font-size: 16pt; } h2 { font-size: 12pt; margin-top: 10px; margin-bottom: 4px; } p { margin-top: 4px; margin-bottom: 4px; } "
        "td, th { padding: 2px 8px 2px 0px; text-align: left; }"
        " #rocks td, #rocks th { font-size: 7pt; padding: 1px 0px 1px 3px; } #rocks td { white-space: nowrap; }" // whole numbers
        " #rocks th { font-size: 6pt; font-weight: normal; } #targets td, #targets th, #measures td, #measures th { font-size: 7.5pt; }"
        " td.name, .note { color: #5b6268; } .warning { background-color: #fff3d6; }"
        " pre { font-size: 7pt; white-space: pre-wrap; }");
    page = withResources(page, document);
    cut(page, "<svg", "</svg>"); // its numbers are on the picture
    document.setHtml(page);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
        writer.setResolution(kResolution);
        writer.setCreator("EdgeScan");
        writer.setTitle(document.metaInformation(QTextDocument::DocumentTitle));
        print(document, writer);
    }
    return bytes;
}

} // namespace

/// A document needs a thread of Qt.
QByteArray pdfOfPage(const std::string& html) {
    QByteArray pdf;
    const std::unique_ptr<QThread> thread(QThread::create([&] { pdf = laidOut(html); }));
    thread->start();
    thread->wait();
    return pdf;
}

} // namespace edgescan::ui
