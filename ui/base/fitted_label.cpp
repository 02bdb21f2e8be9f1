// Chooses the size of the letters.
#include "ui/base/fitted_label.h"

#include <QFontMetrics>

#include <algorithm>

namespace edgescan::ui {

QFont fittedFont(QFont letters, const QString& text, int room, int mostPx, int leastPx) {
    letters.setPixelSize(mostPx);
    const int wide = QFontMetrics(letters).horizontalAdvance(text);
    int px = wide > room && wide > 0 ? std::max(leastPx, mostPx * room / wide) : mostPx;
    letters.setPixelSize(px);
    while (px > leastPx && QFontMetrics(letters).horizontalAdvance(text) > room) letters.setPixelSize(--px);
    return letters;
}

FittedLabel::FittedLabel(int mostPx, int leastPx, QWidget* parent) : QLabel(parent), mostPx_(mostPx), leastPx_(leastPx) {
    setTextFormat(Qt::PlainText);
    setMost(mostPx);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void FittedLabel::showText(const QString& text) {
    setText(text);
    fit();
}

void FittedLabel::setMost(int px) {
    mostPx_ = px;
    QFont letters = font();
    letters.setPixelSize(px);
    letters.setBold(true);
    setFont(letters);
    setMinimumHeight(QFontMetrics(letters).height()); // the widgets below do not move
    fit();
}

QSize FittedLabel::minimumSizeHint() const { return {0, minimumHeight()}; }

void FittedLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void FittedLabel::fit() {
    const int room = contentsRect().width();
    const QFont letters = fittedFont(font(), text(), room, mostPx_, leastPx_);
    if (letters.pixelSize() != font().pixelSize()) setFont(letters);
    setToolTip(QFontMetrics(letters).horizontalAdvance(text()) > room ? text() : QString());
}

} // namespace edgescan::ui
