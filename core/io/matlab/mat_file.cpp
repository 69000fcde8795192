// SPDX-License-Identifier: MIT
#include "core/io/matlab/mat_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <matio.h>

#include "core/error.h"
#include "core/io/hdf5/hdf5_file.h"
#include "core/io/matlab/mat_claims.h"

namespace core {

namespace fs = std::filesystem;

/// A variable; elements and members keep the one alive that they are part of.
struct MatValue::Content {
    std::shared_ptr<matvar_t> whole;
    matvar_t* part = nullptr;
};

struct MatFile::Handle {
    std::unique_lock<std::recursive_mutex> lock; // level 7.3 is HDF5
    mat_t* file = nullptr;
};

namespace {

template <class Type>
void copyNumbers(const matvar_t& variable, std::vector<double>& values) {
    const auto* data = static_cast<const Type*>(variable.data);
    values.assign(data, data + values.size());
}

using Copy = void (*)(const matvar_t&, std::vector<double>&);
Copy copyOf(matio_classes kind) {
    switch (kind) {
    case MAT_C_DOUBLE:
        return copyNumbers<double>;
    case MAT_C_SINGLE:
        return copyNumbers<float>;
    case MAT_C_INT64:
        return copyNumbers<std::int64_t>;
    case MAT_C_UINT64:
        return copyNumbers<std::uint64_t>;
    case MAT_C_INT32:
        return copyNumbers<std::int32_t>;
    case MAT_C_UINT32:
        return copyNumbers<std::uint32_t>;
    case MAT_C_INT16:
        return copyNumbers<std::int16_t>;
    case MAT_C_UINT16:
        return copyNumbers<std::uint16_t>;
    case MAT_C_INT8:
        return copyNumbers<std::int8_t>;
    case MAT_C_UINT8:
        return copyNumbers<std::uint8_t>;
    default:
        return nullptr;
    }
}

std::size_t elementsOf(const matvar_t& variable) {
    std::size_t count = variable.rank > 0 ? 1 : 0;
    for (int axis = 0; axis < variable.rank; ++axis)
        count *= variable.dims[axis];
    return count;
}

/// The rows of a matrix of letters, which MATLAB keeps column by column, with one or two bytes each.
std::vector<std::string> rowsOf(const matvar_t& variable) {
    const auto step = static_cast<std::size_t>(std::max(1, variable.data_size));
    const std::size_t letters = variable.data ? variable.nbytes / step : 0;
    const std::size_t rows = variable.rank > 0 ? variable.dims[0] : 0;
    std::vector<std::string> texts(rows);
    for (std::size_t i = 0; i < letters && rows > 0; ++i) {
        const auto* letter = static_cast<const char*>(variable.data) + i * step;
        if (*letter != '\0') // little endian: the first byte of two
            texts[i % rows] += *letter;
    }
    for (std::string& text : texts)
        text.erase(text.find_last_not_of(' ') + 1);
    return texts;
}

/// Whether so many elements of a cell or members of structures are really there: a damaged file has fewer than it says.
bool holdsParts(const matvar_t& variable, std::size_t parts) {
    return variable.data && variable.nbytes / sizeof(matvar_t*) >= parts;
}

/// A file may claim any size; no table of annotations comes near.
constexpr std::size_t kMostElements = 200'000'000;

/// Refuses what matio cannot read, or only with more memory than there is.
void checkContent(const fs::path& file) {
    std::array<char, 128> header{};
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored) ||
        !std::ifstream(file, std::ios::binary).read(header.data(), header.size()))
        throw Error(ErrorCode::BadInput, file.string(), "", "is not a readable MATLAB file");
    const bool isBigEndian = header[126] == 'M' && header[127] == 'I';
    const bool isLittleEndian = header[126] == 'I' && header[127] == 'M';
    const int level = isBigEndian ? header[124] : header[125];
    if ((!isBigEndian && !isLittleEndian) || (level != 1 && level != 2))
        throw Error(ErrorCode::BadInput, file.string(), "",
                    "is not a readable MATLAB file: levels 5 and 7.3 are read (save with -v7)");
    if (level == 1)
        checkMatClaims(file);
    else
        Hdf5File(file).checkDatasets();
}

} // namespace

bool MatValue::isMissing() const {
    return !m_content || !m_content->part;
}

bool MatValue::isCell() const {
    return !isMissing() && m_content->part->class_type == MAT_C_CELL;
}

bool MatValue::isStructure() const {
    return !isMissing() && m_content->part->class_type == MAT_C_STRUCT;
}

std::size_t MatValue::count() const {
    return isMissing() ? 0 : m_isElement && isStructure() ? 1 : elementsOf(*m_content->part);
}

std::size_t MatValue::size(std::size_t axis) const {
    const int rank = isMissing() ? 0 : m_content->part->rank;
    return axis < static_cast<std::size_t>(rank) ? m_content->part->dims[axis] : 1;
}

