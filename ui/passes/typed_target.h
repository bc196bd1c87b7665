// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/targets/target_place.h"
#include "ui/link/direction_question.h"
#include "ui/link/drive_check_words.h"
#include "ui/link/table_question.h"
#include "ui/passes/pass_book.h"

#include <QObject>

#include <optional>

// A target that is typed: the request for it, and why the station would refuse it. The rules are those of the station
// (core/targets/track_rules). A direction and a position are judged by the station itself, because its mount must reach
// them. A file is read beside the gui thread. Another rotator is not asked before it is to be followed. Gui thread.
namespace boresight::ui {

class RequestDesk;

class TypedTarget : public QObject
{
    Q_OBJECT

public:
    TypedTarget(RequestDesk& desk, HostDesk& host, QObject* parent = nullptr);

    void setText(const QString& text);
    void showStatus(const StationStatus& status);

    // The reason for which the station would refuse the target. Empty: the window knows no reason.
    [[nodiscard]] QString whyNot() const;
    // The reason for which the table of a typed file cannot be tracked, or a text that this is unknown. Empty if it can
    // be tracked, or if no file was typed.
    [[nodiscard]] Sentence aboutTable() const;
    [[nodiscard]] const std::optional<Request>& request() const { return m_request; }  // empty: whyNot() says why

Q_SIGNALS:
    void judged();

private:
    void read();
    void takeTable();
    void place();
    void look();
    [[nodiscard]] QString whyNotTarget() const;  // by the target itself

    std::shared_ptr<const profile::Profile> m_profile;
    Satellites m_satellites;
    Permissions m_permissions;
    UtcTime m_now{};
    QString m_text;
    QString m_problem;  // of the text
    std::optional<Request> m_request;
    std::optional<targets::Target> m_target;
    std::optional<targets::TargetPlace> m_place;  // of m_target, where the site is known
    DirectionQuestion m_question;
    TableQuestion m_table;
};

}  // namespace boresight::ui
