// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <hdf5.h>

namespace test {

/// Writes HDF5 files as h5py and PyTables lay them out, with the library itself.
class Hdf5Writer {
public:
    explicit Hdf5Writer(const std::filesystem::path& path)
        : m_file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
    ~Hdf5Writer() { H5Fclose(m_file); }
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    void group(const std::string& path) {
        H5Gclose(H5Gcreate2(m_file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    }
    void numbers(const std::string& path, const std::vector<hsize_t>& shape, const std::vector<double>& values,
                 hid_t type = H5T_IEEE_F64LE) {
        write(path, type, H5T_NATIVE_DOUBLE, shape, values.data());
    }
    /// As numpy's "S": filled with zeros to the length of the longest.
    void fixedTexts(const std::string& path, const std::vector<std::string>& texts) {
        std::size_t length = 1;
        for (const std::string& text : texts)
            length = std::max(length, text.size());
        std::string bytes(length * texts.size(), '\0');
        for (std::size_t i = 0; i < texts.size(); ++i)
            bytes.replace(i * length, texts[i].size(), texts[i]);
        const hid_t type = fixedType(length);
        write(path, type, type, {texts.size()}, bytes.data());
        H5Tclose(type);
    }
    void variableTexts(const std::string& path, const std::vector<std::string>& texts) {
        std::vector<const char*> pointers;
        for (const std::string& text : texts)
            pointers.push_back(text.c_str());
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, H5T_VARIABLE);
        write(path, type, type, {texts.size()}, pointers.data());
        H5Tclose(type);
    }
    struct Member {
        const char* name;
        std::size_t offset;
        hid_t type;
    };
    template <class Record>
    void table(const std::string& path, const std::vector<Member>& members, const std::vector<Record>& records) {
        const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Record));
        for (const Member& member : members)
            H5Tinsert(type, member.name, member.offset, member.type);
        write(path, type, type, {records.size()}, records.data());
        H5Tclose(type);
    }
    void attribute(const std::string& path, const char* name, const std::string& text) {
        const hid_t type = fixedType(text.size());
        attribute(path, name, type, text.data());
        H5Tclose(type);
    }
    void attribute(const std::string& path, const char* name, double value) {
        attribute(path, name, H5T_NATIVE_DOUBLE, &value);
    }
    static hid_t fixedType(std::size_t length) {
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, length);
        H5Tset_strpad(type, H5T_STR_NULLPAD);
        return type;
    }
    /// numpy's bool, as h5py stores it.
    static hid_t boolType() {
        const hid_t type = H5Tenum_create(H5T_NATIVE_INT8);
        const signed char no = 0, yes = 1;
        H5Tenum_insert(type, "FALSE", &no);
        H5Tenum_insert(type, "TRUE", &yes);
        return type;
    }

private:
    void write(const std::string& path, hid_t type, hid_t memory, const std::vector<hsize_t>& shape, const void* data) {
        const hid_t space = shape.empty() ? H5Screate(H5S_SCALAR)
                                          : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
        const hid_t set = H5Dcreate2(m_file, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
        H5Dclose(set);
        H5Sclose(space);
    }
    void attribute(const std::string& path, const char* name, hid_t type, const void* data) {
        const hid_t space = H5Screate(H5S_SCALAR);
        const hid_t id =
            H5Acreate_by_name(m_file, path.c_str(), name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(id, type, data);
        H5Aclose(id);
        H5Sclose(space);
    }

    hid_t m_file;
};

} // namespace test
