// The card of the selection.
#include "ui/panels/rocks/rock_card.h"

#include "core/base/tolerance_text.h"
#include "ui/base/count_text.h"
#include "ui/base/flow_layout.h"
#include "ui/base/narrow_button.h"
#include "ui/base/shown_text.h"
#include "ui/panels/rocks/rock_table_model.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kSwatchSide = 16; // px

constexpr double kLarge = 1.5; // relative to the normal font size

QString metres(double value, int decimals = 2) { return RockCard::tr("%1 m").arg(value, 0, 'f', decimals); }
QString atLeastText(const QString& value) { return RockCard::tr("at least %1").arg(value); }

QString link(std::uint32_t label) { return QString("<a href=\"%1\">%1</a>").arg(label); }

QStringList links(const std::vector<std::uint32_t>& rocks) {
    QStringList labels;
    for (const std::uint32_t other : rocks) labels << link(other);
    return labels;
}

QString contactsText(const rocks::Rock& rock) {
    const QStringList labels = links(rock.contacts);
    if (labels.isEmpty()) return rock.touchesOther ? RockCard::tr("something that is not a rock") : RockCard::tr("none seen");
    return labels.size() == 1 ? RockCard::tr("at least 1: rock %1").arg(labels.front())
                              : RockCard::tr("at least %1: rocks %2").arg(QString::number(labels.size()), labels.join(", "));
}

QString listed(const std::vector<std::uint32_t>& rocks) {
    const QStringList labels = links(rocks);
    return labels.isEmpty() ? QStringLiteral("–") : labels.join(", ");
}

QString archText(const rocks::Rock& rock) {
    if (!rock.archDeg) return QStringLiteral("–");
    return RockCard::tr("%1° ± %2°%3%4")
        .arg(*rock.archDeg, 0, 'f', 0)
        .arg(rocks::kArchToleranceDeg, 0, 'f', 0)
        .arg(RockCard::tr(", between rocks %1 and %2").arg(link(rock.archBetween[0]), link(rock.archBetween[1])))
        .arg(rock.isBelowContacts ? RockCard::tr(", hangs below") : QString());
}

QString whyNoRock(const rocks::Region* region) {
    if (region == nullptr) return RockCard::tr("nothing was measured here, or no piece fits");
    switch (region->kind) {
    case rocks::RegionKind::Fines:
        return RockCard::tr("fines: too few cells to be shown as a rock");
    case rocks::RegionKind::Outside:
        return RockCard::tr("outside the region of interest");
    case rocks::RegionKind::Rock:
    case rocks::RegionKind::NotRock:
        break;
    }
    if (region->byHand) return RockCard::tr("marked by hand as not a rock");
    return region->score > 0 && region->confidence < rocks::kLeastConfidence ? RockCard::tr("too uncertain to be shown as a rock")
                                                                             : RockCard::tr("wall, floor, or too far away");
}

} // namespace

