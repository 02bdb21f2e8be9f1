// The dialog before an export.
#include "ui/panels/dialogs/export_dialog.h"

#include "core/base/number_text.h"
#include "core/exports/written_coordinates.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kMargins = 64;        // px, with the title bar of the window
constexpr int kBetweenContents = 3; // px
constexpr int kWords = 400;         // px: width of the questions for the reading program

} // namespace

ExportDialog::ExportDialog(std::shared_ptr<const edges::Detection> detection, exports::ExportContent wanted, ExportSelection selected,
                           QWidget* parent)
    : QDialog(parent), detection_(std::move(detection)), contents_(new QButtonGroup(this)), coordinates_(new QButtonGroup(this)),
      selected_(std::move(selected)), format_(new QComboBox), picture_(new QLabel(tr("PNG picture (*.png)"))), onlySelected_(new QCheckBox),
      attached_(new QCheckBox), count_(new QLabel), numbers_(new QLabel), frameHint_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel)) {
    auto* questions = new QWidget; // scrolls on a low screen: squeezed widgets would be unreadable
    auto* column = new QVBoxLayout(questions);
    column->addWidget(contentBox());
    column->addLayout(formatRow());
    coordinatesGroup_ = coordinatesBox();
    column->addWidget(coordinatesGroup_);
    more_ = new QToolButton;
    setObjectName("export-dialog");
    more_->setObjectName("for-program");
    more_->setText(tr("For the program that will read it"));
    more_->setCheckable(true);
    more_->setAutoRaise(true);
    more_->setArrowType(Qt::RightArrow);
    more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    column->addWidget(more_);
    writingGroup_ = writingBox();
    writingGroup_->hide();
    column->addWidget(writingGroup_);
    connect(more_, &QToolButton::toggled, this, [this](bool on) {
        more_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        writingGroup_->setVisible(on);
        fit();
    });
    onlySelected_->setObjectName("onlySelected");
    onlySelected_->setText(tr("Only what is selected (%1 cells)").arg(countText(selected_.cells ? selected_.cells->size() : 0)));
    onlySelected_->setVisible(selected_.cells != nullptr);
    onlySelected_->setChecked(selected_.cells != nullptr && selected_.only);
    column->addWidget(onlySelected_);
    const std::size_t hidden = detection_->scan->attached.size();
    attached_->setObjectName("attached");
    attached_->setText(tr("Also the points that lie behind the nearest of their cell (%1 in the scan)").arg(countText(hidden)));
    attached_->setVisible(hidden > 0);
    column->addWidget(attached_);
    column->addStretch(1);
    showCounts();
    count_->setObjectName("count");
    numbers_->setObjectName("numbers");
    numbers_->setWordWrap(true);
    numbers_->setMinimumHeight(3 * numbers_->fontMetrics().lineSpacing()); // the buttons do not move with the sentence
    numbers_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* whole = new QVBoxLayout(this);
    area_ = scrolled(*questions);
    whole->addWidget(area_, 1);
    whole->addWidget(count_);
    whole->addWidget(numbers_);
    whole->addWidget(buttons_);
    buttons_->button(QDialogButtonBox::Save)->setText(tr("Choose File…"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (const QButtonGroup* group : {contents_, coordinates_}) {
        for (QAbstractButton* button : group->buttons()) connect(button, &QAbstractButton::toggled, this, &ExportDialog::follow);
    }
    connect(format_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        wantedFormat_ = format_->itemData(index).toString();
        follow();
    });
    for (const QCheckBox* box : {attached_, onlySelected_}) connect(box, &QCheckBox::toggled, this, &ExportDialog::follow);
    contents_->button(static_cast<int>(wanted))->setChecked(true);
    follow();
}

/// Its questions are known now, and have their fonts.
void ExportDialog::showEvent(QShowEvent* event) {
    fit();
    QDialog::showEvent(event);
}

/// As large as all questions, as far as the screen allows.
void ExportDialog::fit() {
    const QLayout& questions = *area_->widget()->layout();
    const int wide = area_->minimumWidth() + kMargins;
    // Without a wrapped text a layout has no height for a width.
    const int high = std::max(questions.heightForWidth(wide), questions.sizeHint().height());
    const QMargins around = layout()->contentsMargins();
    const int between = around.top() + around.bottom() + 3 * layout()->spacing();
    const int sentence = std::max(numbers_->minimumHeight(), numbers_->heightForWidth(wide - around.left() - around.right()));
    resize(QSize(wide, high + count_->sizeHint().height() + sentence + buttons_->sizeHint().height() + between)
               .boundedTo(QGuiApplication::primaryScreen()->availableSize() - QSize(0, kMargins)));
}

QGroupBox* ExportDialog::contentBox() {
    auto* box = new QGroupBox(tr("What"));
    auto* column = new QVBoxLayout(box);
    column->setSpacing(kBetweenContents);
    for (const bool pictures : {false, true}) { // what is asked for less comes last
        for (const exports::ExportKind& kind : exports::exportKinds()) {
            if (kind.window.title == nullptr || (kind.holds == exports::ExportKind::Holds::Picture) != pictures) continue;
            auto* button = new QRadioButton;
            button->setObjectName(kind.key);
            contents_->addButton(button, static_cast<int>(kind.content));
            button->setEnabled(kind.content != exports::ExportContent::Targets); // until they are offered
            column->addWidget(button);
        }
    }
    return box;
}

QLayout* ExportDialog::formatRow() {
    auto* row = new QHBoxLayout;
    auto* name = new QLabel(tr("Format"));
    name->setBuddy(format_);
    format_->setObjectName("format");
    format_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row->addWidget(name);
    row->addWidget(format_, 1);
    row->addWidget(picture_, 1);
    return row;
}

void ExportDialog::offerFormats(const std::vector<Format>& formats, const QString& wanted) {
    formats_ = formats;
    wantedFormat_ = wanted;
    for (const Format& format : formats) format_->addItem(format.filter, format.extension);
    follow();
    fit();
}

bool ExportDialog::canHold(const Format& format) const {
    const exports::ExportKind& kind = exports::exportKind(content());
    if (exports::isCloud(kind.content)) return !format.drawsEdges || kind.counts == exports::ExportKind::Counts::EdgePoints;
    return std::ranges::any_of(kind.files, [&](const exports::ExportFile& file) { return format.extension == file.extension; });
}

QStringList ExportDialog::filters() const {
    if (isPicture()) return {picture_->text()};
    QStringList filters;
    for (const Format& format : formats_) {
        if (canHold(format)) filters << format.filter;
    }
    return filters;
}

/// A format that cannot hold the content is off in the list; the one that was chosen comes back with its content.
void ExportDialog::followFormat() {
    int shown = -1;
    for (int n = 0; n < format_->count(); ++n) {
        const Format& format = formats_[static_cast<std::size_t>(n)];
        const bool can = canHold(format);
        format_->setItemData(n, can ? QVariant() : QVariant(0), Qt::UserRole - 1); // flags of the item: 0 = off
        format_->setItemData(n,
                             can                 ? QVariant()
                             : format.drawsEdges ? tr("It draws edge lines: choose the edge points above.")
                                                 : tr("Targets are written as a table or a drawing."),
                             Qt::ToolTipRole);
        if (can && (shown < 0 || format.extension == wantedFormat_)) shown = n;
    }
    if (shown >= 0) format_->setCurrentIndex(shown);
}

void ExportDialog::offerTargets(std::size_t count) {
    targets_ = count;
    contents_->button(static_cast<int>(exports::ExportContent::Targets))->setEnabled(count > 0);
    follow();
}

bool ExportDialog::isPicture() const { return exports::exportKind(content()).holds == exports::ExportKind::Holds::Picture; }

QString ExportDialog::extension() const { return isPicture() ? QStringLiteral(".png") : format_->currentData().toString(); }

QString ExportDialog::numbersText() const {
    if (isPicture()) return {};
    const Scan& scan = *detection_->scan;
    Eigen::AlignedBox3d box;
    if (scan.placement) box.extend(scan.placement->originEnhM);
    const auto written = exports::coordinatesOf(content(), scan, "export" + exactBytes(extension()), options(), box);
    if (written.frame == CoordinateFrame::Scanner) return tr("The file holds x, y and z in metres from the scanner.");
    const auto origin = [&](int axis) { return shownText(shortestText((*written.originEnhM)[axis])); };
    if (written.frame == CoordinateFrame::MineLocal || !written.aboutOrigin.empty())
        return tr("The file holds metres from E %1, N %2, RL %3: a program that does not add these shows small numbers.")
            .arg(origin(0), origin(1), origin(2));
    const QString whole = tr("The file holds Easting, Northing and RL in metres.");
    QStringList rounding;
    for (const std::string& program : written.inFloats) rounding << shownText(program);
    const double stepM = exports::stepOfFloatsM(written.box);
    if (rounding.isEmpty() || stepM < exports::kLeastStepM) return whole;
    return whole + ' ' +
           tr("Choose local metres for %1: numbers of 4 bytes would round them to steps of %2 mm.")
               .arg(rounding.join(", "), shownText(fixedText(stepM * 1000, 0)));
}

/// What the numbers of the chosen coordinates count from in the chosen format, and where the origin is.
QString ExportDialog::frameHint(CoordinateFrame frame) const {
    if (frame == CoordinateFrame::Scanner) return tr("Numbers count from the scanner, along its own axes.");
    if (frame == CoordinateFrame::MineLocal)
        return tr(
            "Small numbers: metres east, north and up from an origin near the scan. To get mine coordinates, add the origin, which is in "
            "the header or in the record of the file.");
    exports::ExportOptions mine = options();
    mine.frame = CoordinateFrame::Mine;
    const auto written = exports::coordinatesOf(content(), *detection_->scan, "export" + exactBytes(extension()), mine, {});
    return written.aboutOrigin.empty()
               ? tr("Each point has its whole Easting, Northing and RL, as on the plans of the mine.") +
                     (extension() == ".csv" ? ' ' + tr("The column elevation_m is the RL.") : QString())
               : tr("The file holds metres from an origin near the scan, because %1 programs round mine coordinates. EdgeScan adds "
                    "the origin of the header when it opens the file; other programs show the small numbers.")
                     .arg(extension().mid(1).toUpper());
}

QGroupBox* ExportDialog::coordinatesBox() {
    auto* box = new QGroupBox(tr("Coordinates"));
    auto* column = new QVBoxLayout(box);
    const bool placed = detection_->scan->placement != nullptr;
    const auto add = [&](CoordinateFrame frame, const QString& text, const char* name, bool possible) {
        auto* button = new QRadioButton(text);
        button->setObjectName(name);
        button->setEnabled(possible);
        coordinates_->addButton(button, static_cast<int>(frame));
        column->addWidget(button);
    };
    add(CoordinateFrame::Mine, tr("Mine grid: Easting, Northing, RL"), "mine", placed);
    add(CoordinateFrame::MineLocal, tr("Local metres from an origin in the mine grid"), "local", placed);
    add(CoordinateFrame::Scanner, tr("Scanner frame, as measured"), "scanner", true);
    coordinates_->button(static_cast<int>(files::usualFrame(*detection_->scan)))->setChecked(true);
    frameHint_->setObjectName("frame-hint");
    frameHint_->setWordWrap(true);
    frameHint_->setMinimumHeight(3 * frameHint_->fontMetrics().lineSpacing()); // the boxes do not move with the sentence
    frameHint_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(frameHint_);
    if (const auto why = files::checkFrame(*detection_->scan, CoordinateFrame::Mine, ""); !why) {
        const std::string& what = why.error().what;
        auto* reason = new QLabel(tr("No mine grid: %1. Scan > Pose and Mounting takes a pose and a calibration.").arg(coreSentence(what)));
        reason->setObjectName("reason");
        reason->setWordWrap(true);
        column->addWidget(reason);
    }
    return box;
}

QGroupBox* ExportDialog::writingBox() {
    auto* box = new QGroupBox;
    auto* grid = new QGridLayout(box);
    grid->setColumnStretch(1, 1);
    for (const files::WritingChoice& choice : files::kWritingChoices) {
        auto* mark = new QCheckBox;
        mark->setObjectName(choice.key);
        auto* words = new QLabel(QObject::tr(choice.help));
        words->setWordWrap(true);
        words->setMinimumWidth(kWords);
        words->setBuddy(mark);
        mark->setAccessibleName(words->text());
        const int row = grid->rowCount();
        connect(mark, &QCheckBox::toggled, this, &ExportDialog::follow);
        grid->addWidget(mark, row, 0, Qt::AlignTop);
        grid->addWidget(words, row, 1);
        choices_.push_back(mark);
    }
    return box;
}

std::size_t ExportDialog::countOf(exports::ExportContent content, bool withAttached, bool onlySelected) const {
    const Scan& scan = *detection_->scan;
    if (content == exports::ExportContent::Targets) return targets_;
    if (!exports::isCloud(content)) return scan.cells();
    const bool edges = exports::exportKind(content).counts == exports::ExportKind::Counts::EdgePoints;
    const auto wanted = [&](std::size_t k) {
        return scan.state[k] == CellState::Valid && (!edges || (*detection_->mask)[k] != 0) &&
               (!onlySelected || std::ranges::binary_search(*selected_.cells, static_cast<std::uint32_t>(k)));
    };
    std::size_t points = 0;
    if (onlySelected)
        points = static_cast<std::size_t>(std::ranges::count_if(*selected_.cells, wanted));
    else if (edges)
        points = static_cast<std::size_t>(std::count_if(detection_->edges->begin(), detection_->edges->end(), wanted));
    else
        points = countCells(scan)[static_cast<std::size_t>(CellState::Valid)];
    if (fillsToo()) points += filledToo(edges, onlySelected);
    if (!withAttached) return points;
    return points + static_cast<std::size_t>(std::count_if(scan.attached.begin(), scan.attached.end(),
                                                           [&](const AttachedPoint& point) { return wanted(point.cell); }));
}

/// Checked, and the chosen format can have it.
bool ExportDialog::isWanted(std::size_t choice) const { return choices_[choice]->isChecked() && choices_[choice]->isEnabledTo(this); }

bool ExportDialog::fillsToo() const {
    for (std::size_t n = 0; n < choices_.size(); ++n) {
        if (files::kWritingChoices[n].member == &files::WritingChoices::filled) return isWanted(n);
    }
    return false;
}

/// Filled cells with coordinates. Filled cells of a cloud with unknown rays have no coordinates.
std::size_t ExportDialog::filledToo(bool edges, bool onlySelected) const {
    if (!filledCells_) {
        const ScanWithFilled whole = withFilled(*detection_->scan, *detection_->filled);
        filledCells_.emplace();
        for (const FilledCell& each : detection_->filled->cells) {
            if (whole.scan.state[each.cell] == CellState::Valid) filledCells_->push_back(each.cell);
        }
    }
    return static_cast<std::size_t>(std::ranges::count_if(*filledCells_, [&](std::uint32_t k) {
        return (!edges || (*detection_->mask)[k] != 0) && (!onlySelected || std::ranges::binary_search(*selected_.cells, k));
    }));
}

/// Each content with the number that would be saved of it, as the boxes below are checked.
void ExportDialog::showCounts() {
    const QString size = tr("%1 × %2 pixels").arg(detection_->scan->beams()).arg(detection_->scan->lines());
    const bool onlySelected = selected_.cells && onlySelected_->isChecked();
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        QAbstractButton* button = contents_->button(static_cast<int>(kind.content));
        if (button == nullptr) continue;
        const bool picture = kind.holds == exports::ExportKind::Holds::Picture;
        const QString counted = picture ? size : countText(countOf(kind.content, attached_->isChecked(), onlySelected));
        button->setText(QObject::tr(kind.window.title).arg(counted));
    }
}

