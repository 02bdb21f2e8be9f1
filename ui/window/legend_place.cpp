// Chooses the side of the legends.
#include "ui/window/legend_place.h"

#include "ui/base/view_plate.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/scale_plate.h"
#include "ui/views/cloud/sight.h"

#include <QLayout>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kLabelWide = 210, kLabelHigh = 28; // px, of the label of a target on a rock
constexpr int kRing = 14;                        // px around it
constexpr int kNarrow = 420;                     // px of the cloud's width

/// True if the plates on this side cover the place, or would cover it.
bool isCovered(const CloudView& cloud, const QRect& label, bool atRight) {
    for (ViewPlate* plate : cloud.findChildren<ViewPlate*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!plate->isVisible() || cloud.layout()->indexOf(plate) < 0) continue; // plates outside the layout avoid the label themselves
        QRect place = plate->geometry();
        const int margin = std::min(place.left(), cloud.width() - 1 - place.right());
        place.moveLeft(atRight ? cloud.width() - margin - place.width() : margin);
        if (place.intersects(label)) return true;
    }
    return false;
}

/// True if the pointer is over a plate of the layout.
bool hasPointer(const CloudView& cloud) {
    const auto plates = cloud.findChildren<ViewPlate*>(QString(), Qt::FindDirectChildrenOnly);
    return std::ranges::any_of(
        plates, [&](ViewPlate* plate) { return plate->isVisible() && cloud.layout()->indexOf(plate) >= 0 && plate->underMouse(); });
}

/// True if the lowest plate of the layout is at the right: another one may have come above it.
bool isAtRight(const CloudView& cloud) {
    const QLayout& over = *cloud.layout();
    for (int n = over.count() - 1; n >= 0; --n) {
        const auto* plate = qobject_cast<ViewPlate*>(over.itemAt(n)->widget());
        if (plate != nullptr) return (over.itemAt(n)->alignment() & Qt::AlignRight) != 0;
    }
    return false;
}

/// Puts all plates of the layout at this side.
void putAt(CloudView& cloud, bool right) {
    QLayout& over = *cloud.layout();
    const Qt::Alignment side = (right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom;
    for (int n = 0; n < over.count(); ++n) {
        QWidget* plate = over.itemAt(n)->widget();
        if (qobject_cast<ViewPlate*>(plate) != nullptr && over.itemAt(n)->alignment() != side) over.setAlignment(plate, side);
    }
}

/// Around the change that a comparison names.
QRect changeIn(const CloudView& cloud, const Comparing& comparing) {
    const QRect place = placeIn(cloud, comparing.someOfRegion());
    return place.isNull() ? place : place.adjusted(-kRing, -kRing, kRing - 1, kRing - 1).intersected(cloud.rect());
}

/// Of the targets and the ends of measurements in view.
std::vector<QRect> ringsIn(const CloudView& cloud) {
    std::vector<QRect> rings;
    const auto add = [&](std::size_t cell) {
        const auto at = cloud.pixelOf(static_cast<std::uint32_t>(cell));
        if (at) rings.emplace_back(at->toPoint() - QPoint(kRing, kRing), QSize(2 * kRing, 2 * kRing));
    };
    for (const TargetMark& target : cloud.marks().targets) add(target.cell);
    for (const MeasureMark& measure : cloud.marks().measures) std::ranges::for_each(measure.cells, add);
    return rings;
}

/// Whether the operator went to a changed region last, or chose a place.
class Way {
public:
    bool visits(std::optional<std::size_t> pinned, std::optional<std::size_t> region) {
        if (pinned != pinned_ || region != region_) visits_ = region && region != region_ && pinned == pinned_;
        pinned_ = pinned;
        region_ = region;
        return visits_;
    }

private:
    std::optional<std::size_t> pinned_, region_;
    bool visits_ = false;
};

} // namespace

void keepLegendsOffPins(CloudView& cloud, LinkedViews& views, const Comparing& comparing, const Targets& targets) {
    const auto way = std::make_shared<Way>();
    const auto look = [&cloud, &views, &comparing, way] {
        const auto fitLegends = [&](int height) {
            QLayout& over = *cloud.layout();
            for (int n = over.count() - 1; n >= 0; --n) { // the lowest first: those above it get the rest
                auto* legend = qobject_cast<ViewPlate*>(over.itemAt(n)->widget());
                if (legend == nullptr || legend->isHidden()) continue;
                const bool covers = cloud.width() < kNarrow && qobject_cast<EdgeLegend*>(legend) != nullptr; // while the images are first
                legend->fitInto(covers ? 0 : height);
                height -= legend->sizeHint().height() + over.spacing();
            }
            over.activate();
        };
        const auto* corner = cloud.findChild<CornerPicture*>("cab-corner"); // over the top of the right side
        const auto roomAt = [&cloud, corner](bool right) {
            return cloud.height() - (right && corner != nullptr && corner->isVisible() ? corner->geometry().bottom() : 0);
        };
        const bool wasRight = isAtRight(cloud);
        fitLegends(roomAt(wasRight));
        const auto cell = views.pinned();
        const auto at = cell ? cloud.pixelOf(static_cast<std::uint32_t>(*cell)) : std::nullopt;
        const QRect label = at ? QRect(at->toPoint() - QPoint(kRing, kLabelHigh), QSize(kLabelWide, 2 * kLabelHigh)) : QRect();
        // Where neither side is free, the legends end below the label; where that is too little for them, each is one row.
        // The way to a changed region keeps that region free: on it no target moves or folds the legends.
        const bool visits = way->visits(cell, comparing.visited());
        const QRect avoided = visits ? QRect() : label;
        const auto neitherIsFree = [&] {
            return !avoided.isEmpty() && isCovered(cloud, avoided, false) && isCovered(cloud, avoided, true);
        };
        if (neitherIsFree()) fitLegends(cloud.height() - label.bottom());
        if (neitherIsFree()) fitLegends(0);
        // They stay at their side until they cover more than at the other: the chosen place, then the change, then other targets. While
        // the cloud turns, and under the pointer, they never move.
        const std::vector<QRect> rings = ringsIn(cloud);
        const auto covered = [&, change = changeIn(cloud, comparing)](bool side) {
            const auto is = [&](const QRect& place) { return !place.isEmpty() && isCovered(cloud, place, side); };
            return std::tuple(is(avoided), is(change), visits ? 0 : std::ranges::count_if(rings, is));
        };
        const bool right = cloud.atRest() && !hasPointer(cloud) && covered(!wasRight) < covered(wasRight) ? !wasRight : wasRight;
        putAt(cloud, right);
        if (right != wasRight) fitLegends(roomAt(right));
        cloud.layout()->activate(); // the scale avoids the legends where they are now
        if (auto* scale = cloud.findChild<ScalePlate*>()) scale->keepOff(label, rings);
    };
    QObject::connect(&views, &LinkedViews::pinChanged, &cloud, look);
    QObject::connect(&targets, &Targets::cardChanged, &cloud, look);
    QObject::connect(&cloud, &CloudView::frameDrawn, &cloud, look);
    // What made them change their side is gone.
    const auto toUsualSide = [&cloud, look] {
        putAt(cloud, false);
        look();
    };
    QObject::connect(&views, &LinkedViews::newScanShown, &cloud, toUsualSide);
    QObject::connect(&comparing, &Comparing::pictureAChanged, &cloud, [toUsualSide](bool some) {
        if (!some) toUsualSide();
    });
}

} // namespace edgescan::ui
