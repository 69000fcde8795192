// SPDX-License-Identifier: MIT
#include "core/io/detector/package_archive.h"

#include <cstring>

#include <zlib.h>

#include "core/error.h"
#include "core/io/files/text_file.h"

namespace core {

namespace {

constexpr std::size_t kMostBytes = 200'000'000; ///< unpacked; the package of the hand detector has 25 MB
constexpr std::size_t kBlock = 512;

Error damaged(const std::filesystem::path& file, const std::string& detail) {
    return {ErrorCode::BadInput, file.string(), "", detail};
}

/// The content of a gzip file.
std::string inflated(const std::string& packed, const std::filesystem::path& file) {
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) // 16: with gzip's header
        throw std::bad_alloc();
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string content;
    std::string chunk(1 << 20, '\0');
    int state = Z_OK;
    while (state == Z_OK && content.size() <= kMostBytes) {
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        state = inflate(&stream, Z_NO_FLUSH);
        content.append(chunk, 0, chunk.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (content.size() > kMostBytes)
        throw damaged(file, "the archive unpacks to more than 200 MB: not the package of the hand detector");
    if (state != Z_STREAM_END)
        throw damaged(file, packed.substr(0, 2) == "\x1f\x8b" ? "the archive is truncated or damaged"
                                                              : "not a .tgz archive (it is not compressed with gzip)");
    return content;
}

/// An octal number of a tar header, ended by a blank or a zero.
std::size_t octal(std::string_view text) {
    std::size_t value = 0;
    for (const char c : text)
        if (c >= '0' && c <= '7')
            value = value * 8 + static_cast<std::size_t>(c - '0');
        else if (value > 0 || c != ' ')
            break;
    return value;
}

/// The files of a tar archive (ustar): a block of 512 bytes with name, size and type, then the content in whole blocks.
std::map<std::string, std::string> untarred(std::string_view archive, const std::filesystem::path& file,
                                            bool (*isWanted)(const std::string& name)) {
    std::map<std::string, std::string> files;
    std::size_t at = 0;
    while (at + kBlock <= archive.size() && archive[at] != '\0') {
        const std::string_view header = archive.substr(at, kBlock);
        if (header.substr(257, 5) != "ustar")
            throw damaged(file, "not an archive of npm (tar)");
        const std::size_t size = octal(header.substr(124, 12));
        at += kBlock;
        if (size > archive.size() - at)
            throw damaged(file, "the archive is truncated or damaged");
        const std::string path(header.data(), strnlen(header.data(), 100));
        const std::string name = path.substr(path.find('/') + 1); // npm puts everything into "package/"
        if ((header[156] == '0' || header[156] == '\0') && isWanted(name))
            files[name] = archive.substr(at, size);
        at += (size + kBlock - 1) / kBlock * kBlock;
    }
    return files;
}

std::map<std::string, std::string> folderFiles(const std::filesystem::path& folder,
                                               bool (*isWanted)(const std::string& name)) {
    std::map<std::string, std::string> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (isWanted(name) && entry.is_regular_file(error))
            files[name] = readTextFile(entry.path(), kMostBytes);
    }
    if (error)
        throw Error(ErrorCode::Io, folder.string(), "", error.message());
    return files;
}

} // namespace

std::map<std::string, std::string> readPackage(const std::filesystem::path& package,
                                               bool (*isWanted)(const std::string& name)) {
    std::error_code error;
    if (std::filesystem::is_directory(package, error))
        return folderFiles(package, isWanted);
    return untarred(inflated(readTextFile(package, kMostBytes), package), package, isWanted);
}

} // namespace core
