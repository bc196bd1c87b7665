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

// What turns the mount, in the guide's first step: one of the kinds of rotator that there are. A kind is found among
// the adapters of this computer, or a person enters where it answers, and which model of many it is. Then this says
// what Connect asks there, what has answered, and what to look at when nothing does. It knows no kind: their drivers
// describe them.
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
    void refreshModels();  // asks for them where the chosen kind has any and none are known

    [[nodiscard]] bool isListed() const;      // among the adapters; else it is entered here
    [[nodiscard]] bool onSerialPort() const;  // those of this computer are offered
    [[nodiscard]] QString whyIncomplete() const;
    [[nodiscard]] ProfileChange::Edit edit() const;                  // of what is complete
    [[nodiscard]] QStringList words(const QString& obstacle) const;  // why Connect is not offered

Q_SIGNALS:
    void changed();
    void modelsWanted();  // of the kind that is chosen

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
    std::vector<QString> m_entered;  // the place of each kind
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
