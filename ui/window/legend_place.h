// Legends over the cloud do not cover the pinned target.
#pragma once

namespace edgescan::ui {

class CloudView;
class Comparing;
class LinkedViews;

/// The plates in the layout of the cloud are on the left; they move to the right while they would cover the pinned cell or its label
/// or, without one, the change that a comparison names.
void keepLegendsOffPins(CloudView& cloud, LinkedViews& views, const Comparing& comparing);

} // namespace edgescan::ui
