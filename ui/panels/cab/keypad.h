// Keys on the screen for numbers, addresses and names, in cab mode: a glove cannot use a keyboard.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

class QDialog;
class QFileDialog;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. While it is on, keys open at the bottom of the screen for each field that gets the focus or is tapped, and close with
/// the focus, with their own key, with Escape and with the dialog. Enter goes to the next field of a dialog; in its last one it closes
/// them. A tap selects the text of a field of one line. The dialog of the field moves up, so that its buttons stay in sight, and back when
/// a key closes the keys or it is closed itself; one of files, whose keys come by a tap, opens above their place. The keys act on that
/// field like a keyboard and never take the focus.
class Keypad : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~Keypad() override;

    void setOn(bool on);
    [[nodiscard]] bool isVisible() const { return keys_ != nullptr && keys_->isVisible(); }
    [[nodiscard]] QRect place() const { return isVisible() ? keys_->geometry() : QRect(); }
    [[nodiscard]] QWidget* field() const { return field_; }
    /// The visible key with this text; null: there is none.
    [[nodiscard]] QToolButton* key(const QString& text) const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The keys were here: what was below them, or has their room now, is under the finger.
    void closedByKey(const QRect& place);

private:
    void openFor(QWidget& field);
    void close();
    void closeByKey();
    [[nodiscard]] QWidget* nextField() const;
    void dock();
    void openAbove(QFileDialog& files);
    [[nodiscard]] QRect usualPlace(const QWidget& window) const;
    static void makeRoom(QDialog& dialog, const QRect& place, const QRect& field);
    void giveBackRoom();
    void type(const QString& text);
    void press(int key, const QString& text = {});
    void showPage(bool letters);
    void setCapitals(bool on);
    void make(QWidget& window);
    void makeFor(QWidget& window);
    [[nodiscard]] QWidget* page(const char* name, const QStringList& rows, int size);

    QPointer<QWidget> field_;
    QPointer<QWidget> closedFor_; // a field whose keys were closed by their key
    QPointer<QWidget> keys_;      // a child of the field's window, which a modal dialog does not block
    QPointer<QWidget> moved_;     // a dialog that made room for the keys
    QRect before_;                // its place and size before that
    bool capitals_ = false;
    bool pressing_ = false;
};

} // namespace edgescan::ui
