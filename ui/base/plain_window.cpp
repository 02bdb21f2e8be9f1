// Sets the locale, the labels and the wheel.
#include "ui/base/plain_window.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QScrollBar>

#include <clocale>

namespace edgescan::ui {
namespace {

/// Widgets whose value the wheel changes.
bool turnsWithTheWheel(const QObject* object) {
    if (qobject_cast<const QScrollBar*>(object) != nullptr) return false;
    return qobject_cast<const QAbstractSlider*>(object) != nullptr || qobject_cast<const QAbstractSpinBox*>(object) != nullptr ||
           qobject_cast<const QComboBox*>(object) != nullptr;
}

/// Tool tips and message boxes contain labels too.
class PlainWidgets : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() == QEvent::Polish) polish(object);
        if (event->type() != QEvent::Wheel || !turnsWithTheWheel(object) || static_cast<QWidget*>(object)->hasFocus())
            return QObject::eventFilter(object, event);
        event->ignore(); // the surrounding area scrolls instead
        return true;
    }

private:
    static void polish(QObject* object) {
        if (auto* label = qobject_cast<QLabel*>(object); label != nullptr && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
        // Qt would give the box the focus because of the wheel, before the wheel event reaches the box.
        if (!turnsWithTheWheel(object)) return;
        auto* box = static_cast<QWidget*>(object);
        if (box->focusPolicy() == Qt::WheelFocus) box->setFocusPolicy(Qt::StrongFocus);
    }
};

} // namespace

PlainWindow::PlainWindow() {
    // QApplication took the locale from the environment.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    static constexpr const char* kName = "plain-widgets";
    if (QApplication::instance()->findChild<QObject*>(kName) != nullptr) return;
    auto* widgets = new PlainWidgets(QApplication::instance());
    widgets->setObjectName(kName);
    QApplication::instance()->installEventFilter(widgets);
}

} // namespace edgescan::ui
