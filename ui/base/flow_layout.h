// Widgets side by side, in as many lines as the width needs: a row that never makes its window wider.
#pragma once

#include <QLayout>

#include <vector>

namespace edgescan::ui {

/// A widget that may grow (Expanding or Ignored) gets the rest of its line, and needs only a little of it.
class FlowLayout : public QLayout {
public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] QSize sizeHint() const override;
    void setGeometry(const QRect& rect) override;
    /// True if the layout is higher with this widget, shown or not, than with only the others that are shown.
    [[nodiscard]] bool isHigherWith(const QWidget& widget, int width) const;

private:
    struct Line {
        std::vector<QLayoutItem*> items;
        int width = 0, height = 0;
    };
    [[nodiscard]] std::vector<QLayoutItem*> shown() const;
    [[nodiscard]] std::vector<Line> lines(const std::vector<QLayoutItem*>& shown, int width) const;
    [[nodiscard]] std::vector<Line> lines(int width) const { return lines(shown(), width); }
    [[nodiscard]] int heightOf(const std::vector<QLayoutItem*>& shown, int width) const;
    [[nodiscard]] static int widthIn(const Line& line, QLayoutItem& item, int width);

    std::vector<QLayoutItem*> items_;
};

} // namespace edgescan::ui
