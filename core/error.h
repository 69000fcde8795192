// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace core {

/// What kind of thing went wrong.
enum class ErrorCode {
    Usage,      ///< the request makes no sense (a bad option)
    NotFound,   ///< a file, sequence, frame, camera or joint that is not there
    BadInput,   ///< a file whose content is not what it should be
    Newer,      ///< a file written by a newer version of the program
    Io,         ///< the file system refused (permission, full disk, lock)
    Unsupported ///< well-formed, but of a kind that is not handled
};

/// The one exception type of the core: bad input, with the file and the field that are at fault.
/// what() reads "FILE: FIELD: what is wrong"; parts that are empty are left out.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, std::string file, std::string field, std::string detail)
        : std::runtime_error(join(file, field, detail))
        , m_code(code)
        , m_file(std::move(file))
        , m_field(std::move(field))
        , m_detail(std::move(detail)) {}

    ErrorCode code() const { return m_code; }
    const std::string& file() const { return m_file; }
    const std::string& field() const { return m_field; }
    const std::string& detail() const { return m_detail; }

private:
    static std::string join(const std::string& file, const std::string& field, const std::string& detail) {
        return (file.empty() ? "" : file + ": ") + (field.empty() ? "" : field + ": ") + detail;
    }

    ErrorCode m_code;
    std::string m_file;
    std::string m_field;
    std::string m_detail;
};

} // namespace core
