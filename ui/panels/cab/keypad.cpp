// The keys on the screen.
#include "ui/panels/cab/keypad.h"

#include "ui/base/scrolled.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QFocusEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kKey = 56, kLowKey = 48, kKeyGap = 6, kKeyRim = 6; // px
constexpr int kLowScreen = 640;                                  // px: a lower screen has lower keys
const QString kBack = QStringLiteral("⌫"), kDone = QStringLiteral("↵"), kHide = QStringLiteral("▼"), kShift = QStringLiteral("⇧"),
              kBlank = QStringLiteral("␣"), kToLetters = QStringLiteral("a–z"), kToNumbers = QStringLiteral("123");
// A text that follows itself is one wide key.
const QStringList kNumberRows{"7 8 9 - / " + kBack, "4 5 6 . : " + kDone, "1 2 3 , ; " + kHide,
                              "0 0 0" + QString(" " + kBlank).repeated(2) + " " + kToLetters};
const QStringList kLetterRows{"q w e r t y u i o p", "a s d f g h j k l _", kShift + " z x c v b n m . " + kBack,
                              kToNumbers + " - :" + QString(" " + kBlank).repeated(5) + " " + kDone + " " + kHide};

QString nameOf(const QString& text) {
    if (text == kBack) return Keypad::tr("Delete the last letter");
    if (text == kDone) return Keypad::tr("Enter");
    if (text == kHide) return Keypad::tr("Close the keys");
    if (text == kShift) return Keypad::tr("Capital letter");
    return text == kBlank ? Keypad::tr("Space") : text;
}

/// The field that takes the letters; null: the widget takes none.
QWidget* fieldOf(QObject* focused) {
    if (auto* box = qobject_cast<QAbstractSpinBox*>(focused)) focused = box->findChild<QLineEdit*>();
    if (auto* line = qobject_cast<QLineEdit*>(focused)) return line->isReadOnly() || !line->isEnabled() ? nullptr : line;
    if (auto* text = qobject_cast<QPlainTextEdit*>(focused)) return text->isReadOnly() || !text->isEnabled() ? nullptr : text;
    return nullptr;
}

bool isNumber(const QWidget& field) {
    if (qobject_cast<QAbstractSpinBox*>(field.parentWidget()) != nullptr) return true;
    const auto* line = qobject_cast<const QLineEdit*>(&field);
    static const QRegularExpression number("^[0-9.:,; -]+$"); // an address and three numbers too
    if (line != nullptr && line->text().isEmpty()) return line->inputMethodHints().testFlag(Qt::ImhPreferNumbers);
    return line != nullptr && number.match(line->text()).hasMatch();
}

/// Its list needs the room of the keys, and the name of a new file is proposed.
bool isOfFiles(const QWidget& field) { return qobject_cast<const QFileDialog*>(field.window()) != nullptr; }

/// The window manager's frame. It comes after the field has the focus, and QWidget::frameGeometry() lacks it then.
QMargins rimOf(const QDialog& dialog) { return dialog.windowHandle() != nullptr ? dialog.windowHandle()->frameMargins() : QMargins(); }

QRect frameOf(const QDialog& dialog) { return dialog.geometry().marginsAdded(rimOf(dialog)); }

bool isBetween(const QDialog& dialog, const QRect& keys) {
    return frameOf(dialog).top() >= dialog.screen()->availableGeometry().top() && frameOf(dialog).bottom() < keys.top();
}

/// The next key replaces it: a finger can neither place the text cursor nor mark a part. Several lines stay as they are.
void selectWhole(QWidget& tapped) {
    auto* line = qobject_cast<QLineEdit*>(fieldOf(&tapped));
    if (line == nullptr) return;
    if (auto* box = qobject_cast<QAbstractSpinBox*>(line->parentWidget()))
        box->selectAll(); // without prefix and suffix
    else
        line->selectAll();
}

} // namespace

Keypad::~Keypad() { setOn(false); }

void Keypad::setOn(bool on) {
    qApp->removeEventFilter(this);
    if (on) qApp->installEventFilter(this);
    if (!on) close();
}

