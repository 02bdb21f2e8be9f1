// The keys on the screen.
#include "ui/panels/cab/keypad.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kKey = 56, kGap = 8, kRim = 8; // px
const QString kBack = QStringLiteral("⌫"), kDone = QStringLiteral("↵"), kToLetters = QStringLiteral("a–z"),
              kToNumbers = QStringLiteral("123");
const QStringList kNumberRows{"7 8 9 -", "4 5 6 .", "1 2 3 :", "0 " + kToLetters + " " + kBack + " " + kDone};
const QStringList kLetterRows{"1 2 3 4 5 6 7 8 9 0", "q w e r t y u i o p", "a s d f g h j k l _",
                              "z x c v b n m . - :", kToNumbers + " " + kBack + " " + kDone};

} // namespace

Keypad::~Keypad() { setOn(false); }

void Keypad::setOn(bool on) {
    qApp->removeEventFilter(this);
    if (on) qApp->installEventFilter(this);
    if (!on) close();
}

QWidget* Keypad::page(const char* name, const QStringList& rows) {
    auto* made = new QWidget;
    made->setObjectName(name);
    auto* grid = new QGridLayout(made);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGap);
    for (int row = 0; row < rows.size(); ++row) {
        const QStringList texts = rows[row].split(' ');
        for (int column = 0; column < texts.size(); ++column) {
            auto* key = new QToolButton;
            key->setText(texts[column]);
            key->setFocusPolicy(Qt::NoFocus);
            key->setMinimumSize(kKey, kKey);
            key->setAutoRepeat(texts[column] == kBack);
            connect(key, &QToolButton::clicked, this, [this, text = texts[column]] { type(text); });
            grid->addWidget(key, row, column);
        }
    }
    return made;
}

QToolButton* Keypad::key(const QString& text) const {
    if (keys_ == nullptr) return nullptr;
    for (auto* each : keys_->findChildren<QToolButton*>()) {
        if (each->text() == text && each->isVisible()) return each;
    }
    return nullptr;
}

bool Keypad::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn && watched->isWidgetType()) {
        auto* field = qobject_cast<QLineEdit*>(watched);
        if (auto* box = qobject_cast<QAbstractSpinBox*>(watched)) field = box->findChild<QLineEdit*>();
        field != nullptr && !field->isReadOnly() && field->isEnabled() ? openFor(*field) : close();
    } else if (event->type() == QEvent::Hide && watched == field_) {
        close();
    }
    return false;
}

/// Below the field where there is room, else above it.
void Keypad::openFor(QLineEdit& field) {
    if (field_ == &field && isVisible()) return;
    field_ = &field;
    if (keys_ == nullptr || keys_->parentWidget() != field.window()) {
        if (keys_ != nullptr) keys_->deleteLater();
        keys_ = new QWidget(field.window(), Qt::Tool | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus);
        keys_->setObjectName("keypad");
        keys_->setAttribute(Qt::WA_ShowWithoutActivating);
        keys_->setFocusPolicy(Qt::NoFocus);
        auto* pages = new QVBoxLayout(keys_);
        pages->setContentsMargins(kRim, kRim, kRim, kRim);
        pages->addWidget(page("keypad-numbers", kNumberRows));
        pages->addWidget(page("keypad-letters", kLetterRows));
    }
    showPage(qobject_cast<QAbstractSpinBox*>(field.parentWidget()) == nullptr);
    const QRect room = field.screen()->availableGeometry(), edit(field.mapToGlobal(QPoint()), field.size());
    const bool below = edit.bottom() + kGap + keys_->height() <= room.bottom();
    keys_->move(std::clamp(edit.left(), room.left(), std::max(room.left(), room.right() - keys_->width())),
                below ? edit.bottom() + kGap : std::max(room.top(), edit.top() - kGap - keys_->height()));
    keys_->show();
}

void Keypad::close() {
    field_ = nullptr;
    if (keys_ != nullptr) keys_->hide();
}

void Keypad::showPage(bool letters) {
    keys_->findChild<QWidget*>("keypad-numbers")->setVisible(!letters);
    keys_->findChild<QWidget*>("keypad-letters")->setVisible(letters);
    keys_->layout()->activate();
    keys_->resize(keys_->sizeHint());
}

void Keypad::type(const QString& text) {
    if (text == kToLetters || text == kToNumbers) return showPage(text == kToLetters);
    if (field_ == nullptr) return;
    if (text == kBack) return press(Qt::Key_Backspace);
    if (text == kDone) return press(Qt::Key_Return);
    press(text[0].toUpper().unicode(), text);
}

/// A number box reads the keys itself.
void Keypad::press(int key, const QString& text) {
    QPointer<QWidget> to = qobject_cast<QAbstractSpinBox*>(field_->parentWidget()) != nullptr ? field_->parentWidget() : field_.data();
    for (const QEvent::Type what : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(what, key, Qt::NoModifier, text);
        if (to != nullptr) QApplication::sendEvent(to, &event); // the first may close the window of the field
    }
}

} // namespace edgescan::ui

#include "moc_keypad.cpp"
