// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QStringList>
#include <QWidget>

#include <optional>

class QLineEdit;

// Go to a typed direction. An axis with an empty field stays where it is. Typing and selecting move nothing. A refusal
// is shown in the notice with the nearest allowed direction, also if only one axis was typed. The typed value stays for
// correction. A click into a field selects it. The last directions that the station accepted can be chosen again.
namespace boresight::ui {

class CommandButton;
class NearestOffer;
class RequestDesk;
class TouchCombo;
class ValueLabel;

class GoToBar : public QWidget
{
    Q_OBJECT

public:
    // `offer` is shown beside the notice.
    GoToBar(RequestDesk& desk, ValueLabel& notice, NearestOffer& offer, const QStringList& recent,
            QWidget* parent = nullptr);

    void setBlocked(const QString& reason);                                                  // empty: can act
    void setPresent(const std::optional<SkyPointing>& direction) { m_present = direction; }  // of the beam
    void focusFields();
    [[nodiscard]] std::optional<Angle> azimuth() const;  // as typed; empty if nothing is typed

Q_SIGNALS:
    void recentChanged(const QStringList& recent);  // to be stored for the next start, the newest first

private:
    void build();
    void go();
    void offerNearest();
    bool isNumber(QLineEdit& field, const QString& otherwise);
    void complain(QLineEdit& field, const QString& text);
    void forgetRefusal();
    void leaveFields();
    void remember();
    void showRecent();
    void fillIn(int recent);

    ValueLabel& m_notice;
    NearestOffer& m_offer;
    QLineEdit* m_azimuth;
    QLineEdit* m_elevation;
    CommandButton* m_go;
    TouchCombo* m_recentBox;
    QStringList m_recent;  // "113.50 10.00"
    // The last direction that was requested. Empty: that axis stays.
    struct Asked
    {
        std::optional<Angle> azimuth;
        std::optional<Angle> elevation;
    };
    Asked m_asked;
    std::optional<SkyPointing> m_present;
};

}  // namespace boresight::ui
