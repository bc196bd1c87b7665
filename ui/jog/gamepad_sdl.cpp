// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that uses SDL: its game controllers, without its window, event loop and signal handlers.
#include "ui/jog/gamepad.h"

#include <QTimer>

#include <SDL.h>

#include <algorithm>
#include <chrono>

namespace boresight::ui {

namespace {

constexpr std::chrono::seconds kLookPause{1};
constexpr std::chrono::milliseconds kReadPause{20};

struct Closer
{
    void operator()(SDL_GameController* controller) const { SDL_GameControllerClose(controller); }
};

class SdlGamepad : public Gamepad
{
public:
    SdlGamepad();
    ~SdlGamepad() override;

private:
    void look();
    void read();
    [[nodiscard]] bool begin();
    [[nodiscard]] double axis(SDL_GameControllerAxis which) const;
    [[nodiscard]] bool pressed(SDL_GameControllerButton which) const;

    std::unique_ptr<SDL_GameController, Closer> m_controller;
    QTimer m_timer;
    bool m_begun = false;
};

SdlGamepad::SdlGamepad()
{
    connect(&m_timer, &QTimer::timeout, this, [this] { m_controller ? read() : look(); });
    m_timer.start(kLookPause);  // the first search comes after the first picture
}

SdlGamepad::~SdlGamepad()
{
    m_controller.reset();
    if (m_begun) {
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
}

bool SdlGamepad::begin()
{
    if (!m_begun) {
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // SDL has no window that could be in front
        // the kernel's drivers are enough, and open without delay
        SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
        m_begun = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
        SDL_GameControllerEventState(SDL_IGNORE);  // it is polled, and nobody reads an event queue
        SDL_JoystickEventState(SDL_IGNORE);
    }
    return m_begun;
}

void SdlGamepad::look()
{
    if (!begin()) {
        m_timer.stop();
        return;
    }
    SDL_GameControllerUpdate();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    for (int device = 0; device < SDL_NumJoysticks() && !m_controller; ++device) {
        if (SDL_IsGameController(device) == SDL_TRUE) {
            m_controller.reset(SDL_GameControllerOpen(device));
        }
    }
    if (m_controller) {
        const char* const name = SDL_GameControllerName(m_controller.get());
        m_timer.start(kReadPause);
        Q_EMIT plugged(name ? QString::fromUtf8(name) : Gamepad::tr("Gamepad"));
    }
}

void SdlGamepad::read()
{
    SDL_GameControllerUpdate();
    if (SDL_GameControllerGetAttached(m_controller.get()) != SDL_TRUE) {
        m_controller.reset();
        m_timer.start(kLookPause);
        Q_EMIT plugged({});
        return;
    }
    Q_EMIT sampled(
        {.right = axis(SDL_CONTROLLER_AXIS_LEFTX),
         .up = -axis(SDL_CONTROLLER_AXIS_LEFTY),
         .deadMan = pressed(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) || pressed(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER),
         .stop = pressed(SDL_CONTROLLER_BUTTON_B)});
}

double SdlGamepad::axis(SDL_GameControllerAxis which) const
{
    return std::max(-1.0, SDL_GameControllerGetAxis(m_controller.get(), which) / double{SDL_JOYSTICK_AXIS_MAX});
}

bool SdlGamepad::pressed(SDL_GameControllerButton which) const
{
    return SDL_GameControllerGetButton(m_controller.get(), which) != 0;
}

}  // namespace

std::unique_ptr<Gamepad> Gamepad::create()
{
    return std::make_unique<SdlGamepad>();
}

}  // namespace boresight::ui
