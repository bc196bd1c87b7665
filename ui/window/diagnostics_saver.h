// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnostics/bundle.h"
#include "ui/charts/telemetry_excerpt.h"
#include "ui/kit/file_worker.h"

#include <QObject>

#include <functional>
#include <utility>

class QWidget;

// Saves the diagnostics of core/diagnostics with the last minutes of telemetry. It asks for the place, collects on the
// gui thread only data in memory, and leaves the rest to a worker.
namespace boresight::ui {

class DiagnosticsSaver : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::minutes kTelemetry{5};

    using QObject::QObject;

    // `gather` is called once a place is chosen, for the data at that moment.
    using Gather = std::function<std::pair<diagnostics::Snapshot, TelemetryExcerpt>()>;
    void askWhere(QWidget& owner, UtcTime now, const Gather& gather);

Q_SIGNALS:
    void saved(const QString& path);
    void failed(const QString& reason);  // with the path

private:
    void save(const QString& path, const diagnostics::Snapshot& snapshot, const TelemetryExcerpt& telemetry);

    FileWorker m_files;
};

}  // namespace boresight::ui
