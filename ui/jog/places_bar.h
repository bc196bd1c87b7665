// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/leavable.h"

#include <QStringList>
#include <QWidget>

class QPushButton;

// The places to which the mount may be sent at once: a typed direction, Park, and behind a button the presets, Home,
// Horizon and Unwrap. It is shown below every panel. Gui thread.
namespace boresight::ui {

class CommandButton;
class GoToBar;
class NearestOffer;
class PresetBar;
class ProfileDraft;
class RequestDesk;
class ValueLabel;

class PlacesBar : public QWidget, public Leavable
{
    Q_OBJECT

public:
    // `recentGoTos`: see GoToBar.
    PlacesBar(ProfileDraft& draft, RequestDesk& desk, const QStringList& recentGoTos, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void focusGoTo();       // Ctrl+G
    void park();            // Ctrl+P
    bool leave() override;  // hides the presets

Q_SIGNALS:
    void recentGoTosChanged(const QStringList& recent);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void build();
    [[nodiscard]] QWidget* makeFirstRow();
    void fillRare();
    void showPark();
    void parkOrUnpark();
    void offerBesidePark();

    ValueLabel* m_notice;
    NearestOffer* m_offer;
    GoToBar* m_goTo;
    CommandButton* m_park;
    QPushButton* m_more;
    QWidget* m_rare;  // rarely used controls
    PresetBar* m_presets;
    CommandButton* m_home;
    CommandButton* m_horizon;
    CommandButton* m_unwrap;
    StationStatus m_status;
};

}  // namespace boresight::ui
