// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gpredict/gpredict_qth.h"
#include "core/messages/adapter.h"
#include "core/messages/rotator_models.h"
#include "core/messages/rotator_offer.h"
#include "core/messages/scan_result.h"
#include "core/messages/table_content.h"

#include <QObject>

#include <utility>
#include <vector>

// Requests of the window to this computer, as RequestDesk handles those to the station. A request leaves as a signal,
// the answer arrives as a signal, and nothing blocks. Gui thread.
namespace boresight::ui {

class HostDesk : public QObject
{
    Q_OBJECT

public:
    explicit HostDesk(std::vector<RotatorOffer> rotators, QObject* parent = nullptr)
        : QObject(parent), m_rotators(std::move(rotators))
    {}

    // Every kind of rotator that can be connected.
    [[nodiscard]] const std::vector<RotatorOffer>& rotators() const { return m_rotators; }

Q_SIGNALS:
    // Emitted for a page.
    void adaptersWanted(const QString& namedBus);  // this bus is listed, too
    void rotatorModelsWanted();
    void scanWanted(const QString& bus);
    void gpredictWanted(const QString& folder);
    // `known`: an earlier answer, or null. It is the answer again if the file has not changed since.
    void tableWanted(const QString& path, const boresight::SharedTableContent& known);
    // Called by the owner of the window.
    void adaptersFound(const std::vector<boresight::Adapter>& adapters);
    void rotatorModelsFound(const boresight::RotatorModels& models);
    void scanned(const boresight::ScanResult& result);
    void gpredictFound(const boresight::profile::GpredictFiles& files);
    void tableRead(const boresight::SharedTableContent& content);

private:
    std::vector<RotatorOffer> m_rotators;
};

}  // namespace boresight::ui
