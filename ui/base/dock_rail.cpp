// The strip of folded panels.
#include "ui/base/dock_rail.h"

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace edgescan::ui {
namespace {

/// The panel's name, written from bottom to top.
class UprightButton : public QToolButton {
public:
    using QToolButton::QToolButton;
    [[nodiscard]] QSize sizeHint() const override {
        const QFontMetrics letters(font());
        return {letters.height() + 14, letters.horizontalAdvance(words()) + 24};
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const bool meant = underMouse() || hasFocus();
        painter.fillRect(rect(), palette().color(meant ? QPalette::Highlight : QPalette::Button));
        painter.setPen(palette().color(meant ? QPalette::HighlightedText : QPalette::ButtonText));
        painter.translate(0, height());
        painter.rotate(-90);
        painter.drawText(QRect(0, 0, height(), width()), Qt::AlignCenter, words());
    }

private:
    [[nodiscard]] QString words() const { return "« " + text(); }
};

QWidget* headOf(QDockWidget* dock) {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 2, 4, 2);
    auto* name = new QLabel(dock->windowTitle());
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    row->addWidget(name, 1);
    auto* fold = new QToolButton;
    fold->setObjectName("fold");
    fold->setText("»");
    fold->setAutoRaise(true);
    fold->setToolTip(QObject::tr("Fold this panel to the edge of the window"));
    QObject::connect(fold, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);
    row->addWidget(fold);
    return head;
}

} // namespace

DockRail::DockRail(QWidget* parent) : QToolBar(parent) {
    setObjectName("rail");
    setWindowTitle(tr("Folded panels"));
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    toggleViewAction()->setVisible(false);
    hide();
}

void DockRail::add(QDockWidget* dock) {
    dock->setTitleBarWidget(headOf(dock));
    auto* button = new UprightButton;
    button->setObjectName("rail-" + dock->objectName());
    button->setText(dock->windowTitle());
    button->setToolTip(tr("Open this panel"));
    docks_.push_back({dock, addWidget(button)});
    connect(button, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);
    connect(dock, &QDockWidget::visibilityChanged, this, &DockRail::showFolded);
    connect(dock->toggleViewAction(), &QAction::toggled, this, &DockRail::showFolded);
    showFolded();
}

void DockRail::setWanted(const QDockWidget* dock, bool on) {
    for (Folded& each : docks_) {
        if (each.dock == dock) each.wanted = on;
    }
    showFolded();
}

void DockRail::setLocked(bool on) {
    locked_ = on;
    showFolded();
}

void DockRail::showFolded() {
    bool any = false;
    for (const Folded& each : docks_) {
        const bool folded = each.wanted && each.dock->isHidden();
        each.place->setVisible(folded);
        any = any || folded;
    }
    setVisible(any && !locked_);
}

} // namespace edgescan::ui

#include "moc_dock_rail.cpp"
