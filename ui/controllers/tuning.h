// The settings: sliders, presets, undo, and the display of results in the panel.
#pragma once

#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QObject>
#include <QUndoStack>

namespace edgescan::ui {

class EdgeCounter;
class EdgesPanel;
class Preferences;
class NoticeBar;

/// GUI thread only. The objects passed to it must outlive it.
class Tuning : public QObject {
    Q_OBJECT
public:
    Tuning(Engine& engine, EdgesPanel& panel, NoticeBar& notice, Preferences& preferences, QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    /// Counts the edges of the picture at every threshold, unless lines are still added to it.
    void count(bool grows);
    void usePreset(const edges::Preset& preset);
    void useSettings(const edges::Settings& settings);
    [[nodiscard]] inspect::TuningPart part() const;
    void setPart(const inspect::TuningPart& part);
    /// Changes one parameter of the table as if the operator had used its row in the panel.
    void setParameter(const char* key, double value);
    /// To the default value, as an undo step; empty: all parameters.
    void reset(const QString& parameter);
    /// Settings of the command line: for this start only, not stored until the operator changes a setting.
    void startWith(const edges::Preset& preset, const edges::Settings& settings);
    void askOpenPreset();
    void askSavePreset();
    /// The curve of edge counts is that of the picture.
    [[nodiscard]] bool settled() const;

private:
    void recall();
    struct Tuned {
        edges::Settings settings;
        edges::Preset preset;
    };
    void change(const edges::Settings& settings, bool dragging);
    void push(const Tuned& after, bool dragging);
    void name(const edges::Preset& preset);
    void noteChange();
    void proposePreset(const edges::Detection& detection);

    Engine& engine_;
    EdgesPanel& panel_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    EdgeCounter* counts_; // child
    int drag_ = 0;        // number of the current drag, for undo
    bool starting_ = false;
    std::shared_ptr<const Scan> shownScan_;
};

} // namespace edgescan::ui
