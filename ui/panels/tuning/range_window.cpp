// The histogram, and the two ends of the displayed range window.
#include "ui/panels/tuning/range_window.h"

#include "ui/base/themes.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kMargin = 10, kBars = 40, kTicks = 16; // px
constexpr std::size_t kSteps = 120;
constexpr double kReach = 8.0;  // px around an end where it can be grabbed
constexpr double kLeast = 0.01; // m between the two ends

double niceAbove(double metres) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(metres, 0.01))));
    for (const double times : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (times * power >= metres) return times * power;
    }
    return 10.0 * power;
}

} // namespace

RangeHistogram rangeHistogram(const Scan& scan) {
    constexpr std::size_t kFine = 20'000;
    float most = 0.0F;
    std::size_t valid = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        most = std::max(most, scan.rangeMm[k]);
        ++valid;
    }
    RangeHistogram histogram;
    histogram.counts.assign(kSteps, 0);
    if (valid == 0 || most <= 0.0F) return histogram;
    const auto fill = [&](std::vector<std::uint32_t>& counts, double mostMm) {
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] != CellState::Valid) continue;
            const double at = static_cast<double>(scan.rangeMm[k]) / mostMm * static_cast<double>(counts.size());
            ++counts[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(counts.size() - 1)))];
        }
    };
    // With stray returns far away the scale would have no space for all other ranges.
    std::vector<std::uint32_t> fine(kFine, 0);
    fill(fine, static_cast<double>(most));
    std::size_t last = kFine;
    for (std::size_t beyond = 0; last > 1 && beyond + fine[last - 1] <= valid / 1000; --last) beyond += fine[last - 1];
    histogram.mostM = niceAbove(static_cast<double>(most) * static_cast<double>(last) / static_cast<double>(kFine) / 1000.0);
    fill(histogram.counts, histogram.mostM * 1000.0);
    return histogram;
}

RangeHandles::RangeHandles(QWidget* parent) : QWidget(parent) {
    setObjectName("range-handles");
    setFixedHeight(kBars + kTicks + 6);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Ends of the range window"));
    setToolTip(tr("Drag an end, or Left and Right for the far one, with Shift for the near one; a double-click makes it automatic"));
}

void RangeHandles::showHistogram(RangeHistogram histogram) {
    histogram_ = std::move(histogram);
    update();
}

void RangeHandles::setWindow(Window window) {
    if (window == window_) return;
    window_ = window;
    update();
}

double RangeHandles::toX(double metres) const { return kMargin + metres / histogram_.mostM * (width() - 2.0 * kMargin); }

double RangeHandles::toMetres(double x) const { return (x - kMargin) / (width() - 2.0 * kMargin) * histogram_.mostM; }

void RangeHandles::moveEnd(bool far, double metres) {
    Window now = window_;
    if (far)
        now.second = std::clamp(metres, now.first + kLeast, std::max(histogram_.mostM, now.first + kLeast));
    else
        now.first = std::clamp(metres, 0.0, std::max(0.0, now.second - kLeast));
    if (now == window_) return;
    setWindow(now);
    emit dragged(now.first, now.second);
}

void RangeHandles::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isKnown()) return;
    const double x = event->pos().x();
    const double toNear = std::abs(toX(window_.first) - x), toFar = std::abs(toX(window_.second) - x);
    held_ = toFar <= toNear;
    if (std::min(toNear, toFar) > kReach) moveEnd(*held_, toMetres(x)); // the nearer end moves
}

void RangeHandles::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->pos().x();
    if (held_) return moveEnd(*held_, toMetres(x));
    const bool over = std::min(std::abs(toX(window_.first) - x), std::abs(toX(window_.second) - x)) <= kReach;
    setCursor(over ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void RangeHandles::mouseReleaseEvent(QMouseEvent* /*event*/) { held_.reset(); }

void RangeHandles::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    held_.reset();
    emit automaticRequested();
}

void RangeHandles::keyPressEvent(QKeyEvent* event) {
    const int way = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (way == 0 || !isKnown()) return QWidget::keyPressEvent(event);
    const bool far = !event->modifiers().testFlag(Qt::ShiftModifier);
    moveEnd(far, (far ? window_.second : window_.first) + way * histogram_.mostM / 100.0);
}

