// SPDX-License-Identifier: MIT
#include "core/io/hdf5/hdf5_file.h"

#include <algorithm>

#include <hdf5.h>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// An identifier of the library, closed as its kind wants.
class Id {
public:
    using Closer = herr_t (*)(hid_t);
    Id(hid_t id, Closer close)
        : m_id(id)
        , m_close(close) {}
    ~Id() {
        if (m_id >= 0)
            m_close(m_id);
    }
    Id(const Id&) = delete;
    Id& operator=(const Id&) = delete;
    operator hid_t() const { return m_id; }
    bool isValid() const { return m_id >= 0; }

private:
    hid_t m_id;
    Closer m_close;
};

/// A file may claim any size; no table of annotations comes near.
constexpr hsize_t kMostElements = 64'000'000;
constexpr std::size_t kMostElementBytes = 1 << 20; ///< of one number, text or record

std::vector<std::size_t> shapeOf(hid_t space) {
    const int rank = H5Sget_simple_extent_ndims(space);
    std::vector<hsize_t> dims(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0)
        H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    return {dims.begin(), dims.end()};
}

/// Without the zeros (or blanks) that fill it up.
std::string trimmed(std::string text) {
    text.erase(std::min(text.find('\0'), text.size()));
    return text;
}

/// Reads texts of one type with `read`, which fills a buffer of elements of the given memory type.
template <class Read>
std::optional<std::vector<std::string>> readTexts(hid_t fileType, hid_t space, std::size_t count, const Read& read) {
    std::vector<std::string> texts(count);
    const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_cset(type, H5Tget_cset(fileType));
    if (H5Tis_variable_str(fileType) > 0) {
        H5Tset_size(type, H5T_VARIABLE);
        std::vector<char*> pointers(count, nullptr);
        const bool isRead = count == 0 || read(type, pointers.data()) >= 0;
        for (std::size_t i = 0; i < count && isRead; ++i)
            texts[i] = pointers[i] ? pointers[i] : "";
        if (count > 0) // also what was read before it failed
            H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
        return isRead ? std::optional(std::move(texts)) : std::nullopt;
    }
    const std::size_t length = H5Tget_size(fileType);
    if (length == 0 || length > kMostElementBytes || count > kMostElements / length)
        return std::nullopt;
    H5Tset_size(type, length);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    std::string buffer(length * count, '\0');
    if (count > 0 && read(type, buffer.data()) < 0)
        return std::nullopt;
    for (std::size_t i = 0; i < count; ++i)
        texts[i] = trimmed(buffer.substr(i * length, length));
    return texts;
}

bool isNumber(hid_t type) {
    const H5T_class_t kind = H5Tget_class(type);
    return kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_ENUM;
}

/// Whether a dataset's numbers can lie in the file: within it where they lie in one piece, and not more than packing
/// makes of it where they lie in parts. The library believes what a damaged file says.
bool isPlausible(hid_t data, hsize_t count, std::size_t elementBytes, hsize_t fileBytes) {
    constexpr hsize_t kMostPacking = 1100; // deflate's is 1032
    constexpr hsize_t kSmallBytes = 1 << 26;
    const hsize_t stored = H5Dget_storage_size(data);
    const Id creation(H5Dget_create_plist(data), H5Pclose);
    const H5D_layout_t layout = creation.isValid() ? H5Pget_layout(creation) : H5D_LAYOUT_ERROR;
    if (layout == H5D_CHUNKED) {
        hsize_t chunk[H5S_MAX_RANK] = {};
        hsize_t chunkBytes = elementBytes;
        const int rank = H5Pget_chunk(creation, H5S_MAX_RANK, chunk);
        for (int axis = 0; axis < rank; ++axis) {
            if (chunk[axis] == 0 || chunkBytes > (hsize_t(1) << 32) / chunk[axis])
                return false;
            chunkBytes *= chunk[axis];
        }
        const hsize_t most = std::max(kSmallBytes, fileBytes * kMostPacking);
        return rank > 0 && stored <= fileBytes && chunkBytes <= most && count * elementBytes <= most;
    }
    if (layout == H5D_CONTIGUOUS && stored > 0) {
        const haddr_t at = H5Dget_offset(data);
        return at == HADDR_UNDEF || (stored >= count * elementBytes && at <= fileBytes && stored <= fileBytes - at);
    }
    if (layout == H5D_COMPACT) // within the dataset's own description
        return stored <= fileBytes && stored >= count * elementBytes;
    return layout != H5D_LAYOUT_ERROR; // never written, or in other files
}

