// Looks for the mark among the keys of the outermost object; damaged text has none.
#include "core/base/own_kind.h"

#include "core/base/bounded_json.h"
#include "core/base/translated_text.h"
#include "core/base/whole_file.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace edgescan {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20U; // of JSON that is read
constexpr const char* kPng = "PNG";                            // a file of that name is replaced, whatever it holds

} // namespace

std::string ownKind(std::string_view text) {
    constexpr std::string_view kMark = "edgescan-";
    if (text.starts_with("\x89PNG")) return kPng;
    if (!text.starts_with('{')) return {};
    auto json = parseJson(text, "");
    if (!json) json = parseJson(text.substr(0, text.find('\n')), "");
    for (const char* key : {"format", "schema"}) {
        const std::string kind = json && json->contains(key) && (*json)[key].is_string() ? (*json)[key].get<std::string>() : "";
        if (kind.starts_with(kMark)) return kind.substr(0, kind.find('/'));
    }
    return {};
}

Result<Done> checkIsOfKind(const std::filesystem::path& path, const std::string& kind) {
    if (isDevice(path) || (kind == kPng && path.extension() == ".png")) return Done{};
    const int first = std::ifstream(path).peek(); // most files are neither JSON nor PNG
    if (first == std::ifstream::traits_type::eof() || (kind.empty() && first != '{' && first != 0x89)) return Done{};
    const auto bytes = readWholeFile(path, kMostBytes);
    if (!bytes) return Done{}; // whether it may be replaced is checked elsewhere
    const std::string before = ownKind(textOf(*bytes));
    if (before == kind) return Done{};
    return Error{before.empty() ? withValues("this is not a file of the kind %1, so it was not replaced", {kind})
                                : withValues("this is a file of the kind %1, so it was not replaced", {before}),
                 path.string(), "choose another name"};
}

} // namespace edgescan
