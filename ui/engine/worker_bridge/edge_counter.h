// Works out, while nobody turns anything, how many edges every threshold would give.
#pragma once

#include "core/edges/gray/threshold_map.h"
#include "core/edges/pipeline/detection.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>

#include <memory>

namespace edgescan::ui {

/// GUI thread only; the newest detection wins.
class EdgeCounter : public QObject {
    Q_OBJECT
public:
    explicit EdgeCounter(QObject* parent = nullptr);

    /// A new detection is on the screen. Nothing is counted while further detections follow quickly, and nothing again where only the
    /// threshold that is swept changed.
    void want(const std::shared_ptr<const Detection>& detection);

signals:
    /// What was counted no longer belongs to the detection.
    void outdated();
    /// `parameter`: key of the threshold.
    void counted(const QString& parameter, const edgescan::EdgeCountCurve& curve);

private:
    Derived<std::shared_ptr<const Detection>, EdgeCountCurve> curve_;
};

} // namespace edgescan::ui
