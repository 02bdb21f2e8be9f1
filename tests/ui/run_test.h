// Each X_test.cpp of this folder defines `int X_test(int, char**)`. The program runs the one that its first argument names.
#pragma once

#include <QtTest>

namespace edgescan::ui {

template <class Test, class Application>
int runTest(int argc, char** argv) {
    const Application application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace edgescan::ui
