// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/io/annotation_jobs.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/text/number_text.h"

// Tables of one view with the header rows scorer, bodyparts, coords. DeepLabCut and Lightning Pose label files have x and y and
// name a picture in the first column(s); Anipose's 2D tables (as DeepLabCut's predictions) have a likelihood too and count
// frames from 0. Missing values are empty.
namespace core {

namespace fs = std::filesystem;

namespace {

// A mark whose place is estimated is half as likely as one that is seen.
constexpr double kVisibleLikelihood = 1.0;
constexpr double kOccludedLikelihood = 0.5;

/// The joints that have a name in the map, with that name.
std::vector<std::pair<std::string, JointId>> namedJoints(const ExportJob& job) {
    std::vector<std::pair<std::string, JointId>> joints;
    for (const JointId& joint : markedJoints(job)) {
        if (const auto name = job.map.sharedName(joint)) {
            joints.emplace_back(*name, joint);
        }
    }
    return joints;
}

std::string header(const ExportJob& job, const std::vector<std::pair<std::string, JointId>>& joints, const std::vector<std::string>& coords) {
    CsvRow scorer{"scorer"}, bodyparts{"bodyparts"}, names{"coords"};
    for (const auto& [name, joint] : joints) {
        for (const std::string& coord : coords) {
            scorer.push_back(job.rater);
            bodyparts.push_back(name);
            names.push_back(coord);
        }
    }
    return csvLine(scorer) + csvLine(bodyparts) + csvLine(names);
}

CsvRow cellsOf(const ExportJob& job, int frame, const std::vector<std::pair<std::string, JointId>>& joints, const std::string& camera,
               bool withLikelihood) {
    CsvRow cells;
    for (const auto& [name, joint] : joints) {
        const auto mark = placedMark(job, frame, joint, camera);
        cells.push_back(mark ? exactText(mark->px.x()) : "");
        cells.push_back(mark ? exactText(mark->px.y()) : "");
        if (withLikelihood) {
            const bool isVisible = mark && mark->state == MarkState::Visible;
            cells.push_back(mark ? exactText(isVisible ? kVisibleLikelihood : kOccludedLikelihood) : "");
        }
    }
    return cells;
}

std::string sixDigits(int number) {
    const std::string digits = std::to_string(number);
    return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

} // namespace

void writeDeepLabCut(const ExportJob& job) {
    PendingFolder folder(job.path);
    const auto joints = namedJoints(job);
    const std::vector<int> frames = settledFrames(job.set, job.rater);
    for (const Camera& camera : job.dataset.cameras) {
        std::string text = header(job, joints, {"x", "y"});
        for (const int frame : frames) {
            CsvRow row{"labeled-data/" + job.sequence.name + "_" + camera.name + "/img" + sixDigits(frame) + ".png"};
            const CsvRow cells = cellsOf(job, frame, joints, camera.name, false);
            row.insert(row.end(), cells.begin(), cells.end());
            text += csvLine(row);
        }
        ensureFolder(folder.path() / camera.name);
        writeFileAtomically(folder.path() / camera.name / ("CollectedData_" + job.rater + ".csv"), text);
    }
    folder.commit();
}

void writeAnipose2d(const ExportJob& job) {
    PendingFolder folder(job.path);
    const auto joints = namedJoints(job);
    for (const Camera& camera : job.dataset.cameras) {
        std::string text = header(job, joints, {"x", "y", "likelihood"});
        for (int frame = 0; frame < job.sequence.frameCount; ++frame) {
            CsvRow row{std::to_string(frame)};
            const CsvRow cells = cellsOf(job, frame, joints, camera.name, true);
            row.insert(row.end(), cells.begin(), cells.end());
            text += csvLine(row);
        }
        writeFileAtomically(folder.path() / (camera.name + ".csv"), text);
    }
    folder.commit();
}

namespace {

/// Where one body part's values stand in a row; -1 = there is no such column.
struct PartColumns {
    int x = -1, y = -1, likelihood = -1;
};

/// A table taken apart: how many columns name the picture, and where each body part is.
struct PoseTable {
    std::vector<CsvRow> rows;
    std::size_t indexColumns = 1;
    std::map<std::string, PartColumns> parts;
    std::size_t firstDataRow = 0;
};

std::size_t rowNamed(const std::vector<CsvRow>& rows, const std::string& name, const std::string& file) {
    constexpr std::size_t kMostHeaderRows = 4;
    for (std::size_t i = 0; i < std::min(rows.size(), kMostHeaderRows); ++i) {
        if (rows[i][0] == name) {
            return i;
        }
    }
    throw Error(ErrorCode::BadInput, file, name, "the header row of that name is missing (scorer, bodyparts, coords are expected)");
}

PoseTable readTable(const fs::path& file) {
    PoseTable table;
    table.rows = readCsv(file);
    rowNamed(table.rows, "scorer", file.string());
    const CsvRow& bodyparts = table.rows[rowNamed(table.rows, "bodyparts", file.string())];
    const std::size_t coordsRow = rowNamed(table.rows, "coords", file.string());
    const CsvRow& coords = table.rows[coordsRow];
    table.firstDataRow = coordsRow + 1;
    const CsvRow* individuals = nullptr; // several animals, here: hands
    for (std::size_t i = 0; i < coordsRow; ++i) {
        individuals = table.rows[i][0] == "individuals" ? &table.rows[i] : individuals;
    }
    while (table.indexColumns < coords.size() && coords[table.indexColumns].empty()) {
        ++table.indexColumns; // newer files name folder, video and picture in a column each
    }
    for (std::size_t column = table.indexColumns; column < std::min(coords.size(), bodyparts.size()); ++column) {
        const bool hasIndividual = individuals && column < individuals->size() && (*individuals)[column] != "single";
        PartColumns& part = table.parts[(hasIndividual ? (*individuals)[column] + "_" : "") + bodyparts[column]];
        int* place = coords[column] == "x" ? &part.x : coords[column] == "y" ? &part.y : coords[column] == "likelihood" ? &part.likelihood : nullptr;
        if (place) {
            *place = static_cast<int>(column);
        }
    }
    return table;
}

int frameOf(const CsvRow& row, std::size_t indexColumns, const std::string& file, std::size_t line) {
    const auto frame = trailingNumber(row.at(indexColumns - 1));
    if (!frame) {
        throw Error(ErrorCode::BadInput, file, "row " + std::to_string(line + 1),
                    "\"" + row[indexColumns - 1] + "\" does not end in the number of a frame");
    }
    return *frame;
}

/// The mark of one body part in one row, or nothing.
std::optional<Mark> markOf(const CsvRow& row, const PartColumns& part, const std::string& file, const std::string& field) {
    const auto value = [&](int column) -> std::optional<double> {
        return column >= 0 && column < static_cast<int>(row.size()) ? cellNumber(row[static_cast<std::size_t>(column)], file, field) : std::nullopt;
    };
    const auto x = value(part.x), y = value(part.y), likelihood = value(part.likelihood);
    const bool isPlaced = x && y && !(*x < 0 && *y < 0); // some tools write -1 for what is missing
    if (!isPlaced || likelihood.value_or(kVisibleLikelihood) <= 0) {
        return std::nullopt;
    }
    return Mark{{*x, *y}, Placement::Manual,
                likelihood.value_or(kVisibleLikelihood) > kOccludedLikelihood ? MarkState::Visible : MarkState::Occluded};
}

void readPoseTable(ImportJob& job, const fs::path& file) {
    const PoseTable table = readTable(file);
    const std::string camera = cameraOfFile(job, file);
    for (std::size_t line = table.firstDataRow; line < table.rows.size(); ++line) {
        const CsvRow& row = table.rows[line];
        if (row.size() <= table.indexColumns) {
            throw Error(ErrorCode::BadInput, file.string(), "row " + std::to_string(line + 1), "is cut off");
        }
        const int frame = frameOf(row, table.indexColumns, file.string(), line);
        for (const auto& [name, part] : table.parts) {
            const auto mark = markOf(row, part, file.string(), "row " + std::to_string(line + 1) + ", " + name);
            const auto joint = job.map.jointOf(name);
            if (mark && joint) {
                addMark(job, frame, *joint, camera, *mark);
            } else if (mark) {
                job.notes.leaveOut("body part \"" + name + "\", which is no joint of the map");
            }
        }
    }
}

} // namespace

void readPoseTables(ImportJob& job) {
    for (const fs::path& file : viewFiles(job.path, ".csv")) {
        readPoseTable(job, file);
    }
}

} // namespace core
