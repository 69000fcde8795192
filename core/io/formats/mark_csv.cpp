// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/io/dataset/sequence_pictures.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/csv_text.h"
#include "core/io/formats/format_requests.h"
#include "core/text/number_text.h"

// Plain tables for spreadsheets and scripts: one line per joint with its 3D point, or one line per mark.
namespace core {

namespace {

const CsvRow kMarkHeader{"sequence", "frame", "rater", "hand", "joint", "camera", "x_px", "y_px", "state", "placement"};
/// One more column where a mark has a likelihood.
const CsvRow kLikelyMarkHeader = [] {
    CsvRow header = kMarkHeader;
    header.emplace_back("likelihood");
    return header;
}();

CsvRow pointRow(const ExportRequest& job, int frame, const std::string& rater, const JointId& id,
                const JointReconstruction& joint) {
    CsvRow row{job.sequence.name, std::to_string(frame), rater, std::string(sideName(id.hand)), id.joint};
    std::string outliers;
    for (const ViewReconstruction& view : joint.views)
        if (view.outlier)
            outliers += (outliers.empty() ? "" : " ") + view.camera;
    if (const auto& point = joint.result.point) {
        for (int axis = 0; axis < 3; ++axis)
            row.push_back(exactText(point->pointInWorld[axis]));
        row.insert(row.end(), {exactText(sigmaMm(point->covariance)), joint.isAccepted ? "" : exactText(point->rmsPx)});
    } else {
        row.insert(row.end(), 5, "");
    }
    row.insert(row.end(), {std::to_string(joint.manualViews), outliers, std::string(statusName(joint.status)),
                           std::string(failureText(joint.result.failure))});
    return row;
}

} // namespace

void writePointCsv(const ExportRequest& job) {
    std::string text = csvLine({"sequence", "frame", "rater", "hand", "joint", "x_mm", "y_mm", "z_mm", "sigma_mm",
                                "rms_px", "manual_views", "outliers", "status", "reason"});
    const PictureGaps gaps = pictureGaps(job.dataset, job.sequence);
    for (const std::string& rater : job.rater.empty() ? ratersOf(job.set) : std::vector{job.rater}) {
        for (const int frame : settledFrames(job.set, rater)) {
            const ReconstructionOptions options{job.options.triangulationOf(rater), false, std::nullopt,
                                                gaps.at(frame)};
            for (const auto& [id, joint] : reconstructFrame(job.set, job.dataset.cameras, frame, rater, options))
                text += csvLine(pointRow(job, frame, rater, id, joint));
        }
    }
    writeFileAtomically(job.path, text);
}

void writeMarkCsv(const ExportRequest& job) {
    const auto isWritten = [&](const MarkKey& key) { return job.rater.empty() || key.rater == job.rater; };
    const bool withLikelihood = std::any_of(job.set.marks.begin(), job.set.marks.end(), [&](const auto& item) {
        return isWritten(item.first) && item.second.likelihood;
    });
    std::string text = csvLine(withLikelihood ? kLikelyMarkHeader : kMarkHeader);
    for (const auto& [key, mark] : job.set.marks) {
        if (isWritten(key)) {
            CsvRow row{job.sequence.name,
                       std::to_string(key.frame),
                       key.rater,
                       std::string(sideName(key.joint.hand)),
                       key.joint.joint,
                       key.camera,
                       mark.hasPlace() ? exactText(mark.px.x()) : "",
                       mark.hasPlace() ? exactText(mark.px.y()) : "",
                       std::string(stateName(mark.state)),
                       std::string(placementName(mark.placement))};
            if (withLikelihood)
                row.push_back(mark.likelihood ? exactText(*mark.likelihood) : "");
            text += csvLine(row);
        }
    }
    writeFileAtomically(job.path, text);
}

namespace {

struct MarkRow {
    MarkKey key;
    Mark mark;
};

/// One line of the table. Throws Error(BadInput) naming the row.
MarkRow markFrom(const CsvRow& row, const std::string& file, const std::string& field) {
    const auto refuse = [&](const std::string& what) -> Error { return {ErrorCode::BadInput, file, field, what}; };
    const auto frame = cellNumber(row[1], file, field + ", frame"), x = cellNumber(row[6], file, field),
               y = cellNumber(row[7], file, field);
    const auto hand = sideFromName(row[3]);
    const auto state = stateFromName(row[8]);
    const auto placement = placementFromName(row[9]);
    if (!frame || *frame != std::floor(*frame) || !hand || !state || !placement)
        throw refuse("frame, hand, state or placement cannot be understood");
    if (*state != MarkState::Unplaceable && (!x || !y))
        throw refuse("has no pixel position");
    const Eigen::Vector2d px = *state == MarkState::Unplaceable ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(*x, *y);
    const auto likelihood =
        row.size() > kMarkHeader.size() ? cellNumber(row.back(), file, field + ", likelihood") : std::nullopt;
    return {{static_cast<int>(*frame), row[2], {*hand, row[4]}, row[5]}, Mark{px, *placement, *state, likelihood}};
}

/// The sequences whose rows are read: those that were asked for, else the job's own, else the only one that there is.
std::set<std::string> sequencesToRead(ImportRequest& job, const std::vector<CsvRow>& rows) {
    if (!job.options.videos.empty())
        return {job.options.videos.begin(), job.options.videos.end()};
    std::set<std::string> names;
    for (std::size_t line = 1; line < rows.size(); ++line)
        names.insert(rows[line].front());
    names.erase("");
    if (names.size() == 1 && !names.contains(job.sequence.name)) {
        job.notes.remark(ImportNoteKind::TableOfSequence, {*names.begin(), job.sequence.name});
        return names;
    }
    return {job.sequence.name};
}

} // namespace

void readMarkCsv(ImportRequest& job) {
    const std::string file = job.path.string();
    const auto rows = readCsv(job.path);
    if (rows.empty() || (rows[0] != kMarkHeader && rows[0] != kLikelyMarkHeader)) {
        const std::string header = csvLine(kMarkHeader);
        throw Error(ErrorCode::BadInput, file, "header", "is not " + header.substr(0, header.size() - 1));
    }
    const std::set<std::string> sequences = sequencesToRead(job, rows);
    for (std::size_t line = 1; line < rows.size(); ++line) {
        const CsvRow& row = rows[line];
        const std::string field = "row " + std::to_string(line + 1);
        if (row.size() != rows[0].size()) {
            throw Error(ErrorCode::BadInput, file, field,
                        "has " + std::to_string(row.size()) + " cells, not " + std::to_string(rows[0].size()));
        }
        if (!row[0].empty() && !sequences.contains(row[0])) {
            job.notes.leaveOutVideo(row[0]);
            continue;
        }
        const MarkRow found = markFrom(row, file, field);
        addMark(job, found.key.frame, found.key.joint, found.key.camera, found.mark, found.key.rater);
    }
}

} // namespace core
