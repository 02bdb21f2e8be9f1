// Targets on a scan and measurements between cells: the card, the marks in all views, the file.
#pragma once

#include "core/edges/tuning/confidence.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/base/cell_marks.h"
#include "ui/controllers/targets/target_store.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"
#include "ui/panels/targets/target_words.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <vector>

class QMenu;
class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class Preferences;
class NoticeBar;
class Rocks;
class Engine;
class TargetsPanel;

/// The values for everything in a notebook, on one picture.
struct KnownTargets {
    std::shared_ptr<const Picture> picture;
    std::map<std::uint32_t, inspect::CellTarget> targets; ///< by cell
    std::vector<std::pair<inspect::StoredMeasure, std::optional<inspect::MeasuredCells>>> measures;

    /// Null: not known yet. Empty: a cell of it has no range.
    [[nodiscard]] const std::optional<inspect::MeasuredCells>* of(const inspect::StoredMeasure& measure) const;
};

/// The confidence of a picture's edges.
struct KnownConfidence {
    std::shared_ptr<const Picture> of;
    std::shared_ptr<const edges::EdgeConfidence> made; ///< null: unknown
    ShownConfidence::State otherwise = ShownConfidence::State::NotAsked;

    bool operator==(const KnownConfidence&) const = default;
};

/// A measurement in words.
struct MeasureWords {
    QString kind, value;  ///< "Throat Width", "1.611 m ± 0.135 m"
    QStringList warnings; ///< each begins with ▲
    QStringList remarks;
    QString offEdge; ///< also one of the remarks; empty: each end is on an edge
};

/// GUI thread only. The objects passed to it must outlive it.
class Targets : public QObject {
    Q_OBJECT
public:
    Targets(Engine& engine, LinkedViews& views, Rocks& rocks, TargetsPanel& panel, NoticeBar& notice, Preferences& preferences,
            QUndoStack& undo);

    /// A new picture is on the screen.
    void followPicture();
    [[nodiscard]] const inspect::Notebook& notebook() const { return notebook_; }
    [[nodiscard]] std::vector<inspect::PinnedTarget> withRocks() const;
    /// Of another scan, as it was stored.
    [[nodiscard]] Result<inspect::Notebook> notebookOf(const inspect::NotebookScan& scan) const { return store_.peek(scan); }
    /// The file of the notebook; empty: none.
    [[nodiscard]] QString notebookFile() const;
    /// The target whose card is shown; null: none.
    [[nodiscard]] const inspect::PinnedTarget* active() const;
    /// The chosen target is not at the cell of its click.
    [[nodiscard]] bool isMoved() const { return active() != nullptr && active()->clicked.has_value(); }
    /// True if the cards belong to the picture on the screen and to all entries of the notebook.
    [[nodiscard]] bool settled() const;
    /// The disk refused the newest ones.
    [[nodiscard]] bool unsaved() const { return store_.failing(); }
    [[nodiscard]] const KnownTargets& known() const { return known_; }
    /// known() does not follow from the pose that is typed, or from that of the picture.
    [[nodiscard]] bool placePending() const;
    /// The data of a card that was not measured at the cell.
    [[nodiscard]] TargetSurroundings around(std::size_t cell) const;
    /// How the cell of a target follows from its click, with a warning if a nearer surface is next to it; empty: it was chosen itself.
    [[nodiscard]] QString clickOf(const inspect::PinnedTarget& target) const;

    void pin(std::size_t cell);
    /// Not possible for a locked target.
    void remove(int number);
    /// Locked targets stay.
    void removeAll();
    /// Asks for the name of the rock at the click and stores it with a target on it.
    void askName(const inspect::ClickedCell& click);
    void rename(int number, const QString& name);
    void setNote(int number, const QString& note);
    /// In the field of the card, or in a dialog while the card is hidden.
    void editName();
    /// Asks for it.
    void askNameOf(int number);
    void askNote(int number);
    void lock(int number, bool on);
    /// What can be done with one target.
    void addEntriesOf(QMenu& menu, int number);
    void keepMeasure(const inspect::StoredMeasure& measure);
    void removeMeasure(std::size_t place);
    /// One thing is chosen: with a measurement no target is active and no rock is selected. Empty: none is chosen.
    void chooseMeasure(std::optional<std::size_t> place);
    /// Its place in the notebook, until a target, a rock or another measurement is chosen.
    [[nodiscard]] std::optional<std::size_t> chosenMeasure() const { return chosen_; }
    /// "3 Big one · 12.340 m · rock 4 · E ... N ... RL ... m": what the list shows of it, in one line.
    [[nodiscard]] QString inWords(const inspect::PinnedTarget& target) const;
    [[nodiscard]] MeasureWords wordsOf(const inspect::StoredMeasure& measure) const;
    /// "3  Big one" of the target at this cell; empty: there is none.
    [[nodiscard]] QString nameAt(std::uint32_t cell) const;
    /// Kind and length of each measurement, in the order of the notebook.
    [[nodiscard]] std::vector<QString> measuresInWords() const;
    [[nodiscard]] inspect::TargetsPart part() const;
    /// As one step of undo.
    void setPart(const inspect::TargetsPart& part);
    /// Shows the cells picked so far for a measurement; an empty mark removes them.
    void showDraft(const MeasureMark& draft);
    /// The source of the picture in words, for the cards.
    void setSource(const QString& source);
    /// For the cards; the first value is stored with each card.
    void setConfidence(const KnownConfidence& confidence);
    /// Copies the card as text to the clipboard.
    void copyCard();
    /// Copies the positions of all targets as a table.
    void copyAll();

