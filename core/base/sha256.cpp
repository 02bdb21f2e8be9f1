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
#include <vector>

namespace edgescan {
namespace {

struct FreeContext {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};
using Context = std::unique_ptr<EVP_MD_CTX, FreeContext>;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

Context startedContext() {
    Context context(EVP_MD_CTX_new());
    if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
    return context;
}

std::string finishedHex(EVP_MD_CTX* context) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(context, digest.data(), &length);
    static constexpr const char* kDigits = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < length; ++i) {
        hex += kDigits[digest[i] >> 4U];
        hex += kDigits[digest[i] & 15U];
    }
    return hex;
}

} // namespace

std::string sha256Hex(std::span<const std::byte> bytes) {
    const Context context = startedContext();
    EVP_DigestUpdate(context.get(), bytes.data(), bytes.size());
    return finishedHex(context.get());
}

Result<std::string> sha256OfFile(const std::filesystem::path& path) {
    // O_NONBLOCK: opening a pipe that nobody writes to must not hang; it is refused just below.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const std::unique_ptr<std::FILE, CloseFile> file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"));
    if (!file) return Error{std::string("the file cannot be opened: ") + std::strerror(errno), path.string(), "check the path"};
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        return Error{"this is no regular file", path.string(), "choose a file"};
    const Context context = startedContext();
    std::vector<unsigned char> piece(std::size_t{1} << 20U);
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get())) {
        EVP_DigestUpdate(context.get(), piece.data(), count);
    }
    if (std::ferror(file.get()) != 0) {
        return Error{std::string("the file cannot be read: ") + std::strerror(errno), path.string(), "check the disk and the path"};
    }
    return finishedHex(context.get());
}

} // namespace edgescan
