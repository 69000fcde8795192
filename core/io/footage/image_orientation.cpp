// SPDX-License-Identifier: MIT
#include "core/io/footage/image_orientation.h"

#include <cstdint>
#include <optional>

#include "core/io/files/text_file.h"

namespace core {

namespace {

constexpr std::uint32_t kOrientationTag = 0x0112;
constexpr std::size_t kTooManyEntries = 1000;

/// A number of `size` bytes at a place; empty beyond the end.
std::optional<std::uint32_t> number(std::string_view bytes, std::size_t at, std::size_t size, bool isLittle) {
    if (at > bytes.size() || size > bytes.size() - at)
        return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + (isLittle ? size - 1 - i : i)]);
    return value;
}

/// The tag in the first directory of a TIFF file, which is also what an EXIF block is (TIFF 6.0); 1 if there is none.
std::uint32_t tagOfTiff(std::string_view tiff) {
    const bool isLittle = tiff.starts_with("II");
    if (!isLittle && !tiff.starts_with("MM"))
        return 1;
    const std::size_t directory = number(tiff, 4, 4, isLittle).value_or(UINT32_MAX);
    const std::size_t entries = number(tiff, directory, 2, isLittle).value_or(0);
    for (std::size_t i = 0; i < entries && i < kTooManyEntries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (number(tiff, entry, 2, isLittle) == kOrientationTag)
            return number(tiff, entry + 8, 2, isLittle).value_or(1);
    }
    return 1;
}

/// JPEG: the segments before the picture's data; EXIF is in APP1.
std::uint32_t tagOfJpeg(std::string_view bytes) {
    std::size_t at = 2;
    while (number(bytes, at, 1, false) == 0xFFu) {
        const std::uint32_t marker = number(bytes, at + 1, 1, false).value_or(0xD9);
        if (marker == 0xFF) { // padding
            ++at;
            continue;
        }
        const std::uint32_t length = number(bytes, at + 2, 2, false).value_or(0);
        if (marker == 0xDA || marker == 0xD9 || length < 2)
            break;
        const std::string_view content = bytes.substr(at + 4, length - 2);
        if (marker == 0xE1 && content.starts_with(std::string_view("Exif\0\0", 6)))
            return tagOfTiff(content.substr(6));
        at += 2 + length;
    }
    return 1;
}

/// PNG and WebP: chunks of a name and a length; EXIF is in `wanted`. `isPng`: length, name, content, checksum; else
/// name, length, content, padding.
std::uint32_t tagOfChunks(std::string_view bytes, std::size_t at, std::string_view wanted, bool isPng) {
    while (const std::optional<std::uint32_t> length = number(bytes, at + (isPng ? 0 : 4), 4, !isPng)) {
        if (bytes.substr(at + (isPng ? 4 : 0), 4) == wanted) {
            std::string_view content = at + 8 <= bytes.size() ? bytes.substr(at + 8, *length) : std::string_view();
            content.remove_prefix(content.starts_with(std::string_view("Exif\0\0", 6)) ? 6 : 0);
            return tagOfTiff(content);
        }
        at += 8 + std::size_t{*length} + (isPng ? 4 : *length % 2);
    }
    return 1;
}

std::uint32_t tagOf(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xD8"))
        return tagOfJpeg(bytes);
    if (bytes.starts_with("\x89PNG\r\n\x1A\n"))
        return tagOfChunks(bytes, 8, "eXIf", true);
    if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP"))
        return tagOfChunks(bytes, 12, "EXIF", false);
    return tagOfTiff(bytes);
}

} // namespace

Orientation orientationOf(std::string_view bytes) {
    switch (tagOf(bytes)) {
    case 2:
        return {0, true};
    case 3:
        return {180, false};
    case 4:
        return {180, true};
    case 5:
        return {270, true};
    case 6:
        return {90, false};
    case 7:
        return {90, true};
    case 8:
        return {270, false};
    default:
        return {};
    }
}

Orientation readOrientation(const std::filesystem::path& file) {
    return orientationOf(readTextFile(file));
}

ImageSize turnedSize(ImageSize size, int rotateDegrees) {
    return rotateDegrees % 180 == 0 ? size : ImageSize{size.height, size.width};
}

std::string sizeText(ImageSize size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

} // namespace core
