// With EDGESCAN_TEST_COUNTRY=de_DE.UTF-8 a test program runs as if the whole process followed that country: C functions, streams that are
// made from then on, case of letters. What the core writes and reads must not change.
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
