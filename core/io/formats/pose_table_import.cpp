// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/io/files/csv_text.h"
#include "core/io/formats/format_requests.h"
#include "core/io/formats/label_videos.h"
#include "core/io/hdf5/pandas_frame.h"
#include "core/text/number_text.h"

// Reads tables of one view with the header rows scorer, bodyparts, coords: what people labelled with DeepLabCut or
// Lightning Pose (x and y; the first column or columns name a picture), and what networks predicted, as Anipose's 2D
// tables hold it (a likelihood, too; frames count from 0), as CSV or as the HDF5 file of pandas. And tables with one
// header row as SLEAP writes them: frame_idx, track, <part>.x, <part>.y, <part>.score.
namespace core {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFrameColumn = "frame_idx";

/// Where one body part's values stand in a row; -1 = there is no such column.
struct PartColumns {
    int x = -1, y = -1, likelihood = -1;
};

/// A table taken apart: which columns name the picture, and where each body part is.
struct PoseTable {
    fs::path file;
    std::vector<CsvRow> rows;
    std::size_t firstIndexColumn = 0, indexColumns = 1;
    int trackColumn = -1; ///< names the hand; -1 = there is none
    std::map<std::string, PartColumns> parts;
    std::size_t firstDataRow = 0;

    std::string fieldOf(std::size_t line) const { return "row " + std::to_string(line + 1); }
    /// Empty if there is none.
    std::string track(std::size_t line) const {
        const auto column = static_cast<std::size_t>(trackColumn);
        return trackColumn >= 0 && column < rows[line].size() ? rows[line][column] : std::string();
    }
    std::optional<double> value(std::size_t line, int column, const std::string& part) const {
        const CsvRow& row = rows[line];
        return column >= 0 && column < static_cast<int>(row.size())
                   ? cellNumber(row[static_cast<std::size_t>(column)], file.string(), fieldOf(line) + ", " + part)
                   : std::nullopt;
    }
};

std::size_t rowNamed(const std::vector<CsvRow>& rows, const std::string& name, const std::string& file) {
    constexpr std::size_t kMostHeaderRows = 4;
    for (std::size_t i = 0; i < std::min(rows.size(), kMostHeaderRows); ++i)
        if (rows[i][0] == name)
            return i;
    throw Error(ErrorCode::BadInput, file, name,
                "the header row of that name is missing (scorer, bodyparts, coords are expected)");
}

int* placeOf(PartColumns& part, const std::string& coord) {
    const bool isLikelihood = coord == "likelihood" || coord == "score" || coord == "confidence";
    return coord == "x" ? &part.x : coord == "y" ? &part.y : isLikelihood ? &part.likelihood : nullptr;
}

/// Columns of the one header row.
void readFlatHeader(PoseTable& table) {
    const CsvRow& header = table.rows[0];
    for (std::size_t column = 0; column < header.size(); ++column) {
        const std::size_t dot = header[column].rfind('.');
        const std::string part = header[column].substr(0, dot);
        if (header[column] == kFrameColumn) {
            table.firstIndexColumn = column;
        } else if (header[column] == "track") {
            table.trackColumn = static_cast<int>(column);
        } else if (dot != std::string::npos && part != "instance") {
            if (int* place = placeOf(table.parts[part], header[column].substr(dot + 1)))
                *place = static_cast<int>(column);
        }
    }
    table.firstDataRow = 1;
}

/// The rows of a data frame as the CSV table of the same labels holds them: DeepLabCut and Anipose write both.
std::vector<CsvRow> rowsOfFrame(const Hdf5File& file) {
    const PandasFrame frame = readPandasFrame(file);
    const std::size_t levels = frame.columns.empty() ? 0 : frame.columns[0].size();
    if (levels != 3 && levels != 4) {
        file.refuse(frame.field,
                    "has columns of " + std::to_string(levels) +
                        " levels: scorer, bodyparts, coords are expected, individuals may stand before bodyparts");
    }
    const std::size_t indexColumns = frame.rows.empty() ? 1 : frame.rows[0].size();
    std::vector<CsvRow> rows;
    for (const char* name : {"scorer", "individuals", "bodyparts", "coords"})
        if (levels == 4 || std::string_view(name) != "individuals")
            rows.emplace_back(indexColumns)[0] = name;
    for (const std::vector<std::string>& column : frame.columns)
        for (std::size_t level = 0; level < levels; ++level)
            rows[level].push_back(column[level]);
    for (std::size_t row = 0; row < frame.rows.size(); ++row) {
        CsvRow cells = frame.rows[row];
        for (std::size_t column = 0; column < frame.columns.size(); ++column) {
            const double value = frame.value(row, column);
            cells.push_back(std::isfinite(value) ? exactText(value) : "");
        }
        rows.push_back(std::move(cells));
    }
    return rows;
}

bool isHdf5(const fs::path& file) {
    return file.extension() == ".h5" || file.extension() == ".hdf5";
}

PoseTable readTable(const fs::path& file) {
    PoseTable table;
    table.file = file;
    table.rows = isHdf5(file) ? rowsOfFrame(Hdf5File(file)) : readCsv(file);
    if (!table.rows.empty() &&
        std::find(table.rows[0].begin(), table.rows[0].end(), kFrameColumn) != table.rows[0].end()) {
        readFlatHeader(table);
        return table;
    }
    rowNamed(table.rows, "scorer", file.string());
    const CsvRow& bodyparts = table.rows[rowNamed(table.rows, "bodyparts", file.string())];
    const std::size_t coordsRow = rowNamed(table.rows, "coords", file.string());
    const CsvRow& coords = table.rows[coordsRow];
    table.firstDataRow = coordsRow + 1;
    const CsvRow* individuals = nullptr; // several animals, here: hands
    for (std::size_t i = 0; i < coordsRow; ++i)
        individuals = table.rows[i][0] == "individuals" ? &table.rows[i] : individuals;
    while (table.indexColumns < coords.size() && coords[table.indexColumns].empty())
        ++table.indexColumns; // newer files name folder, video and picture in a column each
    for (std::size_t column = table.indexColumns; column < std::min(coords.size(), bodyparts.size()); ++column) {
        const bool hasIndividual = individuals && column < individuals->size() && (*individuals)[column] != "single";
        PartColumns& part = table.parts[(hasIndividual ? (*individuals)[column] + "_" : "") + bodyparts[column]];
        if (int* place = placeOf(part, coords[column]))
            *place = static_cast<int>(column);
    }
    return table;
}

/// True if a network wrote the table: it says how sure it is, in other numbers than a table of labels has.
bool isPredicted(const PoseTable& table) {
    for (std::size_t line = table.firstDataRow; line < table.rows.size(); ++line) {
        for (const auto& [name, part] : table.parts) {
            const auto likelihood = table.value(line, part.likelihood, name);
            if (likelihood && *likelihood != 0 && *likelihood != kOccludedLikelihood &&
                *likelihood != kVisibleLikelihood)
                return true;
        }
    }
    return false;
}

/// The path of the picture that a row names, joined of its columns; a number alone is a frame.
std::string pictureOf(const PoseTable& table, std::size_t line) {
    std::string path;
    for (std::size_t column = 0; column < table.indexColumns; ++column)
        path += (path.empty() ? "" : "/") + table.rows[line][table.firstIndexColumn + column];
    return path;
}

/// The mark of one body part in one row, or nothing.
std::optional<Mark> markOf(const PoseTable& table, std::size_t line, const std::string& name, const PartColumns& part,
                           bool predicted) {
    const auto x = table.value(line, part.x, name), y = table.value(line, part.y, name),
               likelihood = table.value(line, part.likelihood, name);
    const bool isPlaced = x && y && !(*x == -1 && *y == -1); // some tools write -1 for what is missing
    if (!isPlaced || likelihood.value_or(kVisibleLikelihood) <= 0)
        return std::nullopt;
    if (predicted)
        return Mark{{*x, *y}, Placement::Proposed, MarkState::Visible, likelihood};
    return Mark{{*x, *y},
                Placement::Manual,
                likelihood.value_or(kVisibleLikelihood) > kOccludedLikelihood ? MarkState::Visible
                                                                              : MarkState::Occluded};
}

void readRow(ImportRequest& job, const PoseTable& table, std::size_t line, bool predicted) {
    const std::string file = table.file.string();
    const std::size_t lastIndexColumn = table.firstIndexColumn + table.indexColumns - 1;
    if (table.rows[line].size() <= lastIndexColumn + (table.trackColumn < 0 ? 1 : 0))
        throw Error(ErrorCode::BadInput, file, table.fieldOf(line), "is cut off");
    const std::string picture = pictureOf(table, line);
    const auto frame = trailingNumber(table.rows[line][lastIndexColumn]);
    if (!frame) {
        throw Error(ErrorCode::BadInput, file, table.fieldOf(line),
                    "\"" + picture + "\" does not end in the number of a frame");
    }
    const auto camera = cameraOfVideo(job, videoOfPicture(picture), table.file);
    if (!camera)
        return;
    for (const auto& [name, part] : table.parts) {
        const auto mark = markOf(table, line, name, part, predicted);
        const auto joint = jointOfPart(job, name, table.track(line));
        if (mark && joint)
            addMark(job, *frame, *joint, *camera, *mark);
        else if (mark)
            leaveOutPart(job, name);
    }
}

} // namespace

void readPoseTables(ImportRequest& job) {
    std::vector<PoseTable> tables;
    // DeepLabCut keeps each table as CSV and as HDF5, of which one is enough.
    const bool onlyHdf5 = !holdsFiles(job.path, ".csv") && holdsFiles(job.path, ".h5");
    for (const fs::path& file : viewFiles(job.path, onlyHdf5 ? ".h5" : ".csv"))
        tables.push_back(readTable(file));
    const bool predicted = job.options.minLikelihood || std::any_of(tables.begin(), tables.end(), isPredicted);
    for (const PoseTable& table : tables)
        for (std::size_t line = table.firstDataRow; line < table.rows.size(); ++line)
            readRow(job, table, line, predicted);
    if (predicted && !job.set.marks.empty())
        job.notes.remark(ImportNoteKind::OnlyGuesses);
}

} // namespace core
