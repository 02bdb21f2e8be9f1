// Reads rows of numbers with std::from_chars: the point is always '.', whatever the locale.
#include "core/files/point_tables/plain_rows.h"
#include "core/files/point_tables/text_layout.h"
#include "core/files/point_tables/text_refusals.h"
#include "core/files/point_tables/text_words.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>

namespace edgescan::files {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kNumbersWithDigits = 60000; // enough to know how numbers are printed

/// "1.#QNAN", "-1.#IND", "1.#INF" of old Microsoft programs.
bool isOldNan(const char* from, const char* to) {
    return to - from >= 3 && from[0] == '#' && (from[1] == 'Q' || from[1] == 'I' || from[1] == 'S');
}

// std::from_chars, and faster where there are a few digits and a point: both whole numbers, up to 10^15, are exact as double, so their
// quotient is the nearest one there is (IEEE 754), which is what from_chars gives.
std::from_chars_result numberFrom(const char* from, const char* to, double& value) {
    static constexpr std::array<double, 16> kTenTo{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    constexpr std::ptrdiff_t kMostExact = 15;
    const bool negative = from < to && *from == '-';
    const char* const first = from + (negative ? 1 : 0);
    const char* point = nullptr;
    const char* at = first;
    std::uint64_t digits = 0;
    for (; at < to; ++at) {
        if (*at >= '0' && *at <= '9')
            digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
        else if (*at == '.' && point == nullptr)
            point = at;
        else
            break;
    }
    const std::ptrdiff_t count = at - first - (point == nullptr ? 0 : 1);
    if (count < 1 || count > kMostExact || (at < to && (*at == 'e' || *at == 'E'))) return std::from_chars(from, to, value);
    const std::ptrdiff_t decimals = point == nullptr ? 0 : at - point - 1;
    const double size = static_cast<double>(digits) / kTenTo[static_cast<std::size_t>(decimals)];
    value = negative ? -size : size;
    return {at, std::errc{}};
}

// Up to seven digits at once, the first in the lowest byte of the eight.
struct EightBytes {
    std::uint64_t value = 0; ///< of the digits
    unsigned count = 0;      ///< of digits; 8: perhaps there are more
};
inline EightBytes digitsAt(const char* from) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, sizeof word);
    if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
    word ^= 0x3030303030303030U; // digits are 0 to 9 now
    const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
    if (others == 0) return {0, 8};
    const unsigned count = static_cast<unsigned>(std::countr_zero(others)) / 8;
    if (count == 0) return {};
    word <<= 8U * (8U - count); // as if zeros were before them
    // Pairs of digits, of pairs, and of fours.
    word = word * 10U + (word >> 8U);
    word = ((word & 0x000000FF000000FFU) * 0x000F424000000064U + ((word >> 16U) & 0x000000FF000000FFU) * 0x0000271000000001U) >> 32U;
    return {word & 0xFFFFFFFFU, count};
}

// "-12.345678": at most seven digits on each side of the point. Null for all else. As in numberFrom(), value is what from_chars gives.
inline const char* usualNumber(const char* from, const char* end, double& value) {
    static constexpr std::array<double, 8> kTenTo{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
    if (end - from < 24) return nullptr; // a sign, eight, a point, eight
    const bool negative = *from == '-';
    from += negative ? 1 : 0;
    const EightBytes whole = digitsAt(from);
    if (whole.count == 8) return nullptr;
    from += whole.count;
    double size = static_cast<double>(whole.value);
    if (*from == '.') {
        const EightBytes part = digitsAt(from + 1);
        if (part.count == 8) return nullptr;
        from += 1 + part.count;
        if (whole.count + part.count == 0) return nullptr;
        size = (size * kTenTo[part.count] + static_cast<double>(part.value)) / kTenTo[part.count]; // whole and below 10^15
    } else if (whole.count == 0) {
        return nullptr;
    }
    value = negative ? -size : size;
    return from;
}

} // namespace

RowReader::RowReader(const Source& source, const TextLayout& layout)
    : source_(&source), begin_(source.text().data()), at_(begin_ + layout.firstByte), end_(begin_ + source.text().size()), layout_(&layout),
      line_(layout.firstLine), nextLine_(layout.firstLine), mayBePlain_(!layout.decimalComma && !layout.labels) {}

double RowReader::fraction() const { return begin_ == end_ ? 1.0 : static_cast<double>(at_ - begin_) / static_cast<double>(end_ - begin_); }

bool RowReader::next(std::span<const double>& numbers) {
    if (readPlainRow(numbers)) return true;
    const bool read = readNextRow(cells_);
    numbers = cells_;
    return read;
}

bool RowReader::next(std::vector<double>& numbers) {
    std::span<const double> row;
    if (!readPlainRow(row)) return readNextRow(numbers);
    numbers.assign(row.begin(), row.end());
    return true;
}

