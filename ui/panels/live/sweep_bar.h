// How much of a sweep has come, with a mark at each lost line.
#pragma once

#include <QWidget>

#include <vector>

namespace edgescan::ui {

/// GUI thread only.
class SweepBar : public QWidget {
    Q_OBJECT
public:
    explicit SweepBar(QWidget* parent = nullptr);

    /// `rows`: of the whole sweep; 0 (unknown) hides the bar.
    void showRows(int row, int rows, const std::vector<int>& lost);
    [[nodiscard]] double share() const { return rows_ > 0 ? static_cast<double>(row_) / rows_ : 0.0; }
    [[nodiscard]] const std::vector<int>& lost() const { return lost_; }
    [[nodiscard]] QSize sizeHint() const override { return {240, 12}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {40, 12}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int row_ = 0, rows_ = 0;
    std::vector<int> lost_;
};

} // namespace edgescan::ui
