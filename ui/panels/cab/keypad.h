// Keys on the screen for numbers, addresses and names, in cab mode: a glove cannot use a keyboard.
#pragma once

#include <QWidget>

#include <vector>

class QLineEdit;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. While it is on, it opens below each field of one line that gets the focus, and closes with the focus. Its keys act on
/// that field like a keyboard and never take the focus.
class Keypad : public QWidget {
    Q_OBJECT
public:
    explicit Keypad(QWidget* window);
    ~Keypad() override;

    void setOn(bool on);
    [[nodiscard]] QLineEdit* field() const { return field_; }
    /// The key with this text, "Del" or "Enter"; null: there is none.
    [[nodiscard]] QToolButton* key(const QString& text) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addKeys();
    void openFor(QLineEdit& field);
    void close();
    void type(const QString& text);
    void press(int key);
    void setLetters(bool on);

    QWidget* home_; // its parent while it is closed
    QLineEdit* field_ = nullptr;
    QWidget* numbers_;
    QWidget* letters_;
    std::vector<QToolButton*> keys_;
};

} // namespace edgescan::ui
