// Lays out the window of a section.
#include "ui/panels/section/section_card.h"

#include "ui/base/count_text.h"
#include "ui/base/elided_label.h"
#include "ui/panels/section/section_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kZoomStep = 1.25;

} // namespace

SectionCard::SectionCard(QWidget* parent)
    : QDialog(parent), plot_(new SectionPlot), words_(new QLabel), outside_(new ElidedLabel(nullptr, 2)),
      export_(new QPushButton(tr("Export Section…"))) {
    setObjectName("section-card");
    setWindowTitle(tr("Section"));
    words_->setWordWrap(true);
    export_->setAutoDefault(false);
    plot_->setToolTip(tr("Wheel: zoom; drag: move; two clicks: a length"));
    auto* foot = new QHBoxLayout;
    const auto zoomBy = [this](double factor) { plot_->zoom(factor, QRectF(plot_->rect()).center()); };
    addButton(*foot, "section-zoom-in", "+", tr("Zoom in"), [zoomBy] { zoomBy(kZoomStep); })->setAutoRepeat(true);
    addButton(*foot, "section-zoom-out", QString::fromUtf8("−"), tr("Zoom out"), [zoomBy] {
        zoomBy(1.0 / kZoomStep);
    })->setAutoRepeat(true);
    addButton(*foot, "section-fit", tr("Fit"), {}, [this] { plot_->zoomToFit(); });
    outside_->setObjectName("section-outside");
    outside_->setMinimumHeight(2 * outside_->fontMetrics().lineSpacing() + 2); // the buttons are lower
    foot->addWidget(outside_, 1);                                              // next to Fit, not over the lines
    foot->addWidget(export_);
    addButton(*foot, "section-close", tr("Close"), {}, [this] { hide(); }); // a cab has no frame to close it by
    connect(plot_, &SectionPlot::viewChanged, this, &SectionCard::showView);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(plot_, 1);
    column->addWidget(words_);
    column->addLayout(foot);
}

QPushButton* SectionCard::addButton(QHBoxLayout& row, const char* name, const QString& text, const QString& words,
                                    const std::function<void()>& press) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setAutoDefault(false);
    if (!words.isEmpty()) {
        button->setAccessibleName(words);
        button->setToolTip(words);
    }
    connect(button, &QPushButton::clicked, this, press);
    row.addWidget(button);
    return button;
}

void SectionCard::setWords(const QString& words) {
    about_ = words;
    words_->setMinimumHeight(0);
    showView();
}

/// What the plot shows now. The words become no lower: the plot would move.
void SectionCard::showView() {
    const std::size_t edges = plot_->edgesShown();
    words_->setText(edges > 0 ? tr("Edge points, green: %1.").arg(countText(edges)) + ' ' + about_ : about_);
    words_->setMinimumHeight(std::max(words_->minimumHeight(), words_->heightForWidth(words_->width())));
    const std::size_t count = plot_->outside();
    outside_->setText(count > 0 ? tr("▲ %1 outside").arg(countText(count)) : QString());
    outside_->setToolTip(count > 0 ? tr("%1 points are outside: Fit shows them").arg(countText(count)) : QString());
}

QString SectionCard::words() const { return words_->text(); }

} // namespace edgescan::ui

#include "moc_section_card.cpp"
