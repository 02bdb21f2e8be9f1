// The rows of the table of columns.
#include "core/rocks/attributes/rock_columns.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"

#include <array>

namespace edgescan::rocks {
namespace {

constexpr std::size_t kColumns = 29;
constexpr int kWhole = 0, kHundredths = 2;

double millimetres(double metres) { return rounded(metres, 1000); }
double thousandths(double share) { return rounded(share, 1000); }
std::string fixed(double value, int decimals) { return fixedText(value, decimals); }
std::string atLeast(double value, int decimals) { return value > 0 ? "≥ " + fixedText(value, decimals) : "–"; }

template <int Axis>
RockValue coordinate(const RockRow& r) {
    return millimetres(r.centreM[Axis]);
}
template <int Axis>
std::string coordinateText(const RockRow& r) {
    return fixed(r.centreM[Axis], kHundredths);
}

using Row = const RockRow&;

std::array<RockColumn, kColumns> columnsOf(CoordinateFrame frame) {
    const auto names = coordinateNames(frame);
    const bool mine = frame == CoordinateFrame::Mine;
    const bool local = frame == CoordinateFrame::MineLocal;
    // clang-format off
    return {{
        {"rock", "Rock", "The number: without edits, 1 is the largest visible area",
         [](Row r) -> RockValue { return r.rock->label; }, [](Row r) { return std::to_string(r.rock->label) + (r.rock->apart.empty() ? "" : " ▲"); }, true},
        {"line", nullptr, "Scan line of the measured cell closest to its centre",
         [](Row r) -> RockValue { return static_cast<std::uint32_t>(r.line); }, nullptr, false},
        {"beam", nullptr, "Beam of that cell",
         [](Row r) -> RockValue { return static_cast<std::uint32_t>(r.beam); }, nullptr, false},
        {"cells", nullptr, "Number of measured cells, without spikes", [](Row r) -> RockValue { return r.rock->cells; }, nullptr, false},
        {names[0], mine ? "E [m]" : local ? "east [m]" : "x [m]", "Mean of its visible points", coordinate<0>, coordinateText<0>, false},
        {names[1], mine ? "N [m]" : local ? "north [m]" : "y [m]", "Mean of its visible points", coordinate<1>, coordinateText<1>, false},
        {names[2], mine ? "RL [m]" : local ? "up [m]" : "z [m]", "Mean of its visible points", coordinate<2>, coordinateText<2>, false},
        {"visible_long_m", "visible length a [m]", "Largest visible span across the line of sight; hidden parts are not counted",
         [](Row r) -> RockValue { return millimetres(r.rock->longestCaliperM); },
         [](Row r) { return fixed(r.rock->longestCaliperM, kHundredths); }, true},
        {"visible_wide_m", "size: visible width b [m]", "Size of the rock: smallest visible span across the line of sight; hidden parts are not counted",
         [](Row r) -> RockValue { return millimetres(r.rock->shortestCaliperM); },
         [](Row r) { return fixed(r.rock->shortestCaliperM, kHundredths); }, true},
        {"tolerance_m", "± of a and b [m]", "Of a and b: spacing of the points and width of the beam, twice",
         [](Row r) -> RockValue { return millimetres(r.rock->toleranceM); },
         [](Row r) { return fixed(shownTolerance(r.rock->toleranceM, kHundredths), kHundredths); }, true},
        {"distance_m", "distance [m]", "From the scanner: median of its ranges",
         [](Row r) -> RockValue { return millimetres(r.rock->distanceM); },
         [](Row r) { return fixed(r.rock->distanceM, kHundredths); }, true},
        {"visible_area_m2", "area [m²]", "Visible area across the beams",
         [](Row r) -> RockValue { return rounded(r.rock->areaM2, 1e4); }, [](Row r) { return fixed(r.rock->areaM2, kHundredths); }, true},
        {"unoccluded_share", "in front [%]", "Share of its outline where it is the nearer side",
         [](Row r) -> RockValue { return thousandths(r.rock->unoccluded); },
         [](Row r) { return fixed(100 * r.rock->unoccluded, kWhole); }, true},
        {"in_front_of", nullptr, "Rocks behind it", [](Row r) -> RockValue { return std::span(r.rock->rocksBehind); }, nullptr, false},
        {"behind", nullptr, "Rocks in front of it", [](Row r) -> RockValue { return std::span(r.rock->rocksInFront); }, nullptr, false},
        {"contacts_at_least", "contacts (≥)", "Rocks that it is seen to touch: at least these",
         [](Row r) -> RockValue { return std::span(r.rock->contacts); },
         [](Row r) { return atLeast(static_cast<double>(r.rock->contacts.size()), kWhole); }, true},
        {"touches_other", nullptr, "It is seen to touch something that is not a rock",
         [](Row r) -> RockValue { return r.rock->touchesOther; }, nullptr, false},
        {"free_below_at_least_m", "free below [m]",
         "Free height under its lowest visible point: at least this; what sent nothing back is never free; without a pose, up is the scanner's z axis",
         [](Row r) -> RockValue { return rounded(r.rock->freeHeightM, 100); },
         [](Row r) { return atLeast(r.rock->freeHeightM, kHundredths); }, true},
        {"arch_deg", "arch [°] ± 25", "Largest angle at it between two rocks that it touches; ↓: it hangs below the line between them; without a pose, up is the scanner's z axis",
         [](Row r) -> RockValue { return r.rock->archDeg ? RockValue(rounded(*r.rock->archDeg, 1)) : RockValue(); },
         [](Row r) { return r.rock->archDeg ? fixed(*r.rock->archDeg, kWhole) + (r.rock->isBelowContacts ? " ↓" : "") : "–"; }, true},
        {"arch_tolerance_deg", nullptr, "Uncertainty of the arch angle",
         [](Row r) -> RockValue { return r.rock->archDeg ? RockValue(kArchToleranceDeg) : RockValue(); }, nullptr, false},
        {"hangs_below", nullptr, "It hangs below the line between the two rocks of the arch",
         [](Row r) -> RockValue { return r.rock->archDeg ? RockValue(r.rock->isBelowContacts) : RockValue(); }, nullptr, false},
        {"finer_share", nullptr, "Share of the rocks that are not wider than it: visible_wide_m against it is the size curve",
         [](Row r) -> RockValue { return thousandths(r.finerShare); }, nullptr, false},
        {"confidence", "confidence p", "Chance that its outline is right; ▲ and hatched: below 0.85",
         [](Row r) -> RockValue { return thousandths(r.rock->confidence); },
         [](Row r) { return (isDoubtful(*r.rock) ? "▲ " : "") + confidenceText(*r.rock); }, true},
        {"by_hand", nullptr, "It was called a rock by hand", [](Row r) -> RockValue { return r.rock->byHand; }, nullptr, false},
        {"note", nullptr, "What every rock is", [](Row) -> RockValue { return kRockCaveat; }, nullptr, false},
        {"apart_m", nullptr, "It was merged by hand of parts that do not touch: the largest distance between their nearest cells",
         [](Row r) -> RockValue { return r.rock->apart.empty() ? RockValue() : RockValue(millimetres(r.rock->apartM())); }, nullptr, false},
        {"may_be_one_with", nullptr, "Rocks that may be the same rock: joining them is nearly as likely to be right",
         [](Row r) -> RockValue { return std::span(r.rock->maybeOneWith); }, nullptr, false},
        {"names", nullptr, "Names of the targets on it", [](Row r) -> RockValue { return r.names.empty() ? RockValue() : RockValue(r.names.c_str()); },
         nullptr, false},
        {"up_assumed", nullptr, "The scan has no pose, so up is the scanner's z axis: free height below it and whether it hangs",
         [](Row r) -> RockValue { return r.upAssumed; }, nullptr, false},
    }};
    // clang-format on
}

} // namespace

std::span<const RockColumn> rockColumns(CoordinateFrame frame) {
    static const std::array kByFrame{columnsOf(CoordinateFrame::Scanner), columnsOf(CoordinateFrame::MineLocal),
                                     columnsOf(CoordinateFrame::Mine)};
    return kByFrame[static_cast<std::size_t>(frame)];
}

double sortingNumber(const RockValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* whole = std::get_if<std::uint32_t>(&value)) return *whole;
    if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
    if (const auto* list = std::get_if<std::span<const std::uint32_t>>(&value)) return static_cast<double>(list->size());
    return -1;
}

