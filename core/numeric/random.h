// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace core {

/// The SplitMix64 generator (Steele, Lea, Flood 2014): the same numbers on every machine and compiler, which the
/// standard library's distributions do not promise.
class RandomGenerator {
public:
    explicit RandomGenerator(std::uint64_t seed)
        : m_state(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, bound), without bias (rejection); bound > 0.
    std::uint64_t below(std::uint64_t bound) {
        const std::uint64_t threshold = (0 - bound) % bound;
        std::uint64_t value = next();
        while (value < threshold)
            value = next();
        return value % bound;
    }

    /// Uniform in [0, 1), 53 bits.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

private:
    std::uint64_t m_state;
};

/// FNV-1a hash of a text: the same on every machine.
inline std::uint64_t stableHash(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325ull;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ull;
    return hash;
}

/// `count` different numbers of [0, size), each subset equally likely, in the order drawn; count <= size.
inline std::vector<int> sampleWithoutReplacement(int size, int count, RandomGenerator& random) {
    std::vector<int> numbers(static_cast<std::size_t>(size));
    std::iota(numbers.begin(), numbers.end(), 0);
    for (int i = 0; i < count; ++i) {
        const auto j = i + static_cast<int>(random.below(static_cast<std::uint64_t>(size - i)));
        std::swap(numbers[static_cast<std::size_t>(i)], numbers[static_cast<std::size_t>(j)]);
    }
    numbers.resize(static_cast<std::size_t>(count));
    return numbers;
}

} // namespace core
