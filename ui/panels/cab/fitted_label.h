// Large letters that become smaller where the words would not fit.
#pragma once

#include <QLabel>

namespace edgescan::ui {

/// One line. Never asks for more width than it is given; letters shrink down to `leastPx`, and what does not fit even so stands in the tip.
class FittedLabel : public QLabel {
public:
    FittedLabel(int mostPx, int leastPx, QWidget* parent = nullptr);

    void showText(const QString& text);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    int mostPx_, leastPx_;
};

} // namespace edgescan::ui
