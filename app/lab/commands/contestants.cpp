// Turns texts into contestants.
#include "app/lab/commands/contestants.h"

#include "app/shared/options.h"

#include <algorithm>
#include <array>

namespace edgescan::cli {
namespace {

struct UsualContestant {
    const char* name;
    const char* flags; ///< null: PCL
};
constexpr std::array<UsualContestant, 6> kUsualContestants{{{"default", ""},
                                                            {"borders", "--rock-borders on"},
                                                            {"thesis", "--preset thesis"},
                                                            {"log-range", "--method log-range"},
                                                            {"gray", "--preset log"}, // the best of all gray ones with fixed settings
                                                            {"pcl", nullptr}}};

Result<lab::Contestant> contestantOf(const std::string& name, const std::string& flags) {
    CLI::App parser;
    MethodFlags method = noFlags();
    addMethodFlags(parser, method);
    try {
        parser.parse(flags);
    } catch (const CLI::ParseError& wrong) {
        return Error{wrong.what(), "--with " + name, "give flags of a method, as detect takes them"};
    }
    const Result<edges::Settings> settings = settingsOf(method);
    if (!settings) return settings.error();
    return lab::Contestant{name, flags, *settings};
}

} // namespace

std::string usualContestants() {
    std::string names;
    for (const UsualContestant& usual : kUsualContestants) {
        names += (names.empty() ? "" : ", ") + std::string(usual.name);
        if (usual.flags != nullptr && *usual.flags != '\0') names += std::string(" (") + usual.flags + ")";
    }
    return names;
}

Result<std::vector<lab::Contestant>> contestantsOf(const std::vector<std::string>& typed) {
    std::vector<std::string> texts = typed;
    if (texts.empty()) {
        for (const UsualContestant& usual : kUsualContestants) texts.emplace_back(usual.name);
    }
    std::vector<lab::Contestant> contestants;
    for (const std::string& text : texts) {
        const std::size_t sign = text.find('=');
        const std::string name = text.substr(0, sign);
        if (name.empty() || std::ranges::find(contestants, name, &lab::Contestant::name) != contestants.end())
            return Error{"the name \"" + name + "\" is empty or there twice", "--with", "give each method a name of its own"};
        const auto usual = std::ranges::find_if(kUsualContestants, [&name](const UsualContestant& one) { return name == one.name; });
        if (sign == std::string::npos && usual == kUsualContestants.end())
            return Error{"no usual method is called \"" + name + "\"", "--with", "write NAME=FLAGS, or use " + usualContestants()};
        if (sign == std::string::npos && usual->flags == nullptr) {
            contestants.push_back({name, "", std::nullopt});
            continue;
        }
        Result<lab::Contestant> one = contestantOf(name, sign == std::string::npos ? usual->flags : text.substr(sign + 1));
        if (!one) return one.error();
        contestants.push_back(std::move(*one));
    }
    return contestants;
}

} // namespace edgescan::cli
