// The drawings of a report's page (SVG) as pictures: a document of Qt shows none.
#pragma once

#include <QImage>
#include <QString>

namespace edgescan::ui {

/// Lines, paths of right angles, circles and texts, as core/exports/html makes them. `scale`: pixels per unit of the drawing.
[[nodiscard]] QImage imageOfDrawing(const QString& svg, double scale);

/// Draws the numbers of a picture over it.
void drawOver(QImage& picture, const QString& svg);

} // namespace edgescan::ui
