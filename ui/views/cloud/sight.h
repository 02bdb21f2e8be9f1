// Brings cells that are out of sight into the 3D view.
#pragma once

#include "ui/views/cloud/cloud_view.h"

#include <QRect>

namespace edgescan::ui {

/// Around these cells in the picture, px of the view; null: all of them are outside it. Of many cells, some are asked.
[[nodiscard]] QRect placeIn(const CloudView& cloud, const CloudView::CellIndices& cells);

/// If more than a tenth of the points are outside the view, or if they are smaller there than this share of its height: looks at them from
/// the scanner's side, where a rock has the face that was measured.
void bringIntoSight(CloudView& cloud, const CloudView::CellIndices& cells, double leastShare = 0.0);

} // namespace edgescan::ui
