// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/passes/pass_book.h"

#include <QWidget>

#include <memory>
#include <optional>

class QBoxLayout;

// The selected pass in words, with the note and the antenna of its satellite, and its actions: track it, watch it, make
// it a favourite. Gui thread. More than 15 members: the widgets that it composes, and how much room they have.
namespace boresight::ui {

class CommandButton;
class FavouriteButton;
class NoteLine;
class ProfileDraft;
class RequestDesk;
class SatelliteAntenna;
class ValueLabel;
class WatchButton;

// What the view of the plan shows of this pass.
struct ShownPlan
{
    plan::SharedVariant variant;  // the selected one; null: no plan, or not yet
    QString sentence;
};

class SelectedPass : public QWidget
{
    Q_OBJECT

public:
    SelectedPass(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    // Empty `pass`: none is selected.
    void select(const std::shared_ptr<const PassBook>& book, const std::optional<BookedPass>& pass);
    void showStatus(const StationStatus& status);
    void setBrief(
        bool on, bool isNamed);  // for little room: only facts that the table does not show, with the name if `isNamed`
    void setNoteShown(
        bool on);  // true: always shown; false: shown only while it is edited, otherwise as a line of the facts
    // Empty: another view is shown. The operator may track the pass by the selected variant.
    void showPlan(const std::optional<ShownPlan>& plan);
    void toggleFavourite(int satellite);
    void editNote();

private:
    void build();
    void track(const std::optional<plan::ChosenWay>& way);
    void showButtons();
    void showFacts();
    [[nodiscard]] std::optional<int> satellite() const;
    [[nodiscard]] const orbit::ElementSet* elements() const;  // the station's present elements; null: it has none
    [[nodiscard]] QString whyNotTracked(const StationStatus& status) const;

    ValueLabel* m_facts;
    ValueLabel* m_refused;
    QBoxLayout* m_buttons;
    CommandButton* m_track;
    CommandButton* m_trackThisWay;
    WatchButton* m_watch;
    FavouriteButton* m_favourite;
    NoteLine* m_note;
    SatelliteAntenna* m_antenna;
    std::shared_ptr<const PassBook> m_book;
    std::optional<BookedPass> m_pass;
    Satellites m_satellites;  // the station's present satellites
    QString m_light;
    QString m_cable;
    QString m_noteText;
    std::optional<ShownPlan> m_plan;
    QString m_driven;  // the plan that the mount drives, in words
    UtcTime m_now{};
    bool m_isBrief = false;
    bool m_isNamed = true;
    bool m_isNoteShown = true;
};

}  // namespace boresight::ui
