// Runs one class of tests: edgescan_window_test modes_test [OPTION OF QTEST...]. One program for all, because linking Qt and VTK takes
// long; ctest starts it for each class.
#include <cstdio>
#include <cstring>

#define EDGESCAN_WINDOW_TEST(name) int name(int, char**);
#include "window_tests.inc" // written by tests/CMakeLists.txt
#undef EDGESCAN_WINDOW_TEST

namespace {

struct WindowTest {
    const char* name;
    int (*run)(int, char**);
};

constexpr WindowTest kTests[] = {
#define EDGESCAN_WINDOW_TEST(name) {#name, name},
#include "window_tests.inc"
#undef EDGESCAN_WINDOW_TEST
};

} // namespace

int main(int argc, char** argv) {
    for (const WindowTest& test : kTests) {
        if (argc > 1 && std::strcmp(argv[1], test.name) == 0) return test.run(argc - 1, argv + 1);
    }
    std::fprintf(stderr, "The first argument names the class of tests:\n");
    for (const WindowTest& test : kTests) std::fprintf(stderr, "  %s\n", test.name);
    return 2;
}
