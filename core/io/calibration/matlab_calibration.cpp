// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <matio.h>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using MatFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using MatVariable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;
/// Looks up a variable or a member of a struct; nullptr if there is none.
using MatLookup = std::function<const matvar_t*(const char*)>;

/// All numbers of a real variable, column by column, as MATLAB keeps them.
std::vector<double> columnNumbers(const matvar_t* variable, const std::string& name, const std::string& field) {
    if (variable == nullptr || variable->data == nullptr)
        throw Error(ErrorCode::BadInput, name, field, "is missing");
    if (variable->class_type != MAT_C_DOUBLE || variable->isComplex || variable->rank != 2)
        throw Error(ErrorCode::BadInput, name, field, "a real matrix of doubles is expected");
    const std::size_t count = variable->dims[0] * variable->dims[1];
    const auto* data = static_cast<const double*>(variable->data);
    std::vector<double> numbers(data, data + count);
    for (const double number : numbers)
        if (!std::isfinite(number))
            throw Error(ErrorCode::BadInput, name, field, "holds a number that is not finite");
    return numbers;
}

/// `place` stands before the members' names in errors.
Camera matlabCamera(const MatLookup& find, const std::string& name, const std::string& place) {
    const auto read = [&](const char* member) { return columnNumbers(find(member), name, place + member); };
    Camera camera;
    // MATLAB multiplies from the left (x K, X r + t), so both are stored transposed; kept column by column, they read
    // as wanted row by row. K(0, 1) is the skew.
    camera.intrinsics = rowMajorMatrix(read("K"), name, place + "K");
    camera.intrinsics(0, 2) -= 1; // its first pixel is 1
    camera.intrinsics(1, 2) -= 1;
    camera.cameraFromWorld.rotation = rowMajorMatrix(read("r"), name, place + "r");
    camera.cameraFromWorld.translation = vectorOf(read("t"), name, place + "t");
    const std::vector<double> radial = read("RDistort"), tangential = read("TDistort");
    if ((radial.size() != 2 && radial.size() != 3) || tangential.size() != 2) {
        throw Error(ErrorCode::BadInput, name, place + "RDistort",
                    "two or three radial and two tangential coefficients are expected");
    }
    camera.distortion = {radial[0], radial[1], tangential[0], tangential[1], radial.size() == 3 ? radial[2] : 0};
    return camera;
}

std::string textOfChars(const matvar_t* variable) {
    std::string text;
    if (variable == nullptr || variable->class_type != MAT_C_CHAR || variable->data == nullptr)
        return text;
    const auto* bytes = static_cast<const unsigned char*>(variable->data);
    const auto step = static_cast<std::size_t>(std::max(1, variable->data_size)); // one or two bytes a letter
    for (std::size_t i = 0; i + step <= variable->nbytes; i += step)
        if (bytes[i] != 0)
            text += static_cast<char>(bytes[i]);
    return text;
}

std::size_t elementCount(const matvar_t& variable) {
    std::size_t count = 1;
    for (int i = 0; i < variable.rank; ++i)
        count *= variable.dims[i];
    return count;
}

/// `list`: the cell of structs, one per camera, that DANNCE calls params and Label3D camParams.
std::vector<Camera> camerasOfProject(mat_t* file, matvar_t& list, const std::string& name) {
    const std::string listName = list.name == nullptr ? "params" : list.name;
    if (list.class_type != MAT_C_CELL || list.data == nullptr)
        throw Error(ErrorCode::BadInput, name, listName, "a cell with a struct per camera is expected");
    const MatVariable names(Mat_VarRead(file, "camnames"), &Mat_VarFree);
    const bool hasNames = names && names->class_type == MAT_C_CELL && names->data != nullptr;
    const std::size_t count = elementCount(list);
    if (hasNames && elementCount(*names) != count)
        throw Error(ErrorCode::BadInput, name, "camnames", "as many names as cameras are expected");
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < count; ++i) {
        const int index = static_cast<int>(i);
        const std::string place = listName + "{" + std::to_string(i + 1) + "}";
        matvar_t* member = Mat_VarGetCell(&list, index);
        if (member == nullptr || member->class_type != MAT_C_STRUCT)
            throw Error(ErrorCode::BadInput, name, place, "a struct is expected");
        cameras.push_back(matlabCamera(
            [member](const char* field) { return Mat_VarGetStructFieldByName(member, field, 0); }, name, place + "."));
        cameras.back().name = hasNames ? textOfChars(Mat_VarGetCell(names.get(), index)) : "";
        if (cameras.back().name.empty())
            cameras.back().name = "Camera" + std::to_string(i + 1);
    }
    return cameras;
}

Camera cameraOfFile(mat_t* file, const fs::path& path) {
    std::vector<MatVariable> held;
    Camera camera = matlabCamera(
        [&](const char* variable) {
            held.emplace_back(Mat_VarRead(file, variable), &Mat_VarFree);
            return held.back().get();
        },
        path.string(), "");
    camera.name = path.stem().string();
    if (camera.name.ends_with("_params"))
        camera.name.resize(camera.name.size() - 7);
    return camera;
}

std::vector<Camera> camerasOfMat(const fs::path& path) {
    const std::string name = path.string();
    constexpr std::uintmax_t kHeaderBytes = 128;
    std::error_code ignored;
    const bool isLongEnough = fs::file_size(path, ignored) >= kHeaderBytes && !ignored;
    const MatFile file(isLongEnough ? Mat_Open(name.c_str(), MAT_ACC_RDONLY) : nullptr, &Mat_Close);
    if (!file)
        throw Error(ErrorCode::BadInput, name, "", "is not a readable MATLAB file");
    for (const char* listName : {"params", "camParams"}) {
        const MatVariable list(Mat_VarRead(file.get(), listName), &Mat_VarFree);
        if (list)
            return camerasOfProject(file.get(), *list, name);
    }
    return {cameraOfFile(file.get(), path)};
}

} // namespace

bool looksLikeDannce(const CalibrationSource& source) {
    return source.hasExtension({".mat"}) || (source.isFolder() && !calibrationFiles(source.path(), {".mat"}).empty());
}

std::vector<Camera> readDannce(const CalibrationSource& source, const CalibrationOptions&) {
    Mat_LogInit("handlens");
    Mat_LogInitFunc("handlens", [](int, char*) {}); // its messages are ours to give
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(source.path(), {".mat"})) {
        const std::vector<Camera> some = camerasOfMat(file);
        cameras.insert(cameras.end(), some.begin(), some.end());
    }
    return cameras;
}

} // namespace core
