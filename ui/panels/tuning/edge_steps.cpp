// Changes the settings in steps, for operators who cannot drag a slider.
#include "core/edges/settings/parameters.h"
#include "ui/base/shown_text.h"
#include "ui/panels/tuning/edges_panel.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {

QString choiceWords(const edges::Parameter& parameter, const edges::Settings& settings) {
    QStringList words;
    const auto chosen = static_cast<unsigned>(parameter.get(settings));
    for (const edges::Choice& choice : parameter.choices) {
        if (parameter.several && (chosen & static_cast<unsigned>(choice.value)) != 0) words << QObject::tr(choice.label);
    }
    return words.isEmpty() ? QObject::tr(edges::choiceLabel(parameter, settings).c_str()) : words.join(", ");
}

QString EdgesPanel::valueText(const char* key) const {
    const edges::Parameter& p = *edges::findParameter(key);
    const double value = p.get(shown_);
    const QString unit = p.choices.empty() && *p.unit != '\0' ? " " + QObject::tr(p.unit) : QString();
    if (!p.choices.empty()) return choiceWords(p, shown_);
    if (!std::isnan(value)) return QString::number(value, 'f', p.decimals) + unit;
    const double inUse = automaticValue(p);
    return std::isnan(inUse) ? tr("auto") : tr("%1%2 auto").arg(QString::number(inUse, 'f', p.decimals), unit);
}

void EdgesPanel::step(const char* key, int steps) {
    const edges::Parameter& p = *edges::findParameter(key);
    double value = p.get(shown_);
    if (!p.choices.empty()) {
        const auto at = std::ranges::find(p.choices, value, &edges::Choice::value) - p.choices.begin();
        const auto last = static_cast<std::ptrdiff_t>(p.choices.size()) - 1;
        value = p.choices[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at + std::clamp(steps, -1, 1), 0, last))].value;
    } else {
        if (std::isnan(value)) value = automaticValue(p);
        if (std::isnan(value)) value = p.minimum;
        value = edges::snapped(p, std::clamp(value + steps * p.step, p.minimum, p.sliderMaximum));
    }
    edit(p, value, true);
}

} // namespace edgescan::ui
