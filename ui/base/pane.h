// A view with its title, which has a line while the keys go to the view by Tab. A button in the title bar shows this view alone; a
// double-click on the title exchanges it with the cloud.
#pragma once

#include <QFrame>

class QAction;
class QLabel;
class QToolButton;

namespace edgescan::ui {

class PaneNote;

class Pane : public QFrame {
    Q_OBJECT
public:
    Pane(const QString& title, QWidget* content, QWidget* parent = nullptr);

    /// Small text after the title ("36,766 edges"); facts that do not fit are left out.
    void setNote(const QString& text);
    /// Small text at the right ("25 % of the points drawn"), if the note leaves space.
    void setRemark(const QString& text);
    /// A button for it in the title row, before the one that shows this view alone.
    void add(QAction& action, const char* icon);
    /// Sets the button to the action that it would do next.
    void showAlone(bool on);
    /// Without the title only the content is visible.
    void setTitled(bool on);
    [[nodiscard]] QWidget* content() const { return content_; }
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString note() const;
    [[nodiscard]] QString remark() const;
    [[nodiscard]] QToolButton* aloneButton() const { return alone_; }

signals:
    void maximiseRequested();
    void swapRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    void fitButtons();

    QWidget* bar_;
    QLabel* title_;
    PaneNote* note_;
    QLabel* remark_;
    QToolButton* alone_;
    QWidget* content_;
    bool focused_ = false; // by a key
};

} // namespace edgescan::ui
