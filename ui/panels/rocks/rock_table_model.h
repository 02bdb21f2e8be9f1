// The model of the table of rocks: one row per rock, and the filter of the shown rows.
#pragma once

#include "ui/panels/rocks/rock_picture.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <memory>

namespace edgescan::ui {

class RockTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// The role of the number for sorting and filtering.
    static constexpr int kNumberRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    /// Null: no rocks.
    void show(std::shared_ptr<const RockPicture> picture);
    [[nodiscard]] const std::shared_ptr<const RockPicture>& picture() const { return picture_; }
    /// Names that the operator gave, by the cell of their target.
    void setNames(const RockNames& names);
    /// Short heads. True: that is a change.
    bool setNarrow(bool on);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static QString briefly(const QString& head);
    [[nodiscard]] static QString inTwoLines(const QString& head);

    std::shared_ptr<const RockPicture> picture_;
    RockNames names_;
    bool narrow_ = false;
};

/// The rocks that are large and certain enough, in the order of a column.
class ShownRocks : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit ShownRocks(QObject* parent = nullptr);
    void setFilter(const RockFilter& filter);
    [[nodiscard]] const RockFilter& filter() const { return filter_; }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    RockFilter filter_;
};

/// The face of a rock as a small square, hatched if its outline is uncertain.
[[nodiscard]] QImage rockSwatch(const RockPicture& picture, const rocks::Rock& rock, int side);

} // namespace edgescan::ui
