// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/passes/favourite_places.h"
#include "ui/passes/pass_searcher.h"
#include "ui/passes/passes_layout.h"
#include "ui/sky/planned_beam.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>

class QTableView;

// The coming passes of all satellites with elements: a search, a list and pictures, and below them the selected pass.
// The plot shows its path over the sky. The passes of the next day are searched for on another thread, and again when
// the elements, the site or the limits change. Gui thread.
namespace boresight::ui {

class ElementsButton;
class PassColumns;
class PassFilter;
class PassTable;
class PassViews;
class ProfileDraft;
class RequestDesk;
class SelectedPass;
class ValueLabel;

class PassesPanel : public QWidget
{
    Q_OBJECT

public:
    PassesPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    [[nodiscard]] PassesLayout arrangement() const;
    void arrange(const PassesLayout& layout);

Q_SIGNALS:
    void settingsWanted(const QString& words);  // the settings with these words, on the page Profile
    void siteWanted();                          // the page where the site is entered
    // The path of the selected pass while this panel is shown. Null: none.
    void wayChosen(const boresight::targets::SkyWay& way);
    void beamChosen(const boresight::ui::PlannedBeam& beam);  // of its plan, while the plan is shown. Null: none
    void favouritesMoved(
        const std::vector<boresight::ui::SatellitePlace>& places);  // favourites above the horizon, once a second

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    // The data that the passes depend on.
    struct Basis
    {
        Satellites satellites;
        profile::SiteSettings site;
        pointing::Region limits;
        pointing::PointingTerms pointing;
        pointing::Antenna antenna;
        targets::MountReach reach;                      // of the mount with this antenna
        std::map<std::int64_t, pointing::Antenna> own;  // by satellite number, only satellites with their own antenna

        bool operator==(const Basis&) const = default;
    };
    struct Search
    {
        Basis basis;
        UtcTime begun{};  // beginning of the searched time
    };
    struct Selected
    {
        std::int64_t number = 0;
        UtcTime highest{};
        targets::SkyWay way{};
    };

    void build();
    void addActions();
    void fitHeight();
    void searchAgain(const StationStatus& status);
    void showBook(const std::shared_ptr<const PassBook>& book);
    void showRows();
    void dropPassesThatAreOver();
    void select(int row);
    void toggleFavourite(int row);
    void tellWay();
    void tellPlan();
    void showFavourites(const StationStatus& status);
    void showNote(const StationStatus& status);
    void showProblems(const QStringList& problems);

    PassSearcher* m_searcher;
    PassTable* m_passes;
    QTableView* m_table;
    PassColumns* m_columns;
    PassViews* m_views;
    QWidget* m_choices;  // buttons that switch the view
    PassFilter* m_filter;
    ValueLabel* m_note;
    ValueLabel* m_problem;
    ElementsButton* m_elements;
    SelectedPass* m_selection;
    FavouritePlaces m_favourites;
    Search m_last;
    UtcTime m_now{};
    std::optional<Selected> m_selected;
};

}  // namespace boresight::ui
