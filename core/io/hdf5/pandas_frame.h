// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/io/hdf5/hdf5_file.h"

namespace core {

/// A table with named rows and columns, as pandas keeps it.
struct PandasFrame {
    std::vector<std::vector<std::string>> columns; ///< per column its name, level by level (scorer, body part, x)
    std::vector<std::vector<std::string>> rows;    ///< per row its name, level by level; numbers as text
    std::vector<double> values;                    ///< row by row; NaN where a value is missing
    std::string field;                             ///< where it lies in the file

    double value(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
};

/// Reads the data frame of an HDF5 file that pandas wrote, in its "fixed" layout (axis0, axis1, block0_values) or its
/// "table" layout (a table with values_block_0). Of several, the one called df_with_missing or keypoints. Throws
/// Error(BadInput) naming file and dataset.
PandasFrame readPandasFrame(const Hdf5File& file);

} // namespace core