void MatValue::refuse(const std::string& what) const {
    throw Error(ErrorCode::BadInput, m_file, m_field, what);
}

MatValue MatValue::element(std::size_t i) const {
    if (!isCell() && !isStructure())
        refuse(isMissing() ? "is missing" : "a cell array or an array of structures is expected");
    if (i >= count())
        refuse("has only " + std::to_string(count()) + " elements");
    MatValue found = *this;
    const std::string number = std::to_string(i + 1);
    if (isStructure()) {
        found.m_index = m_isElement ? m_index : i;
        found.m_isElement = true;
        found.m_field += m_isElement ? "" : "(" + number + ")";
        return found;
    }
    found.m_isElement = false;
    found.m_field += "{" + number + "}";
    matvar_t* part = m_content->part;
    found.m_content = std::make_shared<Content>(
        Content{m_content->whole, holdsParts(*part, i + 1) ? Mat_VarGetCell(part, static_cast<int>(i)) : nullptr});
    return found;
}

MatValue MatValue::member(const std::string& name) const {
    if (!isStructure() || count() != 1)
        refuse(isMissing() ? "is missing" : "a structure is expected");
    MatValue found = *this;
    found.m_index = 0;
    found.m_isElement = false;
    found.m_field += "." + name;
    matvar_t* part = m_content->part;
    const std::size_t parts = (m_index + 1) * Mat_VarGetNumberOfFields(part);
    found.m_content = std::make_shared<Content>(
        Content{m_content->whole,
                holdsParts(*part, parts) ? Mat_VarGetStructFieldByName(part, name.c_str(), m_index) : nullptr});
    return found;
}

MatNumbers MatValue::numbers() const {
    if (isMissing())
        refuse("is missing");
    const matvar_t& variable = *m_content->part;
    const std::size_t count = elementsOf(variable);
    if (count == 0)
        return {{variable.dims, variable.dims + variable.rank}, {}};
    const Copy copy = copyOf(variable.class_type);
    if (!copy || variable.isComplex || !variable.data)
        refuse("real numbers are expected");
    if (count > kMostElements || variable.nbytes < count * static_cast<std::size_t>(std::max(1, variable.data_size)))
        refuse("is damaged or too large");
    MatNumbers numbers{{variable.dims, variable.dims + variable.rank}, std::vector<double>(count)};
    copy(variable, numbers.values);
    return numbers;
}

std::string MatValue::text() const {
    const std::vector<std::string> rows = isMissing() || isCell() ? std::vector<std::string>() : texts();
    if (rows.size() != 1)
        refuse(isMissing() ? "is missing" : "a text is expected");
    return rows.front();
}

std::vector<std::string> MatValue::texts() const {
    if (!isMissing() && m_content->part->class_type == MAT_C_CHAR)
        return rowsOf(*m_content->part);
    if (!isCell())
        refuse(isMissing() ? "is missing" : "a cell array of texts is expected");
    std::vector<std::string> list;
    for (std::size_t i = 0; i < count(); ++i)
        list.push_back(element(i).text());
    return list;
}

MatFile::MatFile(const fs::path& file)
    : m_name(file.string())
    , m_file(std::make_unique<Handle>()) {
    std::error_code ignored;
    if (!fs::exists(file, ignored))
        throw Error(ErrorCode::NotFound, m_name, "", "there is no such file");
    m_file->lock = lockHdf5();
    Mat_LogInit("handlens");
    Mat_LogInitFunc("handlens", [](int, char*) {}); // its messages are ours to give
    checkContent(file);
    m_file->file = Mat_Open(m_name.c_str(), MAT_ACC_RDONLY);
    if (!m_file->file)
        refuse("", "is not a readable MATLAB file");
}

MatFile::~MatFile() {
    Mat_Close(m_file->file);
}

void MatFile::refuse(const std::string& field, const std::string& what) const {
    throw Error(ErrorCode::BadInput, m_name, field, what);
}

MatValue MatFile::read(const std::string& variable) const {
    MatValue value;
    value.m_file = m_name;
    value.m_field = variable;
    const std::shared_ptr<matvar_t> whole(Mat_VarRead(m_file->file, variable.c_str()), &Mat_VarFree);
    value.m_content = std::make_shared<MatValue::Content>(MatValue::Content{whole, whole.get()});
    return value;
}

MatValue MatFile::readShape(const std::string& variable) const {
    MatValue value;
    value.m_file = m_name;
    value.m_field = variable;
    const std::shared_ptr<matvar_t> whole(Mat_VarReadInfo(m_file->file, variable.c_str()), &Mat_VarFree);
    value.m_content = std::make_shared<MatValue::Content>(MatValue::Content{whole, whole.get()});
    return value;
}

} // namespace core
