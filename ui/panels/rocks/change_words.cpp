// Sentences about changed rocks.
#include "ui/panels/rocks/change_words.h"

#include "ui/base/count_text.h"

#include <QObject>
#include <QStringList>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace edgescan::ui {
namespace {

QString lostWords(const rocks::RegionChanges::Lost& lost, const RockPicture& picture) {
    const rocks::Region& region = picture.study.map.regions[lost.region];
    const rocks::RockSettings& settings = picture.study.settings;
    const QString part =
        QObject::tr("A part of rock %1 (%2 cells) is not shown as a rock: ").arg(lost.rock).arg(countText(region.sums.cells));
    switch (region.kind) {
    case rocks::RegionKind::Fines:
        return part + QObject::tr("it is smaller than “Smallest rock” (%1 cells). Lower that number to see it.")
                          .arg(countText(settings.minimumCells));
    case rocks::RegionKind::Outside:
        return part + QObject::tr("it is outside the region of interest. Clear the region to see it.");
    case rocks::RegionKind::Rock:
    case rocks::RegionKind::NotRock:
        break;
    }
    if (rocks::looksLikeRock(region, settings) && region.confidence < rocks::kLeastConfidence)
        return part +
               QObject::tr("its confidence is %1, and a rock needs %2. Click it and choose “Not a Rock, or a Rock Again” to show it.")
                   .arg(region.confidence, 0, 'f', 2)
                   .arg(rocks::kLeastConfidence, 0, 'f', 2);
    if (rocks::isTooFar(region, settings))
        return part + QObject::tr("it is behind “Farthest rock” (%1 m). Raise that number to see it.").arg(settings.farthestM, 0, 'f', 1);
    return part + QObject::tr("it looks like a wall. Click it and choose “Not a Rock, or a Rock Again” to show it.");
}

QString numbersOf(const std::set<std::uint32_t>& labels) {
    QStringList numbers;
    for (const std::uint32_t label : labels) numbers << QString::number(label);
    return numbers.join(", ");
}

/// Each with its visible spans a × b.
QString numbersWithSizes(const std::set<std::uint32_t>& labels, const RockPicture& picture) {
    QStringList numbers;
    for (const std::uint32_t label : labels) {
        const rocks::Rock& rock = *picture.rock(label);
        numbers << QStringLiteral("%1 (%2 × %3 m)").arg(label).arg(rock.longestCaliperM, 0, 'f', 2).arg(rock.shortestCaliperM, 0, 'f', 2);
    }
    return numbers.join(", ");
}

} // namespace

QString editWords(rocks::EditKind kind, const RockPicture& before, const RockPicture& after) {
    std::map<std::uint32_t, std::set<std::uint32_t>> parts, sources; // rocks after of a rock before, and the other way round
    std::pair<std::uint32_t, std::uint32_t> last;                    // neighbours mostly have the same
    for (std::size_t k = 0; k < before.labels.size(); ++k) {
        const std::pair now{before.labelAt(k), after.labelAt(k)};
        if (now.first == 0 || now.second == 0 || std::exchange(last, now) == now) continue;
        parts[now.first].insert(now.second);
        sources[now.second].insert(now.first);
    }
    QStringList sentences;
    if (kind == rocks::EditKind::Join) {
        for (const auto& [rock, from] : sources) {
            if (from.size() > 1) sentences << QObject::tr("Merged: rocks %1 are rock %2 now.").arg(numbersOf(from)).arg(rock);
        }
    } else if (kind == rocks::EditKind::Cut || kind == rocks::EditKind::Part) {
        const QString done =
            kind == rocks::EditKind::Cut ? QObject::tr("Cut: rock %1 is now rocks %2.") : QObject::tr("Split: rock %1 is now rocks %2.");
        for (const auto& [rock, to] : parts) {
            if (to.size() > 1) sentences << done.arg(rock).arg(numbersWithSizes(to, after));
        }
    }
    return sentences.join(' ');
}

QString changeWords(const rocks::RegionChanges& changes, const RockPicture& picture) {
    return changes.lost.empty() ? QString() : lostWords(changes.lost.front(), picture);
}

QString apartWords(const std::vector<std::uint32_t>& cells, const RockPicture& before, const RockPicture& after) {
    const rocks::Rock* merged = cells.empty() ? nullptr : after.rockAt(cells.front());
    if (merged == nullptr) return {};
    QStringList sentences;
    for (const rocks::PartDistance& parts : merged->apart) {
        if (before.regionAt(parts.a) == before.regionAt(parts.b)) continue; // of an earlier merge
        const std::uint32_t a = before.labelAt(parts.a), b = before.labelAt(parts.b);
        const QString apart = QString::number(parts.distanceM, 'f', 2);
        sentences << (a != 0 && b != 0
                          ? QObject::tr("Rocks %1 and %2 do not touch: their nearest cells are %3 m apart.")
                                .arg(std::min(a, b))
                                .arg(std::max(a, b))
                                .arg(apart)
                          : QObject::tr("Rock %1 and a part that was not a rock do not touch: their nearest cells are %2 m apart.")
                                .arg(std::max(a, b))
                                .arg(apart));
    }
    if (!sentences.isEmpty()) sentences << QObject::tr("They are merged as rock %1.").arg(merged->label);
    return sentences.join(' ');
}

} // namespace edgescan::ui
