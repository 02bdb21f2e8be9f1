// Works out, while nobody turns anything, how many edges every threshold would give.
#pragma once

#include "core/method/detection.h"
#include "core/gray/threshold_map.h"
#include "ui/session/background_job.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace edgescan::ui {

/// GUI thread only; the counting runs on a thread of its own, newest frame wins.
class EdgeCounts : public QObject {
    Q_OBJECT
public:
    explicit EdgeCounts(QObject* parent = nullptr);

    /// A new frame is on the screen. Nothing is counted while further frames follow quickly, and nothing again where only the threshold
    /// that is swept changed.
    void want(const std::shared_ptr<const Frame>& frame);

signals:
    /// What was counted no longer belongs to the frame.
    void outdated();
    /// `parameter`: key of the threshold.
    void counted(const QString& parameter, const edgescan::EdgeCountCurve& curve);

private:
    void start();

    std::shared_ptr<const Frame> wanted_;  // not counted yet
    std::shared_ptr<const Frame> counted_; // or being counted
    BackgroundJob* job_ = nullptr;         // child
    QTimer quiet_;
};

} // namespace edgescan::ui
