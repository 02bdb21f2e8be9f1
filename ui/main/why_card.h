// A card beside the window that says why a cell is an edge, or why it is none.
#pragma once

#include <QDialog>

class QLabel;

namespace edgescan::ui {

class WhyCard : public QDialog {
    Q_OBJECT
public:
    explicit WhyCard(QWidget* parent);

    void tell(const QString& text);
    [[nodiscard]] QString text() const;

private:
    QLabel* text_;
};

} // namespace edgescan::ui