/// Cell by cell, past rows without any number.
bool RowReader::readNextRow(std::vector<double>& numbers) {
    while (at_ < end_) {
        const char* const rowEnd = endOfRow();
        rowEnd_ = rowEnd;
        line_ = nextLine_++;
        numbers.clear();
        const bool read = readRow(numbers);
        at_ = rowEnd;
        if (at_ < end_) at_ += *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n' ? 2 : 1;
        if (!read) return false;
        if (!numbers.empty()) return true; // else blank or comment
    }
    return false;
}

/// Once it is known how numbers are printed; false, and nothing is read, where the row is to be looked at cell by cell.
bool RowReader::readPlainRow(std::span<const double>& numbers) {
    static const PlainRowReader reader = plainRowReader();
    if (reader == nullptr || !mayBePlain_ || measuredNumbers_ < kNumbersWithDigits || static_cast<std::size_t>(end_ - at_) < kPlainRowReach)
        return false;
    const PlainRow row = reader(at_, end_, layout_->separator, std::span(plain_).first(std::min(plain_.size(), mostNumbers_)));
    // A row with as many as there is room for may hold more.
    if (row.next == nullptr || (row.numbers == plain_.size() && mostNumbers_ > plain_.size())) return false;
    numbers = std::span(plain_).first(row.numbers);
    line_ = nextLine_++;
    at_ = row.next;
    return true;
}

const char* RowReader::endOfRow() {
    const auto found = [](char c, const char* from, const char* to) {
        const void* at = std::memchr(from, c, static_cast<std::size_t>(to - from));
        return at == nullptr ? to : static_cast<const char*>(at);
    };
    if (newline_ == nullptr || newline_ < at_) newline_ = found('\n', at_, end_);
    return found('\r', at_, newline_);
}

bool RowReader::readRow(std::vector<double>& numbers) {
    const auto isComment = [&] { return *at_ == '#' || *at_ == '%' || *at_ == '!' || (*at_ == '/' && at_ + 1 < rowEnd_ && at_[1] == '/'); };
    const char separator = layout_->separator;
    const char* const row = at_;
    while (at_ < rowEnd_ && (*at_ == ' ' || *at_ == '"' || (*at_ == '\t' && separator != '\t'))) ++at_;
    if (at_ == rowEnd_ || isComment() || *at_ == '\x1a') return true;                               // Ctrl+Z ended files once
    if (!layout_->labels && !layout_->mayBeWords.empty() && layout_->mayBeWords.front()) at_ = row; // it may begin with a quote
    if (layout_->labels && !skipLabel()) return true;
    for (;;) {
        const char* const cell = at_;
        if (!readUsualCell(numbers) && !readCell(numbers)) return false;
        if (numbers.size() == mostNumbers_) return true;
        while (at_ < rowEnd_ && isBlank(*at_) && *at_ != separator) ++at_;
        if (separator == ' ') {
            while (at_ < rowEnd_ && isBlank(*at_)) ++at_;
            if (at_ == rowEnd_ || isComment()) return true;
            continue;
        }
        if (at_ == rowEnd_ || isComment()) return true;
        if (*at_ != separator && !passRestOf(cell, numbers)) return false;
        if (at_ == rowEnd_) return true;
        ++at_; // the separator
        if (at_ == rowEnd_ && layout_->trailingSeparator) return true;
    }
}

/// Past the text that follows the number of a cell; false where the number is needed.
bool RowReader::passRestOf(const char* cell, std::vector<double>& numbers) {
    at_ = endOfCell(cell, rowEnd_, layout_->separator);
    const std::size_t column = numbers.size() - 1;
    if (column < layout_->mayBeWords.size() && layout_->mayBeWords[column]) {
        numbers.back() = kMissing;
        return true;
    }
    problem_ = noNumber(*source_, line_, {cell, static_cast<std::size_t>(at_ - cell)});
    return false;
}

/// Past the label and its separator; false when the row ends there.
bool RowReader::skipLabel() {
    const char separator = layout_->separator;
    const char* const from = at_;
    while (at_ < rowEnd_ && *at_ != separator && !(separator == ' ' && *at_ == '\t')) ++at_;
    label_ = std::string_view(from, static_cast<std::size_t>(at_ - from));
    while (!label_.empty() && isBlank(label_.back())) label_.remove_suffix(1);
    if (at_ == rowEnd_) return false;
    ++at_;
    while (separator == ' ' && at_ < rowEnd_ && isBlank(*at_)) ++at_;
    return at_ < rowEnd_ || separator != ' ';
}

/// A number of a few digits with a blank, a separator or nothing behind it; false, and nothing is read, for all else.
bool RowReader::readUsualCell(std::vector<double>& numbers) {
    if (layout_->decimalComma) return false;
    double value = 0;
    const char* const to = usualNumber(at_, end_, value);
    if (to == nullptr || (to < rowEnd_ && *to != layout_->separator && !isBlank(*to))) return false;
    measureCell(numbers.size(), at_, to);
    numbers.push_back(value);
    at_ = to;
    return true;
}

