// Addresses of files, good and bad.
#include "core/base/file_address.h"

#include <gtest/gtest.h>

using namespace edgescan;

TEST(FileAddress, BecomesThePath) {
    for (const auto& [address, path] : std::initializer_list<std::pair<const char*, const char*>>{
             {"file:///data/a%20b%23.pcd", "/data/a b#.pcd"},
             {"file://localhost/data/a.pcd", "/data/a.pcd"},
             {"FILE:/data/gr%C3%B6%c3%9fe.pcd", "/data/gr\xc3\xb6\xc3\x9f"
                                                "e.pcd"},
             {"/data/a%20b.pcd", "/data/a%20b.pcd"},
             {"file:a.pcd", "file:a.pcd"},
             {"ws://robot:8765", "ws://robot:8765"},
             {"-", "-"},
         }) {
        const auto found = pathOfAddress(address);
        ASSERT_TRUE(found) << address;
        EXPECT_EQ(*found, path);
    }
}

TEST(FileAddress, OfAnotherComputerIsRefused) {
    for (const char* address : {"file://server.example/data/a.pcd", "file:///a%2", "file:///a%zz", "file:///a%00b", "file://"})
        EXPECT_FALSE(pathOfAddress(address)) << address;
    EXPECT_NE(pathOfAddress("file://server.example/a.pcd").error().sentence().find("another computer, server.example"), std::string::npos);
    for (const char* address : {"https://h.example/a.pcd", "smb://h.example/share/a.pcd", "sftp://h.example/a.pcd", "http://h.example"})
        EXPECT_NE(addressElsewhere(address)->sentence().find("another computer, h.example"), std::string::npos);
    EXPECT_NE(addressElsewhere("ws://robot:8765")->sentence().find("a robot's bridge"), std::string::npos);
    for (const char* path : {"/data/a.pcd", "C:/data/a.pcd", "/data/http://a", "://", ""}) EXPECT_FALSE(addressElsewhere(path)) << path;
}
