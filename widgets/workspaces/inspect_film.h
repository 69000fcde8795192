// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QObject>
#include <QSize>
#include <QString>

#include "widgets/jobs/job.h"
#include "widgets/workspaces/inspect_page.h"

namespace core {
class FilmWriter;
}

namespace widgets {

/// Saves the compared pair as a film, iteration by iteration, as the page shows it: the page goes through them, the
/// film is written in the background, and the iteration that was shown before comes back. A film that is stopped leaves
/// nothing behind.
class InspectFilm : public QObject {
    Q_OBJECT

public:
    InspectFilm(InspectPage& page, JobPool& pool, QObject* parent = nullptr);
    ~InspectFilm() override;

    /// From the start pose to the last iteration, which stays for a second. Ends with finished(), stopped() or
    /// failed().
    void save(const QString& path);
    void stop();
    bool isRunning() const { return m_writer != nullptr; }

signals:
    void progressed(double fraction);
    void finished(const QString& path);
    void stopped();
    void failed(const QString& message);

private:
    void take();
    QImage nextPicture();
    void goOn();
    void end();

    InspectPage& m_page;
    Job m_job;
    QString m_path;
    std::shared_ptr<core::FilmWriter> m_writer; ///< of the film that is being saved
    int m_wanted = 0;                           ///< the iteration that is to be taken next
    int m_before = 0;                           ///< the iteration that was shown before
    bool m_isTaken = false;                     ///< it is being written
    QSize m_size;                               ///< of every picture; empty before the first
};

} // namespace widgets
