// Every group keeps to the budget of lines in its README. Who needs more lines says in the commit what goes, or raises the figure in the
// open.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <regex>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = test::sourceFolder();

// "Budget: 4,500 lines." in the README of a folder; 0: none.
int budgetOf(const fs::path& folder) {
    static const std::regex budget(R"(\nBudget: ([0-9,]+) lines)");
    const std::string text = test::fileText(folder / "README.md");
    std::smatch match;
    if (!std::regex_search(text, match, budget)) return 0;
    std::string number = match[1];
    std::erase(number, ',');
    return std::stoi(number);
}

// Lines of .h and .cpp below a folder, without those of folders with a budget of their own.
int linesBelow(const fs::path& folder) {
    int lines = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory()) {
            lines += budgetOf(entry.path()) > 0 ? 0 : linesBelow(entry.path());
        } else if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") {
            const std::string text = test::fileText(entry.path());
            lines += static_cast<int>(std::ranges::count(text, '\n'));
        }
    }
    return lines;
}

TEST(Size, EveryGroupKeepsToItsBudget) {
    std::map<fs::path, int> budgets{{"app", 0}, {"app/lab", 0}, {"app/python", 0}, {"tests", 0}};
    for (const char* storey : {"core", "ui"}) {
        for (const auto& entry : fs::directory_iterator(kSource / storey)) {
            if (entry.is_directory()) budgets[fs::relative(entry.path(), kSource)] = 0;
        }
    }
    int product = 0;
    for (auto& [group, budget] : budgets) {
        budget = budgetOf(kSource / group);
        const int lines = linesBelow(kSource / group);
        EXPECT_GT(budget, 0) << group << "/README.md has no budget";
        EXPECT_LE(lines, budget) << group << " has more lines than the budget in its README.md";
        EXPECT_GE(lines, budget * 9 / 10) << group << ": lower the budget in its README.md to what is there";
        if (group != "app/lab" && group != "tests") product += lines;
    }
    std::cout << "[ measured ] core, ui and app without the laboratory: " << product << " lines\n";
}

} // namespace
} // namespace edgescan