void RowReader::measureCell(std::size_t column, const char* from, const char* to) {
    if (measuredNumbers_ >= kNumbersWithDigits) return;
    if (measured_ && std::find(measured_->begin(), measured_->end(), column) == measured_->end()) return;
    ++measuredNumbers_;
    countDigits(from, to);
}

/// Like std::from_chars, with what other programs write: a comma, a Fortran exponent, a number too large or too small for the type.
std::from_chars_result RowReader::parseNumber(const char* from, double& value) const {
    std::from_chars_result parsed{};
    if (layout_->decimalComma) {
        std::array<char, 64> copy{};
        const auto length = std::min<std::size_t>(static_cast<std::size_t>(rowEnd_ - from), copy.size());
        std::replace_copy(from, from + length, copy.begin(), ',', '.');
        parsed = std::from_chars(copy.data(), copy.data() + length, value);
        parsed.ptr = from + (parsed.ptr - copy.data());
    } else {
        parsed = numberFrom(from, rowEnd_, value);
    }
    if (parsed.ec != std::errc::invalid_argument && parsed.ptr < rowEnd_ && (*parsed.ptr == 'D' || *parsed.ptr == 'd'))
        parsed = numberWithFortranExponent(from, rowEnd_, value);
    if (parsed.ec == std::errc::result_out_of_range) {
        const std::string_view word(from, static_cast<std::size_t>(parsed.ptr - from));
        const std::size_t power = word.find_first_of("eEdD");
        const bool tiny = power != std::string_view::npos && power + 1 < word.size() && word[power + 1] == '-';
        value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return parsed;
}

bool RowReader::readCell(std::vector<double>& numbers) {
    const char separator = layout_->separator;
    const char* const cell = at_;
    const bool mayBeWords = numbers.size() < layout_->mayBeWords.size() && layout_->mayBeWords[numbers.size()];
    if (mayBeWords && separator != ' ' && at_ < rowEnd_ && *at_ == '"') { // "21, 11": a text, though it begins with a number
        at_ = endOfCell(cell, rowEnd_, separator);
        numbers.push_back(kMissing);
        return true;
    }
    while (at_ < rowEnd_ && isBlank(*at_) && *at_ != separator) ++at_;
    if (at_ == rowEnd_ || (separator != ' ' && *at_ == separator)) {
        numbers.push_back(kMissing);
        return true;
    }
    const char* from = at_ + (*at_ == '+' ? 1 : 0);
    double value = kMissing;
    const std::from_chars_result parsed = parseNumber(from, value);
    const char* end = parsed.ptr;
    if (parsed.ec != std::errc::invalid_argument && isOldNan(end, rowEnd_)) {
        value = kMissing;
        while (end < rowEnd_ && !isBlank(*end) && *end != separator) ++end;
    }
    const bool ends = end == rowEnd_ || isBlank(*end) || *end == separator;
    if (parsed.ec == std::errc::invalid_argument || !ends) {
        if (mayBeWords) {
            while (separator == ' ' && at_ < rowEnd_ && !isBlank(*at_)) ++at_;
            if (separator != ' ') at_ = endOfCell(cell, rowEnd_, separator);
            numbers.push_back(kMissing);
            return true;
        }
        const char* wordEnd = at_;
        while (wordEnd < rowEnd_ && !isBlank(*wordEnd) && *wordEnd != separator && wordEnd - at_ < 40) ++wordEnd;
        if (isMissingMark({at_, static_cast<std::size_t>(wordEnd - at_)})) {
            numbers.push_back(kMissing);
            at_ = wordEnd;
            return true;
        }
        // Between other separators a cell may hold blanks: the whole of it says more.
        while (separator != ' ' && wordEnd < rowEnd_ && *wordEnd != separator) ++wordEnd;
        problem_ = noNumber(*source_, line_, {at_, static_cast<std::size_t>(wordEnd - at_)});
        return false;
    }
    measureCell(numbers.size(), from, end);
    numbers.push_back(value);
    at_ = end;
    return true;
}

void RowReader::countDigits(const char* from, const char* to) {
    int significant = 0;
    int decimals = 0;
    int whole = 0;
    bool afterPoint = false;
    for (; from < to && std::string_view("eEdD").find(*from) == std::string_view::npos; ++from) {
        if (*from == '.' || *from == ',') {
            afterPoint = true;
        } else if (*from >= '0' && *from <= '9') {
            if (significant > 0 || *from != '0') ++significant;
            if (afterPoint)
                ++decimals;
            else if (significant > 0)
                ++whole;
        }
    }
    if (from < to) { // 1.234e-05 has more decimals than it shows
        digits_.powers = true;
        int exponent = 0;
        const char* digits = from + 1 + (from + 1 < to && from[1] == '+' ? 1 : 0);
        std::from_chars(digits, to, exponent);
        decimals = std::max(0, decimals - std::clamp(exponent, -400, 400));
    }
    digits_.decimals = std::max(digits_.decimals, decimals);
    digits_.whole = std::max(digits_.whole, whole);
    digits_.significant = std::max(digits_.significant, significant);
}

} // namespace edgescan::files
