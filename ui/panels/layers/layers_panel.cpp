// The panel of layers.
#include "ui/panels/layers/layers_panel.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kSwatch = 14;   // px
constexpr int kMostLines = 6; // of the list before it scrolls

QIcon swatch(const QColor& colour) {
    QPixmap pixels(kSwatch, kSwatch);
    pixels.fill(Qt::transparent);
    QPainter painter(&pixels);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(colour);
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(pixels.rect(), 3, 3);
    return pixels;
}

} // namespace

LayersPanel::LayersPanel(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), add_(new QPushButton(tr("Add a Scan as a Layer…"))),
      activate_(new QPushButton(tr("Make Active"))), remove_(new QPushButton(tr("Remove"))), locate_(new QPushButton(tr("Locate…"))),
      targets_(new QPushButton(tr("Place by Targets"))) {
    setObjectName("layers-panel");
    list_->setObjectName("layer-list");
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setWordWrap(true);
    list_->setIconSize({kSwatch, kSwatch});
    add_->setObjectName("layer-add");
    activate_->setObjectName("layer-activate");
    remove_->setObjectName("layer-remove");
    locate_->setObjectName("layer-locate");
    targets_->setObjectName("layer-targets");
    activate_->setToolTip(tr("Shows the image and the edges of this scan; the others stay in the cloud"));
    targets_->setToolTip(tr("Pin the same three places in both scans as targets with the same numbers: they bring the layer to its place"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(4);
    column->addWidget(list_);
    auto* row = new QHBoxLayout;
    row->addWidget(activate_, 1);
    row->addWidget(remove_, 1);
    column->addLayout(row);
    for (QPushButton* button : {locate_, targets_, add_}) column->addWidget(button);
    column->addStretch(1);
    connect(add_, &QPushButton::clicked, this, &LayersPanel::addRequested);
    const auto ofRow = [this](QPushButton* button, void (LayersPanel::*signal)(int)) {
        connect(button, &QPushButton::clicked, this, [this, signal] {
            if (list_->currentRow() >= 0) emit(this->*signal)(list_->currentRow());
        });
    };
    ofRow(activate_, &LayersPanel::activeRequested);
    ofRow(remove_, &LayersPanel::removeRequested);
    ofRow(locate_, &LayersPanel::locateRequested);
    ofRow(targets_, &LayersPanel::targetsRequested);
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { emit activeRequested(list_->row(item)); });
    connect(list_, &QListWidget::currentRowChanged, this, &LayersPanel::showButtons);
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const int layer = list_->row(item);
        const bool on = item->checkState() == Qt::Checked;
        if (shown_[static_cast<std::size_t>(layer)].visible != on) emit visibleRequested(layer, on);
    });
    showButtons();
}

void LayersPanel::showLayers(const std::vector<LayerLine>& lines) {
    if (lines == shown_) return;
    const int before = list_->currentRow();
    shown_ = lines;
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const LayerLine& line : lines) {
        auto* item = new QListWidgetItem(swatch(line.colour), line.name + '\n' + line.words, list_);
        item->setToolTip(line.tip);
        QFont font = item->font();
        font.setBold(line.active);
        item->setFont(font);
        if (line.active) {
            item->setFlags(item->flags() & ~Qt::ItemIsUserCheckable);
        } else {
            item->setCheckState(line.visible ? Qt::Checked : Qt::Unchecked);
        }
    }
    list_->setCurrentRow(std::min(before, list_->count() - 1));
    int high = 2 * list_->frameWidth() + 2;
    for (int n = 0; n < std::clamp(list_->count(), 1, kMostLines); ++n)
        high += list_->count() > 0 ? list_->sizeHintForRow(n) : list_->fontMetrics().height();
    list_->setFixedHeight(high);
    showButtons();
}

void LayersPanel::showButtons() {
    const int row = list_->currentRow();
    const LayerLine* line = row >= 0 && row < static_cast<int>(shown_.size()) ? &shown_[static_cast<std::size_t>(row)] : nullptr;
    const bool other = line != nullptr && !line->active;
    activate_->setEnabled(other && !line->missing);
    remove_->setEnabled(other);
    locate_->setVisible(other && line->missing);
    targets_->setVisible(other && !line->missing);
}

} // namespace edgescan::ui

#include "moc_layers_panel.cpp"
