// The table of rocks and their size curve: sort by a column, hide small or uncertain rocks, jump to a rock.
#pragma once

#include "ui/panels/rocks/rock_table_model.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QBoxLayout;
class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableView;

namespace edgescan::ui {

class SizeCurveView;

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class RockTable : public QWidget {
    Q_OBJECT
public:
    explicit RockTable(QWidget* parent = nullptr);

    /// Null: no rocks. `remark`: the part of the scan that they cover, and whether they belong to the shown picture.
    void show(const std::shared_ptr<const RockPicture>& picture, const QString& remark);
    void setNames(const RockNames& names);
    /// Selects rows by label. Emits no signal.
    void select(const std::vector<std::uint32_t>& labels);
    [[nodiscard]] std::vector<std::uint32_t> selected() const;
    /// Labels of the shown rows in their order; nothing: all rocks in the order of their numbers.
    [[nodiscard]] std::optional<std::vector<std::uint32_t>> listed() const;

    /// Ends the filter: another scan begins without one.
    void showAll();
    [[nodiscard]] const RockFilter& filter() const { return shown_->filter(); }

    [[nodiscard]] QTableView* table() const { return table_; }
    [[nodiscard]] QTableView* numbers() const { return numbers_; }
    [[nodiscard]] QDoubleSpinBox* smallest() const { return smallest_; }
    [[nodiscard]] QCheckBox* sureOnly() const { return sureOnly_; }
    [[nodiscard]] SizeCurveView* sizeCurve() const { return curve_; }
    [[nodiscard]] QString remark() const;

    [[nodiscard]] QSize sizeHint() const override { return {600, 234}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 120}; }

signals:
    void filterChanged();
    /// The operator selected these rows; labels.
    void chosen(const std::vector<std::uint32_t>& labels);
    /// The operator double-clicked a row.
    void jumpRequested(std::uint32_t label);
    /// Right click on a row, with its position on the screen.
    void menuRequested(std::uint32_t label, const QPoint& position);
    /// `all`: also the rocks that are not shown, in the order of their numbers.
    void exportRequested(bool all);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] const rocks::Rock& rockAt(const QModelIndex& index) const;
    [[nodiscard]] std::uint32_t labelOf(const QModelIndex& index) const; // numbers have gaps
    void fitColumns();
    void connectNumbers();
    void placeNumbers();
    void showCount();
    void askWhichToExport();
    void emitChosen();
    void bringIntoSight();
    void markOnCurve(const std::vector<std::uint32_t>& labels);

    RockTableModel* model_;
    ShownRocks* shown_;
    QTableView* table_;
    QTableView* numbers_; ///< the first column, in sight while the others scroll
    SizeCurveView* curve_;
    QSplitter* sides_;
    QWidget* tools_;
    QBoxLayout* bar_;
    QDoubleSpinBox* smallest_;
    QCheckBox* sureOnly_;
    QPushButton* export_;
    QLabel* count_;
    QString remark_;
    bool showing_ = false;
};

} // namespace edgescan::ui