RockRows::RockRows(const Study& study, CoordinateFrame frame, const NamedCells& names)
    : frame_(frame), beams_(static_cast<std::uint32_t>(study.segmentation->segment.beams)),
      upAssumed_(upOf(*study.segmentation->inputs.scan).assumed), curve_(sizeCurve(study.rocks, study.settings.oversizeM)) {
    if (frame != CoordinateFrame::Scanner) placed_.emplace(*study.segmentation->inputs.scan);
    if (names.empty()) return;
    const Grid<std::uint32_t> labels = rockLabels(*study.segmentation, study.map);
    for (const auto& [cell, name] : names) {
        if (name.empty() || cell >= labels.size() || labels[cell] == 0) continue;
        std::string& all = names_[labels[cell]];
        all += (all.empty() ? "" : "; ") + name;
    }
}

RockRow RockRows::of(const Rock& rock) const {
    RockRow row{&rock, static_cast<int>(rock.cell / beams_), static_cast<int>(rock.cell % beams_), rock.centreM,
                curve_.shareUpTo(rock.shortestCaliperM)};
    row.upAssumed = upAssumed_;
    if (const auto named = names_.find(rock.label); named != names_.end()) row.names = named->second;
    if (placed_) row.centreM = placed_->inFrame(frame_, row.line, row.beam, rock.centreM);
    return row;
}

} // namespace edgescan::rocks
