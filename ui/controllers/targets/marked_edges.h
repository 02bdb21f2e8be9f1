// "This is an edge, this is not": marks on cells, and settings that agree with the marks.
#pragma once

#include "core/edges/tuning/marked_edges.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>

#include <memory>
#include <optional>

class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;
class ProposalsCard;
class Engine;
class Targets;

/// GUI thread only. The objects passed to it must outlive it.
class MarkedEdges : public QObject {
    Q_OBJECT
public:
    MarkedEdges(Engine& engine, LinkedViews& views, Targets& targets, QUndoStack& undo, NoticeBar& notice);

    /// A new picture is on the screen.
    void followPicture();
    /// Marks the pinned cell or the cell under the mouse; the same mark again removes it.
    void mark(std::optional<std::size_t> cell, bool isEdge);
    void clear();
    /// Restores all marks as one undo step.
    void setPart(const edges::EdgeMarks& marks);
    /// Works out off the GUI thread which settings agree, and shows them.
    void propose();
    [[nodiscard]] const edges::EdgeMarks& part() const { return marks_; }
    [[nodiscard]] bool settled() const { return !found_.behind(); }
    /// Null before the first proposals.
    [[nodiscard]] ProposalsCard* card() const { return card_; }

signals:
    void changed();

private:
    struct Question {
        std::shared_ptr<const Scan> scan;
        edges::Settings settings;
        edges::EdgeMarks marks;
    };
    void change(const QString& what, const edges::EdgeMarks& after);
    void use(const edges::EdgeMarks& marks);
    [[nodiscard]] std::vector<edges::EdgeProposal> run(const Question& question, const Asker& asker); // pool's thread
    void makeCard();
    void showStage(int method);
    void showProposals(const Question& question, const std::vector<edges::EdgeProposal>& proposals);
    void show();
    void putBack();

    Engine& engine_;
    LinkedViews& views_;
    Targets& targets_;
    QUndoStack& undo_;
    NoticeBar& notice_;
    edges::EdgeMarks marks_;
    std::uint64_t stream_ = 0; // the stream of the marks
    std::vector<edges::EdgeProposal> proposals_;
    std::optional<edges::Settings> before_; // set while a proposal is previewed
    edges::Settings previewed_;
    ProposalsCard* card_ = nullptr;
    Derived<Question, std::vector<edges::EdgeProposal>> found_; // last
};

} // namespace edgescan::ui
