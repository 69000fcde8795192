// SPDX-License-Identifier: MIT
#include <Eigen/LU>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/csv_text.h"
#include "core/io/formats/format_requests.h"
#include "core/text/number_text.h"

// Anipose's 3D table: per joint x, y, z, error, ncams, score; then M_00..M_22 and center_0..2, which tell how the world
// was turned (X_table = M X_world - center; M need not be orthogonal), and the frame's number fnum.
namespace core {

namespace {

const std::vector<std::string> kJointColumns{"x", "y", "z", "error", "ncams", "score"};

CsvRow headerOf(const std::vector<std::pair<std::string, JointId>>& joints) {
    CsvRow header;
    for (const auto& [name, joint] : joints)
        for (const std::string& column : kJointColumns)
            header.push_back(name + "_" + column);
    for (const char row : {'0', '1', '2'})
        for (const char column : {'0', '1', '2'})
            header.push_back(std::string("M_") + row + column);
    header.insert(header.end(), {"center_0", "center_1", "center_2", "fnum"});
    return header;
}

CsvRow rowOf(const ExportRequest& job, int frame, const std::vector<std::pair<std::string, JointId>>& joints) {
    const auto points = pointsOf(job, frame);
    CsvRow row;
    for (const auto& [name, joint] : joints) {
        const auto found = points.find(joint);
        if (found == points.end()) {
            row.insert(row.end(), kJointColumns.size(), "");
            continue;
        }
        const TriangulatedPoint& point = *found->second.result.point;
        const auto used = std::count(point.inlier.begin(), point.inlier.end(), true);
        for (int axis = 0; axis < 3; ++axis)
            row.push_back(exactText(point.pointInWorld[axis]));
        row.insert(row.end(), {exactText(point.rmsPx), std::to_string(used), "1"});
    }
    row.insert(row.end(), {"1", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0", "0", std::to_string(frame)});
    return row;
}

/// Columns by name.
using Columns = std::map<std::string, std::size_t>;

/// Reads numbers of one row by column name.
class Row {
public:
    Row(const Columns& columns, const CsvRow& cells, std::string file, std::size_t line)
        : m_columns(columns)
        , m_cells(cells)
        , m_file(std::move(file))
        , m_line(line) {}

    std::optional<double> value(const std::string& name) const {
        const auto column = m_columns.find(name);
        if (column == m_columns.end())
            throw Error(ErrorCode::BadInput, m_file, name, "there is no such column");
        if (column->second >= m_cells.size())
            throw Error(ErrorCode::BadInput, m_file, "row " + std::to_string(m_line), "is cut off");
        return cellNumber(m_cells[column->second], m_file, "row " + std::to_string(m_line) + ", " + name);
    }
    std::optional<Eigen::Vector3d> point(const std::string& x, const std::string& y, const std::string& z) const {
        const auto a = value(x), b = value(y), c = value(z);
        return a && b && c ? std::optional(Eigen::Vector3d(*a, *b, *c)) : std::nullopt;
    }

private:
    const Columns& m_columns;
    const CsvRow& m_cells;
    std::string m_file;
    std::size_t m_line;
};

/// The turned world of a row: X_table = matrix * X_world - centre. Without the columns, the world itself.
struct TableFrame {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();

    TableFrame(const Row& row, const Columns& columns, const std::string& file) {
        if (!columns.contains("M_00"))
            return;
        for (int i = 0; i < 3; ++i) {
            const std::string name = "M_" + std::to_string(i);
            const auto values = row.point(name + "0", name + "1", name + "2");
            const auto shift = row.value("center_" + std::to_string(i));
            if (!values || !shift)
                throw Error(ErrorCode::BadInput, file, name, "is missing in a row");
            matrix.row(i) = values->transpose();
            centre[i] = *shift;
        }
        if (std::abs(matrix.determinant()) < 1e-9)
            throw Error(ErrorCode::BadInput, file, "M", "cannot be inverted");
    }
    Eigen::Vector3d toWorld(const Eigen::Vector3d& point) const { return matrix.inverse() * (point + centre); }
};

} // namespace

void writeAnipose3d(const ExportRequest& job) {
    std::vector<std::pair<std::string, JointId>> joints;
    for (const JointId& joint : markedJoints(job))
        if (const auto name = job.map.sharedName(joint))
            joints.emplace_back(*name, joint);
    std::string text = csvLine(headerOf(joints));
    for (int frame = 0; frame < job.sequence.frameCount; ++frame)
        text += csvLine(rowOf(job, frame, joints));
    writeFileAtomically(job.path, text);
}

void readAnipose3d(ImportRequest& job) {
    const std::string file = job.path.string();
    const auto rows = readCsv(job.path);
    Columns columns;
    for (std::size_t i = 0; !rows.empty() && i < rows[0].size(); ++i)
        columns.emplace(rows[0][i], i);
    std::map<std::string, JointId> joints;
    constexpr std::string_view kSuffix = "_error";
    for (const auto& [column, place] : columns) {
        if (column.ends_with(kSuffix)) {
            const std::string name = column.substr(0, column.size() - kSuffix.size());
            if (const auto joint = job.map.jointOf(name))
                joints.emplace(name, *joint);
            else
                job.notes.leaveOut(ImportNoteKind::UnmappedJoint, name);
        }
    }
    if (columns.empty() || (joints.empty() && job.notes.all().empty())) {
        throw Error(ErrorCode::BadInput, file, "header",
                    "the columns <joint>_x, _y, _z, _error are missing: not a 3D table of Anipose");
    }
    for (std::size_t line = 1; line < rows.size(); ++line) {
        const Row row(columns, rows[line], file, line + 1);
        const auto frame = row.value("fnum");
        if (!frame)
            throw Error(ErrorCode::BadInput, file, "row " + std::to_string(line + 1) + ", fnum", "is missing");
        const TableFrame tableFrame(row, columns, file);
        for (const auto& [name, joint] : joints) {
            if (const auto point = row.point(name + "_x", name + "_y", name + "_z")) {
                const auto score = columns.contains(name + "_score") ? row.value(name + "_score") : std::nullopt;
                addPoint(job, static_cast<int>(*frame), joint, tableFrame.toWorld(*point), score);
            }
        }
    }
}

} // namespace core
