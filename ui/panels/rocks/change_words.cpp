// Sentences about changed rocks.
#include "ui/panels/rocks/change_words.h"

#include "ui/base/count_text.h"

#include <QObject>
#include <QStringList>

namespace edgescan::ui {
namespace {

constexpr std::size_t kMostNamed = 3; // pairs of numbers in one sentence

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
        return part + QObject::tr("its confidence is %1, and a rock needs %2. Click it and press “A Rock” (N) to show it.")
                          .arg(region.confidence, 0, 'f', 2)
                          .arg(rocks::kLeastConfidence, 0, 'f', 2);
    return part + QObject::tr("it looks like a wall, or it is behind “Farthest rock” (%1 m). Click it and press “A Rock” (N) to show it.")
                      .arg(settings.farthestM, 0, 'f', 1);
}

} // namespace

QString changeWords(const rocks::RegionChanges& changes, const RockPicture& picture) {
    QStringList sentences;
    if (!changes.lost.empty()) sentences << lostWords(changes.lost.front(), picture);
    QStringList pairs;
    for (const rocks::RegionChanges::Renumbered& rock : changes.renumbered) {
        if (pairs.size() < static_cast<int>(kMostNamed)) pairs << QObject::tr("%1 is now %2").arg(rock.before).arg(rock.after);
    }
    const std::size_t more = changes.renumbered.size() - static_cast<std::size_t>(pairs.size());
    if (more > 0)
        sentences << QObject::tr("Numbers follow the visible area, so other rocks have new ones: %1 and %2 more.")
                         .arg(pairs.join(", "))
                         .arg(more);
    else if (!pairs.isEmpty())
        sentences << QObject::tr("Numbers follow the visible area, so other rocks have new ones: %1.").arg(pairs.join(", "));
    return sentences.join(' ');
}

} // namespace edgescan::ui
