// ISO 8601 without library functions: independent of locale and time zone.
#include "core/base/utc_time.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string>

namespace edgescan {
namespace {

/// The number in the digits [from, from + count); empty if there is any other character.
std::optional<int> digitsAt(std::string_view text, std::size_t from, std::size_t count) {
    if (from + count > text.size()) return std::nullopt;
    int value = 0;
    for (const char c : text.substr(from, count)) {
        if (c < '0' || c > '9') return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return value;
}

std::optional<double> fractionOf(std::string_view text) {
    if (text.empty()) return 0.0;
    double value = 0;
    const std::string number = "0" + std::string(text);
    if (text.size() < 2 || text.size() > 20 || text[0] != '.' || text.find_first_not_of("0123456789", 1) != std::string_view::npos)
        return std::nullopt;
    const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), value);
    return problem == std::errc{} && end == number.data() + number.size() ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<double> parseUtc(std::string_view text) {
    using namespace std::chrono;
    if (text.size() < 20 || text[4] != '-' || text[7] != '-' || text[10] != 'T' || text[13] != ':' || text[16] != ':' || text.back() != 'Z')
        return std::nullopt;
    const auto y = digitsAt(text, 0, 4);
    const auto mo = digitsAt(text, 5, 2);
    const auto d = digitsAt(text, 8, 2);
    const auto h = digitsAt(text, 11, 2);
    const auto mi = digitsAt(text, 14, 2);
    const auto s = digitsAt(text, 17, 2);
    const auto fraction = fractionOf(text.substr(19, text.size() - 20));
    if (!y || !mo || !d || !h || !mi || !s || !fraction || *h > 23 || *mi > 59 || *s > 60) return std::nullopt;
    const year_month_day date{year{*y}, month{static_cast<unsigned>(*mo)}, day{static_cast<unsigned>(*d)}};
    if (!date.ok()) return std::nullopt;
    const auto midnight = sys_days{date}.time_since_epoch();
    return static_cast<double>(duration_cast<seconds>(midnight).count() + *h * 3600 + *mi * 60 + *s) + *fraction;
}

std::string utcText(double seconds) {
    using namespace std::chrono;
    if (!std::isfinite(seconds) || seconds < 0 || seconds > 2.5e11) return {};
    const auto milliseconds = static_cast<long long>(std::llround(seconds * 1000));
    const sys_days midnight{floor<days>(sys_time<std::chrono::milliseconds>{std::chrono::milliseconds{milliseconds}})};
    const year_month_day date{midnight};
    const long long ofDay = milliseconds - duration_cast<std::chrono::milliseconds>(midnight.time_since_epoch()).count();
    const auto part = [](long long value, std::size_t digits) {
        const std::string text = std::to_string(value);
        return std::string(digits - std::min(digits, text.size()), '0') + text;
    };
    return part(static_cast<int>(date.year()), 4) + "-" + part(static_cast<unsigned>(date.month()), 2) + "-" +
           part(static_cast<unsigned>(date.day()), 2) + "T" + part(ofDay / 3600000, 2) + ":" + part(ofDay / 60000 % 60, 2) + ":" +
           part(ofDay / 1000 % 60, 2) + "." + part(ofDay % 1000, 3) + "Z";
}

double utcNow() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

} // namespace edgescan
