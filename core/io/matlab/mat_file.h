// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace core {

/// An array of numbers as MATLAB keeps it: the first index runs fastest.
struct MatNumbers {
    std::vector<std::size_t> shape;
    std::vector<double> values;
    /// 1 beyond the last axis.
    std::size_t size(std::size_t axis) const { return axis < shape.size() ? shape[axis] : 1; }
    double at(std::size_t row, std::size_t column) const { return values[row + column * size(0)]; }
};

/// A variable of a MATLAB file, an element of a cell or structure array, or a member of a structure. It may be missing:
/// then it has no elements, and what reads it throws. All errors are Error(BadInput) naming the file and the place in
/// it, such as "params{2}.K".
class MatValue {
public:
    bool isMissing() const;
    bool isCell() const;
    bool isStructure() const;
    /// Elements of a cell or structure array, or of an array of numbers.
    std::size_t count() const;
    /// Along an axis; 1 beyond the last one.
    std::size_t size(std::size_t axis) const;

    /// The i-th element of a cell array or of an array of structures, from 0.
    MatValue element(std::size_t i) const;
    /// A member of a structure; missing if it has none of that name. Throws if this is not a structure.
    MatValue member(const std::string& name) const;

    /// Real numbers of any type.
    MatNumbers numbers() const;
    std::string text() const;
    /// Of a cell of texts, of a matrix with a text per row (without the blanks that fill it up), or of a single text.
    std::vector<std::string> texts() const;

    [[noreturn]] void refuse(const std::string& what) const;

private:
    friend class MatFile;
    struct Content; // matio's
    std::shared_ptr<const Content> m_content;
    std::size_t m_index = 0; ///< which structure of an array
    bool m_isElement = false;
    std::string m_file, m_field;
};

/// A MATLAB file (levels 5 and 7.3) that is open for reading.
class MatFile {
public:
    /// Throws Error(NotFound) if there is no such file, Error(BadInput) if it is not one of MATLAB.
    explicit MatFile(const std::filesystem::path& file);
    ~MatFile();
    MatFile(const MatFile&) = delete;
    MatFile& operator=(const MatFile&) = delete;

    const std::string& name() const { return m_name; }
    /// A variable with its data; missing if the file has none of that name.
    MatValue read(const std::string& variable) const;
    /// A variable without its numbers, which may be many: only its size and elements can be asked for.
    MatValue readShape(const std::string& variable) const;
    [[noreturn]] void refuse(const std::string& field, const std::string& what) const;

private:
    struct Handle;
    std::string m_name;
    std::unique_ptr<Handle> m_file;
};

} // namespace core
