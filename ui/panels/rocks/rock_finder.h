// Works out the rocks of a detection off the GUI thread.
#pragma once

#include "ui/engine/worker_bridge/derived.h"
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
    [[nodiscard]] bool behind() const { return rocks_.behind(); }

signals:
    void found(const std::shared_ptr<const edgescan::ui::RockPicture>& picture);
    void failed(const QString& what);

private:
    [[nodiscard]] std::shared_ptr<const RockPicture> run(const RockQuestion& question); // pool's thread

    // Of run() alone.
    std::shared_ptr<const Detection> detection_; // that inputs_ were made of
    RockInputs inputs_;
    std::shared_ptr<const RockPicture> last_;

    Derived<RockQuestion, RockPicture> rocks_; // last
};

} // namespace edgescan::ui
