// Picking the cells of a measurement, one click after the other.
#pragma once

#include "core/inspect/measure/notebook.h"

#include <QObject>

#include <optional>
#include <vector>

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;
class Targets;

/// GUI thread only. What it is given must outlive it.
class Measures : public QObject {
    Q_OBJECT
public:
    Measures(LinkedViews& views, Targets& targets, NoticeBar& notice);

    /// Clicks pick cells for this from now on, until stop().
    void start(MeasureKind kind);
    /// With the first cell picked already.
    void startAt(std::size_t cell);
    void stop();
    /// Empty while nothing is measured.
    [[nodiscard]] std::optional<MeasureKind> kind() const { return kind_; }
    [[nodiscard]] const std::vector<std::uint32_t>& picked() const { return picked_; }
    /// Takes the last click back; false: there was none.
    bool takeBack();

signals:
    /// Another kind, or none.
    void kindChanged();
    /// What is to be clicked next; empty: nothing.
    void asked(const QString& words);

private:
    void pick(std::size_t cell);
    void keepPicked();
    void show();

    LinkedViews& views_;
    Targets& targets_;
    NoticeBar& notice_;
    std::optional<MeasureKind> kind_;
    std::vector<std::uint32_t> picked_;
};

} // namespace edgescan::ui
