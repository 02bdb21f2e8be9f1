// The ends of all numbers within 64 bytes are found at once; the digits of one are put in place by one shuffle and added up in pairs.
#include "core/files/point_tables/plain_rows.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include "core/base/simd.h"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace edgescan::files {
namespace {

constexpr std::size_t kBlock = 64;
constexpr std::size_t kLongest = 16; // bytes of a number without its sign
constexpr unsigned kMostDigits = 15; // whole numbers of so many are exact as double, and so is the power of ten
static_assert(kPlainRowReach >= kBlock + kLongest + 1);

// Where each of sixteen digits comes from, by the length of a number and the place of its point (its length: there is none). The last digit
// goes last; 0x80 is a zero.
using Places = std::array<std::uint8_t, 16>;
constexpr auto kPlaces = [] {
    std::array<std::array<Places, kLongest + 1>, kLongest + 1> all{};
    for (std::size_t length = 0; length <= kLongest; ++length) {
        for (std::size_t point = 0; point <= kLongest; ++point) {
            Places& places = all[length][point];
            places.fill(0x80);
            std::size_t to = places.size();
            for (std::size_t from = length; from-- > 0;) {
                if (from != point) places[--to] = static_cast<std::uint8_t>(from);
            }
        }
    }
    return all;
}();
constexpr std::array<double, 16> kPowers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

// A bit for each of 32 bytes that is one of "-./0123456789".
EDGESCAN_AVX2 inline std::uint32_t inNumbers(const char* from) {
    const __m256i bytes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    const __m256i most = _mm256_set1_epi8('9' - '-');
    const __m256i inside = _mm256_cmpeq_epi8(_mm256_max_epu8(_mm256_sub_epi8(bytes, _mm256_set1_epi8('-')), most), most);
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(inside));
}

// A bit for each of 64 bytes that is not one of them.
EDGESCAN_AVX2 inline std::uint64_t endsWithin(const char* from) {
    return ~(std::uint64_t{inNumbers(from)} | std::uint64_t{inNumbers(from + kBlock / 2)} << 32U);
}

// The number of `length` bytes, at most 16, at `from`; false where it is not a plain one.
EDGESCAN_AVX2 inline bool plainNumber(const char* from, std::size_t length, double& value) {
    const bool negative = *from == '-';
    from += negative ? 1 : 0;
    length -= negative ? 1 : 0;
    const __m128i bytes = _mm_sub_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)), _mm_set1_epi8('0'));
    const auto points = static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, _mm_set1_epi8('.' - '0'))));
    const std::size_t point = _tzcnt_u32(points | 1U << length); // bits after the number do not matter
    const bool hasPoint = point < length;
    const __m128i places = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kPlaces[length][point].data()));
    const __m128i digits = _mm_shuffle_epi8(bytes, places);
    const __m128i nine = _mm_set1_epi8(9);
    const auto areDigits = static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(digits, nine), nine)));
    const std::size_t count = length - (hasPoint ? 1 : 0);
    if (areDigits != 0xFFFFU || count - 1 >= kMostDigits) return false;
    const __m128i pairs = _mm_maddubs_epi16(digits, _mm_set_epi8(1, 10, 1, 10, 1, 10, 1, 10, 1, 10, 1, 10, 1, 10, 1, 10));
    const __m128i fours = _mm_madd_epi16(pairs, _mm_set_epi16(1, 100, 1, 100, 1, 100, 1, 100));
    const __m128i eights = _mm_madd_epi16(_mm_packus_epi32(fours, fours), _mm_set_epi16(1, 10000, 1, 10000, 1, 10000, 1, 10000));
    const auto both = static_cast<std::uint64_t>(_mm_cvtsi128_si64(eights));
    const auto whole = static_cast<std::int64_t>((both & 0xFFFFFFFFU) * 100000000U + (both >> 32U));
    const double size = static_cast<double>(whole) / kPowers[hasPoint ? length - 1 - point : 0];
    value = negative ? -size : size;
    return true;
}

EDGESCAN_AVX2 PlainRow readPlainRow(const char* from, const char* end, char separator, std::span<double> numbers) {
    const auto isSeparator = [separator](char c) { return c == separator || (separator == ' ' && c == '\t'); };
    const char* block = from;
    std::uint64_t ends = endsWithin(block);
    std::size_t count = 0;
    for (;;) {
        if (ends == 0) { // on to where this number begins
            if (block == from || static_cast<std::size_t>(end - from) < kPlainRowReach) return {};
            block = from;
            ends = endsWithin(block);
            if (ends == 0) return {};
        }
        const char* to = block + _tzcnt_u64(ends);
        ends &= ends - 1;
        char c = *to;
        if (count == numbers.size()) { // to the end of the row
            if (c != '\n' && c != '\r') {
                from = to + 1;
                continue;
            }
        } else if (to > from) {
            if (static_cast<std::size_t>(to - from) > kLongest || !plainNumber(from, static_cast<std::size_t>(to - from), numbers[count]))
                return {};
            ++count;
        } else if (separator == ' ' && isSeparator(c)) { // blanks before a number
            from = to + 1;
            continue;
        } else if (std::memcmp(from, "nan", 3) == 0) {
            numbers[count++] = std::numeric_limits<double>::quiet_NaN();
            to = from + 3;
            c = *to;
            ends = static_cast<std::size_t>(to - block) >= kBlock - 1 ? 0 : ends & ~std::uint64_t{0} << (to - block + 1);
        } else if (separator != ' ' || count == 0 || (c != '\n' && c != '\r')) {
            return {};
        }
        if (c == '\n') return {to + 1, count};
        if (c == '\r' && to[1] == '\n') return {to + 2, count};
        if (!isSeparator(c)) return {};
        from = to + 1;
    }
}

} // namespace

PlainRowReader plainRowReader() { return instructionSet() >= InstructionSet::Avx2 ? readPlainRow : nullptr; }

} // namespace edgescan::files

#else

namespace edgescan::files {
PlainRowReader plainRowReader() { return nullptr; }
} // namespace edgescan::files

#endif
