// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_draft.h"

#include <QWidget>

#include <optional>

class QPushButton;
class QTableView;

// The rotctld clients: which are connected, which one moves the mount and by which rule, and the operator's actions for
// each. Below them the MQTT broker, if one is used. The rule is a setting of the profile and applies at once.
// More than 15 members: the widgets that it composes.
namespace boresight::ui {

class ChoiceButton;
class ClientModel;
class CommandButton;
class RequestDesk;
class ValueLabel;

class ClientsPanel : public QWidget
{
    Q_OBJECT

public:
    ClientsPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void focusProtocolLog();  // its button

Q_SIGNALS:
    void protocolLogWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void connectButtons();
    QTableView* makeTable();
    QWidget* makeRules();
    QWidget* makeLastRow();
    void nameLockedTarget();
    void showRules();
    void showAccess();
    void showBroker();
    void showSelected();
    void explainOdd(const ClientStatus* client);
    void choose(profile::ControlRule lead, const std::string& lockedTo);
    void lock();
    void copySettings() const;
    [[nodiscard]] const ClientStatus* selected() const;
    [[nodiscard]] QString whyNoChange() const;

    ProfileDraft& m_draft;
    StationStatus m_status;
    ClientModel* m_model;
    QTableView* m_table;
    ValueLabel* m_access;
    ValueLabel* m_broker;
    ValueLabel* m_detail;
    ValueLabel* m_notice;
    ValueLabel* m_gpredict;
    ChoiceButton* m_first;
    ChoiceButton* m_last;
    ChoiceButton* m_locked;
    CommandButton* m_give;
    CommandButton* m_readOnly;
    CommandButton* m_disconnect;
    CommandButton* m_lock;
    QPushButton* m_protocolLog = nullptr;
    std::optional<std::uint64_t> m_selected;  // id, because the row may change
};

}  // namespace boresight::ui
