// Counts the edges at every threshold.
#include "ui/engine/worker_bridge/edge_counter.h"

#include "core/edges/settings/parameters.h"
#include "core/edges/settings/slider_scale.h"

namespace edgescan::ui {
namespace {

constexpr std::chrono::milliseconds kQuiet{250}; // the processors are for the picture while a slider moves

} // namespace

EdgeCounter::EdgeCounter(QObject* parent)
    : QObject(parent),
      curve_(
          Urgency::Now,
          [](const std::shared_ptr<const edges::Detection>& detection) {
              return edges::edgeCountCurve(*detection, edges::sliderValues(edges::sweptParameter(detection->settings.method)));
          },
          [this](const std::shared_ptr<const edges::Detection>& detection, const std::shared_ptr<const edges::EdgeCountCurve>& curve) {
              emit counted(QString::fromUtf8(edges::sweptParameter(detection->settings.method).key), *curve);
          },
          [](const QString&) {}) {}

void EdgeCounter::want(const std::shared_ptr<const edges::Detection>& detection) {
    if (scan_.lock() == detection->scan && edges::sameUpTo(edges::Stage::Edges, settings_, detection->settings)) return;
    scan_ = detection->scan;
    settings_ = detection->settings;
    curve_.ask(detection, kQuiet);
    emit outdated();
}

void EdgeCounter::forget() {
    scan_.reset();
    curve_.giveUp();
    emit outdated();
}

} // namespace edgescan::ui

#include "moc_edge_counter.cpp"
