// The calibration card: question on the left, seam on the right, file and Apply below.
#include "ui/panels/dialogs/calibration_card.h"

#include "ui/base/shown_text.h"
#include "ui/base/two_pictures.h"
#include "ui/base/window_room.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QHideEvent>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kQuestionWidth = 390;

QLabel* plainWords(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

CalibrationCard::CalibrationCard(QWidget* parent)
    : QDialog(parent), scans_(new QListWidget), base_(plainWords("calibration-base")), start_(new QPushButton(tr("&Calibrate"))),
      progress_(new QProgressBar), verdict_(plainWords("calibration-verdict")), table_(new QTableWidget),
      about_(plainWords("calibration-about")), which_(new QComboBox), pictures_(new TwoPictures), saved_(plainWords("calibration-saved")) {
    setObjectName("calibration-card");
    setWindowTitle(tr("Calibrate the Mounting"));
    auto* row = new QHBoxLayout;
    row->addWidget(question());
    row->addWidget(answer_ = answer(), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    save_ = buttons->addButton(tr("&Save As…"), QDialogButtonBox::ActionRole);
    apply_ = buttons->addButton(tr("&Apply to This Scan"), QDialogButtonBox::ActionRole);
    save_->setObjectName("calibration-save");
    apply_->setObjectName("calibration-apply");
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(saved_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(save_, &QPushButton::clicked, this, &CalibrationCard::saveRequested);
    connect(apply_, &QPushButton::clicked, this, &CalibrationCard::applyRequested);
    connect(start_, &QPushButton::clicked, this, [this] {
        if (working_)
            emit givenUp();
        else
            emit startRequested();
    });
    connect(which_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CalibrationCard::showPicture);
    setWorking(false);
    forgetResult();
}

QWidget* CalibrationCard::question() {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    auto* help = plainWords("calibration-help");
    help->setText(
        tr("EdgeScan finds how the scanner is mounted on its stepper, from surfaces that one turn measures twice. Turn 200 degrees instead "
           "of 180 once per mounting; 360 degrees show more. Nothing is applied automatically."));
    column->addWidget(help);
    column->addWidget(new QLabel(tr("Scans with one mounting:")));
    scans_->setObjectName("calibration-scans");
    scans_->setMaximumHeight(84);
    column->addWidget(scans_);
    auto* files = new QHBoxLayout;
    auto* add = new QPushButton(tr("A&dd Scans…"));
    remove_ = new QPushButton(tr("&Remove"));
    auto* choose = new QPushButton(tr("Robot's &File…"));
    choose->setToolTip(tr("The robot's present calibration: only its stepper is replaced"));
    for (QPushButton* each : {add, remove_, choose}) files->addWidget(each);
    column->addLayout(files);
    column->addWidget(base_);
    start_->setObjectName("calibration-start");
    start_->setDefault(true);
    column->addWidget(start_);
    column->addWidget(progress_);
    column->addWidget(verdict_);
    table_->setObjectName("calibration-table");
    table_->setColumnCount(3);
    table_->setHorizontalHeaderLabels({tr("error of the mounting"), tr("value"), tr("± 2 sd")});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    column->addWidget(table_, 1);
    column->addWidget(about_);
    column->addStretch(0);
    connect(add, &QPushButton::clicked, this, &CalibrationCard::addRequested);
    connect(choose, &QPushButton::clicked, this, &CalibrationCard::baseRequested);
    connect(remove_, &QPushButton::clicked, this, [this] { emit removeRequested(scans_->currentRow()); });
    // The scan on the screen stays in the list: its seam is drawn.
    connect(scans_, &QListWidget::currentRowChanged, remove_, [this](int row) { remove_->setEnabled(row > 0 && !working_); });
    auto* scroll = new QScrollArea;
    scroll->setWidget(side);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(kQuestionWidth);
    return scroll;
}

QWidget* CalibrationCard::answer() {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    which_->setObjectName("calibration-picture");
    column->addWidget(which_);
    column->addWidget(pictures_, 1);
    return side;
}

void CalibrationCard::setQuestion(const QStringList& scans, const QString& base) {
    scans_->clear();
    for (const QString& scan : scans) {
        auto* item = new QListWidgetItem(shownName(QFileInfo(scan).fileName(), 60), scans_);
        item->setToolTip(shownText(scan));
    }
    remove_->setEnabled(false);
    base_->setText(base.isEmpty() ? tr("Robot's file: none. The new file has the stepper only.")
                                  : tr("Robot's file: %1. Only its stepper is replaced.").arg(shownName(QFileInfo(base).fileName(), 60)));
    base_->setToolTip(base.isEmpty() ? QString() : shownText(base));
    forgetResult();
}

void CalibrationCard::forgetResult() {
    found_ = false;
    shown_.clear();
    which_->clear();
    which_->hide();
    pictures_->hide();
    pictures_->clear();
    table_->hide();
    verdict_->clear();
    about_->clear();
    setSaved({}, {});
    fit();
}

/// Enlarges the card when it has a picture.
void CalibrationCard::fit() {
    const bool some = !shown_.empty();
    answer_->setVisible(some);
    const QSize wanted = some ? QSize(1180, 690) : QSize(kQuestionWidth + 30, 400);
    resize(wanted.boundedTo(roomForDialog(*this)));
    fitIntoScreen(*this);
}

void CalibrationCard::setWorking(bool on) {
    working_ = on;
    start_->setText(on ? tr("S&top") : tr("&Calibrate"));
    progress_->setVisible(on);
}

void CalibrationCard::begin() {
    forgetResult();
    setWorking(true);
    progress_->setRange(0, 0);
    verdict_->setText(tr("working …"));
}

void CalibrationCard::showStage(const QString& stage, int percent) {
    if (!working_) return;
    progress_->setRange(0, 100);
    progress_->setValue(percent);
    verdict_->setText(stage + " …");
}

void CalibrationCard::showResult(const CalibrationShown& found) {
    setWorking(false);
    found_ = true;
    verdict_->setText("✓ " + found.verdict);
    about_->setText(found.about);
    table_->setRowCount(static_cast<int>(found.rows.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        for (int column = 0; column < 3; ++column) {
            auto* item = new QTableWidgetItem(found.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
            if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(row, column, item);
        }
    }
    table_->resizeRowsToContents();
    int high = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
    for (int row = 0; row < table_->rowCount(); ++row) high += table_->rowHeight(row);
    table_->setFixedHeight(high);
    table_->show();
    shown_ = found.pictures;
    for (const CalibrationPicture& each : shown_) which_->addItem(each.title);
    which_->setVisible(!shown_.empty());
    pictures_->setVisible(!shown_.empty());
    fit();
    setSaved({}, {});
}

void CalibrationCard::showPicture(int which) {
    if (which < 0 || which >= static_cast<int>(shown_.size())) return;
    const CalibrationPicture& each = shown_[static_cast<std::size_t>(which)];
    pictures_->showPair(each.before, each.beforeImage, each.after, each.afterImage, each.busiest);
}

void CalibrationCard::refuse(const QString& why) {
    setWorking(false);
    forgetResult();
    verdict_->setText("✕ " + why);
}

void CalibrationCard::setSaved(const QString& path, const QString& cannot) {
    save_->setEnabled(found_);
    apply_->setEnabled(found_ && !path.isEmpty() && cannot.isEmpty());
    saved_->setText(path.isEmpty() ? QString() : tr("Saved %1.").arg(shownText(path)) + (cannot.isEmpty() ? QString() : " " + cannot));
    apply_->setToolTip(!cannot.isEmpty() ? cannot
                       : path.isEmpty()  ? tr("Save the file first: a record names the file from which a place was computed")
                                         : tr("Opens the scan again with this file. Ctrl+Z undoes it."));
}

QString CalibrationCard::verdict() const { return verdict_->text(); }
QString CalibrationCard::about() const { return about_->text(); }

void CalibrationCard::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (working_ && !event->spontaneous()) emit givenUp();
}

} // namespace edgescan::ui

#include "moc_calibration_card.cpp"
