// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/direction_question.h"

#include <QObject>
#include <QPoint>
#include <QTimer>

class QWidget;

// The menu for one place of the sky: go there, or change the draft of the profile there. An action that is not possible
// is disabled and gives the reason. The menu opens with the station's answer about the place, so that no entry moves
// under the mouse. Nothing happens before an entry is chosen.
namespace boresight::ui {

class ProfileDraft;

class PlotMenu : public QObject
{
    Q_OBJECT

public:
    PlotMenu(const ProfileDraft& draft, RequestDesk& desk, QWidget* parent);

    void showStatus(const StationStatus& status) { m_whyNoMotion = status.permissions.reason(Action::Point); }
    void open(const SkyPointing& place, const QPoint& globalPos);

Q_SIGNALS:
    void goHereWanted(const boresight::SkyPointing& place);
    void horizonPointWanted(const boresight::SkyPointing& place);
    void keepOutWanted(const boresight::SkyPointing& place);

private:
    void show();
    void show(const QString& whyNot, const std::optional<SkyPointing>& nearest);
    [[nodiscard]] QString whyNoPoint() const;
    [[nodiscard]] QString whyNoKeepOut() const;

    const ProfileDraft& m_draft;
    QWidget& m_plot;
    QString m_whyNoMotion;  // to any place
    SkyPointing m_place;
    QPoint m_at;
    DirectionQuestion m_question;
    QTimer m_patience{this};  // how long to wait for a station that does not answer
};

}  // namespace boresight::ui