void RangeHandles::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = themeInUse();
    const double ground = kBars + 2.0, left = toX(0.0), right = toX(histogram_.mostM);
    const double nearX = std::clamp(toX(window_.first), left, right), farX = std::clamp(toX(window_.second), left, right);
    if (!histogram_.counts.empty()) {
        const auto most = static_cast<double>(std::max<std::uint32_t>(1, *std::ranges::max_element(histogram_.counts)));
        const double wide = (right - left) / static_cast<double>(histogram_.counts.size());
        for (std::size_t n = 0; n < histogram_.counts.size(); ++n) {
            // Drawn as square root, so that small counts are visible too.
            const double high = kBars * std::sqrt(static_cast<double>(histogram_.counts[n]) / most),
                         x = left + static_cast<double>(n) * wide;
            const bool inside = x + wide / 2 >= nearX && x + wide / 2 <= farX;
            painter.fillRect(QRectF(x, ground - high, std::max(1.0, wide - 0.5), high), inside ? theme.quietText : theme.edge);
        }
    }
    painter.setPen(theme.edge);
    painter.drawLine(QPointF(left, ground), QPointF(right, ground));
    if (!isKnown()) return;
    painter.setPen(theme.quietText);
    const double step = niceAbove(histogram_.mostM / 4.5);
    for (double metres = 0.0; metres <= histogram_.mostM * (1.0 + 1e-9); metres += step) {
        const bool last = metres + step > histogram_.mostM * (1.0 + 1e-9);
        const QString text = QString::number(metres, 'g', 3) + (last ? " m" : "");
        const double wide = painter.fontMetrics().horizontalAdvance(text);
        const double x = std::clamp(toX(metres) - wide / 2, 0.0, width() - wide);
        painter.drawText(QRectF(x, ground + 2, wide + 1, kTicks), Qt::AlignLeft | Qt::AlignVCenter, text);
    }
    for (const double x : {nearX, farX}) {
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawLine(QPointF(x, 2), QPointF(x, ground));
        painter.setBrush(theme.accent);
        painter.drawRoundedRect(QRectF(x - 4, ground / 2 - 7, 8, 14), 2, 2);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
}

RangeWindow::RangeWindow(QWidget* parent)
    : QWidget(parent), title_(new QLabel(tr("Gray"))), words_(new QLabel), automatic_(new QToolButton), lock_(new QToolButton),
      handles_(new RangeHandles) {
    setObjectName("range-window");
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    words_->setObjectName("range-window-words");
    words_->setTextFormat(Qt::PlainText);
    words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    words_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    automatic_->setObjectName("range-automatic");
    automatic_->setText(tr("Auto"));
    automatic_->setToolTip(tr("Black and white as the method scales the ranges"));
    lock_->setObjectName("range-lock");
    lock_->setText(tr("Lock"));
    lock_->setCheckable(true);
    lock_->setToolTip(tr("The window stays as it is when another scan is opened"));
    auto* line = new QHBoxLayout;
    line->setContentsMargins(6, 2, 6, 2);
    line->setSpacing(6);
    line->addWidget(title_);
    line->addWidget(words_, 1);
    line->addWidget(automatic_);
    line->addWidget(lock_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 2);
    column->setSpacing(0);
    column->addLayout(line);
    column->addWidget(handles_);
    connect(handles_, &RangeHandles::dragged, this, &RangeWindow::windowRequested);
    connect(handles_, &RangeHandles::automaticRequested, this, &RangeWindow::automaticRequested);
    connect(automatic_, &QToolButton::clicked, this, &RangeWindow::automaticRequested);
    connect(lock_, &QToolButton::toggled, this, &RangeWindow::lockRequested);
}

void RangeWindow::showHistogram(const RangeHistogram& histogram) { handles_->showHistogram(histogram); }

void RangeWindow::showWindow(RangeHandles::Window window, bool automatic) {
    handles_->setWindow(window);
    const QString ends = tr("%1 to %2 m").arg(window.first, 0, 'f', 1).arg(window.second, 0, 'f', 1);
    words_->setText(ends);
    brief_ = QString("%1–%2 m").arg(window.first, 0, 'f', 1).arg(window.second, 0, 'f', 1);
    full_ = ends;
    words_->setToolTip(automatic ? tr("automatic: %1").arg(ends) : ends);
    automatic_->setEnabled(!automatic);
    fit();
}

/// If the width is too small, the title is dropped, then the words between the numbers, before a number is cut.
void RangeWindow::fit() {
    constexpr int kSpacing = 2 * 6 + 3 * 6; // px, of the line
    const QFontMetrics metrics = words_->fontMetrics();
    const int room = width() - kSpacing - automatic_->sizeHint().width() - lock_->sizeHint().width();
    title_->setVisible(title_->sizeHint().width() + metrics.horizontalAdvance(full_) <= room);
    words_->setText(metrics.horizontalAdvance(full_) <= room ? full_ : brief_);
}

void RangeWindow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void RangeWindow::setLocked(bool on) { lock_->setChecked(on); }

bool RangeWindow::locked() const { return lock_->isChecked(); }

QString RangeWindow::words() const { return words_->text(); }

} // namespace edgescan::ui

#include "moc_range_window.cpp"
