// The bar of tools.
#include "ui/main/tool_bar.h"

#include <QAction>
#include <QLabel>
#include <QStringList>
#include <QToolButton>

namespace edgescan::ui {

ToolBar::ToolBar(QWidget* parent) : QToolBar(parent), words_(new QLabel), wordsPlace_(nullptr) {
    setObjectName("tools");
    setWindowTitle(tr("Tools"));
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    words_->setObjectName("tool-words");
    words_->setContentsMargins(12, 0, 0, 0);
    // The last in the bar: where there is no room it goes before a button does.
    words_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    wordsPlace_ = addWidget(words_);
}

void ToolBar::add(QAction& action) {
    insertAction(wordsPlace_, &action);
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(&action))) {
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the view
        button->setText(action.text().remove('&'));
    }
}

void ToolBar::addGap() { insertSeparator(wordsPlace_); }

void ToolBar::showAsked(const QString& words) {
    asked_ = words;
    showWords();
}

void ToolBar::showSelected(const QString& words) {
    selected_ = words;
    showWords();
}

void ToolBar::showWords() {
    words_->setText(shown());
    words_->setToolTip(shown());
}

QString ToolBar::shown() const {
    QStringList all{asked_, selected_};
    all.removeAll(QString());
    return all.join(" · ");
}

} // namespace edgescan::ui
