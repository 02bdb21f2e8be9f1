// A button for a narrow panel.
#pragma once

#include <QPushButton>

#include <algorithm>

namespace edgescan::ui {

/// Hardly wider than its text, in each font.
class NarrowButton : public QPushButton {
public:
    using QPushButton::QPushButton;
    [[nodiscard]] QSize sizeHint() const override {
        constexpr int kLeast = 48, kAroundText = 16; // px
        const int words = fontMetrics().size(Qt::TextShowMnemonic, text()).width();
        return {std::max(kLeast, words + kAroundText), QPushButton::sizeHint().height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace edgescan::ui
