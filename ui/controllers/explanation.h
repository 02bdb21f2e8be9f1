// Explains why a cell is an edge or is not an edge: the request, the card with the answer, the framed chain in the images.
#pragma once

#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/derived.h"

#include <memory>

namespace edgescan::edges {
struct Why;
} // namespace edgescan::edges

namespace edgescan::ui {

class NoticeBar;
class WhyCard;

/// GUI thread only. The objects passed to it must outlive it.
class Explanation : public QObject {
    Q_OBJECT
public:
    Explanation(LinkedViews& views, NoticeBar& notice);

    /// What the explained cell is to the operator; the card says it.
    enum class Subject { Pointer, Pin, Click, NearestEdge };
    /// `click`: the text says if it was moved.
    void explain(const inspect::ClickedCell& click, Subject subject);
    /// Explains the cell in the status bar: under the pointer, else the pin. Where there is none, the next click says the cell. Until the
    /// card is closed, a click explains and pins nothing.
    void explainMarked();
    /// After a new picture: the card is of its settings.
    void followPicture();
    /// Also ends the wait for a click. False: there was no card and no wait.
    bool closeCard();
    /// Null before the first question.
    [[nodiscard]] const WhyCard* card() const { return card_; }

signals:
    /// The prompt for the next click; empty: none.
    void asked(const QString& words);

private:
    struct Question {
        std::shared_ptr<const Picture> picture;
        inspect::ClickedCell click;
        Subject subject = Subject::Click;
    };
    [[nodiscard]] QString subjectText(const Question& question) const;
    void forgetTrail();
    void show(const Question& question, bool still, const edges::Why& why);
    void showTrail(const edges::Why& why);
    void mark(std::optional<std::size_t> strongest);
    void waitForClicks();
    void endWait();

    LinkedViews& views_;
    NoticeBar& notice_;
    WhyCard* card_ = nullptr;                // child of the window
    bool waits_ = false;                     // the prompt is shown
    std::optional<Question> asked_;          // of the card
    std::optional<std::size_t> nearestEdge_; // the edge nearest to the cell on the card, if that cell is not an edge
    Derived<Question, edges::Why> why_;
};

} // namespace edgescan::ui
