// What holds for every widget of the program, whoever makes it.
#pragma once

namespace edgescan::ui {

/// Make one before any widget. From then on numbers are written with a decimal point in every country's locale, by Qt and by the libraries
/// under it, and a label shows its text as it is: <b> in a file's name is no markup, also in tool tips and message boxes. A label that is
/// to be rich text says so itself.
struct PlainWindow {
    PlainWindow();
};

} // namespace edgescan::ui
