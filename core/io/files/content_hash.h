// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace core {

/// A 64-bit number that tells one run of bytes from another (FNV-1a over words of eight bytes, with a final mix). No
/// protection against forgery.
inline std::uint64_t contentHash(const void* data, std::size_t size) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    std::uint64_t hash = 0xcbf29ce484222325 ^ size;
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (; size >= 8; size -= 8, bytes += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes, 8);
        hash = (hash ^ word) * kPrime;
        hash ^= hash >> 32;
    }
    for (; size > 0; --size, ++bytes)
        hash = (hash ^ *bytes) * kPrime;
    return hash ^ hash >> 29;
}

} // namespace core
