// RFC 8089, with the name of this computer as some desktops write it.
#include "core/base/file_address.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace edgescan {
namespace {

constexpr std::string_view kScheme = "file:";

bool isThisComputer(const std::string& host) {
    std::array<char, 256> own{};
    if (host.empty() || host == "localhost") return true;
    return ::gethostname(own.data(), own.size() - 1) == 0 && host == asciiLower(own.data());
}

Error onAnotherComputer(std::string_view host, std::string_view address) {
    return {withValues("this is the address of a file on another computer, %1", {std::string(host)}), std::string(address),
            "copy the file to this one, or give its path in a folder that is shared"};
}

} // namespace

std::optional<Error> addressElsewhere(std::string_view text) {
    constexpr std::string_view kMark = "://";
    const std::size_t mark = text.find(kMark);
    const std::string scheme = asciiLower(text.substr(0, mark));
    const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
    if (mark == text.npos || scheme.size() < 2 || !std::ranges::all_of(scheme, isLetter)) return std::nullopt;
    if (scheme == "ws" || scheme == "wss")
        return Error{"this is the address of a robot's bridge and not a file", std::string(text),
                     "use it with record, or in the window with Connect to Scanner"};
    const std::string_view rest = text.substr(mark + kMark.size());
    return onAnotherComputer(rest.substr(0, rest.find('/')), text);
}

Result<std::string> pathOfAddress(std::string_view text) {
    if (asciiLower(text.substr(0, kScheme.size())) != kScheme || !text.substr(kScheme.size()).starts_with('/')) return std::string(text);
    const std::string where(text);
    text.remove_prefix(kScheme.size());
    if (text.starts_with("//")) {
        text.remove_prefix(2);
        const std::string host = asciiLower(text.substr(0, text.find('/')));
        if (!isThisComputer(host)) return onAnotherComputer(host, where);
        text.remove_prefix(std::min(host.size(), text.size()));
    }
    std::string path;
    while (!text.empty()) {
        unsigned char byte = static_cast<unsigned char>(text[0]);
        std::size_t used = 1;
        if (byte == '%') {
            const std::string_view digits = text.substr(1, 2);
            const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
            if (problem != std::errc{} || digits.size() != 2 || end != digits.data() + 2 || byte == 0)
                return Error{"this address has a % without the two digits of a byte", where, "write % as %25, or give the path"};
            used = 3;
        }
        path += static_cast<char>(byte);
        text.remove_prefix(used);
    }
    if (path.empty()) return Error{"this address names no file", where, "give its path"};
    return path;
}

} // namespace edgescan
