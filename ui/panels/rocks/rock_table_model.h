// One row per rock: the numbers behind the table, and which rows of it are shown.
#pragma once

#include "ui/panels/rocks/rock_picture.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <memory>

namespace edgescan::ui {

class RockTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// What sorting and filtering compare: a number.
    static constexpr int kNumberRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    /// Null: no rocks.
    void show(std::shared_ptr<const RockPicture> picture);
    [[nodiscard]] const std::shared_ptr<const RockPicture>& picture() const { return picture_; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const RockPicture> picture_;
};

/// The rocks that are large and sure enough, in the order of a column.
class ShownRocks : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit ShownRocks(QObject* parent = nullptr);
    /// Metres of the visible b.
    void setSmallest(double wideM);
    void setSureOnly(bool on);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    double smallestM_ = 0.0;
    bool sureOnly_ = false;
};

/// The face of a rock as a small square, hatched where its outline is doubtful.
[[nodiscard]] QImage rockSwatch(const RockPicture& picture, const Rock& rock, int side);

} // namespace edgescan::ui
