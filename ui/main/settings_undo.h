// Undo and redo of what the sliders set: one drag is one step.
#pragma once

#include "core/settings/settings.h"

#include <QUndoCommand>

#include <functional>

namespace edgescan::ui {

class SettingsChange : public QUndoCommand {
public:
    /// Changes with the same `drag` number become one step; 0 never does.
    SettingsChange(const Settings& before, const Settings& after, int drag, std::function<void(const Settings&)> apply);

    void undo() override { apply_(before_); }
    void redo() override { apply_(after_); }
    [[nodiscard]] int id() const override { return drag_ == 0 ? -1 : drag_; }
    bool mergeWith(const QUndoCommand* later) override;

private:
    Settings before_;
    Settings after_;
    int drag_;
    std::function<void(const Settings&)> apply_;
};

} // namespace edgescan::ui
