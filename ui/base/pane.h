// A view with its title; a button there, or a double-click on the title, shows it alone.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace edgescan::ui {

class PaneNote;

class Pane : public QFrame {
    Q_OBJECT
public:
    Pane(const QString& title, QWidget* content, QWidget* parent = nullptr);

    /// Small text beside the title ("36,766 edges"); what has no room there is left out.
    void setNote(const QString& text);
    /// Small text at the right ("25 % of the points drawn"), where the note leaves it room.
    void setRemark(const QString& text);
    /// The button says which of both it would do.
    void showAlone(bool on);
    /// Without the title nothing but the content is left.
    void setTitled(bool on);
    [[nodiscard]] QWidget* content() const { return content_; }
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString note() const;
    [[nodiscard]] QString remark() const;
    [[nodiscard]] QToolButton* aloneButton() const { return alone_; }

signals:
    void maximiseWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    QWidget* bar_;
    QLabel* title_;
    PaneNote* note_;
    QLabel* remark_;
    QToolButton* alone_;
    QWidget* content_;
};

} // namespace edgescan::ui
