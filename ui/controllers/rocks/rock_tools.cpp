// Edits of rocks by tools and commands, and their exports.
#include "core/files/open_save/save_scan.h"
#include "core/rocks/selection/region_of_interest.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/rocks/change_words.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <QDir>
#include <QFileInfo>

namespace edgescan::ui {
namespace {

CellDrag::Wanted wantedBy(RockTool tool) {
    if (tool == RockTool::None) return CellDrag::Wanted::Nothing;
    return tool == RockTool::Split ? CellDrag::Wanted::Wheel : CellDrag::Wanted::Drag;
}

} // namespace

QString promptOf(RockTool tool) {
    switch (tool) {
    case RockTool::None:
        return {};
    case RockTool::Split:
        return Rocks::tr("Split: click the part that is a rock of its own (wheel: smaller or larger)");
    case RockTool::Join:
        return Rocks::tr("Merge: drag a line across the rocks, or click the one that belongs to the selected rock");
    case RockTool::Cut:
        return Rocks::tr("Cut: drag a line through the rock, or click both its ends");
    case RockTool::Region:
        return Rocks::tr("Region: drag a line around it");
    }
    return {};
}

void Rocks::useTool(RockTool tool) {
    if (tool != RockTool::None && (!on_ || !picture_)) tool = RockTool::None;
    if (tool != RockTool::None && views_.tool() != Tool::Pin) views_.setTool(Tool::Pin); // one tool at a time
    const RockTool before = std::exchange(tool_, tool);
    if (before != tool) {
        cutFrom_.reset();
        drag_.want(wantedBy(tool));
        views_.setPinsOnClick(tool == RockTool::None); // a click of a tool changes rocks and no target
        views_.setTrail({});
        familyPicture_ = nullptr;
        tip_.hide(); // what it says belongs to the tool
        if (before == RockTool::Split) showSelection();
    }
    emit toolChanged(tool_); // also if it was refused: a pressed switch goes back
}

void Rocks::choosePieceAt(std::size_t cell) {
    const Grid<std::uint32_t>& leaf = picture_->study.segmentation->segment;
    if (familyPicture_ == picture_ && leaf[familyCell_] == leaf[cell]) return;
    const rocks::Study& study = picture_->study;
    family_ = rocks::wheelPiecesAt(*study.segmentation, *study.tree, study.settings.level, static_cast<std::uint32_t>(cell), study.edits);
    familyPicture_ = picture_;
    familyCell_ = cell;
    piece_ = family_.split;
}

void Rocks::stepPiece(int by) {
    if (familyPicture_ == nullptr || familyPicture_ != picture_ || family_.nested.pieces.empty()) return;
    const int last = static_cast<int>(family_.nested.pieces.size()) - 1;
    piece_ = static_cast<std::size_t>(std::clamp(static_cast<int>(piece_) + by, 0, last));
    showPiece(nullptr);
}

// Shows the segment's outline in all views, and the effect of a click.
void Rocks::showPiece(const QObject* from) {
    if (family_.nested.pieces.empty()) return;
    const rocks::NestedPiece& piece = family_.nested.pieces[piece_];
    const Grid<std::uint32_t>& leaf = picture_->study.segmentation->segment;
    std::vector<std::uint8_t> isOfPiece(picture_->study.segmentation->sums.size(), 0);
    for (const std::uint32_t n : piece.segments) isOfPiece[n] = 1;
    Grid<std::uint32_t> mask(leaf.lines, leaf.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = isOfPiece[leaf[k]];
    RockOutline outline = outlineOf(mask, 1);
    QString does = tr("the whole piece as it is");
    if (piece_ < family_.nested.region) does = tr("a click splits it off");
    if (piece_ > family_.nested.region) does = tr("larger than the rock: a click merges it");
    const bool smallest = piece_ == 0, largest = piece_ + 1 == family_.nested.pieces.size();
    const QString wheel = smallest && largest ? tr("no smaller and no larger part")
                          : smallest          ? tr("wheel: larger (this is the smallest part)")
                          : largest           ? tr("wheel: smaller (this is the largest piece)")
                                              : tr("wheel: smaller or larger");
    const QString tip = tr("%1 cells, %2").arg(countText(piece.cells), does) + QStringLiteral(" · ") + wheel;
    views_.setOutline(outline.sides, std::move(outline.cells));
    tip_.show(familyCell_, tip, from);
}

void Rocks::splitAt(std::size_t cell) {
    if (picture_->regionAt(cell) == nullptr) {
        useTool(RockTool::None);
        notice_.showHint(tr("Nothing was split: click on a rock, on the part that is a rock of its own."));
        return;
    }
    choosePieceAt(cell);
    const bool isLarger = piece_ > family_.nested.region;
    rocks::Edit edit = family_.nested.pieces[piece_].edit;
    auto joinedSplit = rocks::editsOfSplit(*picture_->study.segmentation, family_, piece_);
    useTool(RockTool::None);
    if (joinedSplit) { // all edits of these rocks but the joins: a later one is not in it
        if (picture_->study.edits != edits_)
            return notice_.showHint(tr("The rocks are still being computed: split again when they are here."));
        select({cell});
        return pushEdits(stepName("split of a rock"), std::move(*joinedSplit), rocks::EditKind::Part);
    }
    if (edit.cells.empty()) {
        notice_.showHint(tr(
            "Nothing was split: this rock is one piece without a line that separates parts. Cut along a Line splits it where you draw."));
        return;
    }
    select({cell});
    std::vector<rocks::Edit> added{std::move(edit)};
    if (isLarger) return push(stepName("merge of rocks"), std::move(added));
    // The operator says that the part is a rock of its own: alone it may look like a wall.
    if (picture_->labelAt(cell) != 0) added.push_back({rocks::EditKind::Rock, {static_cast<std::uint32_t>(cell)}});
    push(stepName("split of a rock"), std::move(added));
}

/// Two clicks are the ends of a straight line, as of a measurement. False: this click was the first one.
bool Rocks::completesCut(std::vector<QPoint>& cells) {
    constexpr std::size_t kMostOfClick = 2; // cells that a hand may touch
    if (tool_ != RockTool::Cut || cells.empty() || cells.size() > kMostOfClick) return true;
    if (!cutFrom_) {
        cutFrom_ = cells.front();
        notice_.showHint(tr("Click the other end of the line, past the other side of the rock."));
        return false;
    }
    cells = {*cutFrom_, cells.back()};
    return true;
}

void Rocks::applyStroke(std::vector<QPoint> cells) {
    if (!completesCut(cells)) return;
    const RockTool tool = tool_;
    useTool(RockTool::None);
    if (!picture_) return;
    if (tool == RockTool::Region) return applyRegion(cells);
    rocks::CutLine stroke;
    for (const QPoint& cell : cells) stroke.push_back(static_cast<std::uint32_t>(picture_->labels.index(cell.y(), cell.x())));
    if (!cells.empty() && !picture_->labels.contains(cells.back().y(), cells.back().x())) stroke.clear(); // of a sweep that grew meanwhile
    if (tool == RockTool::Join) applyJoin(stroke);
    if (tool == RockTool::Cut)
        cutter_.ask({picture_, std::move(stroke), stream_, chosen() ? std::optional(static_cast<std::uint32_t>(*chosen())) : std::nullopt});
}

void Rocks::applyCut(const CutAsked& asked, const std::vector<rocks::Edit>& cut) {
    if (asked.stream != stream_) return; // the cells are of another scan
    if (!cut.empty()) {
        const rocks::Edit& part = cut.back();
        const auto* whole = asked.of->regionAt(part.cells.front());
        const bool isSelected = selected_.size() == 1 && asked.of->regionAt(selected_.front()) == whole;
        if (part.kind == rocks::EditKind::Whole && !isSelected) select({part.cells.front()}); // the card shows what was cut
        return push(stepName("cut of a rock"), cut);
    }
    notice_.showHint(tr("Nothing was cut: draw the line through a rock, from one side to the other. Each part needs %1 cells.")
                         .arg(rocks::kFewestSplit));
    writeWaiting();
}

void Rocks::applyJoin(const rocks::CutLine& stroke) {
    const rocks::Study& study = picture_->study;
    auto join = rocks::joinAlong(*study.segmentation, study.map, stroke);
    if (!join && !stroke.empty() && chosen()) {
        const std::array<std::uint32_t, 2> cells{static_cast<std::uint32_t>(*chosen()), stroke.back()};
        join = rocks::joinOf(*study.segmentation, study.map, cells);
    }
    if (join) return push(stepName("merge of rocks"), {std::move(*join)});
    notice_.showHint(tr("Nothing was merged: draw the line from one rock over the crack into the next."));
}

void Rocks::applyRegion(const std::vector<QPoint>& cells) {
    std::vector<rocks::RegionCorner> drawn;
    for (const QPoint& cell : cells) drawn.push_back({cell.y(), cell.x()});
    OperatorEdits after = operatorEdits();
    after.region = rocks::regionOfDrawing(drawn);
    if (after.region.empty())
        notice_.showHint(tr("There is no region yet: draw the line round what counts, in one of the images."));
    else
        pushOperatorEdits(stepName("region of interest"), std::move(after));
}

void Rocks::clearRegion() {
    if (settings_.region.empty()) return;
    OperatorEdits after = operatorEdits();
    after.region.clear();
    pushOperatorEdits(stepName("region of interest"), std::move(after));
}

namespace {

constexpr qint64 kOneTurnMs = 1000;

QString nameOfTurn(const rocks::RockSettings& before, const rocks::RockSettings& after) {
    for (const rocks::RockParameter& row : rocks::rockParameters()) {
        if (row.get(before) != row.get(after)) return QString(row.label) + '\n' + QObject::tr(row.label);
    }
    return stepName("region of interest");
}

} // namespace

void Rocks::change(const rocks::RockSettings& settings) {
    if (settings == settings_) return;
    const QString name = nameOfTurn(settings_, settings);
    if (turned_ != name || !sinceTurn_.isValid() || sinceTurn_.elapsed() > kOneTurnMs) turn_ = nextDrag();
    turned_ = name;
    sinceTurn_.start();
    undo_.push(new UndoStep<rocks::RockSettings>(
        turn_, [name](const rocks::RockSettings&, const rocks::RockSettings&) { return name; }, settings_, settings,
        [this](rocks::RockSettings value) {
            value.region = settings_.region; // it belongs to one scan and has its own undo steps
            useSettings(value);
            return true;
        }));
}

void Rocks::reset(const QString& parameter) {
    rocks::RockSettings settings = settings_;
    for (const rocks::RockParameter& row : rocks::rockParameters()) {
        if (on_ && (parameter.isEmpty() || parameter == row.key)) row.set(settings, row.get(rocks::RockSettings{}));
    }
    change(settings);
}

std::optional<rocks::Preset> Rocks::part() const {
    if (!on_ || !engine_.picture()) return std::nullopt;
    return rocks::Preset{settings_, edits_, engine_.picture()->detection->scan->sha256};
}

void Rocks::setPart(const std::optional<rocks::Preset>& part) {
    if (!part) return;
    if (sidecar_.reading()) {
        restored_ = part;
        return;
    }
    const rocks::RockSettings settings = part->settings.value_or(settings_);
    const OperatorEdits byHandThen{part->edits, settings.region};
    change(settings);
    if (byHandThen == operatorEdits()) return;
    const bool replaces = operatorEdits() != OperatorEdits{};
    pushOperatorEdits(stepName("Open Session"), byHandThen);
    if (replaces)
        notice_.showNotice(NoticeBar::Kind::Warning,
                           tr("The session's edits of rocks replaced those that were stored next to the scan; Ctrl+Z brings them back."));
}

void Rocks::setOperatorEdits(const OperatorEdits& byHand) {
    if (byHand == this->operatorEdits()) return;
    edits_ = byHand.edits;
    settings_.region = byHand.region;
    panel_.showSettings(settings_);
    sidecar_.keep(settings_, edits_);
    ask();
    emit changed();
}

void Rocks::pushOperatorEdits(const QString& name, OperatorEdits after, const std::vector<std::size_t>& merged) {
    const auto use = [this, merged, before = operatorEdits(), after](const OperatorEdits& value) {
        const bool isUndo = value != after;
        // What another window changed meanwhile stays.
        setOperatorEdits({rocks::mergedEdits((isUndo ? after : before).edits, value.edits, edits_), value.region});
        if (on_ && !merged.empty()) select(isUndo ? merged : std::vector{merged.back()});
        return true;
    };
    auto* step = new UndoStep<OperatorEdits>(name, operatorEdits(), std::move(after), use,
                                             engine_.hereNow()); // a closed scan takes its edits with it
    newestEdit_ = step;
    undo_.push(step);
}

void Rocks::push(const QString& name, std::vector<rocks::Edit> added, const std::vector<std::size_t>& merged) {
    const rocks::EditKind kind = added.front().kind;
    std::vector<rocks::Edit> edits = edits_;
    std::ranges::move(added, std::back_inserter(edits));
    pushEdits(name, std::move(edits), kind, merged);
}

/// What the step changed is judged when its rocks are known; before, this only is known of those on the screen that have all edits so far.
void Rocks::pushEdits(const QString& name, std::vector<rocks::Edit> edits, rocks::EditKind kind, const std::vector<std::size_t>& merged) {
    const bool known = picture_ && !ofAnotherPicture() && picture_->study.edits == edits_ && picture_->study.settings == settings_;
    judgedFrom_ = known ? picture_ : nullptr;
    judgedKind_ = kind;
    pushOperatorEdits(name, {std::move(edits), settings_.region}, merged);
}

/// Undo takes back the newest edit.
/// A step that changed no rock is taken back. Else it is said which rocks have another number now, and which part is not a rock.
void Rocks::judgeEdit() {
    if (!judgedFrom_ || picture_->study.edits != edits_ || picture_->study.edits == judgedFrom_->study.edits) return;
    const auto before = std::exchange(judgedFrom_, nullptr);
    if (before->detection != picture_->detection || before->study.settings != picture_->study.settings) return;
    const rocks::RegionChanges changes =
        rocks::regionChanges(*before->study.segmentation, before->study.map, *picture_->study.segmentation, picture_->study.map);
    if (!changes.any) {
        if (!isNewest(undo_, newestEdit_)) return;
        newestEdit_->undo();            // the stack calls undo() of no obsolete step,
        newestEdit_->setObsolete(true); // which it only removes
        undo_.undo();
        return notice_.showHint(
            tr("No rock changed, so nothing is to be undone. Click on another part of the rock, or draw across the whole of it, past its "
               "outline."));
    }
    const bool merges = judgedKind_ == rocks::EditKind::Join;
    const QString apart = merges ? apartWords(edits_.back().cells, *before, *picture_) : QString(); // names the merged rock too
    const QString result = apart.isEmpty() ? editWords(judgedKind_, *before, *picture_) : apart;
    const QString words = QStringList{result, changeWords(changes, *picture_)}.join(' ').trimmed();
    if (words.isEmpty()) return;
    if (apart.isEmpty() && !changes.lost.empty())
        notice_.showHint(words); // until the next step, which may be its undo
    else
        notice_.showNotice(apart.isEmpty() ? NoticeBar::Kind::Done : NoticeBar::Kind::Warning, words);
    if (isNewest(undo_, newestEdit_)) notice_.offerUndo(undo_);
}

void Rocks::mergeOffered() {
    const rocks::Rock* rock = picture_ && selected_.size() == 1 ? picture_->rockAt(selected_.front()) : nullptr;
    if (rock == nullptr || rock->maybeOneWith.empty()) return mergeSelected();
    std::vector<std::uint32_t> cells{rock->cell};
    for (const std::uint32_t other : rock->maybeOneWith) cells.push_back(picture_->rock(other)->cell);
    merge(cells);
}

void Rocks::mergeSelected() {
    if (!picture_) return;
    std::vector<std::uint32_t> cells;
    for (const std::size_t cell : selected_) {
        if (picture_->regionAt(cell) != nullptr) cells.push_back(static_cast<std::uint32_t>(cell));
    }
    if (cells.size() < 2) return useTool(RockTool::Join);
    merge(cells);
}

void Rocks::merge(const std::vector<std::uint32_t>& cells) {
    auto join = rocks::joinOf(*picture_->study.segmentation, picture_->study.map, cells);
    if (!join) return notice_.showHint(tr("Nothing was merged: this is one rock already."));
    push(stepName("merge of rocks"), {std::move(*join)}, selected_);
}

void Rocks::callChosen(bool rock) {
    if (!picture_ || !chosen() || picture_->regionAt(*chosen()) == nullptr) return;
    push(rock ? stepName("mark as a rock") : stepName("mark as not a rock"),
         {{rock ? rocks::EditKind::Rock : rocks::EditKind::NotRock, {static_cast<std::uint32_t>(*chosen())}}});
}

void Rocks::toggleChosen() {
    if (!picture_ || !chosen()) return notice_.showHint(tr("Select a rock first: show the rocks and click on the face of one."));
    callChosen(picture_->labelAt(*chosen()) == 0);
}

namespace {

// The extension determines the content of the file.
struct RockFile {
    const exports::ExportKind* kind;
    const exports::ExportFile* file;
};

// The table is first: it is the file that people use most.
const std::vector<RockFile>& rockFiles() {
    static const std::vector<RockFile> kFiles = [] {
        std::vector<RockFile> files;
        for (const exports::ExportKind& kind : exports::exportKinds()) {
            for (const exports::ExportFile& file : kind.files) {
                if (file.title != nullptr) files.push_back({&kind, &file});
            }
        }
        std::ranges::stable_partition(files, [](const RockFile& each) { return each.kind->content == exports::ExportContent::RockTable; });
        return files;
    }();
    return kFiles;
}

const RockFile* rockFileOf(const QString& path) {
    const std::string extension = "." + QFileInfo(path).suffix().toLower().toStdString();
    const auto found = std::ranges::find_if(rockFiles(), [&](const RockFile& each) { return extension == each.file->extension; });
    return found == rockFiles().end() ? nullptr : &*found;
}

} // namespace

void Rocks::askExport(bool all) {
    if (!picture_) {
        notice_.showHint(tr("There is nothing to export yet: show the rocks of a scan first."));
        return;
    }
    SaveQuestion question;
    const std::size_t count = picture_->study.rocks.size();
    const auto listed = all ? std::nullopt : table_.listed();
    question.title = listed && listed->size() < count ? tr("Export %1 of %2").arg(listed->size()).arg(rockCount(count))
                                                      : tr("Export %1").arg(rockCount(count));
    for (const RockFile& each : rockFiles())
        question.filters << QString("%1 (*%2)").arg(QObject::tr(each.file->title), each.file->extension);
    question.extension = rockFiles().front().file->extension;
    const QString name = shownName(exactText(picture_->detection->scan->name), 80).replace(' ', '-').replace('/', '-') + "_rocks" +
                         frameTail(files::usualFrame(*picture_->detection->scan));
    question.place = QDir(preferences_.folder("exports")).filePath(name + question.extension);
    question.files = withItsRecord;
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) exportTo(path, all);
}

void Rocks::exportTo(const QString& path, bool all) {
    const RockFile* file = rockFileOf(path);
    if (file == nullptr) {
        QStringList endings;
        for (const RockFile& each : rockFiles()) endings << each.file->extension + 1; // without its dot
        notice_.showNotice(NoticeBar::Kind::Error, tr("%1 was not written: give it one of the endings %2.").arg(path, endings.join(", ")));
        return;
    }
    whenKnown(path, [this, path, file, all] {
        exports::ExportOptions options;
        if (file->file->coordinates != exports::ExportFile::Coordinates::None)
            options.frame = files::usualFrame(*picture_->detection->scan);
        options.rocks = std::shared_ptr<const rocks::Study>(picture_, &picture_->study);
        if (auto listed = all ? std::nullopt : table_.listed()) {
            auto study = std::make_shared<rocks::Study>(picture_->study);
            study->listed = std::move(listed);
            options.rocks = std::move(study);
        }
        if (!pinnedTargets_.empty()) options.targets = std::make_shared<const std::vector<inspect::PinnedTarget>>(pinnedTargets_);
        engine_.save(file->kind->content, path, options);
    });
}

void Rocks::whenKnown(const QString& path, std::function<void()> write) {
    if (picture_ && !behind()) return write();
    const auto cancel = [this, path] { std::erase_if(waiting_, [&](const Waiting& each) { return each.path == path; }); };
    waiting_.push_back(
        {path, std::move(write), engine_.works().start(tr("%1 waits for the rocks").arg(QFileInfo(path).fileName()), cancel)});
    if (!on_ || !(working() || nextOfSweep_.isActive())) refuseWaiting(); // nothing would end the wait
}

void Rocks::writeWaiting() {
    if (!picture_ || behind()) return;
    for (const Waiting& each : std::exchange(waiting_, {})) each.write();
}

void Rocks::refuseWaiting() {
    for (const Waiting& each : std::exchange(waiting_, {}))
        notice_.showNotice(NoticeBar::Kind::Warning, tr("%1 was not written: its rocks are not known.").arg(each.path));
}

} // namespace edgescan::ui
