// Finds the border between two cells' regions, and the level that joins them.
#include "core/rocks/attributes/why_border.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace edgescan::rocks {
namespace {

std::string described(const BorderWhy& why, const Study& study) {
    if (why.regions[0] == 0 || why.regions[1] == 0)
        return "One of the cells belongs to no piece: nothing was measured there, or no piece fits.";
    const bool isRock = study.map.regions[why.regions[0]].kind == RegionKind::Rock;
    const bool isOtherRock = study.map.regions[why.regions[1]].kind == RegionKind::Rock;
    if (why.alwaysOne)
        return std::string("Both cells lie in one piece that no level parts") + (isRock ? "" : ", which is not a rock") +
               "; a stroke can cut it.";
    const std::string level = " at level " + shortestText(study.settings.level);
    if (why.sameRegion())
        return "They are one " + std::string(isRock ? "rock" : "region, which is not a rock,") + level + ", and two below " +
               fixedText(*why.joinedFrom, 2) + ".";
    std::string text = "They are two" + level;
    if (!isRock && !isOtherRock) text = "They are two regions" + level + ", which are not rocks";
    if (isRock != isOtherRock)
        text = "They are two regions" + level + ", of which only the " + (isRock ? "first" : "second") + " is a rock";
    text += why.joinedFrom ? ", and one from level " + fixedText(*why.joinedFrom, 2) + " on" : ", and no level joins them";
    if (!why.border) return text + "; they have no border with each other.";
    const RegionBorder& b = *why.border;
    text += ": on " + std::to_string(b.cracks) + " cracks a jump or valley of " + fixedText(b.mean(b.sumE1), 2) + ", an edge of " +
            fixedText(b.mean(b.sumE2), 2) + " and a valley " + fixedText(30 * b.mean(b.sumValley), 0) + " mm deep near the crack and " +
            fixedText(125 * b.mean(b.sumWide), 0) + " mm on the whole give log odds of " + fixedText(b.meanZ(), 2) + ".";
    return text;
}

} // namespace

BorderWhy whyTwoRocks(const Study& study, std::uint32_t one, std::uint32_t other) {
    BorderWhy why;
    why.cells = {one, other};
    std::uint32_t a = study.segmentation->segment[one];
    std::uint32_t b = study.segmentation->segment[other];
    why.regions = {study.map.regionOfSegment[a], study.map.regionOfSegment[b]};
    why.alwaysOne = a == b && a != kNoSegment;
    if (a != kNoSegment && b != kNoSegment && a != b) {
        for (const Merge& merge : study.tree->merges) {
            if (a == merge.gone) a = merge.remaining;
            if (b == merge.gone) b = merge.remaining;
            if (a != b) continue;
            why.alwaysOne = !std::isfinite(merge.height);
            if (!why.alwaysOne) why.joinedFrom = merge.height;
            break;
        }
    }
    const auto [least, most] = std::minmax(why.regions[0], why.regions[1]);
    for (const RegionBorder& border : study.map.borders) {
        if (least == 0 || border.a != least || border.b != most) continue;
        why.border = border.a == why.regions[0] ? border : border.reversed();
    }
    why.verdict = described(why, study);
    return why;
}

} // namespace edgescan::rocks
