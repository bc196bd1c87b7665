// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells ThreadSanitizer about the ordering that Qt's event queue guarantees. Linked into every program of the tsan
// preset.
//
// The Qt of the distribution is not instrumented, and its mutexes are futexes, which ThreadSanitizer cannot see.
// Without help each queued call between two threads is reported as a race: 54 reports in a correct program of two
// threads and 1000 queued signals. Here each event is ordered on its own address: Qt releases it when the sender
// allocates it, and acquires it when the receiver gets or frees it. Three more orderings are known. What a thread did
// before it ended comes before the return of QThread::wait(). What a thread did before it gave work to a QThreadPool
// comes before that work. What a thread of a pool did before it ended comes before the end of the pool. Nothing else is
// ordered, so a value shared outside events is still reported. Arguments of queued signals are copied after the
// allocation: tsan.supp names those. Painting stays on the requesting thread, because Qt Gui's pool of threads is
// ordered by semaphores that ThreadSanitizer cannot see either.

#include <QtCore/QCoreApplication>
#include <QtCore/QDeadlineTimer>
#include <QtCore/QRunnable>
#include <QtCore/QThread>
#include <QtCore/QThreadPool>
#include <QtCore/QThreadStorage>
#include <QtCore/qnamespace.h>

#include <dlfcn.h>
#include <link.h>
#include <sanitizer/tsan_interface.h>
#include <sys/types.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>
#include <utility>

namespace {

struct CodeRange
{
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;

    [[nodiscard]] bool contains(const void* address) const
    {
        const auto value = reinterpret_cast<std::uintptr_t>(address);
        return value >= begin && value < end;
    }
};

// The libraries that post events to other threads. (A resolved host name comes from Qt Network.)
struct SenderCode
{
    const char* library;
    CodeRange range;
};

constinit std::array g_senders{SenderCode{"libQt6Core.so", {}}, SenderCode{"libQt6Network.so", {}}};

bool isQt(const void* caller)
{
    return std::any_of(g_senders.begin(), g_senders.end(),
                       [caller](const SenderCode& sender) { return sender.range.contains(caller); });
}

CodeRange executableCode(const dl_phdr_info& library)
{
    for (int i = 0; i < library.dlpi_phnum; ++i) {
        const auto& segment = library.dlpi_phdr[i];
        if (segment.p_type == PT_LOAD && (segment.p_flags & PF_X) != 0) {
            const std::uintptr_t begin = library.dlpi_addr + segment.p_vaddr;
            return {.begin = begin, .end = begin + segment.p_memsz};
        }
    }
    return {};
}

int findSenders(dl_phdr_info* library, std::size_t /*size*/, void* /*unused*/)
{
    for (SenderCode& sender : g_senders) {
        if (std::strstr(library->dlpi_name, sender.library) != nullptr) {
            sender.range = executableCode(*library);
        }
    }
    return 0;
}

// Exists in each thread that has received an event or work of a pool. Qt destroys it when the thread ends, after the
// deferred deletions and before it wakes a waiting thread.
struct ThreadEnd
{
    static inline char s_order = 0;

    ThreadEnd() = default;
    ThreadEnd(const ThreadEnd&) = delete;
    ThreadEnd& operator=(const ThreadEnd&) = delete;
    ~ThreadEnd() { __tsan_release(&s_order); }
};

QThreadStorage<ThreadEnd*> g_threadEnds;

void orderItsEnd()
{
    if (!g_threadEnds.hasLocalData()) {
        g_threadEnds.setLocalData(new ThreadEnd);
    }
}

// Qt calls this in the receiver's thread before it delivers an event. data: receiver, event, result.
bool eventDelivered(void** data)
{
    __tsan_acquire(data[1]);
    orderItsEnd();
    return false;
}

[[maybe_unused]] const bool g_installed = [] {
    dl_iterate_phdr(findSenders, nullptr);
    return QInternal::registerCallback(QInternal::EventNotifyCallback, eventDelivered);
}();

void freeBlock(void* block, const void* caller)
{
    if (block != nullptr && isQt(caller)) {
        __tsan_acquire(block);
    }
    std::free(block);
}

}  // namespace

// The linker redirects our calls of QThread::wait() to this function (--wrap, BoresightOptions.cmake). If the thread
// has already ended, Qt returns after reading its state, which ThreadSanitizer cannot see.
extern "C" bool __real__ZN7QThread4waitE14QDeadlineTimer(QThread* thread, QDeadlineTimer deadline);
extern "C" bool __wrap__ZN7QThread4waitE14QDeadlineTimer(QThread* thread, QDeadlineTimer deadline)
{
    const bool ended = __real__ZN7QThread4waitE14QDeadlineTimer(thread, deadline);
    if (ended) {
        __tsan_acquire(&ThreadEnd::s_order);
    }
    return ended;
}

