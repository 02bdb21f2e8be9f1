// Lays out the window of a section.
#include "ui/panels/section/section_card.h"

#include "ui/base/count_text.h"
#include "ui/panels/section/section_plot.h"

#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kZoomStep = 1.25;

} // namespace

SectionCard::SectionCard(QWidget* parent)
    : QDialog(parent), asked_(new QLabel), plot_(new SectionPlot), words_(new QLabel), export_(new QPushButton(tr("Export Section…"))) {
    setObjectName("section-card");
    setWindowTitle(tr("Section"));
    words_->setWordWrap(true);
    export_->setAutoDefault(false);
    plot_->setToolTip(tr("Wheel: zoom; drag: move; two clicks: a length"));
    asked_->setObjectName("section-asked");
    asked_->setWordWrap(true);
    auto* foot = new QHBoxLayout;
    const auto zoomBy = [this](double factor) { plot_->zoom(factor, QRectF(plot_->rect()).center()); };
    addButton(*foot, "section-zoom-in", "+", tr("Zoom in"), [zoomBy] { zoomBy(kZoomStep); })->setAutoRepeat(true);
    addButton(*foot, "section-zoom-out", QString::fromUtf8("−"), tr("Zoom out"), [zoomBy] {
        zoomBy(1.0 / kZoomStep);
    })->setAutoRepeat(true);
    addButton(*foot, "section-fit", tr("Fit"), tr("Zoom to what the section is about"),
              [this] { plot_->zoomTo(SectionPlot::Part::About); });
    addButton(*foot, "section-all", tr("All"), tr("Zoom to all points of the section"), [this] { plot_->zoomTo(SectionPlot::Part::All); });
    foot->addStretch(1);
    foot->addWidget(export_);
    addButton(*foot, "section-close", tr("Close"), {}, [this] { hide(); }); // a cab has no frame to close it by
    connect(plot_, &SectionPlot::viewChanged, this, &SectionCard::showView);
    connect(plot_, &SectionPlot::clicked, this, &SectionCard::showAsked);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(asked_);
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
    showAsked(true);
}

/// What the next click does, above the plot.
QString SectionCard::askedWords(bool found, std::size_t ends) {
    return !found      ? tr("▲ This click is not on a line: click nearer to one.")
           : ends == 1 ? tr("Click on the other end of the length.")
           : ends == 2 ? tr("This length is stored with the measurements. Two more clicks measure another.")
                       : tr("Two clicks on the lines measure a length.");
}

void SectionCard::showAsked(bool found) { asked_->setText(askedWords(found, plot_->ends().size())); }

void SectionCard::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (!event->spontaneous()) emit closed(); // it was not only made small
}

/// With room for the longest of the words: the plot must not move under the second click.
void SectionCard::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    const QString shown = asked_->text();
    int high = 0;
    for (const QString& each : {askedWords(false, 0), askedWords(true, 0), askedWords(true, 1), askedWords(true, 2)}) {
        asked_->setText(each);
        high = std::max(high, asked_->heightForWidth(asked_->width()));
    }
    asked_->setFixedHeight(high);
    asked_->setText(shown);
}

/// What the plot shows now. The words become no lower, and have room for all sentences: the plot would move.
void SectionCard::showView() {
    const auto say = [this](std::size_t edges, std::size_t outside) {
        QStringList sentences;
        if (outside > 0) sentences << tr("▲ %1 points are outside: All shows them.").arg(countText(outside));
        if (edges > 0) sentences << tr("Edge points, green: %1.").arg(countText(edges));
        words_->setText((sentences << about_).join(' '));
        words_->setMinimumHeight(std::max(words_->minimumHeight(), words_->heightForWidth(words_->width())));
    };
    constexpr std::size_t kMany = 88888;
    say(kMany, kMany);
    say(plot_->edgesShown(), plot_->outside());
}

QString SectionCard::words() const { return words_->text(); }

} // namespace edgescan::ui

#include "moc_section_card.cpp"
