// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/passes/favourite_places.h"
#include "ui/passes/pass_searcher.h"
#include "ui/passes/passes_layout.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>

class QTableView;

// The coming passes of the satellites whose elements the station knows, to search, as a list and in pictures, and below
// them the selected pass. The plot shows its way over the sky. They are searched for beside the gui thread, for a day
// ahead, and again when the elements, the site or the limits change. Gui thread.
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
    void settingsWanted(const QString& words);  // of the page Profile
    void siteWanted();                          // where it is entered
    // Of the selected pass, while it is seen here; null: of none.
    void wayChosen(const boresight::targets::SkyWay& way);
    void favouritesMoved(const std::vector<boresight::ui::SatellitePlace>& places);  // that are up, once a second

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    // What the passes depend on.
    struct Basis
    {
        Satellites satellites;
        profile::SiteSettings site;
        pointing::Region limits;
        pointing::PointingTerms pointing;
        pointing::Antenna antenna;
        targets::MountReach reach;                      // with it
        std::map<std::int64_t, pointing::Antenna> own;  // of satellites that have one

        bool operator==(const Basis&) const = default;
    };
    struct Search
    {
        Basis basis;
        UtcTime begun{};  // of the span
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
    void showFavourites(const StationStatus& status);
    void showNote(const StationStatus& status);
    void showProblems(const QStringList& problems);

    PassSearcher* m_searcher;
    PassTable* m_passes;
    QTableView* m_table;
    PassColumns* m_columns;
    PassViews* m_views;
    QWidget* m_choices;  // of the view
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
