// Draws the picture in the corner.
#include "ui/panels/cab/corner_picture.h"

#include "ui/base/marks.h"

#include <QHideEvent>
#include <QPainter>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kFromEdge = 12; // px
constexpr int kNarrowest = 150, kWidest = 300;
constexpr int kMargin = 8;
constexpr double kMostWords = 0.1; // of the height
constexpr int kLeastForGloves = 48;
constexpr int kLeastLetters = 11;             // px
constexpr double kRing = 8.0, kEndRing = 4.0; // radius, px: of one cell, of each end of a measurement

/// With the largest letters, from `mostPx` down to `leastPx`, in which the text fits into the room.
QFont fittedFont(QFont letters, const QString& text, int room, int mostPx, int leastPx) {
    letters.setPixelSize(mostPx);
    const int wide = QFontMetrics(letters).horizontalAdvance(text);
    int px = wide > room && wide > 0 ? std::max(leastPx, mostPx * room / wide) : mostPx;
    letters.setPixelSize(px);
    while (px > leastPx && QFontMetrics(letters).horizontalAdvance(text) > room) letters.setPixelSize(--px);
    return letters;
}

} // namespace

CornerPicture::CornerPicture(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);
    parent->installEventFilter(this);
    place();
}

void CornerPicture::show(std::shared_ptr<const QImage> image, const PictureMark& marked, const QTransform& toScreen) {
    marked_ = marked;
    const bool turned = std::exchange(toScreen_, toScreen) != toScreen_;
    if (std::exchange(image_, std::move(image)) != image_ || turned) {
        scaled_ = QPixmap();
        place();
    }
    update();
}

void CornerPicture::setWords(const QString& words) {
    setText(words);
    setAccessibleName(words);
    place();
    update();
}

void CornerPicture::endAt(int bottom) {
    bottom_ = bottom;
    place();
}

/// At most a quarter of the available space, in the aspect ratio of the image. A low view has no room for words below the picture: one line
/// is over it.
void CornerPicture::place() {
    const QSize room = parentWidget()->size();
    int width = std::min(kWidest, std::max(kNarrowest, room.width() / 4));
    int height = 0;
    if (image_ && !image_->isNull()) {
        const QSize turned = toScreen_.mapRect(image_->rect()).size();
        const double shape = static_cast<double>(turned.height()) / turned.width();
        height = static_cast<int>(std::min(width * shape, room.height() * 0.4));
    }
    const int least = std::max(0, kLeastForGloves - height);
    const bool enough = least > 0 || wordsHeight(width) <= room.height() * kMostWords;
    words_ = enough ? std::max(least, std::min(wordsHeight(width), room.height() - 2 * kFromEdge - height)) : 0;
    const int top = std::clamp(bottom_ + 1 - height - words_, kFromEdge, std::max(kFromEdge, room.height() - kFromEdge - height - words_));
    const QRect at(room.width() - kFromEdge - width, top, width, height + words_);
    if (at.size() != size()) scaled_ = QPixmap();
    const int before = reach();
    const bool moves = at.top() != y(); // of a view that is not laid out yet: no finger is on its way to where it was
    const QRegion left = isVisible() && !moves ? QRegion(geometry().intersected(parentWidget()->rect())) - at : QRegion();
    setGeometry(at);
    if (!left.isEmpty()) emit uncovered(left.translated(parentWidget()->mapToGlobal(QPoint())));
    if (reach() != before) emit reachChanged(reach());
}

/// As many lines as the text needs.
int CornerPicture::wordsHeight(int width) const {
    const QRect lines = fontMetrics().boundingRect(0, 0, width - 2 * kMargin, 1 << 14, Qt::AlignLeft | Qt::TextWordWrap, text());
    return lines.height() + kMargin;
}

int CornerPicture::reach() const { return width() + kFromEdge; }

bool CornerPicture::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QAbstractButton::eventFilter(watched, event);
}

void CornerPicture::changeEvent(QEvent* event) {
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::FontChange) place();
}

void CornerPicture::hideEvent(QHideEvent* event) {
    QAbstractButton::hideEvent(event);
    // Of a view that is not laid out yet a part is outside.
    const QRect left = geometry().intersected(parentWidget()->rect()).translated(parentWidget()->mapToGlobal(QPoint()));
    if (!event->spontaneous()) emit uncovered(left);
}

/// The words, in smaller letters where the line is too short for them.
void CornerPicture::drawLine(QPainter& painter, const QRect& line) const {
    const QFont letters = fittedFont(font(), text(), line.width(), fontInfo().pixelSize(), kLeastLetters);
    painter.setFont(letters);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, QFontMetrics(letters).elidedText(text(), Qt::ElideRight, line.width()));
    painter.setFont(font());
}

void CornerPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), QColor(0x1b, 0x1d, 0x1f));
    const QRect above = rect().adjusted(0, 0, 0, -words_);
    if (image_ && !image_->isNull() && above.height() > 0) {
        if (scaled_.isNull()) {
            const QSize room = toScreen_.mapRect(QRect(QPoint(), above.size())).size() * devicePixelRatioF();
            const QSize pixels = image_->size().scaled(room, Qt::KeepAspectRatio);
            scaled_ = QPixmap::fromImage(image_->scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).transformed(toScreen_));
            scaled_.setDevicePixelRatio(devicePixelRatioF());
        }
        QRectF at(QPointF(), QSizeF(scaled_.size()) / devicePixelRatioF());
        at.moveCenter(QRectF(above).center());
        painter.drawPixmap(at.topLeft(), scaled_);
        const auto place = [&](const QPoint& cell) {
            const QPointF way =
                toScreen_.map(QPointF((cell.x() + 0.5) / image_->width(), (cell.y() + 0.5) / image_->height()) - QPointF(0.5, 0.5));
            return at.center() + QPointF(way.x() * at.width(), way.y() * at.height());
        };
        const auto draw = [&] {
            for (const auto& [a, b] : marked_.links)
                painter.drawLine(place(marked_.cells.value(static_cast<int>(a))), place(marked_.cells.value(static_cast<int>(b))));
            const double ring = marked_.cells.size() == 1 ? kRing : kEndRing;
            for (const QPoint& cell : marked_.cells) painter.drawEllipse(place(cell), ring, ring);
        };
        strokeTwice(painter, QPen(Qt::black, 4.0), QPen(Qt::white, 2.0), draw);
    }
    const QRect line(0, height() - fontMetrics().height() - 2, width(), fontMetrics().height() + 2);
    if (words_ == 0) painter.fillRect(line, QColor(0x1b, 0x1d, 0x1f, 190));
    painter.setPen(QColor(0xe8, 0xe8, 0xe8));
    if (words_ == 0)
        drawLine(painter, line.adjusted(kMargin, 0, -kMargin, 0));
    else
        painter.drawText(rect().adjusted(kMargin, above.height(), -kMargin, 0), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                         text());
    painter.setPen(QPen(hasFocus() ? QColor(0x6c, 0xb2, 0xff) : QColor(0x63, 0x68, 0x6e), hasFocus() ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

} // namespace edgescan::ui

#include "moc_corner_picture.cpp"
