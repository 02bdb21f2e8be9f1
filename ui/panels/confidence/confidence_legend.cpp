// The legend of edge confidence.
#include "ui/panels/confidence/confidence_legend.h"

#include "ui/base/count_text.h"
#include "ui/base/themes.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

QString nameOfBand(std::size_t band) {
    if (band == 0) return ConfidenceLegend::tr("at all of them");
    if (band + 1 == kBands) return ConfidenceLegend::tr("below %1 %").arg(edges::kConfidenceBands[band - 1]);
    return ConfidenceLegend::tr("%1 % and more").arg(edges::kConfidenceBands[band]);
}

/// As thick as the points are large.
QPixmap swatchOf(const QColor& colour, std::size_t band) {
    QPixmap swatch(18, 9);
    swatch.fill(Qt::transparent);
    QPainter painter(&swatch);
    const int thick = static_cast<int>(7 - band);
    painter.fillRect(QRect(0, (9 - thick) / 2, 18, std::max(2, thick)), colour);
    return swatch;
}

} // namespace

ConfidenceLegend::ConfidenceLegend(QWidget* parent)
    : QWidget(parent), words_(new QLabel(this)), least_(new QLabel(this)), slider_(new QSlider(Qt::Horizontal, this)) {
    setObjectName("confidence-legend");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1); // names directly follow their colours
    auto* title = new QLabel(tr("Confidence of edges"), this);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    grid->addWidget(title, 0, 0, 1, 3);
    words_->setObjectName("confidence-words");
    words_->setTextFormat(Qt::PlainText);
    words_->setWordWrap(true);
    grid->addWidget(words_, 1, 0, 1, 3);
    for (std::size_t band = 0; band < kBands; ++band) {
        const int row = static_cast<int>(band) + 2;
        swatches_[band] = new QLabel(this);
        names_[band] = new QLabel(nameOfBand(band), this);
        counts_[band] = new QLabel(this);
        counts_[band]->setObjectName(QString("confidence-%1").arg(band));
        grid->addWidget(swatches_[band], row, 0);
        grid->addWidget(names_[band], row, 1);
        grid->addWidget(counts_[band], row, 2, Qt::AlignRight);
    }
    slider_->setObjectName("confidence-least");
    slider_->setRange(0, 100);
    slider_->setSingleStep(1);
    slider_->setPageStep(10);
    slider_->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard focus in the view
    slider_->setToolTip(tr("Edges that fewer of the nearby settings find are left out of the views. Exports have all of them."));
    slider_->setAccessibleName(tr("Least confidence shown"));
    grid->addWidget(least_, static_cast<int>(kBands) + 2, 0, 1, 3);
    grid->addWidget(slider_, static_cast<int>(kBands) + 3, 0, 1, 3);
    connect(slider_, &QSlider::valueChanged, this, [this](int percent) {
        least_->setText(percent > 0 ? tr("Shown: %1 % and more").arg(percent) : tr("Shown: all"));
        emit leastRequested(percent);
    });
    least_->setText(tr("Shown: all"));
    setColours(bandColours(false));
    showRows(false);
    hide();
}

void ConfidenceLegend::setColours(const EdgeColours& colours) {
    for (std::size_t band = 0; band < kBands; ++band) swatches_[band]->setPixmap(onViewGround(swatchOf(colours[band], band)));
}

void ConfidenceLegend::setLeast(int percent) { slider_->setValue(percent); }

int ConfidenceLegend::least() const { return slider_->value(); }

void ConfidenceLegend::showRows(bool on) {
    for (std::size_t band = 0; band < kBands; ++band) {
        for (QLabel* each : {swatches_[band], names_[band], counts_[band]}) each->setVisible(on);
    }
    least_->setVisible(on);
    slider_->setVisible(on);
}

void ConfidenceLegend::showWorking(int done) { words_->setText(tr("computing: %1 %").arg(done)); }

void ConfidenceLegend::showNone(const QString& why) {
    words_->setText(why);
    showRows(false);
}

void ConfidenceLegend::showMade(const ConfidencePicture& made) {
    words_->setText(tr("share of %1 nearby settings that find the edge").arg(made.confidence->settings));
    for (std::size_t band = 0; band < kBands; ++band) counts_[band]->setText(countText(made.counts[band]));
    showRows(true);
}

QString ConfidenceLegend::counted(std::size_t band) const { return counts_[band]->text(); }
QString ConfidenceLegend::words() const { return words_->text(); }

} // namespace edgescan::ui

#include "moc_confidence_legend.cpp"
