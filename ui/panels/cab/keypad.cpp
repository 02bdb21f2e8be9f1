// The keys on the screen.
#include "ui/panels/cab/keypad.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kKey = 56, kGap = 8, kRim = 8; // px
const QStringList kNumberRows{"7 8 9 -", "4 5 6 .", "1 2 3 :", "0 abc Del Enter"};
const QStringList kLetterRows{"1 2 3 4 5 6 7 8 9 0", "q w e r t y u i o p", "a s d f g h j k l _", "z x c v b n m . - :", "123 Del Enter"};

} // namespace

Keypad::Keypad(QWidget* window)
    : QWidget(window, Qt::Tool | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus), home_(window), numbers_(new QWidget),
      letters_(new QWidget) {
    setObjectName("keypad");
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
    auto* pages = new QVBoxLayout(this);
    pages->setContentsMargins(kRim, kRim, kRim, kRim);
    pages->addWidget(numbers_);
    pages->addWidget(letters_);
    addKeys();
    setLetters(false);
    hide();
}

Keypad::~Keypad() { setOn(false); }

void Keypad::addKeys() {
    for (const auto& [page, rows] : {std::pair{numbers_, kNumberRows}, {letters_, kLetterRows}}) {
        auto* grid = new QGridLayout(page);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setSpacing(kGap);
        for (int row = 0; row < rows.size(); ++row) {
            const QStringList texts = rows[row].split(' ');
            for (int column = 0; column < texts.size(); ++column) {
                auto* key = new QToolButton;
                key->setText(texts[column]);
                key->setObjectName("key-" + texts[column]);
                key->setFocusPolicy(Qt::NoFocus);
                key->setMinimumSize(kKey, kKey);
                key->setAutoRepeat(texts[column] == "Del");
                connect(key, &QToolButton::clicked, this, [this, text = texts[column]] { type(text); });
                grid->addWidget(key, row, column);
                keys_.push_back(key);
            }
        }
    }
}

QToolButton* Keypad::key(const QString& text) const {
    const auto found = std::ranges::find_if(keys_, [&](const QToolButton* each) { return each->text() == text && !each->isHidden(); });
    return found == keys_.end() ? nullptr : *found;
}

void Keypad::setOn(bool on) {
    qApp->removeEventFilter(this);
    if (on) qApp->installEventFilter(this);
    if (!on) close();
}

bool Keypad::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        auto* field = qobject_cast<QLineEdit*>(watched);
        if (auto* box = qobject_cast<QAbstractSpinBox*>(watched)) field = box->findChild<QLineEdit*>();
        if (field != nullptr && !field->isReadOnly() && field->isEnabled())
            openFor(*field);
        else if (qobject_cast<QWidget*>(watched) != nullptr)
            close();
    } else if (watched == field_ && (event->type() == QEvent::Hide || event->type() == QEvent::Destroy)) {
        close();
    }
    return false;
}

/// Below the field where there is room, else above it. A window that is modal reaches only its own children.
void Keypad::openFor(QLineEdit& field) {
    if (field_ == &field && isVisible()) return;
    field_ = &field;
    if (parentWidget() != field.window()) setParent(field.window(), windowFlags());
    setLetters(qobject_cast<QAbstractSpinBox*>(field.parentWidget()) == nullptr);
    const QScreen* screen = field.screen();
    const QRect room = screen->availableGeometry(), edit(field.mapToGlobal(QPoint()), field.size());
    const bool below = edit.bottom() + kGap + height() <= room.bottom();
    move(std::clamp(edit.left(), room.left(), std::max(room.left(), room.right() - width())),
         below ? edit.bottom() + kGap : std::max(room.top(), edit.top() - kGap - height()));
    show();
}

void Keypad::close() {
    field_ = nullptr;
    hide();
    if (parentWidget() != home_) setParent(home_, windowFlags()); // a dialog destroys its children
}

void Keypad::setLetters(bool on) {
    numbers_->setVisible(!on);
    letters_->setVisible(on);
    layout()->activate();
    resize(sizeHint());
}

void Keypad::type(const QString& text) {
    if (text == "abc" || text == "123") return setLetters(text == "abc");
    if (field_ == nullptr) return;
    if (text == "Del") return press(Qt::Key_Backspace);
    if (text == "Enter") return press(Qt::Key_Return);
    QKeyEvent down(QEvent::KeyPress, text[0].toUpper().unicode(), Qt::NoModifier, text),
        up(QEvent::KeyRelease, text[0].toUpper().unicode(), Qt::NoModifier, text);
    QApplication::sendEvent(field_, &down);
    if (field_ != nullptr) QApplication::sendEvent(field_, &up);
}

void Keypad::press(int key) {
    QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier), up(QEvent::KeyRelease, key, Qt::NoModifier);
    QApplication::sendEvent(field_, &down);
    if (field_ != nullptr) QApplication::sendEvent(field_, &up);
}

} // namespace edgescan::ui

#include "moc_keypad.cpp"
