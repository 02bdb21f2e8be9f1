// Legends over the cloud do not cover targets.
#pragma once

namespace edgescan::ui {

class CloudView;
class Comparing;
class LinkedViews;
class Targets;

/// The plates in the layout of the cloud are on the left; they change sides where they would cover less there: of the pinned cell
/// with its label, then of the change that a comparison names, then of the other targets.
void keepLegendsOffPins(CloudView& cloud, LinkedViews& views, const Comparing& comparing, const Targets& targets);

} // namespace edgescan::ui
