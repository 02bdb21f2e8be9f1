// The timeline of a recording.
#include "ui/panels/live/timeline.h"

#include "ui/base/elided_label.h"
#include "ui/base/flow_layout.h"
#include "ui/base/themes.h"

#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace edgescan::ui {
namespace {

constexpr int kTickMs = 40;
constexpr int kLeastLabel = 120; // px
constexpr int kNearMark = 6;     // px
constexpr double kNsPerMs = 1e6;
constexpr double kLongestPauseNs = 2e9; // longest pause while playing, in recorded time: longer gaps are skipped
constexpr std::array<double, 9> kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 25.0, 100.0};

QString utcText(std::int64_t ns) {
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(ns / 1'000'000, Qt::UTC);
    return time.toString("yyyy-MM-dd HH:mm:ss.zzz").chopped(2) + " UTC";
}

} // namespace

/// Over the lines of a recording, with a mark at the start of each sweep.
class TimelineSlider : public QSlider {
public:
    explicit TimelineSlider(QWidget* parent = nullptr);
    void setMarks(std::vector<int> positions);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] int pixelOf(int position) const;

    std::vector<int> marks_;
};

TimelineSlider::TimelineSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) { setMinimumWidth(120); }

void TimelineSlider::setMarks(std::vector<int> positions) {
    marks_ = std::move(positions);
    update();
}

int TimelineSlider::pixelOf(int position) const {
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
    return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), position, width() - handle);
}

void TimelineSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    painter.setPen(QPen(themeInUse().warn, 2.0));
    for (const int mark : marks_) {
        const int x = pixelOf(mark);
        painter.drawLine(x, 0, x, 4);
    }
}

/// A click moves the slider there, not by one page; near a mark to the mark, where a sweep has ended.
void TimelineSlider::mousePressEvent(QMouseEvent* event) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (event->button() == Qt::LeftButton && !handle.contains(event->pos())) {
        const int length = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
        const int x = event->pos().x();
        const auto mark = std::ranges::find_if(marks_, [&](int position) { return std::abs(pixelOf(position) - x) <= kNearMark; });
        setValue(mark != marks_.end() ? *mark : QStyle::sliderValueFromPosition(minimum(), maximum(), x - length / 2, width() - length));
    }
    QSlider::mousePressEvent(event);
}

Timeline::Timeline(QWidget* parent)
    : QWidget(parent), play_(new QPushButton(tr("Play"))), slider_(new TimelineSlider), label_(new ElidedLabel), speeds_(new QComboBox) {
    setObjectName("timeline");
    play_->setObjectName("timeline-play");
    slider_->setObjectName("timeline-slider");
    label_->setObjectName("timeline-label");
    label_->setTextFormat(Qt::PlainText);
    play_->setToolTip(tr("Space plays and pauses; Left and Right step by a line, with Shift by ten"));
    for (const double speed : kSpeeds) speeds_->addItem(QString("× %1").arg(speed), speed);
    speeds_->setObjectName("timeline-speed");
    speeds_->setCurrentIndex(speeds_->findData(1.0));
    label_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    label_->setMinimumWidth(kLeastLabel);
    slider_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    auto* row = new FlowLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    for (QWidget* each : std::initializer_list<QWidget*>{play_, speeds_, slider_, label_}) row->addWidget(each);
    ticking_.setInterval(kTickMs);
    connect(&ticking_, &QTimer::timeout, this, &Timeline::tick);
    connect(play_, &QPushButton::clicked, this, &Timeline::togglePlay);
    connect(slider_, &QSlider::valueChanged, this, [this](int line) {
        goTo(line);
        setClock();
    });
    connect(speeds_, qOverload<int>(&QComboBox::activated), this, [this](int index) { speed_ = speeds_->itemData(index).toDouble(); });
    hide();
}

void Timeline::load(const std::filesystem::path& path, const ReadingOptions& options) {
    clear();
    player_ = std::make_unique<ReplayPlayer>(path, options);
    connect(player_.get(), &ReplayPlayer::loaded, this, &Timeline::showContents);
    connect(player_.get(), &ReplayPlayer::refused, this, &Timeline::refused);
    connect(player_.get(), &ReplayPlayer::arrived, this, [this](const ReplayedSweep& at) {
        seeking_ = false;
        emit arrived(at);
        if (at.position != position_) seek();
    });
}

void Timeline::clear() {
    play(false);
    player_.reset();
    seeking_ = false;
    const bool was = active();
    contents_ = {};
    position_ = home_ = 0;
    hide();
    if (was) emit activeChanged(false);
}

