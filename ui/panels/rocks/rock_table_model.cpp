// The columns of the table of rocks.
#include "ui/panels/rocks/rock_table_model.h"

#include "ui/panels/rocks/rock_colours.h"

#include <QPainter>

#include <array>
#include <cmath>
#include <limits>

namespace edgescan::ui {
namespace {

constexpr int kSwatch = 14; // px

// Rocks without a value come last in every order.
double orLast(const std::optional<double>& value) { return value.value_or(-1.0); }

QString fixed(double value, int decimals) { return QString::number(value, 'f', decimals); }
QString atLeast(double value, int decimals) { return value > 0.0 ? QStringLiteral("≥ ") + fixed(value, decimals) : QStringLiteral("–"); }

struct RockColumn {
    const char* title;
    const char* help;
    double (*number)(const rocks::Rock&);
    QString (*text)(const rocks::Rock&);
};

const std::array<RockColumn, 11>& columns() {
    static const std::array<RockColumn, 11> all{{
        {QT_TRANSLATE_NOOP("QObject", "Rock"), QT_TRANSLATE_NOOP("QObject", "The label: 1 is the largest visible area"),
         [](const rocks::Rock& r) { return static_cast<double>(r.label); }, [](const rocks::Rock& r) { return QString::number(r.label); }},
        {QT_TRANSLATE_NOOP("QObject", "a visible [m]"), QT_TRANSLATE_NOOP("QObject", "Largest visible span across the line of sight"),
         [](const rocks::Rock& r) { return r.longestCaliperM; }, [](const rocks::Rock& r) { return fixed(r.longestCaliperM, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "b visible [m]"), QT_TRANSLATE_NOOP("QObject", "Smallest visible span across the line of sight"),
         [](const rocks::Rock& r) { return r.shortestCaliperM; }, [](const rocks::Rock& r) { return fixed(r.shortestCaliperM, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "± [m]"),
         QT_TRANSLATE_NOOP("QObject", "Of a and b: spacing of the points and width of the beam, twice"),
         [](const rocks::Rock& r) { return r.toleranceM; }, [](const rocks::Rock& r) { return fixed(r.toleranceM, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "distance [m]"), QT_TRANSLATE_NOOP("QObject", "From the scanner: median of its ranges"),
         [](const rocks::Rock& r) { return r.distanceM; }, [](const rocks::Rock& r) { return fixed(r.distanceM, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "area [m²]"), QT_TRANSLATE_NOOP("QObject", "Visible area across the beams"),
         [](const rocks::Rock& r) { return r.areaM2; }, [](const rocks::Rock& r) { return fixed(r.areaM2, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "in front [%]"), QT_TRANSLATE_NOOP("QObject", "Share of its outline where it is the nearer side"),
         [](const rocks::Rock& r) { return r.unoccluded; }, [](const rocks::Rock& r) { return fixed(100.0 * r.unoccluded, 0); }},
        {QT_TRANSLATE_NOOP("QObject", "contacts (≥)"), QT_TRANSLATE_NOOP("QObject", "Rocks that it is seen to touch: at least these"),
         [](const rocks::Rock& r) { return static_cast<double>(r.contacts.size()); },
         [](const rocks::Rock& r) { return atLeast(static_cast<double>(r.contacts.size()), 0); }},
        {QT_TRANSLATE_NOOP("QObject", "free below [m]"),
         QT_TRANSLATE_NOOP("QObject", "Free height under its lowest visible point: at least this; what sent nothing back is never free"),
         [](const rocks::Rock& r) { return r.freeHeightM; }, [](const rocks::Rock& r) { return atLeast(r.freeHeightM, 2); }},
        {QT_TRANSLATE_NOOP("QObject", "arch [°] ± 25"),
         QT_TRANSLATE_NOOP("QObject", "Largest angle at it between two rocks that it touches; ↓: it hangs below the line between them"),
         [](const rocks::Rock& r) { return orLast(r.archDeg); },
         [](const rocks::Rock& r) {
             return r.archDeg ? fixed(*r.archDeg, 0) + (r.isBelowContacts ? QStringLiteral(" ↓") : QString()) : QStringLiteral("–");
         }},
        {QT_TRANSLATE_NOOP("QObject", "p"), QT_TRANSLATE_NOOP("QObject", "Chance that its outline is right; ▲ and hatched: below 0.85"),
         [](const rocks::Rock& r) { return r.confidence; },
         [](const rocks::Rock& r) { return (isDoubtful(r) ? QStringLiteral("▲ ") : QString()) + fixed(r.confidence, 2); }},
    }};
    return all;
}

constexpr int kWideColumn = 2;
constexpr int kConfidenceColumn = 10;

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

int RockTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !picture_ ? 0 : static_cast<int>(picture_->study.rocks.size());
}

int RockTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(columns().size()); }

QVariant RockTableModel::data(const QModelIndex& index, int role) const {
    if (!picture_ || !index.isValid()) return {};
    const rocks::Rock& rock = picture_->study.rocks[static_cast<std::size_t>(index.row())];
    const RockColumn& column = columns()[static_cast<std::size_t>(index.column())];
    if (role == Qt::DisplayRole) return column.text(rock);
    if (role == kNumberRole) return column.number(rock);
    if (role == Qt::TextAlignmentRole) return static_cast<int>(index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    if (role == Qt::DecorationRole && index.column() == 0) return rockSwatch(*picture_, rock, kSwatch);
    return {};
}

QVariant RockTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const RockColumn& column = columns()[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return QObject::tr(column.title);
    if (role == Qt::ToolTipRole) return QObject::tr(column.help);
    return {};
}

ShownRocks::ShownRocks(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(RockTableModel::kNumberRole); }

void ShownRocks::setSmallest(double wideM) {
    smallestM_ = wideM;
    invalidateFilter();
}

void ShownRocks::setSureOnly(bool on) {
    sureOnly_ = on;
    invalidateFilter();
}

bool ShownRocks::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto number = [&](int column) {
        return sourceModel()->data(sourceModel()->index(row, column, parent), RockTableModel::kNumberRole).toDouble();
    };
    return number(kWideColumn) >= smallestM_ && (!sureOnly_ || number(kConfidenceColumn) >= rocks::kSureConfidence);
}

} // namespace edgescan::ui

#include "moc_rock_table_model.cpp"
