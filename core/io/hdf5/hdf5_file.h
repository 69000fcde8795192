// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace core {

/// Numbers of any integer, boolean or real type, row by row.
struct Hdf5Numbers {
    std::vector<std::size_t> shape; ///< empty for a single number
    std::vector<double> values;
};

/// Held while the library is used, which is not safe for threads.
std::unique_lock<std::recursive_mutex> lockHdf5();

/// An HDF5 file that is open for reading. Paths are those inside the file, such as "metadata/nodes". All readers throw
/// Error(BadInput) naming the file and the dataset if it is missing, damaged, or of another type. Only one of them is
/// open at a time (lockHdf5).
class Hdf5File {
public:
    /// Throws Error(NotFound) if there is no such file, Error(BadInput) if it is not one of HDF5.
    explicit Hdf5File(const std::filesystem::path& file);
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    const std::string& name() const { return m_name; }
    /// True if there is a group or dataset of that path.
    bool has(const std::string& path) const;
    /// What a group holds, ascending; "/" is the whole file.
    std::vector<std::string> childrenOf(const std::string& group) const;

    Hdf5Numbers numbers(const std::string& path) const;
    /// Texts of fixed or variable length, in the order of the file, without padding.
    std::vector<std::string> texts(const std::string& path) const;
    bool holdsTexts(const std::string& path) const;

    /// The fields of a table (a dataset of records), in order.
    std::vector<std::string> fieldsOf(const std::string& path) const;
    /// One field of a table: a row per record, and a column per number in it.
    Hdf5Numbers numbers(const std::string& path, const std::string& field) const;
    std::vector<std::string> texts(const std::string& path, const std::string& field) const;
    bool holdsTexts(const std::string& path, const std::string& field) const;

    /// Of a group or dataset; empty if it has no such attribute or one that is not a single text or number.
    std::optional<std::string> textAttribute(const std::string& path, const std::string& attribute) const;
    std::optional<double> numberAttribute(const std::string& path, const std::string& attribute) const;

    std::uintmax_t bytes() const; ///< size of the file
    /// Throws Error(BadInput) naming the first dataset that claims more than the file can hold. Readers of this class
    /// check what they read; this is for other programs' readers of the same file.
    void checkDatasets() const;

    /// An error about a dataset of this file.
    [[noreturn]] void refuse(const std::string& path, const std::string& what) const;

private:
    std::unique_lock<std::recursive_mutex> m_lock;
    std::string m_name;
    std::int64_t m_file = -1;
};

} // namespace core
