// What the thresholds do: edge counts under the sliders, and why a cell is an edge.
#include "core/explain/why.h"
#include "ui/base/notice_bar.h"
#include "ui/dialogs/why_card.h"
#include "ui/image/image_view.h"
#include "ui/main/main_window.h"
#include "ui/panel/edges_panel.h"
#include "ui/session/edge_counts.h"

#include <QMenu>

#include <memory>

namespace edgescan::ui {

void MainWindow::connectThresholds() {
    counts_ = new EdgeCounts(this);
    connect(counts_, &EdgeCounts::outdated, panel_, &EdgesPanel::forgetCounts);
    connect(counts_, &EdgeCounts::counted, panel_, &EdgesPanel::showCounts);
    for (ImageView* view : {gray_, edges_}) {
        connect(view, &ImageView::menuWanted, this, [this](int line, int beam, const QPoint& position) {
            if (!shown_ || line >= shown_->detection->scan->lines()) return;
            const std::size_t cell = shown_->detection->scan->rangeMm.index(line, beam);
            QMenu menu;
            menu.addAction(tr("&Why is this cell an edge, or none?"), this, [this, cell] {
                stick(cell);
                explain(cell);
            });
            menu.exec(position);
        });
    }
}

void MainWindow::explain(std::size_t cell) {
    const std::shared_ptr<const Picture> picture = shown_;
    if (!picture || explaining_ != nullptr) return; // the answer to the last question comes first
    explaining_ = new BackgroundJob(
        [this, picture, cell](const BackgroundJob::Progress&) -> std::function<void()> {
            const auto why = std::make_shared<const Why>(whyCell(*picture->detection, cell));
            return [this, picture, why] {
                if (why_ == nullptr) {
                    why_ = new WhyCard(this);
                    connect(why_, &QDialog::finished, this, &MainWindow::forgetTrail);
                }
                QString text = QString::fromStdString(whyText(*why, picture->detection->settings));
                if (picture == shown_ && !why->chainMembers.empty())
                    text += tr("\nIts chain is framed in both pictures, the strongest cell ringed.");
                why_->tell(text);
                showTrail(*picture, *why);
            };
        },
        this);
    connect(explaining_, &BackgroundJob::ended, this, [this] {
        explaining_->deleteLater();
        explaining_ = nullptr;
    });
}

// The chain of the cell that was asked about, for as long as the picture and the answer are there.
void MainWindow::showTrail(const Picture& picture, const Why& why) {
    EdgeTrail trail;
    if (&picture == shown_.get()) {
        for (const std::uint32_t k : why.chainMembers) trail.cells.push_back(*asPoint(k));
        for (const CellStrength& cell : why.chain) trail.way.emplace_back(cell.beam, cell.line);
        if (why.chainTop) trail.strongest = QPoint(why.chainTop->beam, why.chainTop->line);
    }
    for (ImageView* view : {gray_, edges_}) view->setTrail(trail);
}

void MainWindow::forgetTrail() {
    for (ImageView* view : {gray_, edges_}) view->setTrail({});
}

void MainWindow::explainMarked() {
    const std::optional<std::size_t> cell = hovered_ ? hovered_ : sticky_;
    if (cell && shown_)
        explain(*cell);
    else
        notice_->showNotice(NoticeBar::Kind::Warning, tr("Point at a cell or click one first; then Why says what decides about it."));
}

} // namespace edgescan::ui
