// The card of the selection: one rock, several rocks, or a place that is not a rock; with buttons that change it.
#pragma once

#include "ui/base/fact_row.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QFrame>

#include <cstdint>
#include <vector>

class QLabel;
class QPushButton;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class RockCard : public QFrame {
    Q_OBJECT
public:
    explicit RockCard(QWidget* parent = nullptr);

    /// `cells`: the selected cells; the card describes the last one. Hidden without a selection. `stale`: the numbers belong to an older
    /// picture.
    /// `targets`: the operator's targets by cell, each with its number and name; `names`: the names alone.
    void show(const RockPicture& picture, const std::vector<std::size_t>& cells, bool stale, const RockNames& targets,
              const RockNames& names);
    /// All texts of the card, row by row.
    [[nodiscard]] QString text() const;

    [[nodiscard]] QPushButton* split() const { return split_; }
    [[nodiscard]] QPushButton* cut() const { return cut_; }
    [[nodiscard]] QPushButton* merge() const { return merge_; }
    [[nodiscard]] QPushButton* rockOrNot() const { return rockOrNot_; }
    [[nodiscard]] QToolButton* close() const { return close_; }

signals:
    void closeRequested();
    /// On: the next click on the rock splits it; off: cancelled.
    void splitRequested(bool on);
    /// On: the next line through the rock cuts it; off: cancelled.
    void cutRequested(bool on);
    /// The selected rocks; with one selected, it and the rocks that may be the same rock.
    void mergeRequested();
    void nameRequested();
    void sectionRequested();
    /// Another rock that the card names.
    void rockRequested(std::uint32_t label);
    /// The operator marks it as a rock, or as not a rock.
    void markRequested(bool rock);

private:
    void showRock(const RockPicture& picture, const rocks::Rock& rock, const RockNames& targets, const QString& name);
    void showNoRock(const RockPicture& picture, std::size_t cell);

    QLabel* swatch_;
    QLabel* title_;
    QLabel* spans_;
    QLabel* state_;
    FactList* rows_;
    QLabel* caveat_;
    QToolButton* close_;
    QPushButton* name_;
    QPushButton* section_;
    QPushButton* split_;
    QPushButton* cut_;
    QPushButton* merge_;
    QPushButton* rockOrNot_;
    bool isRock_ = false;
};

} // namespace edgescan::ui
