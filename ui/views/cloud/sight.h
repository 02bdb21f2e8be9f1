// Brings cells that are out of sight into the 3D view.
#pragma once

#include "ui/views/cloud/cloud_view.h"

namespace edgescan::ui {

/// If more than a tenth of the points are outside the view, or if they are smaller there than this share of its height: looks at them from
/// the scanner's side, where a rock has the face that was measured.
void bringIntoSight(CloudView& cloud, const CloudView::CellIndices& cells, double leastShare = 0.0);

} // namespace edgescan::ui
