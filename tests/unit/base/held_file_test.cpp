// Bytes of an open file do not change, whether mapped or read.
#include "core/base/held_file.h"

#include "core/base/whole_file.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

std::string longText() {
    std::string text;
    while (text.size() < 3000000) text += std::to_string(text.size()) + "\n";
    return text;
}

TEST(HeldFile, HasTheBytesOfTheFileWhateverItsSize) {
    const test::TemporaryFolder folder;
    for (const std::string& text : {std::string(), std::string("x"), longText()}) {
        ASSERT_TRUE(writeWholeFile(folder / "file", text));
        const auto held = holdFile(folder / "file");
        ASSERT_TRUE(held) << held.error().sentence();
        EXPECT_TRUE(textOf(held->bytes()) == text) << text.size();
    }
}

TEST(HeldFile, NobodyWritesToWhatIsMapped) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "file";
    ASSERT_TRUE(writeWholeFile(path, longText()));
    {
        const auto held = holdFile(path);
        ASSERT_TRUE(held);
        if (!held->isMapped()) GTEST_SKIP() << "this system gives no lease here";
        EXPECT_EQ(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC), -1);
        EXPECT_EQ(errno, EWOULDBLOCK);
        // Another file under the same name does not change this one.
        ASSERT_TRUE(writeWholeFile(path, std::string("new")));
        EXPECT_TRUE(textOf(held->bytes()) == longText());
    }
    const int file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    EXPECT_GE(file, 0);
    ::close(file);
}

TEST(HeldFile, WhatSomebodyWritesToIsCopied) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "file";
    ASSERT_TRUE(writeWholeFile(path, longText()));
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    const auto held = holdFile(path);
    ASSERT_TRUE(held);
    EXPECT_FALSE(held->isMapped());
    ASSERT_EQ(::ftruncate(file, 0), 0);
    ::close(file);
    EXPECT_TRUE(textOf(held->bytes()) == longText());
}

TEST(HeldFile, WhatIsNoFileIsRefusedAsReadingRefusesIt) {
    const test::TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const fs::path& path : {pipe, folder / ".", folder / "missing"}) {
        const auto held = holdFile(path);
        const auto read = readWholeFile(path);
        ASSERT_FALSE(held) << path;
        EXPECT_EQ(held.error().sentence(), read.error().sentence());
    }
}

} // namespace
} // namespace edgescan
