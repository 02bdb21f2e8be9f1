// Numbers with their units and limits of validity.
#include "ui/controllers/files/calibration_words.h"

#include "ui/base/count_text.h"

#include <QObject>

namespace edgescan::ui {
namespace {

QString decimals(double value, int digits) { return QString::number(value, 'f', digits); }

std::array<QString, 3> errorRow(const QString& name, double value, double sd, const QString& unit, int digits) {
    return {name, decimals(value, digits) + " " + unit, decimals(2 * sd, digits) + " " + unit};
}

} // namespace

CalibrationShown calibrationWords(const inspect::SelfCalibration& found) {
    const AssemblyErrors& e = found.errors;
    const AssemblyErrors& sd = found.sd;
    CalibrationShown shown;
    const QString mm = "mm", deg = "°";
    shown.rows = {errorRow(QObject::tr("lever arm t1, in the scan plane"), e.t1Mm(), sd.t1Mm(), mm, 2),
                  errorRow(QObject::tr("lever arm t2, across the plane"), e.t2Mm(), sd.t2Mm(), mm, 2),
                  errorRow(QObject::tr("tilt of the scan plane"), e.tiltDeg(), sd.tiltDeg(), deg, 4),
                  errorRow(QObject::tr("beam index"), e.indexDeg(), sd.indexDeg(), deg, 4),
                  found.turnIsEstimated
                      ? errorRow(QObject::tr("turn at 180°"), e.turnDeg(), sd.turnDeg(), deg, 4)
                      : std::array<QString, 3>{QObject::tr("turn at 180°"), QObject::tr("unchanged"), QObject::tr("not measured")}};
    shown.verdict = QObject::tr("found from %1 cells, %2° seen twice").arg(countText(found.cells)).arg(decimals(found.overlapDeg, 1));
    shown.about =
        QObject::tr("Mismatch of the two views: %1 mm before, %2 mm with these errors (median; noise alone explains %3 mm). One scan "
                    "never shows a shift along the axis, an offset of all ranges or the stepper's zero.")
            .arg(decimals(found.medianBeforeMm, 1), decimals(found.medianAfterMm, 1), decimals(found.noiseMm, 1));
    return shown;
}

CalibrationPicture seamWords(std::size_t lateEdges, const std::array<double, 2>& met) {
    const auto share = [&](std::size_t n) { return QString::number(100 * met[n], 'f', 0); };
    CalibrationPicture picture;
    picture.title = QObject::tr("Edges of both views");
    const QString signs = QObject::tr("orange – late view, blue | early view, white + both");
    picture.before = QObject::tr("Before: %1 % of %2 late edges are next to an early one (%3)").arg(share(0)).arg(lateEdges).arg(signs);
    picture.after = QObject::tr("After: %1 % of them").arg(share(1));
    return picture;
}

CalibrationPicture apartWords(const inspect::SelfCalibration& found) {
    CalibrationPicture picture;
    picture.title = QObject::tr("Distance of the views");
    picture.before = QObject::tr("Before: %1 mm apart (median; blue nearer, red farther than the late view, full colour at 50 mm)")
                         .arg(decimals(found.medianBeforeMm, 1));
    picture.after = QObject::tr("After: %1 mm apart").arg(decimals(found.medianAfterMm, 1));
    return picture;
}

} // namespace edgescan::ui
