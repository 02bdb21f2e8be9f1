// JSON from outside is read in one place: no other file of the program calls nlohmann's parser.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <regex>

namespace edgescan {
namespace {

TEST(OneJsonReader, NobodyElseCallsTheParser) {
    static const std::regex parser(R"([Jj]son\s*::\s*(parse|sax_parse|from_cbor|from_bson|from_msgpack|from_ubjson)\s*\(|QJsonDocument)");
    int files = 0;
    for (const char* storey : {"core", "ui", "app"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(test::sourceFolder()) / storey)) {
            const auto& path = entry.path();
            if (path.extension() != ".cpp" && path.extension() != ".h") continue;
            ++files;
            const bool calls = std::regex_search(test::fileText(path), parser);
            EXPECT_EQ(calls, path.filename() == "bounded_json.cpp") << path;
        }
    }
    EXPECT_GT(files, 200);
}

} // namespace
} // namespace edgescan
