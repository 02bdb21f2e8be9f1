// Keys on the screen for numbers, addresses and names, in cab mode: a glove cannot use a keyboard.
#pragma once

#include <QLineEdit>
#include <QObject>
#include <QPointer>
#include <QWidget>

class QToolButton;

namespace edgescan::ui {

/// GUI thread only. While it is on, keys open below each field of one line that gets the focus, and close with the focus. They act on that
/// field like a keyboard and never take the focus.
class Keypad : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~Keypad() override;

    void setOn(bool on);
    [[nodiscard]] bool isVisible() const { return keys_ != nullptr && keys_->isVisible(); }
    [[nodiscard]] QLineEdit* field() const { return field_; }
    /// The visible key with this text; null: there is none.
    [[nodiscard]] QToolButton* key(const QString& text) const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void openFor(QLineEdit& field);
    void close();
    void type(const QString& text);
    void press(int key, const QString& text = {});
    void showPage(bool letters);
    [[nodiscard]] QWidget* page(const char* name, const QStringList& rows);

    QPointer<QLineEdit> field_;
    QPointer<QWidget> keys_; // a child of the field's window, which a modal dialog does not block
};

} // namespace edgescan::ui
