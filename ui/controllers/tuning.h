// The settings: sliders, presets, undo, and what the panel tells of the result.
#pragma once

#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QElapsedTimer>
#include <QObject>
#include <QUndoStack>

namespace edgescan::ui {

class EdgeCounter;
class EdgesPanel;
class Memory;
class NoticeBar;

/// GUI thread only. What it is given must outlive it.
class Tuning : public QObject {
    Q_OBJECT
public:
    Tuning(Engine& engine, EdgesPanel& panel, NoticeBar& notice, Memory& memory, QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    void usePreset(const Preset& preset);
    void useSettings(const Settings& settings);
    [[nodiscard]] TuningPart part() const;
    void setPart(const TuningPart& part);
    /// One parameter of the table, as if its row of the panel had been turned.
    void turn(const char* key, double value);
    /// As the command line wants it: this start only, nothing of it is remembered until somebody changes a setting.
    void startWith(const Preset& preset, const Settings& settings);
    /// The number or choice that somebody turned last, as long as the method reads it; else the threshold that it is mostly turned by.
    [[nodiscard]] const Parameter& lastTurned() const;
    void askOpenPreset();
    void askSavePreset();

    [[nodiscard]] QUndoStack& undoStack() { return undo_; }
    /// Milliseconds from the last change of a setting to the picture shown; of a new scan, how long the method took.
    [[nodiscard]] double updateMs() const { return updateMs_; }

private:
    void recall();
    void change(const Settings& settings, bool dragging);
    void noteChange();

    Engine& engine_;
    EdgesPanel& panel_;
    NoticeBar& notice_;
    Memory& memory_;
    QUndoStack& undo_;
    EdgeCounter* counts_; // child
    int drag_ = 0;        // number of the drag, for undo
    bool starting_ = false;
    const Parameter* turned_ = nullptr;
    QElapsedTimer sinceChange_;
    double updateMs_ = 0.0;
    std::shared_ptr<const Scan> shownScan_;
};

} // namespace edgescan::ui
