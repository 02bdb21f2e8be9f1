// Why a cell is an edge, or why it is none: the question, the card that answers it, the chain that is framed in the images.
#pragma once

#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/newest.h"

#include <memory>

namespace edgescan {
struct Why;
}

namespace edgescan::ui {

class NoticeBar;
class WhyCard;

/// GUI thread only. What it is given must outlive it.
class Explanation : public QObject {
    Q_OBJECT
public:
    Explanation(LinkedViews& views, NoticeBar& notice);

    void explain(std::size_t cell);
    /// The cell that is pointed at or was clicked.
    void explainMarked();
    void forgetTrail();
    /// False: it was not open.
    bool closeCard();
    /// Null before the first question.
    [[nodiscard]] const WhyCard* card() const { return card_; }

private:
    struct Question {
        std::shared_ptr<const Picture> picture;
        std::size_t cell = 0;
    };
    struct Answer {
        std::shared_ptr<const Picture> picture;
        std::shared_ptr<const Why> why;
    };
    void tell(const Answer& answer);
    void showTrail(const Why& why);

    LinkedViews& views_;
    NoticeBar& notice_;
    WhyCard* card_ = nullptr;           // child of the window
    std::optional<std::size_t> beside_; // the edge next to the cell on the card, where that is none
    Newest<Question, Answer> worker_;
};

} // namespace edgescan::ui