    /// Shows marks of another controller like targets; replaces earlier ones.
    void showExtraMarks(std::vector<TargetMark> marks);
    /// The target that a click means: at the clicked cell, at the one that is meant, or next to it. Null: none.
    [[nodiscard]] const inspect::PinnedTarget* at(const inspect::ClickedCell& click) const;

signals:
    /// The panel has new content to look at.
    void pinned();
    /// The card shows another target or other values, or another measurement is chosen.
    void cardChanged();
    void explanationRequested(std::size_t cell);
    void measureRequested(std::size_t cell);

private:
    struct Question {
        std::shared_ptr<const Picture> picture;
        inspect::Notebook notebook;
    };
    [[nodiscard]] KnownTargets workOut(const Question& question); // pool's thread
    void connectPanel();
    void addToMenu(QMenu& menu, const inspect::ClickedCell& click);
    [[nodiscard]] std::optional<QString> askText(const QString& title, const QString& label, const QString& text, int mostLetters) const;
    void setText(int number, const QString& text, std::string inspect::PinnedTarget::*member, std::size_t mostBytes, const QString& step);
    void followPin(std::optional<std::size_t> cell);
    void change(const QString& what, const inspect::Notebook& after);
    void use(const inspect::Notebook& notebook);
    void chooseWhatCame(const inspect::Notebook& before);
    void keep();
    void adopt(const QString& path, const inspect::Notebook& mine, const inspect::Notebook& theirs); // of another window
    void ask();
    void storeKnown(const KnownTargets& known);
    void show();
    void showCard();
    void keepConfidence();
    [[nodiscard]] QString atTargetsText(const inspect::StoredMeasure& measure) const;
    [[nodiscard]] static QString nameOf(const inspect::PinnedTarget& target); ///< "3  Big one"
    [[nodiscard]] QStringList wordsOf(const inspect::PinnedTarget& target) const;
    void findSweep();
    [[nodiscard]] QString keyOf(const Picture& picture) const;
    [[nodiscard]] static QString leftBehind(std::size_t entries);
    [[nodiscard]] const inspect::PinnedTarget* onRockAt(std::size_t cell) const;
    [[nodiscard]] static inspect::PinnedTarget* numbered(inspect::Notebook& notebook, int number);
    [[nodiscard]] const inspect::CellTarget* knownOf(std::uint32_t cell) const;
    [[nodiscard]] const inspect::MeasuredCells* knownOf(const inspect::StoredMeasure& measure) const;
    [[nodiscard]] std::vector<std::size_t> wayOf(const inspect::StoredMeasure& measure) const;
    [[nodiscard]] CellMarks marks() const;
    [[nodiscard]] QString tagOf(const inspect::PinnedTarget& target) const;

    Engine& engine_;
    LinkedViews& views_;
    Rocks& rocks_;
    TargetsPanel& panel_;
    NoticeBar& notice_;
    QUndoStack& undo_;
    TargetStore store_;
    QString key_;         // of the scan of the notebook
    bool stored_ = false; // the notebook of that scan is
    inspect::Notebook notebook_;
    std::map<QString, inspect::Notebook> others_; // of scans that were on the screen earlier
    struct Sweep {
        inspect::ScanHead head;
        int beams = 0;
        double startS = 0.0; // since 1970
        std::uint64_t stream = 0;
    };
    std::map<QString, Sweep> sweeps_;  // of `others_`: those without a file
    bool looksForSweep_ = false;       // the scan on the screen may be one of them
    std::shared_ptr<const Scan> scan_; // on the screen
    std::uint64_t stream_ = 0;
    std::vector<TargetMark> beside_;
    MeasureMark draft_;
    QString source_;
    KnownTargets known_;
    KnownConfidence confidence_;
    // number and cell: the stored card belongs to this picture
    std::map<std::pair<int, std::uint32_t>, std::weak_ptr<const Picture>> pinnedOn_;
    std::optional<std::size_t> chosen_; // measurement of the notebook
    bool using_ = false;                // an undo step is running: signals of the views are ignored

    // Used only on the pool's threads, by one at a time.
    std::weak_ptr<const Scan> noiseScan_;
    RangeNoise noise_;
    decltype(KnownTargets::measures) measured_; // on that scan: no setting changes a measurement
    Derived<Question, KnownTargets> worked_;    // last
};

} // namespace edgescan::ui
