// The columns of the table of rocks.
#include "ui/panels/rocks/rock_table_model.h"

#include "core/rocks/attributes/rock_columns.h"
#include "ui/base/shown_text.h"
#include "ui/panels/rocks/rock_colours.h"

#include <QPainter>
#include <QRegularExpression>

#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kSwatch = 14; // px

// The frame only names the coordinates, which the table does not show.
const std::vector<rocks::RockColumn>& columns() {
    static const std::vector<rocks::RockColumn> kShown = [] {
        std::vector<rocks::RockColumn> shown;
        for (const rocks::RockColumn& column : rocks::rockColumns(CoordinateFrame::Scanner)) {
            if (column.inWindow) shown.push_back(column);
        }
        return shown;
    }();
    return kShown;
}

/// The first rocks and the nearest are asked for first; of each other number the largest.
bool isCountedUp(const rocks::RockColumn& column) {
    return column.key == std::string_view("rock") || column.key == std::string_view("distance_m");
}

} // namespace

QImage rockSwatch(const RockPicture& picture, const rocks::Rock& rock, int side) {
    QImage image(side, side, QImage::Format_RGB32);
    const QColor colour = rockColour(picture.colours[rock.label]);
    image.fill(colour);
    if (!isDoubtful(rock)) return image;
    QPainter painter(&image);
    painter.fillRect(image.rect(), QBrush(colour.darker(300), Qt::BDiagPattern));
    return image;
}

void RockTableModel::show(std::shared_ptr<const RockPicture> picture) {
    beginResetModel();
    picture_ = std::move(picture);
    endResetModel();
}

void RockTableModel::setNames(const RockNames& names) {
    if (names == names_) return;
    names_ = names;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, 0));
}

int RockTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !picture_ ? 0 : static_cast<int>(picture_->study.rocks.size());
}

int RockTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(columns().size()); }

QVariant RockTableModel::data(const QModelIndex& index, int role) const {
    if (!picture_ || !index.isValid()) return {};
    const rocks::Rock& rock = picture_->study.rocks[static_cast<std::size_t>(index.row())];
    const rocks::RockColumn& column = columns()[static_cast<std::size_t>(index.column())];
    const QString name =
        index.column() == 0 && (role == Qt::DisplayRole || role == Qt::ToolTipRole) ? picture_->nameOf(rock.label, names_) : QString();
    if (role == Qt::ToolTipRole && index.column() == 0) {
        QStringList tip{name, partsText(rock), likelyText(rock)};
        tip.removeAll({});
        if (!tip.isEmpty()) return tip.join('\n');
    }
    const bool isMarked = index.column() == 0 && !rock.maybeOneWith.empty();
    if (role == Qt::DisplayRole)
        return shownText(column.text({&rock})) + (isMarked ? " ≈" : "") + (name.isEmpty() ? QString() : " " + name);
    if (role == kNumberRole) return rocks::sortingNumber(column.value({&rock}));
    if (role == Qt::TextAlignmentRole) return static_cast<int>(index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    if (role == Qt::DecorationRole && index.column() == 0) return rockSwatch(*picture_, rock, kSwatch);
    return {};
}

/// "size: visible width b [m]" as "b [m]": four columns of a narrow table are in sight. The tool tip has all of it.
QString RockTableModel::briefly(const QString& head) {
    static const QRegularExpression kLetter("^(?:(±) .*|.* (\\w)) (\\[[^\\]]+\\])$", QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch match = kLetter.match(head);
    return match.hasMatch() ? match.captured(1) + match.captured(2) + ' ' + match.captured(3) : head;
}

/// Broken in two at the blank nearest to its middle, so that the longest word decides how wide a column is.
QString RockTableModel::inTwoLines(const QString& head) {
    const auto middle = head.size() / 2;
    const auto before = head.lastIndexOf(' ', middle), after = head.indexOf(' ', middle);
    const auto at = before < 0 || (after >= 0 && after - middle < middle - before) ? after : before;
    return at < 0 ? head : QString(head).replace(at, 1, '\n');
}

bool RockTableModel::setNarrow(bool on) {
    if (std::exchange(narrow_, on) == on) return false;
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    return true;
}

QVariant RockTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const rocks::RockColumn& column = columns()[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return inTwoLines(narrow_ ? briefly(QObject::tr(column.title)) : QObject::tr(column.title));
    if (role == Qt::InitialSortOrderRole) return isCountedUp(column) ? Qt::AscendingOrder : Qt::DescendingOrder;
    if (role == Qt::ToolTipRole) return QObject::tr(column.title) + "\n" + QObject::tr(column.help);
    return {};
}

ShownRocks::ShownRocks(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(RockTableModel::kNumberRole); }

void ShownRocks::setFilter(const RockFilter& filter) {
    filter_ = filter;
    invalidateFilter();
}

bool ShownRocks::filterAcceptsRow(int row, const QModelIndex&) const {
    const auto& picture = static_cast<const RockTableModel*>(sourceModel())->picture();
    return filter_.shows(picture->study.rocks[static_cast<std::size_t>(row)]);
}

} // namespace edgescan::ui

#include "moc_rock_table_model.cpp"
