// Lays out the window of a section.
#include "ui/panels/section/section_card.h"

#include "ui/panels/section/section_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace edgescan::ui {

SectionCard::SectionCard(QWidget* parent)
    : QDialog(parent), plot_(new SectionPlot), words_(new QLabel), export_(new QPushButton(tr("Export Section…"))) {
    setObjectName("section-card");
    setWindowTitle(tr("Section"));
    words_->setWordWrap(true);
    export_->setAutoDefault(false);
    plot_->setToolTip(tr("Wheel: zoom; drag: move; two clicks: a length"));
    auto* foot = new QHBoxLayout;
    foot->addWidget(words_, 1);
    foot->addWidget(export_, 0, Qt::AlignBottom);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(plot_, 1);
    column->addLayout(foot);
}

void SectionCard::setWords(const QString& words) { words_->setText(words); }

QString SectionCard::words() const { return words_->text(); }

} // namespace edgescan::ui

#include "moc_section_card.cpp"
