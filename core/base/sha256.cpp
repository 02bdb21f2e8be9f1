// SHA-256 through OpenSSL's EVP interface.
#include "core/base/sha256.h"

#include <openssl/evp.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace edgescan {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

} // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
    if (context_ != nullptr && EVP_DigestInit_ex(context_, EVP_sha256(), nullptr) == 1) return;
    EVP_MD_CTX_free(context_);
    throw std::bad_alloc();
}

Sha256::~Sha256() { EVP_MD_CTX_free(context_); }

void Sha256::add(std::span<const std::byte> bytes) { EVP_DigestUpdate(context_, bytes.data(), bytes.size()); }

std::string Sha256::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(context_, digest.data(), &length);
    static constexpr const char* kDigits = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < length; ++i) {
        hex += kDigits[digest[i] >> 4U];
        hex += kDigits[digest[i] & 15U];
    }
    return hex;
}

std::string sha256Hex(std::span<const std::byte> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

Result<std::string> sha256OfFile(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a pipe that nobody writes to must not hang; it is refused just below.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const std::unique_ptr<std::FILE, CloseFile> file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"));
    if (!file) return Error{std::string("the file cannot be opened: ") + std::strerror(errno), path.string(), "check the path"};
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        return Error{"this is no regular file", path.string(), "choose a file"};
    Sha256 hash;
    std::vector<std::byte> piece(std::size_t{1} << 20U);
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get())) hash.add(std::span(piece).first(count));
    if (std::ferror(file.get()) != 0) {
        return Error{std::string("the file cannot be read: ") + std::strerror(errno), path.string(), "check the disk and the path"};
    }
    return hash.hex();
}

} // namespace edgescan
