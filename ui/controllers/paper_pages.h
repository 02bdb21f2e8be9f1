// Pages of a document on paper.
#pragma once

#include <QTextDocument>

namespace edgescan::ui {

/// For a document that is laid out on pages: headings stay with what follows them and pictures with their captions; paragraphs of less than
/// half a page, tables of less than a page and rows of longer tables are not split.
void keepTogether(QTextDocument& document);

/// The page where a place of the document is, from 0.
[[nodiscard]] int pageOf(const QTextDocument& document, double y);
/// Whether lines of the block are on two pages.
[[nodiscard]] bool isSplit(const QTextBlock& block);

} // namespace edgescan::ui
