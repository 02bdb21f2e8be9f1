// The place of notices: over the titles of the views, so that no view moves when a notice comes or goes.
#pragma once

class QWidget;

namespace edgescan::ui {

class NoticeBar;

/// `views`: the widget at whose upper edge notices are. GUI thread only; both must have the same parent.
void keepOverViews(NoticeBar& notice, QWidget& views);

} // namespace edgescan::ui
