// Finds the rocks of a detection off the GUI thread.
#pragma once

#include "ui/engine/worker_bridge/derived.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QObject>

#include <memory>

namespace edgescan::ui {

/// The inputs of the computation.
struct RockQuestion {
    std::shared_ptr<const edges::Detection> detection;
    rocks::RockSettings settings;
    std::vector<rocks::Edit> edits;
    RockFilter filter;
};

/// GUI thread only. Only the newest question is answered.
class RockFinder : public QObject {
    Q_OBJECT
public:
    explicit RockFinder(QObject* parent = nullptr);

    void ask(const RockQuestion& question);
    /// What is stored for the next question about the same scan is freed.
    void forget();
    /// What was asked last is not answered yet.
    [[nodiscard]] bool behind() const { return rocks_.behind(); }

signals:
    void found(const std::shared_ptr<const edgescan::ui::RockPicture>& picture);
    void failed(const QString& what);

private:
    [[nodiscard]] std::shared_ptr<const RockPicture> run(const RockQuestion& question); // pool's thread

    // Used only on the pool's threads, by one at a time.
    std::shared_ptr<const edges::Detection> detection_; // the detection of inputs_
    rocks::Inputs inputs_;
    std::shared_ptr<const RockPicture> last_;

    Derived<RockQuestion, RockPicture> rocks_; // last
};

} // namespace edgescan::ui
