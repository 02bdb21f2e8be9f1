// The table of themes, and the palettes made from it.
#include "ui/base/themes.h"

#include <QAbstractButton>
#include <QApplication>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <vector>

namespace edgescan::ui {
namespace {

const Theme* g_inUse = nullptr;

} // namespace

const std::array<Theme, kThemes>& themes() {
    static const std::array<Theme, kThemes> all{{
        {.key = "night",
         .label = QT_TRANSLATE_NOOP("QObject", "&Night"),
         .window = {0x2b, 0x2d, 0x30},
         .panel = {0x23, 0x25, 0x28},
         .base = {0x19, 0x1b, 0x1d},
         .button = {0x38, 0x3b, 0x3f},
         .line = {0x48, 0x4c, 0x51},
         .edge = {0x85, 0x8b, 0x92},
         .text = {0xe8, 0xe8, 0xe8},
         .quietText = {0xb3, 0xb8, 0xbe},
         .unusable = {0x8c, 0x92, 0x99},
         .accent = {0x6c, 0xb2, 0xff},
         .chosen = {0x1f, 0x4f, 0x80},
         .warn = {0xf2, 0xb5, 0x4a},
         .bad = {0xff, 0x82, 0x76}},
        {.key = "day",
         .label = QT_TRANSLATE_NOOP("QObject", "&Day"),
         .window = {0xe3, 0xe6, 0xe9},
         .panel = {0xf1, 0xf3, 0xf5},
         .base = {0xff, 0xff, 0xff},
         .button = {0xf8, 0xf9, 0xfa},
         .line = {0xb9, 0xbf, 0xc6},
         .edge = {0x73, 0x7a, 0x82},
         .text = {0x14, 0x17, 0x1a},
         .quietText = {0x46, 0x4d, 0x55},
         .unusable = {0x74, 0x7b, 0x83},
         .accent = {0x0b, 0x57, 0xa4},
         .chosen = {0x0b, 0x57, 0xa4},
         .warn = {0x7a, 0x4d, 0x00},
         .bad = {0xa5, 0x1d, 0x1d}},
        {.key = "gray",
         .label = QT_TRANSLATE_NOOP("QObject", "&Control-Room Gray"),
         .window = {0xc3, 0xc6, 0xc9},
         .panel = {0xcf, 0xd2, 0xd4},
         .base = {0xdf, 0xe1, 0xe3},
         .button = {0xd6, 0xd8, 0xda},
         .line = {0xa2, 0xa6, 0xab},
         .edge = {0x63, 0x68, 0x6e},
         .text = {0x0f, 0x11, 0x13},
         .quietText = {0x33, 0x38, 0x3d},
         .unusable = {0x5f, 0x64, 0x6a},
         .accent = {0x0a, 0x44, 0x80},
         .chosen = {0x0a, 0x44, 0x80},
         .warn = {0x5c, 0x3a, 0x00},
         .bad = {0x8a, 0x12, 0x12}},
    }};
    return all;
}

const Theme& themeOf(const QString& key) {
    const auto found = std::ranges::find_if(themes(), [&](const Theme& theme) { return key == theme.key; });
    return found == themes().end() ? themes().front() : *found;
}

const Theme& themeInUse() { return g_inUse != nullptr ? *g_inUse : themes().front(); }

const std::vector<ColourPair>& pairsInUse() {
    constexpr double kText = 4.5;
    constexpr double kGraphics = 3.0;
    static const std::vector<ColourPair> pairs{
        {"words on the window", &Theme::text, &Theme::window, kText},
        {"words on a panel, a tip or a notice", &Theme::text, &Theme::panel, kText},
        {"words in a field or a table", &Theme::text, &Theme::base, kText},
        {"words on a button", &Theme::text, &Theme::button, kText},
        {"quiet words on the window", &Theme::quietText, &Theme::window, kText},
        {"quiet words on a panel", &Theme::quietText, &Theme::panel, kText},
        {"quiet words in an empty field", &Theme::quietText, &Theme::base, kText},
        {"quiet words on a button", &Theme::quietText, &Theme::button, kText},
        {"a number plate of a target", &Theme::base, &Theme::text, kText},
        {"a warning on the window", &Theme::warn, &Theme::window, kText},
        {"a warning on a panel", &Theme::warn, &Theme::panel, kText},
        {"a warning on a button", &Theme::warn, &Theme::button, kText},
        {"a mark of the timeline", &Theme::warn, &Theme::base, kGraphics},
        {"a fault on the window", &Theme::bad, &Theme::window, kText},
        {"a fault on a panel", &Theme::bad, &Theme::panel, kText},
        {"a link in a text", &Theme::accent, &Theme::base, kText},
        {"a link on the window", &Theme::accent, &Theme::window, kText},
        {"the focus on the window", &Theme::accent, &Theme::window, kGraphics},
        {"the focus on a panel", &Theme::accent, &Theme::panel, kGraphics},
        {"the focus in a field", &Theme::accent, &Theme::base, kGraphics},
        {"the focus on a button", &Theme::accent, &Theme::button, kGraphics},
        {"a border on the window", &Theme::edge, &Theme::window, kGraphics},
        {"a border on a panel", &Theme::edge, &Theme::panel, kGraphics},
        {"a border in a field", &Theme::edge, &Theme::base, kGraphics},
        {"a border of a button", &Theme::edge, &Theme::button, kGraphics},
        {"greyed words on the window", &Theme::unusable, &Theme::window, kGraphics},
        {"greyed words on a panel", &Theme::unusable, &Theme::panel, kGraphics},
        {"greyed words in a field", &Theme::unusable, &Theme::base, kGraphics},
        {"greyed words on a button", &Theme::unusable, &Theme::button, kGraphics},
    };
    return pairs;
}

QPalette paletteOf(const Theme& theme) {
    QPalette palette;
    const std::initializer_list<std::pair<QPalette::ColorRole, QColor>> colours{
        {QPalette::Window, theme.window},
        {QPalette::WindowText, theme.text},
        {QPalette::Base, theme.base},
        {QPalette::AlternateBase, theme.panel},
        {QPalette::Text, theme.text},
        {QPalette::Button, theme.button},
        {QPalette::ButtonText, theme.text},
        {QPalette::BrightText, theme.text},
        {QPalette::ToolTipBase, theme.panel},
        {QPalette::ToolTipText, theme.text},
        {QPalette::PlaceholderText, theme.quietText},
        {QPalette::Highlight, theme.chosen},
        {QPalette::HighlightedText, Qt::white},
        {QPalette::Link, theme.accent},
        {QPalette::LinkVisited, theme.accent},
        {QPalette::Light, theme.window}, // styles draw it as the shadow of disabled text
        {QPalette::Midlight, theme.line},
        {QPalette::Mid, theme.edge},
        {QPalette::Dark, theme.line},
        {QPalette::Shadow, theme.line},
    };
    for (const auto& [role, colour] : colours) palette.setColor(role, colour);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, theme.unusable);
    return palette;
}

QPixmap onViewGround(const QPixmap& sign) {
    constexpr int kRim = 2; // px
    QPixmap plate(sign.width() + 2 * kRim, sign.height() + 2 * kRim);
    plate.fill(themes().front().window);
    QPainter(&plate).drawPixmap(kRim, kRim, sign);
    return plate;
}

void setSign(QAbstractButton& row, const QPixmap& sign) {
    const QPixmap plate = onViewGround(sign);
    row.setIconSize(plate.size());
    row.setIcon(QIcon(plate));
}

void useColours(const Theme& theme) {
    g_inUse = &theme;
    QApplication::setPalette(paletteOf(theme));
    emit ThemeNews::self().changed(theme);
}

void followColours(QWidget& widget, const std::function<void(const Theme&)>& paint) {
    paint(themeInUse());
    QObject::connect(&ThemeNews::self(), &ThemeNews::changed, &widget, paint);
}

ThemeNews& ThemeNews::self() {
    static ThemeNews news;
    return news;
}

} // namespace edgescan::ui

#include "moc_themes.cpp"
