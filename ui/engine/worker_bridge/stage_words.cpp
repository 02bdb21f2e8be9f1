// The list of stages.
#include "ui/engine/worker_bridge/stage_words.h"

#include <QObject>

#include <array>

namespace edgescan::ui {
namespace {

// Their texts for the translations (tests/ui/languages_test.cpp compares them with the core's).
[[maybe_unused]] constexpr std::array kStages{
    QT_TRANSLATE_NOOP("QObject", "opened"),
    QT_TRANSLATE_NOOP("QObject", "reading"),
    QT_TRANSLATE_NOOP("QObject", "reading points"),
    QT_TRANSLATE_NOOP("QObject", "reading ranges"),
    QT_TRANSLATE_NOOP("QObject", "reading the picture"),
    QT_TRANSLATE_NOOP("QObject", "unpacking"),
    QT_TRANSLATE_NOOP("QObject", "finding telegrams"),
    QT_TRANSLATE_NOOP("QObject", "putting packets together"),
    QT_TRANSLATE_NOOP("QObject", "grid"),
    QT_TRANSLATE_NOOP("QObject", "finding the grid"),
    QT_TRANSLATE_NOOP("QObject", "finding the axis"),
    QT_TRANSLATE_NOOP("QObject", "projecting the points"),
    QT_TRANSLATE_NOOP("QObject", "placing the points"),
    QT_TRANSLATE_NOOP("QObject", "finding edges"),
    QT_TRANSLATE_NOOP("QObject", "drawing"),
};

} // namespace

QString stageWords(const char* stage) { return QObject::tr(stage); }

} // namespace edgescan::ui