// The same for the work of a pool: an existing thread of the pool takes it under a mutex of Qt. This must not access
// the work before it is ordered, so it does not receive a std::function.
namespace {

class PoolWork : public QRunnable
{
public:
    explicit PoolWork(std::function<void()> work) : m_work(std::move(work)) { __tsan_release(&s_order); }
    void run() override
    {
        __tsan_acquire(&s_order);
        orderItsEnd();
        m_work();
    }

private:
    static inline char s_order = 0;

    std::function<void()> m_work;
};

}  // namespace

extern "C" void __wrap__ZN11QThreadPool5startESt8functionIFvvEEi(QThreadPool* pool, std::function<void()> work,
                                                                 int priority)
{
    pool->start(new PoolWork(std::move(work)), priority);
}

// A pool frees memory that its threads have allocated in it: the list of the threads waiting for work.
extern "C" void __real__ZN11QThreadPoolD1Ev(QThreadPool* pool);
extern "C" void __wrap__ZN11QThreadPoolD1Ev(QThreadPool* pool)
{
    pool->waitForDone();
    __tsan_acquire(&ThreadEnd::s_order);
    __real__ZN11QThreadPoolD1Ev(pool);
}

// A posted call is freed by the last user, either the thread that posts it or the one that executes it. ThreadSanitizer
// cannot see how Qt counts the users. Posting writes nothing else.
extern "C" void AnnotateIgnoreWritesBegin(const char* file, int line);
extern "C" void AnnotateIgnoreWritesEnd(const char* file, int line);
extern "C" bool
__real__ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv(
    QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type, void* result);
extern "C" bool
__wrap__ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv(
    QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type, void* result)
{
    const bool posted = type == Qt::QueuedConnection;
    if (posted) {
        AnnotateIgnoreWritesBegin(__FILE__, __LINE__);
    }
    const bool done =
        __real__ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv(
            object, slot, type, result);
    if (posted) {
        AnnotateIgnoreWritesEnd(__FILE__, __LINE__);
    }
    return done;
}

// Qt Gui asks this before it splits the painting of a large area. On a thread of the pool it paints without splitting.
// No code of ours calls it.
bool QThreadPool::contains(const QThread* /*thread*/) const
{
    return true;
}

// Qt starts a program by a clone that shares its memory, which clang's own clone() does not expect. Until the program
// is executed the child does nothing of interest.
extern "C" int clone(int (*run)(void*), void* stack, int flags, void* argument, ...)
{
    using Clone = int (*)(int (*)(void*), void*, int, void*, pid_t*, void*, pid_t*);
    static const auto ours = reinterpret_cast<Clone>(dlsym(dlopen("libc.so.6", RTLD_NOLOAD | RTLD_LAZY), "clone"));
    std::va_list rest;
    va_start(rest, argument);
    auto* const parent = va_arg(rest, pid_t*);
    auto* const threadData = va_arg(rest, void*);
    auto* const child = va_arg(rest, pid_t*);
    va_end(rest);
    return ours(run, stack, flags, argument, parent, threadData, child);
}

// Qt makes room in the list of waiting events of a thread by moving them, under its own lock, wherever an event is
// posted. What our own code moves, also in templates of Qt, is still checked.
extern "C" __attribute__((disable_sanitizer_instrumentation)) void* memmove(void* to, const void* from,
                                                                            std::size_t size)
{
    using Move = void* (*)(void*, const void*, std::size_t);
    static constinit Move watched = nullptr;
    if (watched == nullptr) {
        watched = reinterpret_cast<Move>(dlsym(RTLD_NEXT, "memmove"));
    }
    if (!isQt(__builtin_return_address(0))) {
        return watched(to, from, size);
    }
    AnnotateIgnoreWritesBegin(__FILE__, __LINE__);
    void* const moved = watched(to, from, size);
    AnnotateIgnoreWritesEnd(__FILE__, __LINE__);
    return moved;
}

void* operator new(std::size_t size)
{
    void* block = std::malloc(size);
    if (block == nullptr) {
        std::abort();  // the tests never run out of memory on purpose
    }
    if (isQt(__builtin_return_address(0))) {
        __tsan_release(block);
    }
    return block;
}

void operator delete(void* block) noexcept
{
    freeBlock(block, __builtin_return_address(0));
}

void operator delete(void* block, std::size_t /*size*/) noexcept
{
    freeBlock(block, __builtin_return_address(0));
}
