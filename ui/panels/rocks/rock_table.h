// The table of rocks and their size curve: sort by a column, leave out what is small or doubtful, jump to a rock.
#pragma once

#include "ui/panels/rocks/rock_table_model.h"

#include <QWidget>

#include <cstdint>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableView;

namespace edgescan::ui {

class SizeCurveView;

/// GUI thread only. Shows what it is told and says what the operator wants.
class RockTable : public QWidget {
    Q_OBJECT
public:
    explicit RockTable(QWidget* parent = nullptr);

    /// Null: no rocks. `remark`: how much of the scan they are of, and whether they are of the picture shown.
    void show(const std::shared_ptr<const RockPicture>& picture, const QString& remark);
    /// Labels. Tells nobody.
    void select(const std::vector<std::uint32_t>& labels);
    [[nodiscard]] std::vector<std::uint32_t> selected() const;

    [[nodiscard]] QTableView* table() const { return table_; }
    [[nodiscard]] QDoubleSpinBox* smallest() const { return smallest_; }
    [[nodiscard]] QCheckBox* sureOnly() const { return sureOnly_; }
    [[nodiscard]] QPushButton* exportButton() const { return export_; }
    [[nodiscard]] SizeCurveView* sizeCurve() const { return curve_; }
    [[nodiscard]] QString remark() const;

    [[nodiscard]] QSize sizeHint() const override { return {600, 234}; }

signals:
    /// The operator selected these rows; labels.
    void chosen(const std::vector<std::uint32_t>& labels);
    /// A double-click.
    void jumpWanted(std::uint32_t label);
    void exportWanted();

private:
    void tellCount();
    void tellChosen();
    void markOnCurve(const std::vector<std::uint32_t>& labels);

    RockTableModel* model_;
    ShownRocks* shown_;
    QTableView* table_;
    SizeCurveView* curve_;
    QDoubleSpinBox* smallest_;
    QCheckBox* sureOnly_;
    QPushButton* export_;
    QLabel* count_;
    QString remark_;
    bool showing_ = false;
};

} // namespace edgescan::ui