exports::ExportContent ExportDialog::content() const { return static_cast<exports::ExportContent>(contents_->checkedId()); }

exports::ExportOptions ExportDialog::options() const {
    exports::ExportOptions options;
    options.frame = static_cast<CoordinateFrame>(coordinates_->checkedId());
    options.includeAttached = exports::isCloud(content()) && attached_->isChecked();
    if (exports::isCloud(content()) && onlySelected_->isChecked()) options.selection = selected_.cells;
    for (std::size_t n = 0; n < choices_.size(); ++n)
        options.choices.*files::kWritingChoices[n].member = exports::isCloud(content()) && isWanted(n);
    return options;
}

std::size_t ExportDialog::count() const { return countOf(content(), options().includeAttached, options().selection != nullptr); }

void ExportDialog::follow() {
    if (contents_->checkedId() < 0) return;
    setWindowTitle(tr("Export") + ": " + contents_->checkedButton()->text());
    const bool cloud = exports::isCloud(content());
    coordinatesGroup_->setEnabled(!isPicture());
    writingGroup_->setEnabled(cloud);
    more_->setEnabled(cloud);
    format_->setVisible(!isPicture() && format_->count() > 0);
    picture_->setVisible(isPicture());
    attached_->setEnabled(cloud);
    onlySelected_->setEnabled(cloud);
    followFormat();
    for (std::size_t n = 0; n < choices_.size(); ++n) {
        const files::WritingChoice& choice = files::kWritingChoices[n];
        const bool isForFilled = choice.member == &files::WritingChoices::filled;
        const bool fits = format_->count() == 0 || choice.changes(exactBytes(extension()));
        choices_[n]->setEnabled(fits && (!isForFilled || detection_->filled));
    }
    numbers_->setText(numbersText());
    frameHint_->setText(frameHint(options().frame));
    showCounts();
    const auto chosen = std::ranges::find(formats_, extension(), &Format::extension);
    const bool lines = cloud && chosen != formats_.end() && chosen->drawsEdges;
    const QString many = countText(count());
    const bool ofTargets = content() == exports::ExportContent::Targets;
    count_->setText(lines       ? tr("Lines through %1 edge points will be saved.").arg(many)
                    : cloud     ? tr("%1 points will be saved.").arg(many)
                    : ofTargets ? tr("%1 will be saved.").arg(targetCount(targets_))
                                : tr("%1 cells will be saved.").arg(many));
}

} // namespace edgescan::ui

#include "moc_export_dialog.cpp"
