// Moves what would be split to the next page. A document of Qt has page breaks before paragraphs and tables only.
#include "ui/controllers/paper_pages.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextFrame>
#include <QTextLayout>
#include <QTextTable>

#include <algorithm>
#include <cmath>
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
        const bool split = page != last && (flows ? room < high / 8 : length < (part.table != nullptr ? high : high / 2));
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

} // namespace edgescan::ui
