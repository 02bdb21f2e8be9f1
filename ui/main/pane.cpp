// A view with its title.
#include "ui/main/pane.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace edgescan::ui {

Pane::Pane(const QString& title, QWidget* content, QWidget* parent)
    : QFrame(parent), title_(new QLabel(title)), remark_(new QLabel), content_(content) {
    auto* bar = new QWidget;
    bar->installEventFilter(this);
    bar->setToolTip(tr("Double-click: this view alone, and back"));
    auto* line = new QHBoxLayout(bar);
    line->setContentsMargins(6, 2, 6, 2);
    line->addWidget(title_);
    line->addStretch(1);
    line->addWidget(remark_);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(content, 1);
}

void Pane::setRemark(const QString& text) { remark_->setText(text); }

QString Pane::title() const { return title_->text(); }

bool Pane::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick) {
        emit maximiseWanted();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace edgescan::ui
