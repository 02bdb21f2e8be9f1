// Legends over the cloud keep out of the way of what is pinned.
#pragma once

namespace edgescan::ui {

class CloudView;
class LinkedViews;

/// The plates in the layout of the cloud stand at the left; at the right while the cell that is pinned, or its label, lies under them.
void keepLegendsAside(CloudView& cloud, LinkedViews& views);

} // namespace edgescan::ui
