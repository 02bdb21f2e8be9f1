// How many edges every threshold would give.
#include "ui/session/edge_counts.h"

#include "core/method/methods.h"
#include "core/settings/parameters.h"
#include "ui/panel/count_curve.h"

namespace edgescan::ui {
namespace {

constexpr int kQuietMs = 250; // the worker has the cores to itself while a hand is on a slider

} // namespace

EdgeCounts::EdgeCounts(QObject* parent) : QObject(parent) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(kQuietMs);
    connect(&quiet_, &QTimer::timeout, this, &EdgeCounts::start);
}

void EdgeCounts::want(const std::shared_ptr<const Detection>& detection) {
    if (counted_ && counted_->scan == detection->scan && sameUpTo(Stage::Edges, counted_->settings, detection->settings)) return;
    counted_.reset();
    wanted_ = detection;
    emit outdated();
    quiet_.start();
}

void EdgeCounts::start() {
    if (!wanted_ || job_ != nullptr) return;
    counted_ = std::move(wanted_);
    wanted_.reset();
    const std::shared_ptr<const Detection> detection = counted_;
    job_ = new BackgroundJob(
        [this, detection](const BackgroundJob::Progress&) -> std::function<void()> {
            const Parameter& swept = sweptParameter(detection->settings.method);
            EdgeCountCurve curve = edgeCountCurve(thresholdMapOf(*detection), curveThresholds(swept));
            return [this, detection, &swept, curve = std::move(curve)] {
                if (counted_ == detection) emit counted(QString::fromUtf8(swept.key), curve);
            };
        },
        this);
    connect(job_, &BackgroundJob::ended, this, [this] {
        job_->deleteLater();
        job_ = nullptr;
        if (wanted_) quiet_.start();
    });
}

} // namespace edgescan::ui
