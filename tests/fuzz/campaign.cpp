// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign.h"

#include "tests/fuzz/harness.h"
#include "tests/fuzz/mutator.h"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>

namespace boresight::fuzz {
namespace {

// Seen by both processes.
struct Progress
{
    std::size_t fed = 0;
    std::size_t accepted = 0;
    std::size_t size = 0;
    std::array<char, 65536> input{};
};

struct Unmap
{
    void operator()(Progress* progress) const { munmap(progress, sizeof(Progress)); }
};
using SharedProgress = std::unique_ptr<Progress, Unmap>;

SharedProgress shareProgress()
{
    void* const memory = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        std::perror("mmap");
        std::exit(EXIT_FAILURE);
    }
    return SharedProgress(new (memory) Progress);  // placed in the mapping; Unmap releases it
}

// SIGPROF or SIGALRM ends a process that does not begin the next input in time.
void beginWatch(const Campaign& campaign)
{
    const itimerval most{.it_interval = {}, .it_value = {.tv_sec = campaign.mostProcessorTime.count(), .tv_usec = 0}};
    setitimer(ITIMER_PROF, &most, nullptr);
    alarm(static_cast<unsigned>(campaign.longest.count()));
}

void feedAll(const Campaign& campaign, Progress& progress)
{
    Mutator mutator(grammar(), campaign.seed);
    for (; progress.fed < campaign.inputs; ++progress.fed) {
        const std::string input = mutator.next();
        progress.size = std::min(input.size(), progress.input.size());
        std::copy_n(input.begin(), progress.size, progress.input.begin());
        beginWatch(campaign);
        feed(asBytes(input));
        if (takeAccepted()) {
            ++progress.accepted;
            mutator.keep(input);
        }
    }
    progress.size = 0;
}

std::string words(int status, const Campaign& campaign)
{
    if (WIFSIGNALED(status)) {
        switch (WTERMSIG(status)) {
            case SIGPROF:
                return "not done after " + std::to_string(campaign.mostProcessorTime.count()) + " s of processor time";
            case SIGALRM:
                return "not done after " + std::to_string(campaign.longest.count()) + " s";
            default:
                return "ended by signal " + std::to_string(WTERMSIG(status));
        }
    }
    return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Outcome run(const Campaign& campaign)
{
    const SharedProgress progress = shareProgress();
    const auto started = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) {
        feedAll(campaign, *progress);
        std::exit(EXIT_SUCCESS);  // so that the leak check runs
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        std::perror("fork");
        std::exit(EXIT_FAILURE);
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
    Outcome outcome{.fed = progress->fed, .accepted = progress->accepted, .seconds = taken.count()};
    if (status != 0) {
        outcome.failure = Failure{.number = progress->fed,
                                  .input = std::string(progress->input.data(), progress->size),
                                  .how = words(status, campaign)};
    }
    return outcome;
}

}  // namespace boresight::fuzz