QWidget* Keypad::page(const char* name, const QStringList& rows, int size) {
    auto* made = new QWidget;
    made->setObjectName(name);
    auto* grid = new QGridLayout(made);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kKeyGap);
    for (int row = 0; row < rows.size(); ++row) {
        const QStringList texts = rows[row].split(' ');
        for (int column = 0, wide = 1; column < texts.size(); column += wide) {
            for (wide = 1; column + wide < texts.size() && texts[column + wide] == texts[column];) ++wide;
            auto* key = new QToolButton;
            key->setText(texts[column]);
            key->setAccessibleName(nameOf(texts[column]));
            key->setFocusPolicy(Qt::NoFocus);
            key->setFixedHeight(size);
            key->setMinimumWidth(wide * size + (wide - 1) * kKeyGap);
            key->setCheckable(texts[column] == kShift);
            key->setAutoRepeat(texts[column] == kBack);
            connect(key, &QToolButton::clicked, this, [this, key] { type(key->text()); });
            grid->addWidget(key, row, column, 1, wide);
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
        QWidget* field = fieldOf(watched);
        const bool comesBack = static_cast<QFocusEvent*>(event)->reason() == Qt::ActiveWindowFocusReason && field == closedFor_;
        if (field == nullptr)
            close();
        else if (!comesBack && !isOfFiles(*field)) // there the keys come by a tap
            openFor(*field);
    } else if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType()) {
        auto* pressed = static_cast<QWidget*>(watched);
        QWidget* field = fieldOf(pressed->objectName() == "qt_scrollarea_viewport" ? pressed->parentWidget() : pressed);
        if (field != nullptr && field->hasFocus()) openFor(*field); // closed by its key, and tapped again
    } else if (event->type() == QEvent::MouseButtonRelease && watched->isWidgetType()) {
        selectWhole(*static_cast<QWidget*>(watched));
    } else if ((event->type() == QEvent::Move || event->type() == QEvent::WindowActivate) && watched == moved_ && isVisible()) {
        if (frameOf(*qobject_cast<QDialog*>(watched)).top() < keys_->screen()->availableGeometry().top()) dock();
    } else if ((event->type() == QEvent::Show || event->type() == QEvent::WindowActivate) &&
               qobject_cast<QFileDialog*>(watched) != nullptr) {
        auto* files = static_cast<QFileDialog*>(watched); // it has its place a little later
        QMetaObject::invokeMethod(
            files, [this, files] { openAbove(*files); }, Qt::QueuedConnection);
    } else if (event->type() == QEvent::Hide && (watched == field_ || watched == moved_)) {
        close();
        if (watched == moved_) giveBackRoom(); // it opens again as it was
    } else if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape) close();
        // Enter ends the typing: the button that the dialog would press is in sight, and a tap away.
        if (pressing_ && key == Qt::Key_Return && qobject_cast<QDialog*>(watched) != nullptr) return true;
    }
    return false;
}

void Keypad::make(QWidget& window) {
    const int size = window.screen()->availableGeometry().height() < kLowScreen ? kLowKey : kKey;
    keys_ = new QWidget(&window, Qt::Tool | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus);
    keys_->setObjectName("keypad");
    keys_->setAttribute(Qt::WA_ShowWithoutActivating);
    keys_->setFocusPolicy(Qt::NoFocus);
    auto* pages = new QVBoxLayout(keys_);
    pages->setContentsMargins(kKeyRim, kKeyRim, kKeyRim, kKeyRim);
    pages->addWidget(page("keypad-numbers", kNumberRows, size));
    pages->addWidget(page("keypad-letters", kLetterRows, size));
}

void Keypad::makeFor(QWidget& window) {
    if (keys_ != nullptr && keys_->parentWidget() == &window) return;
    if (keys_ != nullptr) keys_->deleteLater();
    make(window);
}

void Keypad::openFor(QWidget& field) {
    closedFor_ = nullptr;
    if (field_ == &field && isVisible()) return keys_->raise();
    field_ = &field;
    makeFor(*field.window());
    setCapitals(false);
    showPage(!isNumber(field));
    keys_->show();
    QMetaObject::invokeMethod(keys_, &QWidget::raise, Qt::QueuedConnection); // a dialog raises itself after it got the focus
}

/// The keys of a dialog of files come when the operator has seen its buttons: it opens where it is not in their way. It moved when they
/// came, and Cancel was then where Save had been.
void Keypad::openAbove(QFileDialog& files) {
    if (!files.isVisible()) return;
    makeFor(files);
    showPage(true);
    if (!isBetween(files, usualPlace(files))) makeRoom(files, usualPlace(files), QRect());
}

/// At the bottom of the screen of `window`, in its middle.
QRect Keypad::usualPlace(const QWidget& window) const {
    const QRect room = window.screen()->availableGeometry();
    QRect place(QPoint(), keys_->size());
    place.moveCenter(room.center());
    place.moveBottom(room.bottom());
    return place;
}

