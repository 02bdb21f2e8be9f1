// Which links are followed, the mode of new files, pipes without a reader, hashes of special files.
#include "core/base/sha256.h"
#include "core/base/whole_file.h"
#include "tests/support/run_program.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <thread>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using test::fileText;

unsigned modeOf(const fs::path& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

TEST(FileManners, TheUmaskOfTheOwnerHolds) {
    const test::TemporaryFolder folder;
    for (const unsigned mask : {0022U, 0077U, 0002U}) {
        const unsigned before = ::umask(mask);
        const fs::path path = folder / std::to_string(mask);
        EXPECT_TRUE(writeWholeFile(path, std::string("x")));
        ::umask(before);
        EXPECT_EQ(modeOf(path), 0666U & ~mask);
    }
    // A replaced file keeps its mode, but set-user-id bits do not remain.
    const fs::path path = folder / "old";
    ASSERT_TRUE(writeWholeFile(path, std::string("x")));
    ASSERT_EQ(::chmod(path.c_str(), 04640), 0);
    EXPECT_TRUE(writeWholeFile(path, std::string("y")));
    EXPECT_EQ(modeOf(path), 0640U);
}

TEST(FileManners, LinksOfOneselfAreFollowed) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeWholeFile(folder / "file", std::string("old")));
    fs::create_symlink("file", folder / "one");
    fs::create_symlink("one", folder / "two");
    ASSERT_TRUE(writeWholeFile(folder / "two", std::string("new")));
    EXPECT_EQ(fileText(folder / "file"), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "two"));
    fs::create_symlink("there", folder / "dangling");
    ASSERT_TRUE(writeWholeFile(folder / "dangling", std::string("new")));
    EXPECT_EQ(fileText(folder / "there"), "new");
    fs::create_symlink("circle", folder / "circle");
    EXPECT_FALSE(writeWholeFile(folder / "circle", std::string("new")));
}

TEST(FileManners, LinksOfAnotherUserAreNotFollowed) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can make a link of another user";
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeWholeFile(folder / "mine", std::string("old")));
    fs::create_symlink("mine", folder / "laid");
    ASSERT_EQ(::lchown((folder / "laid").c_str(), 65534, 65534), 0);
    fs::create_symlink("laid", folder / "ours"); // our link leads to theirs
    for (const char* name : {"laid", "ours"}) {
        const auto written = writeWholeFile(folder / name, std::string("new"));
        ASSERT_FALSE(written) << name;
        EXPECT_NE(written.error().sentence().find("another user"), std::string::npos) << written.error().sentence();
    }
    EXPECT_EQ(fileText(folder / "mine"), "old");
}

/// Whether this thread of the process waits for something.
bool sleeps(long thread) {
    const std::string facts = fileText("/proc/self/task/" + std::to_string(thread) + "/stat");
    const std::size_t name = facts.rfind(") ");
    return name != std::string::npos && facts.at(name + 2) == 'S';
}

TEST(FileManners, APipeWithoutAReaderIsRefusedAndOneWithIsWritten) {
    const test::TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const auto refused = writeWholeFile(pipe, std::string("x"));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("no program reads"), std::string::npos) << refused.error().sentence();
    // More than a pipe holds, and a reader that comes when the writer waits for it.
    const std::string text(1 << 20, 'x');
    std::string read;
    std::thread reader([&, writer = ::syscall(SYS_gettid)] {
        EXPECT_TRUE(test::waitUntil([&] { return sleeps(writer); }));
        read = fileText(pipe);
    });
    EXPECT_TRUE(writeWholeFile(pipe, text));
    reader.join();
    EXPECT_EQ(read, text);
    // A reader that goes away is an error, not a signal.
    std::thread leaver([&] { ::close(::open(pipe.c_str(), O_RDONLY)); });
    EXPECT_FALSE(writeWholeFile(pipe, text));
    leaver.join();
    EXPECT_FALSE(sha256OfFile(pipe));
    EXPECT_FALSE(readWholeFile(pipe));
}

} // namespace
} // namespace edgescan
