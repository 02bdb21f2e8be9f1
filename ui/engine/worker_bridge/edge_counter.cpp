// Counts the edges at every threshold.
#include "ui/engine/worker_bridge/edge_counter.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/slider_scale.h"

namespace edgescan::ui {
namespace {

constexpr int kQuietMs = 250; // while the operator drags a slider, the worker has the cores to itself

} // namespace

EdgeCounter::EdgeCounter(QObject* parent)
    : QObject(parent),
      worker_(
          this,
          [](const std::shared_ptr<const edges::Detection>& detection) {
              const std::vector<double> thresholds = edges::sliderValues(edges::sweptParameter(detection->settings.method));
              return Counted{detection, edges::edgeCountCurve(edges::thresholdMapOf(*detection), thresholds)};
          },
          [this](const Counted& counted) {
              if (counted.detection != asked_) return; // the newest answer follows
              emit this->counted(QString::fromUtf8(edges::sweptParameter(asked_->settings.method).key), counted.curve);
          },
          [](const QString&) {}) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(kQuietMs);
    connect(&quiet_, &QTimer::timeout, this, [this] { worker_.post(asked_); });
}

void EdgeCounter::want(const std::shared_ptr<const edges::Detection>& detection) {
    if (asked_ && asked_->scan == detection->scan && edges::sameUpTo(edges::Stage::Edges, asked_->settings, detection->settings)) return;
    asked_ = detection;
    emit outdated();
    quiet_.start();
}

} // namespace edgescan::ui
