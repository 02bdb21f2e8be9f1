// DXF is pairs of lines: a group code, then its value. Code 0 begins an entity, 10, 20 and 30 are its place.
#include "core/writers/dxf_points.h"

#include "core/points/text_layout.h"

#include <charconv>
#include <optional>

namespace edgescan {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    Number value{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

} // namespace

Result<std::vector<Eigen::Vector3d>> dxfPoints(std::string_view text, const std::string& where) {
    std::vector<Eigen::Vector3d> points;
    bool inPoint = false;
    std::size_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
        const TextLine codeLine = textLineAt(text, at);
        const auto code = numberIn<int>(trimmed(codeLine.text));
        if (!code || codeLine.next >= text.size())
            return Error{"this is no whole DXF group", where + ": line " + std::to_string(line + 1), "export it again"};
        const TextLine valueLine = textLineAt(text, codeLine.next);
        const std::string_view value = trimmed(valueLine.text);
        at = valueLine.next;
        line += 2;
        if (*code == 0) {
            inPoint = value == "POINT";
            if (inPoint) points.emplace_back(Eigen::Vector3d::Zero());
        }
        if (!inPoint || (*code != 10 && *code != 20 && *code != 30)) continue;
        const auto number = numberIn<double>(value);
        if (!number) return Error{"this coordinate is no number", where + ": line " + std::to_string(line), "export it again"};
        points.back()[*code / 10 - 1] = *number;
    }
    return points;
}

} // namespace edgescan
