// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/adapter.h"
#include "core/messages/rotator_models.h"
#include "core/messages/rotator_offer.h"
#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QStringList>
#include <QWidget>

#include <string>
#include <utility>
#include <vector>

// The first part of the guide's first step: the choice of the kind of rotator. Some kinds are listed among the adapters
// of this computer. For others the operator enters an address or port, and sometimes a model. This widget shows what
// Connect will send to it, its answer, and what to check if there is no answer. It contains no code for a certain kind:
// the drivers describe their kinds.
namespace boresight::ui {

class ModelChoice;
class TouchCombo;

class RotatorChoice : public QWidget
{
    Q_OBJECT

public:
    explicit RotatorChoice(const std::vector<RotatorOffer>& offers, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void showAdapters(const std::vector<Adapter>& adapters);
    void showModels(const RotatorModels& models);
    void refreshModels();  // asks for the models if the chosen kind has models and none are known

    [[nodiscard]] bool isListed() const;      // the kind is listed among the adapters; otherwise it is entered here
    [[nodiscard]] bool onSerialPort() const;  // the serial ports of this computer are offered
    [[nodiscard]] QString whyIncomplete() const;
    [[nodiscard]] ProfileChange::Edit edit()
        const;  // the edit of the profile; call it only if whyIncomplete() is empty
    [[nodiscard]] QStringList words(const QString& obstacle)
        const;  // the texts about the chosen rotator, with the reason why Connect is not possible

Q_SIGNALS:
    void changed();
    void modelsWanted();  // asks for the models of the chosen kind

private:
    void build();
    void choose(int kind);
    void takeFrom(const profile::Profile& profile);
    void offerPorts();
    [[nodiscard]] const RotatorOffer& offer() const { return m_offers.at(m_kind); }
    [[nodiscard]] Result<std::string> bus() const;
    [[nodiscard]] QString busText(const QString& place) const;
    [[nodiscard]] bool isInUse() const;
    [[nodiscard]] QStringList wordsInUse() const;

    std::vector<RotatorOffer> m_offers;
    std::vector<QString> m_entered;  // what was entered for each kind
    std::size_t m_kind = 0;
    QStringList m_ports;
    StationStatus m_status;
    std::pair<profile::AxisDriver, std::string> m_taken;  // driver and bus in force, as last shown
    TouchCombo* m_kinds;
    ModelChoice* m_model;
    QWidget* m_fields;
    TouchCombo* m_place;
    TouchCombo* m_baud;
};

}  // namespace boresight::ui
