// Two scroll areas that follow each other.
#include "ui/base/two_pictures.h"

#include <QLabel>
#include <QPixmap>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace edgescan::ui {

TwoPictures::TwoPictures(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (std::size_t n = 0; n < 2; ++n) {
        words_[n] = new QLabel;
        words_[n]->setTextFormat(Qt::PlainText);
        words_[n]->setWordWrap(true);
        pictures_[n] = new QLabel;
        areas_[n] = new QScrollArea;
        areas_[n]->setWidget(pictures_[n]);
        areas_[n]->setAlignment(Qt::AlignCenter);
        column->addWidget(words_[n]);
        column->addWidget(areas_[n], 1);
    }
    for (const auto bar : {&QScrollArea::horizontalScrollBar, &QScrollArea::verticalScrollBar}) {
        QScrollBar* one = (areas_[0]->*bar)();
        QScrollBar* other = (areas_[1]->*bar)();
        connect(one, &QScrollBar::valueChanged, other, &QScrollBar::setValue);
        connect(other, &QScrollBar::valueChanged, one, &QScrollBar::setValue);
        for (const QScrollBar* each : {one, other}) {
            connect(each, &QScrollBar::actionTriggered, this, [this] { moved_ = true; });
            // The scroll range is known only after the picture was laid out.
            connect(each, &QScrollBar::rangeChanged, this, [this] {
                if (!moved_) centre();
            });
        }
    }
}

void TwoPictures::showPair(const QString& aboveWords, const QImage& above, const QString& belowWords, const QImage& below, QPoint busiest) {
    words_[0]->setText(aboveWords);
    words_[1]->setText(belowWords);
    const std::array<const QImage*, 2> images{&above, &below};
    for (std::size_t n = 0; n < 2; ++n) {
        pictures_[n]->setPixmap(QPixmap::fromImage(*images[n]));
        pictures_[n]->setFixedSize(images[n]->size());
        pictures_[n]->setAccessibleName(words_[n]->text());
    }
    busiest_ = busiest;
    moved_ = false;
    centre();
}

void TwoPictures::clear() { showPair({}, {}, {}, {}, {}); }

QImage TwoPictures::picture(int place) const { return pictures_[static_cast<std::size_t>(place)]->pixmap(Qt::ReturnByValue).toImage(); }

void TwoPictures::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (!moved_) centre();
}

void TwoPictures::centre() {
    const QSize seen = areas_[0]->viewport()->size();
    for (QScrollArea* area : areas_) { // both areas: the range of the other one may not be known yet
        area->horizontalScrollBar()->setValue(busiest_.x() - seen.width() / 2);
        area->verticalScrollBar()->setValue(busiest_.y() - seen.height() / 2);
    }
}

} // namespace edgescan::ui

#include "moc_two_pictures.cpp"
