// Fills in templates of names and compares the names with each other.
#include "core/batch/archive/output_names.h"

#include "core/base/sha256.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <span>

namespace edgescan::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPart = 200; // bytes; a file system allows 255
constexpr std::size_t kKeptOfLong = 160;
constexpr std::size_t kKeyDigits = 16;

std::string keyOf(const std::string& text) { return sha256Hex(std::as_bytes(std::span(text))).substr(0, kKeyDigits); }

// The name of one folder. Characters with a meaning in paths are written as %2F and the like, and % itself as %25, so that different names
// stay different.
std::string partOf(const std::string& text) {
    if (text == ".") return "%2E";
    if (text == "..") return "%2E%2E";
    std::string part;
    for (const char c : text) {
        if (c == '%')
            part += "%25";
        else if (c == '/')
            part += "%2F";
        else
            part += c;
    }
    if (part.size() > kLongestPart) part = part.substr(0, kKeptOfLong) + "~" + keyOf(text);
    return part;
}

std::string pathOf(const fs::path& path) {
    std::string name;
    for (const fs::path& part : path) {
        if (part.empty()) continue;
        name += (name.empty() ? "" : "/") + partOf(part.string());
    }
    return name;
}

std::string filled(const std::string& pattern, const std::string& input) {
    std::string name;
    for (std::size_t at = 0; at < pattern.size();) {
        const bool field = pattern[at] == '{';
        const std::size_t end = std::min(pattern.find(field ? '}' : '{', at), pattern.size());
        const std::string text = pattern.substr(at + (field ? 1 : 0), end - at - (field ? 1 : 0));
        if (!field) name += text;
        for (const NameField& known : nameFields()) {
            if (field && text == known.key) name += known.of(input);
        }
        at = end + (field ? 1 : 0);
    }
    return fs::path("/" + name).lexically_normal().relative_path().string();
}

Result<Done> checkPattern(const std::string& pattern) {
    std::string known;
    for (const NameField& field : nameFields()) known += (known.empty() ? "{" : ", {") + std::string(field.key) + "}";
    for (std::size_t at = pattern.find_first_of("{}"); at != std::string::npos; at = pattern.find_first_of("{}", at + 1)) {
        const std::size_t end = pattern.find_first_of("{}", at + 1);
        const bool closed = pattern[at] == '{' && end != std::string::npos && pattern[end] == '}';
        const std::string key = closed ? pattern.substr(at + 1, end - at - 1) : "";
        if (std::ranges::none_of(nameFields(), [&](const NameField& field) { return key == field.key; }))
            return Error{"the template has braces around something that is not a field", pattern, "use " + known};
        at = end;
    }
    return Done{};
}

} // namespace

const std::vector<NameField>& nameFields() {
    static const std::vector<NameField> fields{
        {"path", "the whole path, with its extension", [](const std::string& input) { return pathOf(input); }},
        {"folder", "the path of its folder", [](const std::string& input) { return pathOf(fs::path(input).parent_path()); }},
        {"name", "its name with the extension", [](const std::string& input) { return partOf(fs::path(input).filename().string()); }},
        {"stem", "its name without", [](const std::string& input) { return partOf(fs::path(input).stem().string()); }},
        {"key", "16 digits that no other path has", keyOf}};
    return fields;
}

Result<std::vector<std::string>> outputNames(const std::vector<std::string>& inputs, const std::string& pattern) {
    if (auto fine = checkPattern(pattern); !fine) return fine.error();
    std::vector<std::string> names;
    for (const std::string& input : inputs) names.push_back(filled(pattern, input));
    // With a slash behind each name, a folder inside another is sorted directly behind it, or behind other folders inside it.
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return names[i] + "/"; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::string& name = names[order[i]];
        if (name.empty()) return Error{"the template gives no name for this scan", inputs[order[i]], "use {path} or {key} in it"};
        if (i == 0 || !(name + "/").starts_with(names[order[i - 1]] + "/")) continue;
        return Error{"the results would lie where those of " + inputs[order[i - 1]] + " do (" + names[order[i - 1]] + ")", inputs[order[i]],
                     "use {path} or {key} in the template"};
    }
    return names;
}

} // namespace edgescan::batch
