// Buttons for gloves: the tools, and the button that must be held for a second.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>

class QAction;

namespace edgescan::ui {

inline constexpr int kHoldMs = 1000;

/// A button that acts only after it was held for a second: for actions that a glove must not start by accident.
class HoldButton : public QToolButton {
    Q_OBJECT
public:
    explicit HoldButton(QWidget* parent = nullptr);

signals:
    void held();
    /// The operator released it too soon.
    void releasedEarly();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void tick();

    QElapsedTimer since_;
    QTimer tick_;
};

/// Large enough for gloves, with an icon and text below it.
void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word);
[[nodiscard]] QToolButton* gloveButton(const char* name, const char* sign, const QString& word);
/// Looks as this command of the desk, and does the same. `word`: shorter than its own.
[[nodiscard]] QToolButton* gloveButton(const char* name, QAction& command, const QString& word = {});

/// A small triangle: a tap opens a menu.
void showMenuSign(QToolButton& button);

} // namespace edgescan::ui
