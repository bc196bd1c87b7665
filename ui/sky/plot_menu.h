// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QObject>
#include <QPoint>

#include <functional>
#include <optional>

class QWidget;

// What can be done at one place of the sky: go there, or change the draft of the profile there. What cannot be done is
// disabled and says why. Nothing happens before an entry is chosen.
namespace boresight::ui {

class ProfileDraft;

class PlotMenu : public QObject
{
    Q_OBJECT

public:
    // What the station says about a place before it is asked: why the mount may not go there (empty: it may), and the
    // nearest place that is allowed.
    struct Advice
    {
        QString whyNot = {};
        std::optional<SkyPointing> nearest = {};
    };
    using Adviser = std::function<Advice(const SkyPointing&)>;

    PlotMenu(const ProfileDraft& draft, QWidget* parent);

    void setAdviser(const Adviser& adviser) { m_adviser = adviser; }
    void open(const SkyPointing& place, const QPoint& globalPos);

Q_SIGNALS:
    void goHereWanted(const boresight::SkyPointing& place);
    void horizonPointWanted(const boresight::SkyPointing& place);
    void keepOutWanted(const boresight::SkyPointing& place);

private:
    [[nodiscard]] QString whyNoPoint() const;
    [[nodiscard]] QString whyNoKeepOut() const;

    const ProfileDraft& m_draft;
    QWidget& m_plot;
    Adviser m_adviser;
};

}  // namespace boresight::ui
