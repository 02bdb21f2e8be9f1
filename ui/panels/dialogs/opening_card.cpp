// The list of assumptions made on opening.
#include "ui/panels/dialogs/opening_card.h"

#include "ui/base/core_words.h"
#include "ui/base/shown_text.h"
#include "ui/base/window_room.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QShowEvent>
#include <QStyle>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kAroundWords = 8; // total px above and below the text of a row
constexpr QSize kLeastList(260, 120);
constexpr int kWidest = 700, kHighest = 620, kHead = 72; // px; the head: that of a cab, or the menus

/// An icon and a word, without colour.
QString signOf(const files::OpeningPoint& point) {
    if (!point.against.empty()) return "▲ " + OpeningCard::tr("doubtful");
    if (point.source == files::OpeningPoint::Source::Guessed) return "? " + OpeningCard::tr("detected");
    if (point.source == files::OpeningPoint::Source::Assumed) return "? " + OpeningCard::tr("assumed");
    return "✓ " + (point.source == files::OpeningPoint::Source::Typed ? OpeningCard::tr("given by you") : OpeningCard::tr("from the file"));
}

QTreeWidgetItem* rowOf(const QStringList& words) {
    auto* row = new QTreeWidgetItem(words);
    for (int column = 0; column < words.size(); ++column) row->setToolTip(column, words[column]);
    return row;
}

/// "mounting, line angles"; empty: nothing was assumed.
QString assumedNames(const std::vector<files::OpeningPoint>& points) {
    QStringList names;
    for (const files::OpeningPoint& point : points) {
        if (point.source == files::OpeningPoint::Source::Assumed) names << QObject::tr(point.what).toLower();
    }
    return names.join(", ");
}

} // namespace

QString shownSentence(const files::Sentence& sentence) {
    std::vector<std::string> values; // some are texts of the core
    for (const std::string& value : sentence.values) values.push_back(exactBytes(coreSentence(value)));
    return shownText(files::filledIn(exactBytes(QObject::tr(sentence.pattern)), values));
}

OpeningCard::OpeningCard(QWidget* parent)
    : QDialog(parent), verdict_(new QLabel), about_(new QLabel), list_(new QTreeWidget), adopt_(nullptr) {
    setObjectName("opening-card");
    setWindowTitle(tr("Does This Look Right?"));
    for (QLabel* label : {verdict_, about_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    list_->setObjectName("opening-list");
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setWordWrap(true);
    list_->setMinimumSize(kLeastList);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(true);
    connect(list_->header(), &QHeaderView::sectionResized, this, &OpeningCard::fitRows);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    adopt_ = buttons->addButton(tr("&Adopt"), QDialogButtonBox::ApplyRole);
    adopt_->setEnabled(false);
    auto* column = new QVBoxLayout(this);
    column->addWidget(verdict_);
    column->addWidget(about_);
    column->addWidget(list_, 1);
    column->addWidget(buttons);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        int point = 0, other = 0;
        const bool some = chosen(point, other);
        adopt_->setEnabled(some);
        if (some) emit previewRequested(point, other);
    });
    connect(adopt_, &QPushButton::clicked, this, [this] {
        int point = 0, other = 0;
        if (chosen(point, other)) emit adoptRequested(point, other);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// Makes rows as high as their text at its width: a tree asks its rows for their size without a width.
void OpeningCard::fitRows() {
    const int margin = 2 * (list_->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
    const QRect room(0, 0, std::max(60, list_->columnWidth(1) - margin), 10000);
    bool others = false;
    for (QTreeWidgetItemIterator row(list_); *row != nullptr; ++row) {
        const int high = list_->fontMetrics().boundingRect(room, Qt::TextWordWrap, (*row)->text(1)).height() + kAroundWords;
        if ((*row)->sizeHint(1).height() == high) continue;
        (*row)->setSizeHint(1, QSize(0, high));
        others = true;
    }
    if (others) list_->doItemsLayout(); // the tree caches the heights of rows
}

void OpeningCard::showEvent(QShowEvent* event) {
    placeAtRight();
    QDialog::showEvent(event);
    QMetaObject::invokeMethod(this, &OpeningCard::fitRows, Qt::QueuedConnection); // after the columns have their widths
}

/// Over the right half of the window: the operator judges the picture in the rest.
void OpeningCard::placeAtRight() {
    const QWidget& below = *parentWidget()->window();
    const int wide = std::clamp(below.width() / 2, minimumSizeHint().width(), kWidest);
    const int high = std::min(std::max(minimumSizeHint().height(), below.height() - kHead), kHighest);
    setGeometry(fittedInScreen({below.mapToGlobal(QPoint(below.width() - wide, kHead)), QSize(wide, high)}, {},
                               below.screen()->availableGeometry()));
}

bool OpeningCard::chosen(int& point, int& other) const {
    const QTreeWidgetItem* row = list_->currentItem();
    const QTreeWidgetItem* above = row != nullptr ? row->parent() : nullptr;
    if (above == nullptr || row->data(0, Qt::UserRole).isNull()) return false;
    point = list_->indexOfTopLevelItem(above->parent() != nullptr ? above->parent() : const_cast<QTreeWidgetItem*>(above));
    other = row->data(0, Qt::UserRole).toInt();
    return true;
}

void OpeningCard::showPoints(const QString& scan, const std::vector<files::OpeningPoint>& points) {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const files::OpeningPoint& point : points) {
        auto* row = rowOf({signOf(point), QObject::tr(point.what) + ": " + shownSentence(point.taken)});
        list_->addTopLevelItem(row);
        if (!point.against.empty()) row->addChild(rowOf({QString(), "▲ " + shownSentence(point.against)}));
        for (std::size_t n = 0; n < point.others.size(); ++n) {
            auto* other = rowOf({tr("or"), shownSentence(point.others[n].words)});
            other->setData(0, Qt::UserRole, static_cast<int>(n));
            row->addChild(other);
        }
        row->setExpanded(true);
    }
    QMetaObject::invokeMethod(this, &OpeningCard::fitRows, Qt::QueuedConnection); // after the columns have their widths
    adopt_->setEnabled(false);
    const QString assumed = assumedNames(points);
    verdict_->setText(points.empty()              ? tr("%1: there is no other way to read it.").arg(scan)
                      : files::looksWrong(points) ? tr("%1: something contradicts how it was read.").arg(scan)
                      : !assumed.isEmpty()        ? tr("%1: assumed (%2), and the scan itself does not contradict it.").arg(scan, assumed)
                                                  : tr("%1: nothing contradicts how it was read.").arg(scan));
    showState(QString());
}

void OpeningCard::showState(const QString& words) {
    about_->setText(!words.isEmpty() ? words
                                     : tr("Click another reading to see the scan read that way. Adopt takes it, and Ctrl+Z undoes that. "
                                          "Close restores the former reading."));
}

QString OpeningCard::verdict() const { return verdict_->text(); }

} // namespace edgescan::ui

#include "moc_opening_card.cpp"
