// Settings that apply to every widget of the program.
#pragma once

namespace edgescan::ui {

/// Make one before any widget. It makes Qt and the libraries under it write numbers with a decimal point in every locale. It also makes
/// labels show their text unchanged: <b> in a file name is not markup, not in tool tips and message boxes either. A label with rich text
/// must ask for it.
struct PlainWindow {
    PlainWindow();
};

} // namespace edgescan::ui
