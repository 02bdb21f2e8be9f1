// Brings cells that are out of sight into the 3D view.
#pragma once

#include "ui/views/cloud/cloud_view.h"

namespace edgescan::ui {

/// If more than a tenth of the points are outside the view: moves the camera, and zooms only where that is not enough.
void bringIntoSight(CloudView& cloud, const CloudView::CellIndices& cells);

} // namespace edgescan::ui
