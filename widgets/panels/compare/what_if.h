// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "widgets/jobs/fit_runner.h"
#include "widgets/presenters/what_if_case.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// One method on one case.
struct WhatIfTrial {
    std::string method; ///< as core::parseMethod reads it
    WhatIfCase what;
    std::string column;     ///< whose place it takes; empty for none
    std::string key;        ///< the parameter that is explored
    double x = 0;           ///< its value
    bool isLive = false;    ///< the real-time variant, which answers first and is not judged
    std::string curve = {}; ///< one of a row of values: a point of that curve, not judged; empty for none
};

/// Fits the open pair again and again while a parameter is dragged. One fit at a time, in the background: the one that
/// runs ends, and of what was asked meanwhile the latest counts; only the real-time variant does not wait for others,
/// and what it found has a moment to be drawn before the next one takes the processor.
class WhatIf : public QObject {
    Q_OBJECT

public:
    WhatIf(const FitRunner& fits, const DatasetSession& datasets, JobPool& pool, QObject* parent = nullptr);

    /// In this order; what waits from a call before is forgotten.
    void run(std::vector<WhatIfTrial> trials);
    void stop();
    /// In the background: what takes a moment the first time, before it is asked for. Happens by itself after a fit,
    /// as soon as nothing else is to be done.
    void prepare();
    /// Whether that is done for the pair that is open.
    bool isPrepared() const;
    /// The outlines of the silhouettes that the last answer met; null where they are the pair's own.
    const std::shared_ptr<const CameraOutlines>& outlinesPx() const { return m_outlines; }
    bool isRunning() const { return m_job.isRunning() || m_pause.isActive(); }

signals:
    void found(const widgets::WhatIfTrial& trial, const widgets::MethodOutcome& outcome);
    void failed(const QString& message);
    void finished();

private:
    struct PairNoise;
    struct CaseMasks;
    std::shared_ptr<PairNoise> noiseOf(const std::shared_ptr<const FitOutcome>& outcome, int draw);
    std::shared_ptr<CaseMasks> masksOf(const std::shared_ptr<const FitOutcome>& outcome, const WhatIfCase& what);
    void goOn();
    void startNext();

    const FitRunner& m_fits;
    const DatasetSession& m_datasets;
    Job m_job;
    Job m_preparing;
    QTimer m_pause; ///< after the real-time variant
    std::deque<WhatIfTrial> m_waiting;
    bool m_runsLive = false;
    bool m_awaitsIdle = false;          ///< to prepare
    std::shared_ptr<PairNoise> m_noise; ///< of the pair that was fitted last: one draw, whatever its strength
    std::shared_ptr<CaseMasks> m_masks; ///< of the case that was fitted last: its methods share them
    std::shared_ptr<const CameraOutlines> m_outlines; ///< of what was found last
};

} // namespace widgets
