// Kind and size of the noise at the median range of the scan, at half and at twice this range.
#include "ui/panels/tuning/noise_words.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"

#include <QObject>

namespace edgescan::ui {

QString noiseWords(const edges::Detection& detection) {
    if (!detection.responses || !(detection.responses->scales.rangeM > 0)) return {};
    const edges::DepthResponses& found = *detection.responses;
    const auto at = [](const RangeNoise& noise, double rangeM) {
        return QObject::tr("%1 mm at %2 m").arg(noise.at(rangeM), 0, 'f', 1).arg(rangeM, 0, 'f', 1);
    };
    const double usual = found.scales.rangeM;
    const QString kind = found.neighboursAlike  ? QObject::tr("neighbours err alike, as in a depth camera")
                         : found.scales.inSteps ? QObject::tr("each cell errs for itself, in steps of the file")
                                                : QObject::tr("each cell errs for itself");
    QString text = QObject::tr("Noise in use: %1; sigma %2, %3, %4.")
                       .arg(kind, at(found.noise, 0.5 * usual), at(found.noise, usual), at(found.noise, 2 * usual));
    if (found.neighboursAlike) text += " " + QObject::tr("Folds have to exceed %1.").arg(at(found.foldNoise, usual));
    if (found.roughness.rough)
        text += " " + QObject::tr("Rough scan: around half of the folds %1 % of the cells fold, so a fold must exceed its surroundings.")
                          .arg(100 * found.roughness.aroundFolds, 0, 'f', 0);
    return text;
}

} // namespace edgescan::ui