/// The dialog goes above the keys at `place`, as high as the room there if it can be. If it is too high for that, it stays on the screen,
/// as far from the screen's upper or lower end as its `field` (on the screen) needs.
void Keypad::makeRoom(QDialog& dialog, const QRect& place, const QRect& field) {
    const QRect room = dialog.screen()->availableGeometry();
    const QMargins rim = rimOf(dialog);
    const int around = rim.top() + rim.bottom();
    const int high =
        std::clamp(place.top() - room.top() - around, std::min(dialog.minimumSizeHint().height(), dialog.height()), dialog.height());
    const int height = high + around, before = frameOf(dialog).top();
    int top = std::max(room.top(), place.top() - height);
    if (top + height > place.top()) {
        const QRect moved = field.translated(0, top - before);
        const int lowest = std::max(room.top(), room.bottom() + 1 - height);
        if (moved.bottom() >= place.top()) top = std::clamp(top + room.top() + place.height() + kKeyGap - moved.top(), room.top(), lowest);
    }
    dialog.setGeometry(dialog.geometry().left(), top + rim.top(), dialog.width(), high);
}

/// At the bottom of the screen, or at its top if the field is there. A dialog moves above the keys.
void Keypad::dock() {
    const auto edit = [this] { return QRect(field_->mapToGlobal(QPoint()), field_->size()); };
    QRect place = usualPlace(*field_);
    auto* dialog = qobject_cast<QDialog*>(field_->window());
    if (dialog != nullptr && !isBetween(*dialog, place)) {
        if (std::exchange(moved_, dialog) != dialog) before_ = dialog->geometry();
        makeRoom(*dialog, place, edit());
    }
    scrollTo(*field_);
    if (place.intersects(edit())) place.moveTop(field_->screen()->availableGeometry().top());
    keys_->move(place.topLeft());
}

void Keypad::close() {
    field_ = nullptr;
    if (keys_ != nullptr) keys_->hide();
}

void Keypad::closeByKey() {
    const QRect were = place();
    QWidget* closed = field_;
    close();
    closedFor_ = closed;
    giveBackRoom();
    emit closedByKey(were);
}

/// Only after a key closed them, or the dialog is hidden: it must not move under a finger that taps its button.
void Keypad::giveBackRoom() {
    if (moved_ != nullptr) moved_->setGeometry(before_);
    moved_ = nullptr;
}

void Keypad::showPage(bool letters) {
    keys_->findChild<QWidget*>("keypad-numbers")->setVisible(!letters);
    keys_->findChild<QWidget*>("keypad-letters")->setVisible(letters);
    keys_->layout()->activate();
    keys_->resize(keys_->sizeHint());
    if (field_ != nullptr) dock();
}

/// For the next letter.
void Keypad::setCapitals(bool on) {
    capitals_ = on;
    for (auto* each : keys_->findChild<QWidget*>("keypad-letters")->findChildren<QToolButton*>()) {
        if (each->text() == kShift) each->setChecked(on);
        if (each->text().size() == 1 && each->text()[0].isLetter()) each->setText(on ? each->text().toUpper() : each->text().toLower());
    }
}

void Keypad::type(const QString& text) {
    if (text == kToLetters || text == kToNumbers) return showPage(text == kToLetters);
    if (text == kShift) return setCapitals(!capitals_);
    if (text == kHide) return closeByKey();
    if (field_ == nullptr) return;
    if (text == kBack) return press(Qt::Key_Backspace);
    if (text == kBlank) return press(Qt::Key_Space, " ");
    if (text != kDone) {
        press(text[0].toUpper().unicode(), text);
        if (capitals_ && text[0].isLetter()) setCapitals(false);
        return;
    }
    const bool lines = qobject_cast<QPlainTextEdit*>(field_) != nullptr;
    press(Qt::Key_Return, lines ? "\n" : QString());
    if (lines || field_ == nullptr) return;
    QWidget* next = nextField();
    next != nullptr ? next->setFocus(Qt::TabFocusReason) : closeByKey();
}

/// The one below in its dialog; null: it is the last one.
QWidget* Keypad::nextField() const {
    if (qobject_cast<QDialog*>(field_->window()) == nullptr) return nullptr;
    for (QWidget* at = field_->nextInFocusChain(); at != field_->window() && at != field_; at = at->nextInFocusChain()) {
        QWidget* field = fieldOf(at);
        if (field != nullptr && field != field_ && at->isVisible() && (at->focusPolicy() & Qt::TabFocus) != 0) return at;
    }
    return nullptr;
}

/// A number box reads the keys itself.
void Keypad::press(int key, const QString& text) {
    QPointer<QWidget> to = qobject_cast<QAbstractSpinBox*>(field_->parentWidget()) != nullptr ? field_->parentWidget() : field_.data();
    pressing_ = true;
    for (const QEvent::Type what : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(what, key, Qt::NoModifier, text);
        if (to != nullptr) QApplication::sendEvent(to, &event); // the first may close the window of the field
    }
    pressing_ = false;
}

} // namespace edgescan::ui

#include "moc_keypad.cpp"
