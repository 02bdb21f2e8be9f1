// A/B: keeps a picture and compares what is on the screen with it; a key flips the two in all views together.
#pragma once

#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/newest.h"
#include "ui/panels/change/comparison.h"

#include <QObject>

#include <memory>
#include <optional>

class QUndoStack;

namespace edgescan::ui {

class ChangeLegend;
class Files;
class LinkedViews;
class Memory;
class NoticeBar;
class Rocks;
class Engine;
struct EdgesInstead;

/// GUI thread only. What it is given must outlive it.
class Comparing : public QObject {
    Q_OBJECT
public:
    Comparing(Engine& engine, LinkedViews& views, Rocks& rocks, ChangeLegend& legend, const Files& files, NoticeBar& notice, Memory& memory,
              QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    /// What is on the screen becomes A. It stays until another one is kept, or it is forgotten. Each of these is one step of undo; a step
    /// holds no picture, it is made again.
    void keep();
    void forget();
    [[nodiscard]] const std::shared_ptr<const Picture>& kept() const { return kept_; }
    /// A, as it can be made again; empty: there is none, or it is of no file.
    [[nodiscard]] const std::optional<EarlierScan>& part() const { return earlier_; }
    void setPart(const std::optional<EarlierScan>& part);
    /// Another scan becomes A, read as the one on the screen was, with the settings on the screen. It is read on a thread of its own.
    void compareWith(const QString& path);
    void askScan();

    /// Off: the edges in their own colours, A still a key away.
    void setDifferenceShown(bool on);
    /// Which kinds of change are shown.
    void setRows(const ChangeRows& rows);
    [[nodiscard]] const ChangeRows& rows() const { return rows_; }
    /// A instead of what is on the screen, in all views; off again.
    void flip(bool on);
    /// Of A and what is on the screen; null until it is known, and where there is nothing to compare.
    [[nodiscard]] const std::shared_ptr<const Comparison>& comparison() const { return comparison_; }
    /// Nothing is being read or compared.
    [[nodiscard]] bool settled() const { return !reading_ && !working_; }
    /// All views come close to the next one, the largest first.
    void nextRegion();

    /// The key that flips while it is held.
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void keptChanged(bool some);
    void rowsChanged();
    void flipped(bool on);
    /// The views show a difference, or none any more.
    void differenceShown(bool on);

private:
    struct Reading {
        EarlierScan from;
        std::shared_ptr<const Scan> scan; ///< where it is the one on the screen
        bool asStep = false;              ///< its end is a step of undo
    };
    struct Read {
        Reading asked;
        Result<std::shared_ptr<const Picture>> picture;
    };
    struct Answer {
        ComparisonAsked asked;
        Result<std::shared_ptr<const Comparison>> made;
    };
    [[nodiscard]] static Result<std::shared_ptr<const Picture>> pictureOf(const Reading& reading); // reading thread
    void ask();
    void take(const Answer& answer);
    void takeRead(const Read& read);
    void use(std::shared_ptr<const Picture> kept, std::optional<EarlierScan> from);
    void read(const EarlierScan& from, bool asStep);
    void push(const QString& what, const std::shared_ptr<const Picture>& after, const std::optional<EarlierScan>& from);
    [[nodiscard]] std::optional<EarlierScan> fromShown() const;
    void show();
    void showLegend();
    [[nodiscard]] bool comparable() const;

    Engine& engine_;
    LinkedViews& views_;
    ChangeLegend& legend_;
    Rocks& rocks_;
    const Files& files_;
    NoticeBar& notice_;
    Memory& memory_;
    QUndoStack& undo_;
    std::shared_ptr<const Picture> kept_;
    std::optional<EarlierScan> earlier_;
    std::shared_ptr<const Comparison> comparison_;
    ChangeRows rows_{true, true, true, true, true, true};
    std::shared_ptr<const EdgesInstead> drawn_; // as it was given to the views
    bool shown_ = true, working_ = false, reading_ = false;
    std::size_t region_ = 0;
    quint32 heldCode_ = 0;                   ///< of the key that flips, while it is held
    std::shared_ptr<const Comparison> last_; // comparing thread only
    Newest<Reading, Read> reader_;
    Newest<ComparisonAsked, Answer> comparer_; // last
};

} // namespace edgescan::ui
