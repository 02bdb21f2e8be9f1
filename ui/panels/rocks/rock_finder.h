// Finds the rocks of a detection on its own thread.
#pragma once

#include "ui/engine/worker_bridge/newest.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QObject>

#include <memory>

namespace edgescan::ui {

/// The inputs of the computation.
struct RockQuestion {
    std::shared_ptr<const edges::Detection> detection;
    rocks::RockSettings settings;
    std::vector<rocks::Edit> edits;
};

/// GUI thread only. Only the newest question is answered.
class RockFinder : public QObject {
    Q_OBJECT
public:
    explicit RockFinder(QObject* parent = nullptr);

    void ask(const RockQuestion& question);
    /// True while the newest question has no answer.
    [[nodiscard]] bool behind() const { return behind_; }

signals:
    void found(const std::shared_ptr<const edgescan::ui::RockPicture>& picture);
    void failed(const QString& what);

private:
    struct Asked {
        std::uint64_t number = 0;
        RockQuestion question;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const RockPicture> picture;
    };
    [[nodiscard]] Answer run(const Asked& asked); // worker's thread

    std::uint64_t asked_ = 0;
    bool behind_ = false;

    // Used only by the worker's thread.
    std::shared_ptr<const edges::Detection> detection_; // the detection of inputs_
    rocks::Inputs inputs_;
    std::shared_ptr<const RockPicture> last_;

    Newest<Asked, Answer> worker_; // last member: its thread uses the members above
};

} // namespace edgescan::ui
