// Counts the edges at every threshold while the operator changes nothing.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/edge_count_curve.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>

#include <memory>

namespace edgescan::ui {

/// GUI thread only; the count runs off the GUI thread, and only the newest detection is counted.
class EdgeCounter : public QObject {
    Q_OBJECT
public:
    explicit EdgeCounter(QObject* parent = nullptr);

    /// A new detection is on the screen. It is counted when no other detection follows shortly. It is not counted again if only the swept
    /// threshold changed.
    void want(const std::shared_ptr<const edges::Detection>& detection);
    /// The picture grows: nothing is counted, and the same detection can be wanted again.
    void forget();
    /// The newest count is still to come.
    [[nodiscard]] bool behind() const { return curve_.behind(); }

signals:
    /// The last count does not belong to the current detection.
    void outdated();
    /// `parameter`: key of the threshold.
    void counted(const QString& parameter, const edgescan::edges::EdgeCountCurve& curve);

private:
    std::weak_ptr<const Scan> scan_; // of the newest count, and the settings
    edges::Settings settings_;
    Derived<std::shared_ptr<const edges::Detection>, edges::EdgeCountCurve> curve_;
};

} // namespace edgescan::ui