RockCard::RockCard(QWidget* parent)
    : QFrame(parent), swatch_(new QLabel), title_(new QLabel), spans_(new LargeLabel(kLarge)), state_(new QLabel), rows_(new FactList),
      caveat_(new QLabel), close_(new QToolButton), name_(new NarrowButton(tr("Name…"))), section_(new NarrowButton(tr("Section"))),
      split_(new NarrowButton(tr("Split"))), cut_(new NarrowButton(tr("Cut"))), merge_(new NarrowButton(tr("Merge"))),
      rockOrNot_(new NarrowButton(tr("Not a Rock"))) {
    setObjectName("rock-card");
    setFrameShape(QFrame::StyledPanel);
    QFont bold = font();
    bold.setBold(true);
    title_->setFont(bold);
    title_->setWordWrap(true); // several selected rocks must not widen the panel, which would move the cloud
    close_->setText(QStringLiteral("✕"));
    close_->setAutoRaise(true);
    close_->setToolTip(tr("Deselect this rock"));
    caveat_->setWordWrap(true);
    state_->setWordWrap(true);
    spans_->setObjectName("rock-spans");
    caveat_->setText(tr("Hidden parts are not counted."));

    auto* head = new QHBoxLayout;
    head->addWidget(swatch_);
    head->addWidget(title_, 1);
    head->addWidget(close_);
    state_->setObjectName("rock-state");
    state_->setTextFormat(Qt::RichText);
    // A clicked number replaces the text that it is in: only after the click.
    connect(state_, &QLabel::linkActivated, rows_, &FactList::linked, Qt::QueuedConnection);
    connect(rows_, &FactList::linked, this, [this](const QString& rock) { emit rockRequested(rock.toUInt()); });
    split_->setCheckable(true);
    split_->setToolTip(tr("Then click the part of the rock that is a rock of its own; the wheel takes a smaller or a larger part (S)"));
    cut_->setCheckable(true);
    cut_->setToolTip(tr("Then draw a line through the rock, from one side to the other (X)"));
    name_->setObjectName("rock-name");
    name_->setToolTip(tr("A target on this rock holds its name (F2)"));
    section_->setObjectName("rock-section");
    section_->setToolTip(tr("The vertical plane through the rock, along its longest visible width"));
    merge_->setToolTip(tr("The selected rocks are one; Ctrl+click selects several (M)"));
    auto* buttons = new FlowLayout;
    buttons->setSpacing(4);
    for (QPushButton* button : {split_, cut_, merge_, rockOrNot_, name_, section_}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        buttons->addWidget(button);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addLayout(buttons); // above the texts, which grow and shrink under the pointer
    column->addLayout(head);
    column->addWidget(spans_);
    column->addWidget(state_);
    column->addWidget(rows_);
    column->addWidget(caveat_);

    connect(close_, &QToolButton::clicked, this, &RockCard::closeRequested);
    connect(name_, &QPushButton::clicked, this, &RockCard::nameRequested);
    connect(section_, &QPushButton::clicked, this, &RockCard::sectionRequested);
    connect(split_, &QPushButton::clicked, this, &RockCard::splitRequested);
    connect(cut_, &QPushButton::clicked, this, &RockCard::cutRequested);
    connect(merge_, &QPushButton::clicked, this, &RockCard::mergeRequested);
    connect(rockOrNot_, &QPushButton::clicked, this, [this] { emit markRequested(!isRock_); });
    hide();
}

void RockCard::show(const RockPicture& picture, const std::vector<std::size_t>& cells, bool stale, const RockNames& targets,
                    const RockNames& names) {
    setVisible(!cells.empty());
    if (cells.empty()) return;
    const rocks::Rock* rock = picture.rockAt(cells.back());
    isRock_ = rock != nullptr;
    if (isRock_)
        showRock(picture, *rock, targets, picture.nameOf(rock->label, names));
    else
        showNoRock(picture, cells.back());
    if (cells.size() > 1) title_->setText(tr("%1, and %2 more selected").arg(title_->text()).arg(cells.size() - 1));
    QStringList state;
    if (stale) state << tr("▲ of the picture before; being computed again");
    if (isRock_ && isDoubtful(*rock)) state << tr("▲ uncertain outline: hatched");
    if (isRock_ && !rock->apart.empty()) state << partsText(*rock);
    const bool maybeOne = isRock_ && !rock->maybeOneWith.empty();
    if (maybeOne) state << tr("may be one with %1: Merge joins them").arg(rocksText(rock->maybeOneWith, link));
    if (isRock_ && rock->byHand) state << tr("a rock by hand: marked or cut");
    state_->setText(state.join("<br>"));
    state_->setVisible(!state.isEmpty());
    for (QPushButton* button : {split_, cut_, name_, section_}) button->setEnabled(isRock_);
    merge_->setEnabled(cells.size() > 1 || maybeOne);
    const rocks::Region* region = picture.regionAt(cells.back());
    rockOrNot_->setEnabled(region != nullptr);
    rockOrNot_->setText(isRock_ ? tr("Not a Rock") : tr("A Rock"));
    rockOrNot_->setToolTip(isRock_ ? tr("This is a wall, a floor or something else (N)") : tr("This is a rock (N)"));
}

void RockCard::showRock(const RockPicture& picture, const rocks::Rock& rock, const RockNames& targets, const QString& name) {
    swatch_->setPixmap(QPixmap::fromImage(rockSwatch(picture, rock, kSwatchSide)));
    title_->setText(tr("Rock %1").arg(rock.label) + (name.isEmpty() ? QString() : " " + name)); // as in the table
    spans_->setText(tr("%1 × %2 m").arg(rock.longestCaliperM, 0, 'f', 2).arg(rock.shortestCaliperM, 0, 'f', 2));
    spans_->show();
    const auto linked = [](const char* key, const QString& title, const QString& value) {
        return Fact{.key = key, .name = title, .value = value, .links = true};
    };
    Facts facts{{"size", tr("visible spans a × b"), "± " + metres(shownTolerance(rock.toleranceM, 2))},
                {"distance", tr("distance, median"), metres(rock.distanceM)},
                {"area", tr("visible area"), tr("%1 m²").arg(rock.areaM2, 0, 'f', 2)},
                {"front", tr("in front"), tr("%1 % of its outline").arg(100.0 * rock.unoccluded, 0, 'f', 0)},
                linked("behind", tr("behind rocks"), listed(rock.rocksInFront)),
                linked("contacts", tr("visible contacts"), contactsText(rock)),
                {"free", tr("free height below"), rock.freeHeightM > 0.0 ? atLeastText(metres(rock.freeHeightM)) : tr("none seen")},
                linked("arch", tr("arch angle"), archText(rock))};
    if (rocks::upOf(*picture.study.segmentation->inputs.scan).assumed)
        facts.push_back({"up", tr("up"), tr("the scanner's z axis, assumed")});
    facts.push_back({"confidence", tr("confidence p"), exactText(rocks::confidenceText(rock))});
    QStringList pinned;
    for (const auto& [cell, target] : targets) {
        if (picture.labelAt(cell) == rock.label) pinned << target;
    }
    if (!pinned.isEmpty()) facts.push_back({"target", tr("pinned target"), pinned.join(", ")});
    rows_->show(facts);
}

void RockCard::showNoRock(const RockPicture& picture, std::size_t cell) {
    swatch_->clear();
    title_->setText(tr("Not a rock"));
    spans_->hide();
    const rocks::Region* region = picture.regionAt(cell);
    Facts facts{{"because", tr("because"), whyNoRock(region)}};
    if (region != nullptr) {
        facts.push_back({"cells", tr("cells"), countText(region->sums.cells)});
        facts.push_back({"area", tr("visible area"), tr("%1 m²").arg(region->sums.areaM2, 0, 'f', 2)});
    }
    rows_->show(facts);
}

QString RockCard::text() const {
    QStringList lines{title_->text(), spans_->isHidden() ? QString() : spans_->text(),
                      QTextDocumentFragment::fromHtml(state_->text()).toPlainText()};
    lines << rows_->texts();
    lines << rockCaveat() << caveat_->text();
    return lines.join('\n');
}

} // namespace edgescan::ui

#include "moc_rock_card.cpp"
