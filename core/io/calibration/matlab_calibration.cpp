// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include <matio.h>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"

namespace core {

namespace fs = std::filesystem;

namespace {

using MatFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using MatVariable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;

/// All numbers of a real variable, column by column, as MATLAB keeps them.
std::vector<double> columnNumbers(mat_t* file, const std::string& name, const char* variableName) {
    const MatVariable variable(Mat_VarRead(file, variableName), &Mat_VarFree);
    if (!variable || variable->data == nullptr)
        throw Error(ErrorCode::BadInput, name, variableName, "is missing");
    if (variable->class_type != MAT_C_DOUBLE || variable->isComplex || variable->rank != 2)
        throw Error(ErrorCode::BadInput, name, variableName, "a real matrix of doubles is expected");
    const std::size_t count = variable->dims[0] * variable->dims[1];
    const auto* data = static_cast<const double*>(variable->data);
    std::vector<double> numbers(data, data + count);
    for (const double number : numbers)
        if (!std::isfinite(number))
            throw Error(ErrorCode::BadInput, name, variableName, "holds a number that is not finite");
    return numbers;
}

Camera readParams(const fs::path& path) {
    const std::string name = path.string();
    constexpr std::uintmax_t kHeaderBytes = 128;
    std::error_code ignored;
    const bool isLongEnough = fs::file_size(path, ignored) >= kHeaderBytes && !ignored;
    const MatFile file(isLongEnough ? Mat_Open(name.c_str(), MAT_ACC_RDONLY) : nullptr, &Mat_Close);
    if (!file)
        throw Error(ErrorCode::BadInput, name, "", "is not a readable MATLAB file");
    const auto read = [&](const char* variable) { return columnNumbers(file.get(), name, variable); };
    Camera camera;
    camera.name = path.stem().string();
    if (camera.name.ends_with("_params"))
        camera.name.resize(camera.name.size() - 7);
    // MATLAB multiplies from the left (x K, X r + t), so both are stored transposed; kept column by column, they read
    // as wanted row by row.
    camera.intrinsics = rowMajorMatrix(read("K"), name, "K");
    camera.intrinsics(0, 2) -= 1; // its first pixel is 1
    camera.intrinsics(1, 2) -= 1;
    camera.cameraFromWorld.rotation = rowMajorMatrix(read("r"), name, "r");
    camera.cameraFromWorld.translation = vectorOf(read("t"), name, "t");
    const std::vector<double> radial = read("RDistort"), tangential = read("TDistort");
    if ((radial.size() != 2 && radial.size() != 3) || tangential.size() != 2) {
        throw Error(ErrorCode::BadInput, name, "RDistort",
                    "two or three radial and two tangential coefficients are expected");
    }
    camera.distortion = {radial[0], radial[1], tangential[0], tangential[1], radial.size() == 3 ? radial[2] : 0};
    return camera;
}

} // namespace

std::vector<Camera> readDannce(const fs::path& path) {
    Mat_LogInit("handlens");
    Mat_LogInitFunc("handlens", [](int, char*) {}); // its messages are ours to give
    std::vector<Camera> cameras;
    for (const fs::path& file : calibrationFiles(path, {".mat"}))
        cameras.push_back(readParams(file));
    return cameras;
}

} // namespace core
