// With EDGESCAN_TEST_COUNTRY=de_DE.UTF-8 a test program runs as if the whole process used that locale: C functions, streams created later,
// upper and lower case. What the core writes and reads must not change.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>

namespace {

const bool kSet = [] {
    const char* country = std::getenv("EDGESCAN_TEST_COUNTRY");
    if (country == nullptr) return false;
    if (std::setlocale(LC_ALL, country) == nullptr) {
        std::fprintf(stderr, "the locale %s is not there\n", country);
        std::exit(1);
    }
    std::locale::global(std::locale(country));
    return true;
}();

} // namespace
