// A view with its title; a double-click on the title shows it alone.
#pragma once

#include <QFrame>

class QLabel;

namespace edgescan::ui {

class Pane : public QFrame {
    Q_OBJECT
public:
    Pane(const QString& title, QWidget* content, QWidget* parent = nullptr);

    /// Small text at the right of the title ("drawn 1/4 of the points").
    void setRemark(const QString& text);
    [[nodiscard]] QWidget* content() const { return content_; }
    [[nodiscard]] QString title() const;

signals:
    void maximiseWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* title_;
    QLabel* remark_;
    QWidget* content_;
};

} // namespace edgescan::ui
