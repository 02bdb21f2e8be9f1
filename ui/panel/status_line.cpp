// The status bar.
#include "ui/panel/status_line.h"

#include "core/depth/depth_settings.h"
#include "core/scan/placement.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kShowWorkAfterMs = 100;

QString number(double value, int decimals) { return QString::number(value, 'f', decimals); }

// Thousands apart, the same in every locale.
QString count(std::size_t n) { return QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(n)); }

QString rangeText(const Probe& probe) {
    if (probe.state == CellState::Valid) return QObject::tr("range %1 m").arg(number(probe.rangeMm / 1000.0, 3));
    if (probe.state == CellState::DeviceStatus) return QObject::tr("device status %1").arg(number(probe.rangeMm, 0));
    if (probe.state == CellState::NoReturn) return QObject::tr("no return");
    return QString::fromUtf8(cellStateName(probe.state)).replace('_', ' ');
}

} // namespace

QString probeText(const Probe& probe) {
    QString text = QObject::tr("line %1  beam %2").arg(probe.line).arg(probe.beam);
    if (!std::isnan(probe.beamDeg)) text += QObject::tr("  at %1° / %2°").arg(number(probe.lineDeg, 3), number(probe.beamDeg, 3));
    text += "  " + rangeText(probe) + QObject::tr("  gray %1").arg(probe.gray);
    if (probe.state == CellState::Valid) {
        text +=
            QObject::tr("  x %1  y %2  z %3 m").arg(number(probe.pointM.x(), 3), number(probe.pointM.y(), 3), number(probe.pointM.z(), 3));
    }
    if (probe.mineM)
        text +=
            QObject::tr("  N %1  E %2  El %3").arg(number(probe.mineM->y(), 3), number(probe.mineM->x(), 3), number(probe.mineM->z(), 3));
    else
        text += QObject::tr("  N –  E –  El –");
    if (!probe.edge) return text + QObject::tr("  not an edge");
    return text + (probe.kind == DepthEdge::None ? QObject::tr("  EDGE") : QObject::tr("  EDGE (%1)").arg(edgeClassName(probe.kind)));
}

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent), probe_(new QLabel), place_(new QLabel), counts_(new QLabel), time_(new QLabel), renderer_(new QLabel),
      work_(new QWidget), stage_(new QLabel), bar_(new QProgressBar) {
    probe_->setObjectName("probe");
    place_->setObjectName("place");
    counts_->setObjectName("counts");
    probe_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // A long probe must not push the window wider.
    probe_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* line = new QHBoxLayout(work_);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(stage_);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(true);
    bar_->setFixedWidth(140);
    line->addWidget(bar_);
    auto* cancel = new QPushButton(tr("Cancel (Esc)"));
    connect(cancel, &QPushButton::clicked, this, &StatusLine::cancelWanted);
    line->addWidget(cancel);
    work_->hide();
    untilWorkIsShown_.setSingleShot(true);
    untilWorkIsShown_.setInterval(kShowWorkAfterMs);
    connect(&untilWorkIsShown_, &QTimer::timeout, this, [this] { showProgress(QString(), 0.0); });
    addWidget(work_);
    addWidget(probe_, 1);
    for (QLabel* label : {place_, counts_, time_, renderer_}) addPermanentWidget(label);
}

void StatusLine::showProbe(const std::optional<Probe>& probe) {
    probe_->setText(probe ? probeText(*probe) : QString());
    probe_->setToolTip(probe_->text()); // in a narrow window the end is cut off
}

void StatusLine::showPlace(const Scan& scan) {
    if (!scan.placement) {
        place_->setText(tr("scanner frame"));
        place_->setToolTip(tr("Without a pose nothing is known of the mine grid: coordinates count from the scanner."));
        return;
    }
    const Placement& place = *scan.placement;
    QString text = tr("mine grid");
    if (!place.grid.empty()) text += " " + QString::fromStdString(place.grid);
    text += tr(" · origin E %1 N %2 El %3")
                .arg(number(place.originEnhM.x(), 0), number(place.originEnhM.y(), 0), number(place.originEnhM.z(), 0));
    if (place.outOfSpec) text += tr(" · OUT OF SPEC");
    place_->setText(text);
    QStringList about{tr("Placed by %1").arg(QString::fromStdString(place.source))};
    for (const std::string& warning : place.warnings) about << QString::fromStdString(warning);
    place_->setToolTip(about.join("\n"));
}

void StatusLine::showCounts(const Detection& detection) {
    const auto cells = countCells(*detection.scan);
    const auto of = [&](CellState state) { return cells[static_cast<std::size_t>(state)]; };
    QString text = tr("%1 points · %2 edges · %3 no return")
                       .arg(count(of(CellState::Valid)), count(detection.edges->size()), count(of(CellState::NoReturn)));
    if (of(CellState::DeviceStatus) > 0) text += tr(" · %1 status").arg(count(of(CellState::DeviceStatus)));
    for (const CellState state : {CellState::OutOfWindow, CellState::Masked, CellState::Lost}) {
        if (of(state) > 0) text += QString(" · %1 %2").arg(count(of(state)), QString(cellStateName(state)).replace('_', ' '));
    }
    counts_->setText(text);
}

void StatusLine::showTime(double milliseconds) { time_->setText(tr("%1 ms").arg(number(milliseconds, 1))); }

void StatusLine::showRenderer(const QString& name) {
    renderer_->setText(name.section(' ', 0, 0));
    renderer_->setToolTip(name);
}

void StatusLine::startWork(const QString& title) {
    workTitle_ = title;
    untilWorkIsShown_.start();
}

void StatusLine::showProgress(const QString& stage, double fraction) {
    if (untilWorkIsShown_.isActive()) return;
    stage_->setText(stage.isEmpty() ? workTitle_ : workTitle_ + ": " + stage);
    bar_->setValue(static_cast<int>(std::lround(fraction * 1000)));
    work_->show();
}

void StatusLine::endWork() {
    untilWorkIsShown_.stop();
    work_->hide();
}

QString StatusLine::probeShown() const { return probe_->text(); }
QString StatusLine::placeShown() const { return place_->text(); }
QString StatusLine::countsShown() const { return counts_->text(); }

} // namespace edgescan::ui
