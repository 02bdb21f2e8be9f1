// SHA-256 by OpenSSL's functions for SHA-256 alone. OpenSSL's newer interface reads the system's certificate settings before the first
// hash, which takes longer than hashing a megabyte.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/base/sha256.h"

#include <openssl/sha.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace edgescan {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

} // namespace

Sha256::Sha256() : context_(std::make_unique<SHA256state_st>()) { SHA256_Init(context_.get()); }

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes) { SHA256_Update(context_.get(), bytes.data(), bytes.size()); }

std::string Sha256::hex() {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
    SHA256_Final(digest.data(), context_.get());
    static constexpr const char* kDigits = "0123456789abcdef";
    std::string hex;
    for (const unsigned char byte : digest) {
        hex += kDigits[byte >> 4U];
        hex += kDigits[byte & 15U];
    }
    return hex;
}

std::string sha256Hex(std::span<const std::byte> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

Result<std::string> sha256OfFile(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a pipe without a writer must not block; the check below refuses it.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const std::unique_ptr<std::FILE, CloseFile> file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"));
    if (!file) return Error{std::string("the file cannot be opened: ") + std::strerror(errno), path.string(), "check the path"};
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        return Error{"this is not a regular file", path.string(), "choose a file"};
    Sha256 hash;
    std::vector<std::byte> piece(std::size_t{1} << 20U);
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get())) hash.add(std::span(piece).first(count));
    if (std::ferror(file.get()) != 0) {
        return Error{std::string("the file cannot be read: ") + std::strerror(errno), path.string(), "check the disk and the path"};
    }
    return hash.hex();
}

} // namespace edgescan
