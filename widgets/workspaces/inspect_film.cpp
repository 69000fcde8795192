// SPDX-License-Identifier: MIT
#include "widgets/workspaces/inspect_film.h"

#include <algorithm>

#include <QPainter>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/error.h"
#include "core/io/footage/film_writer.h"
#include "widgets/text/error_text.h"
#include "widgets/workspaces/inspect_picture.h"

namespace widgets {

namespace {

constexpr double kIterationsPerSecond = 8;
constexpr int kLastPictures = 8; ///< of the result

cv::Mat bgrOf(const QImage& picture) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    const cv::Mat view(rgb.height(), rgb.width(), CV_8UC3, const_cast<uchar*>(rgb.constBits()),
                       static_cast<std::size_t>(rgb.bytesPerLine()));
    cv::Mat bgr;
    cv::cvtColor(view, bgr, cv::COLOR_RGB2BGR);
    return bgr;
}

} // namespace

InspectFilm::InspectFilm(InspectPage& page, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_page(page)
    , m_job(pool) {
    connect(page.overlays(), &InspectOverlays::drawn, this, &InspectFilm::take,
            Qt::QueuedConnection); // the meshes come right after
    connect(&m_job, &Job::failed, this, [this](const QString& message) {
        end();
        emit failed(message);
    });
}

InspectFilm::~InspectFilm() = default;

void InspectFilm::save(const QString& path) {
    if (isRunning() || !m_page.columns()->outcome())
        return;
    try {
        m_writer = std::make_shared<core::FilmWriter>(path.toStdString(), kIterationsPerSecond);
    } catch (const core::Error& error) {
        emit failed(errorInWords(error));
        return;
    }
    m_path = path;
    m_before = m_page.iteration();
    m_wanted = 0;
    m_isTaken = false;
    m_size = {};
    emit progressed(0);
    if (m_page.iteration() == 0)
        take(); // it is shown already
    else
        m_page.setIteration(0);
}

void InspectFilm::stop() {
    if (!isRunning())
        return;
    m_job.stop();
    end();
    emit stopped();
}

/// The page on paper that stays as large: its legend may take another line, where a reason to refuse matches comes up.
QImage InspectFilm::nextPicture() {
    constexpr int kSpareLines = 2;
    const QImage page = pageImage(comparisonPicture(m_page), 1);
    if (m_size.isEmpty())
        m_size = page.size() + QSize(0, kSpareLines * m_page.fontMetrics().height());
    QImage picture(m_size, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter(&picture).drawImage(0, 0, page);
    return picture;
}

/// Takes the page once it shows what is wanted, poses and layers.
void InspectFilm::take() {
    const InspectOverlays::Scene& shown = m_page.overlays()->scene();
    if (!isRunning() || m_isTaken || !shown.poses || shown.iteration != m_wanted)
        return;
    m_isTaken = true;
    const QImage picture = nextPicture();
    const bool isLast = m_wanted >= m_page.lastIteration();
    m_job.start([this, picture, isLast, writer = m_writer, path = m_path](const JobContext&) -> Job::Delivery {
        const cv::Mat bgr = bgrOf(picture);
        for (int i = 0; i < (isLast ? kLastPictures : 1); ++i)
            writer->add(bgr);
        if (isLast)
            writer->finish();
        return [this, isLast, path] {
            if (!isLast)
                return goOn();
            end();
            emit finished(path);
        };
    });
}

void InspectFilm::goOn() {
    ++m_wanted;
    m_isTaken = false;
    emit progressed(double(m_wanted) / std::max(1, m_page.lastIteration()));
    if (m_wanted > m_page.lastIteration())
        stop(); // another pair is shown by now
    else
        m_page.setIteration(m_wanted);
}

void InspectFilm::end() {
    m_writer.reset();
    m_page.setIteration(m_before);
}

} // namespace widgets
