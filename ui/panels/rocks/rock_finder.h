// Works out the rocks of a detection on a thread of its own.
#pragma once

#include "ui/engine/worker_bridge/newest.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QObject>

#include <memory>

namespace edgescan::ui {

/// What rocks are made of.
struct RockQuestion {
    std::shared_ptr<const Detection> detection;
    RockSettings settings;
    std::vector<RockEdit> edits;
};

/// GUI thread only. The newest question wins.
class RockFinder : public QObject {
    Q_OBJECT
public:
    explicit RockFinder(QObject* parent = nullptr);

    void ask(const RockQuestion& question);
    /// What was asked last is not answered yet.
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

    // Worker's thread only.
    std::shared_ptr<const Detection> detection_; // that inputs_ were made of
    RockInputs inputs_;
    std::shared_ptr<const RockPicture> last_;

    Newest<Asked, Answer> worker_; // last: its thread uses the rest
};

} // namespace edgescan::ui