/// A dataset with its type, its extent and its number of elements.
struct OpenDataset {
    OpenDataset(const Hdf5File& file, std::int64_t id, const std::string& path)
        : data(file.has(path) ? H5Dopen2(id, path.c_str(), H5P_DEFAULT) : H5I_INVALID_HID, H5Dclose)
        , type(data.isValid() ? H5Dget_type(data) : H5I_INVALID_HID, H5Tclose)
        , space(data.isValid() ? H5Dget_space(data) : H5I_INVALID_HID, H5Sclose) {
        if (!data.isValid())
            file.refuse(path, file.has(path) ? "is a group, a dataset is expected" : "is missing");
        const hssize_t points = H5Sget_simple_extent_npoints(space);
        if (points < 0 || static_cast<hsize_t>(points) > kMostElements || H5Tget_size(type) > kMostElementBytes)
            file.refuse(path, "is damaged or too large");
        count = static_cast<std::size_t>(points);
        if (!isPlausible(data, count, H5Tget_size(type), file.bytes()))
            file.refuse(path, "is damaged or too large");
    }
    Id data, type, space;
    std::size_t count = 0;
};

/// The type of one field of a table, and its place in the records.
struct Field {
    Field(const Hdf5File& file, const OpenDataset& table, const std::string& path, const std::string& name)
        : index(H5Tget_class(table.type) == H5T_COMPOUND ? H5Tget_member_index(table.type, name.c_str()) : -1)
        , type(index >= 0 ? H5Tget_member_type(table.type, static_cast<unsigned>(index)) : H5I_INVALID_HID, H5Tclose) {
        if (index < 0)
            file.refuse(path, "has no field \"" + name + "\"");
    }
    int index;
    Id type;
};

/// A record of the one field, as it is to lie in memory.
Id recordOf(const std::string& field, hid_t memoryType) {
    const hid_t record = H5Tcreate(H5T_COMPOUND, H5Tget_size(memoryType));
    H5Tinsert(record, field.c_str(), 0, memoryType);
    return {record, H5Tclose};
}

} // namespace

std::unique_lock<std::recursive_mutex> lockHdf5() {
    static std::recursive_mutex mutex;
    return std::unique_lock(mutex);
}

Hdf5File::Hdf5File(const fs::path& file)
    : m_lock(lockHdf5())
    , m_name(file.string()) {
    if (!fs::exists(file))
        throw Error(ErrorCode::NotFound, m_name, "", "there is no such file");
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // its messages are ours to give
    m_file = fs::is_regular_file(file) && H5Fis_hdf5(m_name.c_str()) > 0
                 ? H5Fopen(m_name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)
                 : H5I_INVALID_HID;
    if (m_file < 0)
        throw Error(ErrorCode::BadInput, m_name, "", "is not a readable HDF5 file");
}

Hdf5File::~Hdf5File() {
    H5Fclose(m_file);
}

void Hdf5File::refuse(const std::string& path, const std::string& what) const {
    throw Error(ErrorCode::BadInput, m_name, path, what);
}

