// Flags of rocks.
#include "app/cli/rock_flags.h"

#include "app/shared/exits.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/shell_quoted.h"

namespace edgescan::cli {

void addRockFlags(CLI::App& command, RockFlags& flags, bool ofOneScan) {
    const char* group = "Rocks";
    for (const rocks::RockParameter& p : rocks::rockParameters()) {
        const std::string flag = std::string("--") + p.key;
        const NumberLimits limits = p.limits();
        const auto parse = [&flags, flag, limits, &p](const std::string& text) {
            flags.typed.emplace_back(&p, numberTyped(flag, text, limits, p.decimals == 0));
        };
        const std::string unit = *p.unit == '\0' ? "" : std::string(" [") + p.unit + "]";
        command.add_option_function<std::string>(flag, parse, p.help + unit)
            ->type_name(rangeName(limits))
            ->default_str(shortestText(p.get(rocks::RockSettings{})))
            ->group(group);
    }
    command.add_option("--region", flags.region, "Region of interest: two opposite cells, or the corners of a polygon")
        ->type_name("\"LINE,BEAM LINE,BEAM...\"")
        ->group(group);
    if (!ofOneScan) return;
    command
        .add_option("--edits", flags.edits,
                    "Edits by hand, with settings where it has some: SCAN.rocks.json of the viewer (docs/method/rocks.md)")
        ->type_name("FILE")
        ->group(group);
}

bool anyTyped(const RockFlags& flags) { return !flags.typed.empty() || !flags.region.empty() || !flags.edits.empty(); }

Result<Done> checkRocks(RockFlags& flags) {
    if (!flags.region.empty()) {
        const auto region = rocks::parseRegion(flags.region);
        if (!region) return region.error();
        flags.corners = *region;
    }
    if (!flags.edits.empty()) claimInput(flags.edits);
    return Done{};
}

std::string typedFlags(const RockFlags& flags) {
    std::string text;
    const auto add = [&](const std::string& flag, const std::string& value) { text += (text.empty() ? "--" : " --") + flag + " " + value; };
    for (const auto& [parameter, value] : flags.typed) add(parameter->key, shortestText(value));
    if (!flags.region.empty()) add("region", shellQuoted(flags.region));
    if (!flags.edits.empty()) add("edits", shellQuoted(flags.edits));
    return text;
}

Result<rocks::Preset> presetOf(const RockFlags& flags, const Scan& scan) {
    rocks::Preset preset;
    if (!flags.edits.empty()) {
        auto read = rocks::readRockPreset(flags.edits, scan);
        if (!read) return read.error();
        preset = std::move(*read);
    }
    rocks::RockSettings settings = preset.settings.value_or(rocks::RockSettings{});
    for (const auto& [parameter, value] : flags.typed) parameter->set(settings, value);
    if (!flags.corners.empty()) {
        const auto inside = rocks::isRegionInside(flags.corners, scan.lines(), scan.beams());
        if (!inside) return inside.error();
        if (!*inside) printError(printable(scan.name) + ": a part of the --region is outside of the scan; the rest counts.");
        settings.region = flags.corners;
    }
    preset.settings = settings;
    return preset;
}

} // namespace edgescan::cli
