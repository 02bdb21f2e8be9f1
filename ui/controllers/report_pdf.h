// A report as PDF.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QTextDocument>

#include <string>

namespace edgescan::ui {

/// For a document that is laid out on pages: headings stay with what follows them and pictures with their captions; paragraphs of less than
/// half a page, tables of less than a page and rows of longer tables are not split.
void keepTogether(QTextDocument& document);

/// The page where a place of the document is, from 0.
[[nodiscard]] int pageOf(const QTextDocument& document, double y);
/// Whether lines of the block are on two pages.
[[nodiscard]] bool isSplit(const QTextBlock& block);

/// Lines, paths of right angles, circles and texts, as core/exports/html makes them. `scale`: pixels per unit of the drawing.
[[nodiscard]] QImage imageOfDrawing(const QString& svg, double scale);

/// Draws the numbers of a picture over it.
void drawOver(QImage& picture, const QString& svg);

/// The pages of a report (core/exports/html/scan_page.h) without what only works on a screen: A4, with page numbers.
[[nodiscard]] QByteArray pdfOfPage(const std::string& html);

} // namespace edgescan::ui
