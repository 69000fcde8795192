// SPDX-License-Identifier: MIT
#include "core/io/hdf5/pandas_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/hdf5/column_pickle.h"
#include "core/text/number_text.h"

namespace core {

namespace {

using Names = std::vector<std::vector<std::string>>;

bool isTable(const Hdf5File& file, const std::string& group) {
    return file.has(group + "/table");
}

bool isFrame(const Hdf5File& file, const std::string& group) {
    return isTable(file, group) || file.has(group + "/block0_values");
}

std::string frameGroup(const Hdf5File& file) {
    for (const char* usual : {"df_with_missing", "keypoints"})
        if (isFrame(file, usual))
            return usual;
    std::vector<std::string> frames;
    for (const std::string& name : file.childrenOf("/"))
        if (isFrame(file, name))
            frames.push_back(name);
    if (frames.size() != 1)
        file.refuse("df_with_missing",
                    frames.empty() ? "is missing: this is not a data frame of pandas" : "is missing");
    return frames.front();
}

/// Texts, or numbers as text.
std::vector<std::string> cells(const Hdf5File& file, const std::string& path) {
    if (file.holdsTexts(path))
        return file.texts(path);
    std::vector<std::string> texts;
    for (const double value : file.numbers(path).values)
        texts.push_back(exactText(value));
    return texts;
}

/// One axis of the fixed layout: names of one level in one dataset, or levels and, per item, the number of its name in
/// each (-1: missing).
Names axisNames(const Hdf5File& file, const std::string& axis) {
    Names names;
    if (!file.has(axis + "_level0")) {
        for (std::string& name : cells(file, axis))
            names.push_back({std::move(name)});
        return names;
    }
    for (int level = 0; file.has(axis + "_level" + std::to_string(level)); ++level) {
        const std::string label = axis + "_label" + std::to_string(level);
        const std::vector<std::string> known = cells(file, axis + "_level" + std::to_string(level));
        const std::vector<double> labels = file.numbers(label).values;
        if (level > 0 && labels.size() != names.size())
            file.refuse(label, "has " + std::to_string(labels.size()) + " items, " + std::to_string(names.size()) +
                                   " are expected");
        names.resize(labels.size());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (!(labels[i] >= -1 && labels[i] < static_cast<double>(known.size())))
                file.refuse(label, "holds a number that is none of its level's");
            names[i].push_back(labels[i] < 0 ? "" : known[static_cast<std::size_t>(labels[i])]);
        }
    }
    return names;
}

/// Some columns of a frame.
struct Block {
    Names columns;
    std::vector<double> values; ///< row by row
};

std::string shapeText(const std::vector<std::size_t>& shape) {
    std::string text;
    for (const std::size_t size : shape)
        text += (text.empty() ? "" : " x ") + std::to_string(size);
    return text;
}

/// A block of the fixed layout: pandas turns it before it is written, so a row of the file is a row of the frame.
Block readBlock(const Hdf5File& file, const std::string& path, std::size_t rows) {
    Block block{axisNames(file, path + "_items"), {}};
    Hdf5Numbers numbers = file.numbers(path + "_values");
    const std::size_t columns = block.columns.size();
    if (rows * columns == 0)
        return block;
    if (numbers.shape == std::vector<std::size_t>{rows, columns}) {
        block.values = std::move(numbers.values);
    } else if (numbers.shape == std::vector<std::size_t>{columns, rows}) {
        block.values.resize(rows * columns);
        for (std::size_t i = 0; i < block.values.size(); ++i)
            block.values[i] = numbers.values[i % columns * rows + i / columns];
    } else {
        file.refuse(path + "_values",
                    "is of shape " + shapeText(numbers.shape) + ", " + shapeText({rows, columns}) + " is expected");
    }
    return block;
}

/// A block of the table layout: one field of its records; an attribute names its columns.
Block readField(const Hdf5File& file, const std::string& table, const std::string& field) {
    const Hdf5Numbers numbers = file.numbers(table, field);
    const auto kind = file.textAttribute(table, field + "_kind");
    const auto columns = kind ? columnsOfPickle(*kind) : std::nullopt;
    if (!columns || columns->size() != numbers.shape[1]) {
        file.refuse(table + ", " + field + "_kind",
                    kind ? "the names of the columns cannot be understood: save the table as CSV and import that"
                         : "is missing: nothing names the columns");
    }
    return {*columns, numbers.values};
}

void addBlock(PandasFrame& frame, std::vector<Block>& blocks, Block block) {
    frame.columns.insert(frame.columns.end(), block.columns.begin(), block.columns.end());
    blocks.push_back(std::move(block));
}

/// Puts the blocks side by side.
void joinBlocks(PandasFrame& frame, const std::vector<Block>& blocks) {
    frame.values.reserve(frame.rows.size() * frame.columns.size());
    for (std::size_t row = 0; row < frame.rows.size(); ++row) {
        for (const Block& block : blocks) {
            const auto first = block.values.begin() + static_cast<std::ptrdiff_t>(row * block.columns.size());
            frame.values.insert(frame.values.end(), first, first + static_cast<std::ptrdiff_t>(block.columns.size()));
        }
    }
}

PandasFrame readTableLayout(const Hdf5File& file, const std::string& table) {
    PandasFrame frame;
    frame.field = table;
    std::vector<std::string> names;
    if (file.holdsTexts(table, "index"))
        names = file.texts(table, "index");
    else
        for (const double value : file.numbers(table, "index").values)
            names.push_back(exactText(value));
    for (std::string& name : names)
        frame.rows.push_back({std::move(name)});
    std::vector<Block> blocks;
    for (const std::string& field : file.fieldsOf(table))
        if (field.starts_with("values_block_") && !file.holdsTexts(table, field))
            addBlock(frame, blocks, readField(file, table, field));
    joinBlocks(frame, blocks);
    return frame;
}

PandasFrame readFixedLayout(const Hdf5File& file, const std::string& group) {
    PandasFrame frame;
    frame.field = group;
    frame.rows = axisNames(file, group + "/axis1");
    std::vector<Block> blocks;
    for (int i = 0; file.has(group + "/block" + std::to_string(i) + "_values"); ++i)
        addBlock(frame, blocks, readBlock(file, group + "/block" + std::to_string(i), frame.rows.size()));
    joinBlocks(frame, blocks);
    return frame;
}

} // namespace

PandasFrame readPandasFrame(const Hdf5File& file) {
    const std::string group = frameGroup(file);
    return isTable(file, group) ? readTableLayout(file, group + "/table") : readFixedLayout(file, group);
}

} // namespace core