/// The file was opened meanwhile: its longest sweep is on the screen, complete.
void Timeline::showContents(const RecordingContents& contents) {
    if (contents.lineNs.size() < 2 || contents.sweeps.empty()) return emit loaded();
    contents_ = contents;
    const auto longest = std::max_element(contents_.sweeps.begin(), contents_.sweeps.end(),
                                          [](const RecordedSweep& a, const RecordedSweep& b) { return a.received < b.received; });
    home_ = position_ = endOf(static_cast<std::size_t>(longest - contents_.sweeps.begin()));
    {
        const QSignalBlocker quiet(slider_);
        slider_->setRange(contents_.first, lines());
        slider_->setPageStep(std::max(1, lines() / 20));
        slider_->setValue(position_);
    }
    std::vector<int> marks;
    for (const RecordedSweep& sweep : contents_.sweeps) marks.push_back(sweep.firstLine);
    slider_->setMarks(marks.size() > 1 ? marks : std::vector<int>{});
    showPlace();
    show();
    emit activeChanged(true);
    emit loaded();
}

int Timeline::sweepAt(int position) const {
    int sweep = 0;
    while (sweep + 1 < static_cast<int>(contents_.sweeps.size()) &&
           contents_.sweeps[static_cast<std::size_t>(sweep) + 1].firstLine < position)
        ++sweep;
    return sweep;
}

int Timeline::endOf(std::size_t sweep) const {
    return sweep + 1 < contents_.sweeps.size() ? contents_.sweeps[sweep + 1].firstLine : lines();
}

QString Timeline::labelShown() const { return label_->text(); }

void Timeline::showPlace() {
    const std::size_t line = static_cast<std::size_t>(std::clamp(position_ - 1, 0, lines() - 1));
    const auto sweep = static_cast<std::size_t>(sweepAt(position_));
    const bool several = contents_.sweeps.size() > 1; // lines are counted in their sweep, as in the picture's own count
    const int before = several ? contents_.sweeps[sweep].firstLine : 0, end = several ? endOf(sweep) : lines();
    QString text = tr("RECORDED · line %2/%3 at %1").arg(utcText(contents_.lineNs[line])).arg(position_ - before).arg(end - before);
    if (several) text += tr(" · recorded sweep %1 of %2").arg(sweep + 1).arg(contents_.sweeps.size());
    label_->setText(text);
}

/// Sets the time from which playing continues.
void Timeline::setClock() {
    if (active()) atNs_ = static_cast<double>(contents_.lineNs[static_cast<std::size_t>(std::min(position_, lines() - 1))]);
}

void Timeline::play(bool on) {
    if (on == playing() || (on && !active())) return;
    if (on) {
        if (position_ >= lines()) goTo(contents_.first);
        setClock();
        sinceTick_.start();
        ticking_.start();
    } else {
        ticking_.stop();
    }
    play_->setText(on ? tr("Pause") : tr("Play"));
    emit playingChanged(on);
}

void Timeline::tick() {
    const double passedMs = static_cast<double>(sinceTick_.restart());
    if (seeking_) return; // a slow machine plays slower and skips no line
    const auto& times = contents_.lineNs;
    if (position_ >= lines()) return play(false);
    const auto next = static_cast<double>(times[static_cast<std::size_t>(position_)]);
    atNs_ = std::max(atNs_ + passedMs * kNsPerMs * speed_, next - kLongestPauseNs);
    const auto until = std::upper_bound(times.begin() + position_, times.end(), static_cast<std::int64_t>(atNs_));
    const int line = static_cast<int>(until - times.begin());
    if (line != position_) goTo(line);
}

void Timeline::goTo(int line) {
    const int wanted = std::clamp(line, contents_.first, std::max(contents_.first, lines()));
    if (!active() || wanted == position_) return;
    position_ = wanted;
    {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(wanted);
    }
    showPlace();
    seek();
}

void Timeline::stepBy(int step) {
    play(false);
    goTo(position_ + step);
}

bool Timeline::stepSweep(int by) {
    std::optional<int> end;
    for (std::size_t n = 0; active() && n < contents_.sweeps.size(); ++n) {
        const bool isNext = by > 0 && endOf(n) > position_ && !end;
        const bool isPrevious = by < 0 && endOf(n) < position_;
        if (isNext || isPrevious) end = endOf(n);
    }
    if (!end) return false;
    play(false);
    goTo(*end);
    return true;
}

void Timeline::setSpeed(double factor) {
    speed_ = factor;
    speeds_->setCurrentIndex(speeds_->findData(factor));
}

void Timeline::seek() {
    if (!player_ || seeking_) return;
    seeking_ = true;
    player_->seek(position_);
}

} // namespace edgescan::ui

#include "moc_timeline.cpp"