bool Hdf5File::has(const std::string& path) const {
    for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
        if (H5Lexists(m_file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
            return false;
    return path == "/" || (H5Lexists(m_file, path.c_str(), H5P_DEFAULT) > 0 &&
                           H5Oexists_by_name(m_file, path.c_str(), H5P_DEFAULT) > 0);
}

std::uintmax_t Hdf5File::bytes() const {
    std::error_code ignored;
    return fs::file_size(m_name, ignored);
}

void Hdf5File::checkDatasets() const {
    struct Visit {
        const Hdf5File& file;
        std::int64_t id;
        std::optional<Error> error{};
    } visit{*this, m_file};
    const auto look = [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
        Visit& work = *static_cast<Visit*>(to);
        if (info->type != H5O_TYPE_DATASET)
            return 0;
        try {
            OpenDataset(work.file, work.id, name);
        } catch (const Error& error) { // not through the library, which is written in C
            work.error = error;
            return 1;
        }
        return 0;
    };
    if (H5Ovisit2(m_file, H5_INDEX_NAME, H5_ITER_NATIVE, look, &visit, H5O_INFO_BASIC) < 0)
        refuse("", "is damaged");
    if (visit.error)
        throw Error(*visit.error);
}

std::vector<std::string> Hdf5File::childrenOf(const std::string& group) const {
    const Id id(H5Gopen2(m_file, group.c_str(), H5P_DEFAULT), H5Gclose);
    if (!id.isValid())
        refuse(group, "is not a group");
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->push_back(name);
        return 0;
    };
    H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
    return names;
}

Hdf5Numbers Hdf5File::numbers(const std::string& path) const {
    const OpenDataset set(*this, m_file, path);
    if (!isNumber(set.type))
        refuse(path, "numbers are expected");
    Hdf5Numbers numbers{shapeOf(set.space), std::vector<double>(set.count)};
    if (set.count > 0 && H5Dread(set.data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.values.data()) < 0)
        refuse(path, "cannot be read");
    return numbers;
}

bool Hdf5File::holdsTexts(const std::string& path) const {
    return H5Tget_class(OpenDataset(*this, m_file, path).type) == H5T_STRING;
}

std::vector<std::string> Hdf5File::texts(const std::string& path) const {
    const OpenDataset set(*this, m_file, path);
    if (H5Tget_class(set.type) != H5T_STRING)
        refuse(path, "texts are expected");
    auto texts = readTexts(set.type, set.space, set.count, [&set](hid_t type, void* to) {
        return H5Dread(set.data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
    });
    if (!texts)
        refuse(path, "cannot be read");
    return *texts;
}

std::vector<std::string> Hdf5File::fieldsOf(const std::string& path) const {
    const OpenDataset set(*this, m_file, path);
    if (H5Tget_class(set.type) != H5T_COMPOUND)
        refuse(path, "a table with named fields is expected");
    std::vector<std::string> names;
    for (int i = 0; i < H5Tget_nmembers(set.type); ++i) {
        char* name = H5Tget_member_name(set.type, static_cast<unsigned>(i));
        if (name == nullptr)
            refuse(path, "is damaged");
        names.emplace_back(name);
        H5free_memory(name);
    }
    return names;
}

Hdf5Numbers Hdf5File::numbers(const std::string& path, const std::string& field) const {
    const OpenDataset set(*this, m_file, path);
    const Field member(*this, set, path, field);
    const bool isArray = H5Tget_class(member.type) == H5T_ARRAY;
    const Id element(isArray ? H5Tget_super(member.type) : H5Tcopy(member.type), H5Tclose);
    if (!isNumber(element))
        refuse(path + ", " + field, "numbers are expected");
    const auto width =
        static_cast<std::size_t>(H5Tget_size(member.type) / std::max<std::size_t>(1, H5Tget_size(element)));
    if (width == 0 || set.count > kMostElements / width)
        refuse(path + ", " + field, "is damaged or too large");
    const hsize_t dims[] = {width};
    const Id memory(isArray ? H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, dims) : H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose);
    const Id record = recordOf(field, memory);
    Hdf5Numbers numbers{{set.count, width}, std::vector<double>(set.count * width)};
    if (set.count > 0 && H5Dread(set.data, record, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.values.data()) < 0)
        refuse(path + ", " + field, "cannot be read");
    return numbers;
}

bool Hdf5File::holdsTexts(const std::string& path, const std::string& field) const {
    const OpenDataset set(*this, m_file, path);
    return H5Tget_class(Field(*this, set, path, field).type) == H5T_STRING;
}

std::vector<std::string> Hdf5File::texts(const std::string& path, const std::string& field) const {
    const OpenDataset set(*this, m_file, path);
    const Field member(*this, set, path, field);
    if (H5Tget_class(member.type) != H5T_STRING)
        refuse(path + ", " + field, "texts are expected");
    auto texts = readTexts(member.type, set.space, set.count, [&](hid_t type, void* to) {
        return H5Dread(set.data, recordOf(field, type), H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
    });
    if (!texts)
        refuse(path + ", " + field, "cannot be read");
    return *texts;
}

std::optional<std::string> Hdf5File::textAttribute(const std::string& path, const std::string& attribute) const {
    if (!has(path) || H5Aexists_by_name(m_file, path.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0)
        return std::nullopt;
    const Id id(H5Aopen_by_name(m_file, path.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Id type(H5Aget_type(id), H5Tclose), space(H5Aget_space(id), H5Sclose);
    if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1)
        return std::nullopt;
    const auto texts = readTexts(type, space, 1, [&id](hid_t memory, void* to) { return H5Aread(id, memory, to); });
    return texts ? std::optional(texts->front()) : std::nullopt;
}

std::optional<double> Hdf5File::numberAttribute(const std::string& path, const std::string& attribute) const {
    if (!has(path) || H5Aexists_by_name(m_file, path.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0)
        return std::nullopt;
    const Id id(H5Aopen_by_name(m_file, path.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Id type(H5Aget_type(id), H5Tclose), space(H5Aget_space(id), H5Sclose);
    double value = 0;
    if (!isNumber(type) || H5Tget_size(type) > kMostElementBytes || H5Sget_simple_extent_npoints(space) != 1 ||
        H5Aread(id, H5T_NATIVE_DOUBLE, &value) < 0)
        return std::nullopt;
    return value;
}

} // namespace core
