// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/error.h"
#include "core/io/annotation_jobs.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/io/sequence_pictures.h"
#include "core/text/number_text.h"

// Plain tables for spreadsheets and scripts: one line per joint with its 3D point, or one line per mark.
namespace core {

namespace {

const CsvRow kMarkHeader{"sequence", "frame", "rater", "hand", "joint", "camera", "x_px", "y_px", "state", "placement"};

CsvRow pointRow(const ExportJob& job, int frame, const std::string& rater, const JointId& id, const JointReconstruction& joint) {
    CsvRow row{job.sequence.name, std::to_string(frame), rater, std::string(sideName(id.hand)), id.joint};
    std::string outliers;
    for (const ViewReconstruction& view : joint.views) {
        if (view.outlier) {
            outliers += (outliers.empty() ? "" : " ") + view.camera;
        }
    }
    if (const auto& point = joint.result.point) {
        for (int axis = 0; axis < 3; ++axis) {
            row.push_back(exactText(point->pointInWorld[axis]));
        }
        row.insert(row.end(), {exactText(sigmaMm(point->covariance)), exactText(point->rmsPx)});
    } else {
        row.insert(row.end(), 5, "");
    }
    row.insert(row.end(), {std::to_string(joint.manualViews), outliers, std::string(statusName(joint.status)), joint.result.reason});
    return row;
}

} // namespace

void writePointCsv(const ExportJob& job) {
    std::string text = csvLine({"sequence", "frame", "rater", "hand", "joint", "x_mm", "y_mm", "z_mm", "sigma_mm", "rms_px", "manual_views",
                                "outliers", "status", "reason"});
    const PictureGaps gaps = pictureGaps(job.dataset, job.sequence);
    for (const std::string& rater : job.rater.empty() ? ratersOf(job.set) : std::vector{job.rater}) {
        for (const int frame : settledFrames(job.set, rater)) {
            const ReconstructionOptions options{job.triangulation, false, std::nullopt, gaps.at(frame)};
            for (const auto& [id, joint] : reconstructFrame(job.set, job.dataset.cameras, frame, rater, options)) {
                text += csvLine(pointRow(job, frame, rater, id, joint));
            }
        }
    }
    writeFileAtomically(job.path, text);
}

void writeMarkCsv(const ExportJob& job) {
    std::string text = csvLine(kMarkHeader);
    for (const auto& [key, mark] : job.set.marks) {
        if (job.rater.empty() || key.rater == job.rater) {
            text += csvLine({job.sequence.name, std::to_string(key.frame), key.rater, std::string(sideName(key.joint.hand)), key.joint.joint,
                             key.camera, mark.hasPlace() ? exactText(mark.px.x()) : "", mark.hasPlace() ? exactText(mark.px.y()) : "",
                             std::string(stateName(mark.state)), std::string(placementName(mark.placement))});
        }
    }
    writeFileAtomically(job.path, text);
}

void readMarkCsv(ImportJob& job) {
    const std::string file = job.path.string();
    const auto rows = readCsv(job.path);
    if (rows.empty() || rows[0] != kMarkHeader) {
        throw Error(ErrorCode::BadInput, file, "header", "is not " + csvLine(kMarkHeader).substr(0, csvLine(kMarkHeader).size() - 1));
    }
    for (std::size_t line = 1; line < rows.size(); ++line) {
        const CsvRow& row = rows[line];
        const std::string field = "row " + std::to_string(line + 1);
        const auto refuse = [&](const std::string& what) -> Error { return {ErrorCode::BadInput, file, field, what}; };
        if (row.size() != kMarkHeader.size()) {
            throw refuse("has " + std::to_string(row.size()) + " cells, not " + std::to_string(kMarkHeader.size()));
        }
        const auto frame = cellNumber(row[1], file, field + ", frame"), x = cellNumber(row[6], file, field), y = cellNumber(row[7], file, field);
        const auto hand = sideFromName(row[3]);
        const auto state = stateFromName(row[8]);
        const auto placement = placementFromName(row[9]);
        if (!frame || *frame != std::floor(*frame) || !hand || !state || !placement) {
            throw refuse("frame, hand, state or placement makes no sense");
        }
        if (*state != MarkState::Unplaceable && (!x || !y)) {
            throw refuse("has no pixel position");
        }
        const Eigen::Vector2d px = *state == MarkState::Unplaceable ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(*x, *y);
        addMark(job, static_cast<int>(*frame), {*hand, row[4]}, row[5], Mark{px, *placement, *state}, row[2]);
    }
}

} // namespace core
