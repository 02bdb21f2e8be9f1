// Lays the page of a report out on paper.
#include "ui/controllers/report_pdf.h"

#include "ui/controllers/paper_drawings.h"
#include "ui/controllers/paper_pages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFont>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTextDocument>
#include <QTextFrame>
#include <QThread>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgescan::ui {
namespace {

constexpr int kMarginMm = 15;
constexpr int kWide = 660, kHigh = 385; // px of 1/96 inch: two pictures with their heading, legends and captions fill a page
constexpr int kNumberedHigh = 780;      // one with numbers, which must be read, has a page of its own
constexpr int kLogoHigh = 90;
constexpr int kInnerMargin = 24; // px of 1/96 inch: the page number is in it
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

/// The pictures become resources of the document, no larger than the page.
QString withResources(const QString& html, QTextDocument& document) {
    const QString begin = "src=\"data:image/png;base64,", logo = "<p class=\"logo\">";
    QString made;
    int from = 0, number = 0;
    double pictureWide = kWide; // of the last picture, px: a bar below it belongs to it
    for (int at = static_cast<int>(html.indexOf(begin)); at >= 0; at = static_cast<int>(html.indexOf(begin, from))) {
        const int data = at + static_cast<int>(begin.size()), end = static_cast<int>(html.indexOf('"', data));
        if (end < 0) break;
        QImage image = QImage::fromData(QByteArray::fromBase64(html.mid(data, end - data).toLatin1()), "PNG");
        // "...">\n<svg class="numbers" ...": the numbers of the picture are drawn on it, and the drawing goes.
        const bool numbered = html.indexOf("<svg class=\"numbers\"", end) == end + 3;
        if (numbered) drawOver(image, html.mid(end + 3, html.indexOf("</svg>", end) + 6 - (end + 3)));
        const bool isLogo = html.lastIndexOf(logo, at) >= 0 && html.indexOf("</p>", html.lastIndexOf(logo, at)) > at;
        const int high = isLogo ? kLogoHigh : numbered ? kNumberedHigh : kHigh;
        const bool isBar = html.mid(at - kBar.size(), kBar.size()) == kBar;
        const double scale = image.isNull() ? 1.0
                             : isBar        ? pictureWide / kWide
                                     : std::min(static_cast<double>(kWide) / image.width(), static_cast<double>(high) / image.height());
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
    edge.setMargin(kInnerMargin);
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
    // Columns of facts become rows of a table, which paper can show.
    page.replace("<dl class=\"facts\">", "<table class=\"facts\" cellpadding=\"2\">").replace("</dl>", "</table>");
    page.replace("<div><dt>", "<tr><td class=\"name\">").replace("</dt><dd>", "</td><td>").replace("</dd></div>", "</td></tr>");
    page.replace("\"></i>", "\">&nbsp;&nbsp;&nbsp;</i>&nbsp;");
    page.replace("</span><span", "</span>&nbsp;&nbsp; <span");
    // A table of one cell holds a picture, its legend and its caption on one page.
    page.replace("<figure class=\"picture\">", "<table width=\"100%\"><tr><td class=\"figure\">")
        .replace("</figure>", "</td></tr></table>");
    page.replace("<figcaption>", "<p class=\"note\">").replace("</figcaption>", "</p>");
    QTextDocument document;
    QFont font("Noto Sans");
    font.setPointSize(9);
    document.setDefaultFont(font);
    document.setDefaultStyleSheet(
        "h1 { font-size: 16pt; } h2 { font-size: 12pt; } td, th { padding: 2px 8px 2px 0px; text-align: left; }"
        " #rocks td, #rocks th { font-size: 6pt; padding: 1px 0px 1px 3px; } #rocks td { white-space: nowrap; }" // whole numbers
        " #rocks th { font-size: 5.5pt; font-weight: normal; } #targets td, #measures td { font-size: 7.5pt; }"
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
