// The command line that computes the same edges.
#include "core/edges/command_text.h"

#include "core/edges/parameters.h"
#include "core/edges/presets.h"

#include <vector>

namespace edgescan {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::vector<std::string> differences(const Settings& from, const Settings& to) {
    std::vector<std::string> flags;
    for (const Parameter& p : parameters()) {
        const std::string value = formatValue(p, p.get(to));
        if (formatValue(p, p.get(from)) != value) flags.push_back(std::string("--") + p.key + " " + value);
    }
    return flags;
}

} // namespace

std::string detectCommand(const std::string& path, const Settings& settings) {
    const Preset* nearest = nullptr;
    std::vector<std::string> fewest;
    for (const Preset& preset : builtInPresets()) {
        std::vector<std::string> flags = differences(preset.settings, settings);
        if (nearest != nullptr && flags.size() >= fewest.size()) continue;
        nearest = &preset;
        fewest = std::move(flags);
    }
    std::string command = "edgescan-cli detect " + quoted(path) + " --preset " + nearest->name;
    for (const std::string& flag : fewest) command += " " + flag;
    return command + " --json -";
}

} // namespace edgescan
