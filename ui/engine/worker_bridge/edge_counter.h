// Works out, while nobody turns anything, how many edges every threshold would give.
#pragma once

#include "core/edges/gray/threshold_map.h"
#include "core/edges/pipeline/detection.h"
#include "ui/engine/worker_bridge/newest.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace edgescan::ui {

/// GUI thread only; the counting runs on a thread of its own, newest detection wins.
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
    struct Counted {
        std::shared_ptr<const Detection> detection;
        EdgeCountCurve curve;
    };

    std::shared_ptr<const Detection> asked_; // counted, being counted, or waiting for quiet
    QTimer quiet_;
    Newest<std::shared_ptr<const Detection>, Counted> worker_;
};

} // namespace edgescan::ui
