// Cells that are pinned on a scan and what is measured between them: the card, the marks in all views, the file that keeps them.
#pragma once

#include "core/edges/tuning/confidence.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/base/cell_marks.h"
#include "ui/controllers/targets/target_store.h"
#include "ui/engine/worker_bridge/newest.h"
#include "ui/engine/worker_bridge/picture.h"
#include "ui/panels/targets/target_words.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <vector>

class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class Memory;
class NoticeBar;
class Rocks;
class Engine;
class TargetsPanel;

/// What is known of all that is in a notebook, on one picture.
struct KnownTargets {
    std::shared_ptr<const Picture> picture;
    std::map<std::uint32_t, CellTarget> targets; ///< by cell
    std::vector<std::pair<KeptMeasure, std::optional<MeasuredCells>>> measures;
};

/// How sure the edges of a picture are.
struct KnownConfidence {
    std::shared_ptr<const Picture> of;
    std::shared_ptr<const EdgeConfidence> made; ///< null: not known
    ToldConfidence::State otherwise = ToldConfidence::State::NotAsked;

    bool operator==(const KnownConfidence&) const = default;
};

/// GUI thread only. What it is given must outlive it.
class Targets : public QObject {
    Q_OBJECT
public:
    Targets(Engine& engine, LinkedViews& views, Rocks& rocks, TargetsPanel& panel, NoticeBar& notice, Memory& memory, QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    [[nodiscard]] const Notebook& notebook() const { return notebook_; }
    /// The file that the notebook is kept in; empty: none.
    [[nodiscard]] QString keptIn() const;
    /// The target whose card is shown; null: none.
    [[nodiscard]] const PinnedTarget* active() const;
    /// What the cards say is of the picture on the screen and of all in the notebook.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] const KnownTargets& known() const { return known_; }
    /// What its card says besides what was measured.
    [[nodiscard]] TargetSurroundings around(std::size_t cell) const;
    /// So many places on in the notebook, round and round; the card is that one's.
    void goTo(int by);

    void pin(std::size_t cell);
    /// But of one that is locked.
    void letGo(int number);
    /// But of those that are locked.
    void letGoOfAll();
    void rename(int number, const QString& name);
    void lock(int number, bool on);
    void keepMeasure(const KeptMeasure& measure);
    void removeMeasure(std::size_t place);
    [[nodiscard]] TargetsPart part() const;
    /// As one step of undo.
    void setPart(const TargetsPart& part);
    /// What is being picked for a measurement; no cells: nothing is.
    void showDraft(const MeasureMark& draft);
    /// Where the picture comes from, in words, for the cards.
    void setSource(const QString& source);
    /// For the cards, and as it first is for what is kept of them.
    void setConfidence(const KnownConfidence& confidence);
    /// The card as text, to the clipboard.
    void copyCard();

    /// Lines between the cells of a measurement.
    [[nodiscard]] static std::vector<std::pair<std::size_t, std::size_t>> linksOf(MeasureKind kind);
    /// Marks of others, drawn like targets until others are given.
    void showBeside(std::vector<TargetMark> marks);

signals:
    /// There is something to look at in the panel.
    void pinned();
    /// The card is of another target, or says something else.
    void cardChanged();
    void whyWanted(std::size_t cell);
    void measureWanted(std::size_t cell);

private:
    struct Question {
        std::shared_ptr<const Picture> picture;
        Notebook notebook;
    };
    [[nodiscard]] KnownTargets workOut(const Question& question); // worker's thread
    void connectPanel();
    void followPin(std::optional<std::size_t> cell);
    void change(const QString& what, Notebook after);
    void use(const Notebook& notebook);
    void keep();
    void ask();
    void take(KnownTargets known);
    void show();
    void showCard();
    void keepConfidence();
    [[nodiscard]] QString keyOf(const Picture& picture) const;
    [[nodiscard]] bool moveRockPin(std::size_t cell);
    [[nodiscard]] PinnedTarget* numbered(Notebook& notebook, int number) const;
    [[nodiscard]] const CellTarget* knownOf(std::uint32_t cell) const;
    [[nodiscard]] const MeasuredCells* knownOf(const KeptMeasure& measure) const;
    [[nodiscard]] CellMarks marks() const;
    [[nodiscard]] QString tagOf(const PinnedTarget& target) const;

    Engine& engine_;
    LinkedViews& views_;
    Rocks& rocks_;
    TargetsPanel& panel_;
    NoticeBar& notice_;
    QUndoStack& undo_;
    TargetStore store_;
    QString key_; // of the scan that the notebook belongs to
    Notebook notebook_;
    int rockPin_ = 0;                    // number of the target that clicks on rocks move; 0: none
    std::map<QString, Notebook> others_; // of scans that were on the screen before
    std::vector<TargetMark> beside_;
    MeasureMark draft_;
    QString source_;
    KnownTargets known_;
    KnownConfidence confidence_;
    std::map<std::pair<int, std::uint32_t>, std::weak_ptr<const Picture>> pinnedOn_; // number and cell: what is kept of its card is of it
    bool using_ = false; // a step is being taken: what the views tell of it is known

    // Worker's thread only.
    std::shared_ptr<const Scan> noiseScan_;
    RangeNoise noise_;
    Newest<Question, KnownTargets> worker_; // last
};

} // namespace edgescan::ui
