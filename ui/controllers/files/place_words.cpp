// Sentences about a placed scan.
#include "ui/controllers/files/place_words.h"

#include "core/base/number_text.h"
#include "core/scan/georef/placed_look.h"
#include "ui/base/shown_text.h"

#include <QCoreApplication>

#include <cmath>

namespace edgescan::ui {
namespace {

struct PlaceWords {
    Q_DECLARE_TR_FUNCTIONS(PlaceWords)
};

QString number(double value, int digits) { return shownText(fixedText(value, digits)); }

QString spanOf(const char* name, double from, double to) {
    return QString("%1 %2 … %3 m").arg(QLatin1String(name), number(from, 2), number(to, 2));
}

/// Empty: the pose fits the mounting.
QString doubtWords(const PlacedLook& look, Viewing viewing) {
    switch (lookDoubt(look, viewing)) {
    case LookDoubt::None:
        break;
    case LookDoubt::TurnedForward:
        return PlaceWords::tr(
            "The scanner looks forward: what is above it without a pose is now in front of it. If it looks up into a bell, "
            "choose “up” on the page Mounting.");
    case LookDoubt::NotUp:
        return PlaceWords::tr("The mounting looks up, but pitch and roll turn it to the side: type 0 and 0 for a level boom, or choose "
                              "“forward” on the page Mounting.");
    case LookDoubt::MostlyBelow:
        return PlaceWords::tr("The mounting looks up, but %1 % of the points are lower than the scanner: correct pitch and roll, or choose "
                              "another direction on the page Mounting.")
            .arg(number(100.0 * look.belowShare, 0));
    }
    return {};
}

} // namespace

QString placeWords(const Scan& scan, Viewing viewing) {
    const PlacedLook look = placedLook(scan);
    QString words = PlaceWords::tr("Scanner at E %1, N %2, RL %3 m. ")
                        .arg(number(look.sensor.x(), 3), number(look.sensor.y(), 3), number(look.sensor.z(), 3));
    words +=
        (look.elevationDeg < 0.0 ? PlaceWords::tr("It looks %1° below the horizon. ") : PlaceWords::tr("It looks %1° above the horizon. "))
            .arg(number(std::abs(look.elevationDeg), 0));
    words += PlaceWords::tr("Its points: ");
    words += spanOf("E", look.least.x(), look.most.x()) + ", " + spanOf("N", look.least.y(), look.most.y()) + ", " +
             spanOf("RL", look.least.z(), look.most.z());
    const QString doubt = doubtWords(look, viewing);
    return doubt.isEmpty() ? words : words + QString::fromUtf8("\n▲ ") + doubt;
}

} // namespace edgescan::ui
