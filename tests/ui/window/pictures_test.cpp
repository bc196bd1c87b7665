// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/picture_book.h"

#include <span>

// Pictures of every panel and every kind of trouble.
namespace boresight::ui {
namespace {

struct Scene
{
    const char* name;
    StationStatus (*status)();
    char panel;  // digit of its key
};

StationStatus midPass()
{
    return samples::tracking(330);
}

StationStatus late()
{
    return samples::withAge(samples::tracking(330), std::chrono::milliseconds(900));
}

StationStatus threePlaces()
{
    return samples::asking(Axis::Azimuth, 3, 180_deg, true);
}

StationStatus manyPlaces()
{
    return samples::asking(Axis::Azimuth, 150, 3.6_deg, false);
}

StationStatus elevationPlaces()
{
    return samples::asking(Axis::Elevation, 7, 12_deg, false);
}

constexpr Scene kHealthy[] = {{"track", midPass, '1'},
                              {"operator", samples::operatorMoving, '1'},
                              {"routed", samples::routed, '1'},
                              {"cable", samples::cableEnding, '1'},
                              {"charts", midPass, '2'},
                              {"limits", samples::bounded, '3'},
                              {"clients", samples::fighting, '4'},
                              {"log", midPass, '5'},
                              {"drives", samples::idle, '6'},
                              {"proof", samples::proving, '6'},
                              {"protection", samples::idle, '7'},
                              {"reading", samples::reading, '7'},
                              {"profile", samples::bounded, '8'}};

constexpr Scene kTroubles[] = {{"late", late, '1'},
                               {"stopped", samples::stopped, '1'},
                               {"fault", samples::faulted, '1'},
                               {"disconnected", samples::disconnected, '1'},
                               {"limited", samples::limited, '1'},
                               {"no-clients", samples::disconnected, '4'},
                               {"released", samples::released, '6'},
                               {"factory-jog", samples::factoryDrives, '1'},
                               {"factory-drives", samples::factoryDrives, '6'},
                               {"factory-protection", samples::factoryDrives, '7'},
                               {"turn", threePlaces, '9'},
                               {"turn-jog", threePlaces, '1'},
                               {"turn-charts", threePlaces, '2'},
                               {"turns", manyPlaces, '9'},
                               {"turn-elevation", elevationPlaces, '9'}};

class PanelPictures : public PictureBook
{
protected:
    void takeAll(std::span<const Scene> scenes)
    {
        for (const Scene& scene : scenes) {
            show(scene.status(), scene.panel);
            take(QLatin1String(scene.name));
        }
    }
};

// REQ-UI-15 (PanelPictures.*): Nothing that must be readable is cut off at 1024×700. packaging/screenshots has the
// tests write the pictures to look at.
TEST_P(PanelPictures, AreTakenOfEveryPanel)
{
    takeAll(kHealthy);
}

TEST_P(PanelPictures, AreTakenOfEveryTrouble)
{
    takeAll(kTroubles);
}

INSTANTIATE_TEST_SUITE_P(All, PanelPictures, kThemesAndPortuguese, editionName);

}  // namespace
}  // namespace boresight::ui
