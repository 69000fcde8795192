// SPDX-License-Identifier: MIT
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/error.h"
#include "core/io/calibration/calibration_readers.h"
#include "core/io/files/csv_text.h"
#include "core/io/files/text_file.h"
#include "core/text/number_text.h"

namespace core {

namespace {

constexpr std::size_t kCoefficients = 11;

/// Upper triangular K with positive diagonal and K(2,2) = 1, such that M = K R with orthonormal R; M's last row has
/// length 1. From K K^T = M M^T, by a Cholesky factorisation from the last row upwards.
Eigen::Matrix3d upperFactor(const Eigen::Matrix3d& m) {
    const Eigen::Matrix3d product = (m * m.transpose()).eval();
    const Eigen::Matrix3d lower = Eigen::LLT<Eigen::Matrix3d>(product.reverse()).matrixL();
    return lower.reverse();
}

/// u = (L1 x + L2 y + L3 z + L4) / (L9 x + L10 y + L11 z + 1), v = (L5 x + ... + L8) / (the same).
Camera cameraOfCoefficients(const std::vector<double>& l, const std::string& file, const std::string& name) {
    Eigen::Matrix3d m;
    m << l[0], l[1], l[2], l[4], l[5], l[6], l[8], l[9], l[10];
    const double depthScale = m.row(2).norm();
    if (!(depthScale > 0) || !(std::abs(m.determinant()) > 0))
        throw Error(ErrorCode::BadInput, file, name, "the coefficients are not those of a perspective camera");
    if (m.determinant() < 0) {
        throw Error(ErrorCode::Unsupported, file, name,
                    "counts pixels from the lower left corner (as DLTdv does before version 8) or has the origin "
                    "behind the camera; write coefficients for the upper left corner");
    }
    m /= depthScale;
    Camera camera;
    camera.name = name;
    camera.intrinsics = upperFactor(m);
    camera.intrinsics.row(2) << 0, 0, 1;
    const Eigen::Matrix3d inverseK = camera.intrinsics.inverse();
    camera.cameraFromWorld.rotation = inverseK * m;
    camera.cameraFromWorld.translation = inverseK * Eigen::Vector3d(l[3], l[7], 1) / depthScale;
    camera.intrinsics(0, 2) -= 1; // MATLAB's first pixel is 1
    camera.intrinsics(1, 2) -= 1;
    return camera;
}

/// The table's numbers; empty if it is not eleven rows of as many numbers each.
std::vector<std::vector<double>> coefficientRows(const CalibrationSource& source) {
    std::vector<std::vector<double>> rows;
    for (const CsvRow& cells : parseCsv(source.text(), source.path().string())) {
        std::vector<double> row(cells.size());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::vector<std::string_view> words = splitWords(cells[i]);
            if (words.size() != 1 || !parseNumber(words[0], row[i]))
                return {};
        }
        if (!rows.empty() && rows.front().size() != row.size())
            return {};
        rows.push_back(row);
    }
    return rows.size() == kCoefficients ? rows : std::vector<std::vector<double>>();
}

} // namespace

bool looksLikeDlt(const CalibrationSource& source) {
    return source.hasExtension({".csv"}) && !coefficientRows(source).empty();
}

std::vector<Camera> readDlt(const CalibrationSource& source, const CalibrationOptions&) {
    const std::string file = source.path().string();
    const std::vector<std::vector<double>> rows = coefficientRows(source);
    if (rows.empty())
        throw Error(ErrorCode::BadInput, file, "", "eleven rows with a number per camera are expected");
    std::vector<Camera> cameras;
    for (std::size_t c = 0; c < rows.front().size(); ++c) {
        std::vector<double> column;
        for (const std::vector<double>& row : rows)
            column.push_back(row[c]);
        cameras.push_back(cameraOfCoefficients(column, file, "cam" + std::to_string(c + 1)));
    }
    return cameras;
}

} // namespace core
