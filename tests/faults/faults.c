// Faults of the machine, for a program that this library is loaded into before others: the n-th allocation fails, the n-th write
// fails in one of several ways, or the n-th call that changes a file is the last.
//
//   ALGAE_FAULT=memory:N      allocation number N since main gives nothing
//   ALGAE_FAULT=memory:each:N:M   that of allocation N, N + M, N + 2M ... up to the first write or change of a file: at each of these the
//                             process forks, the allocation fails in the child, and the parent goes on when it is told to (see fork_here)
//   ALGAE_FAULT=full:N        write number N fails: no space is left
//   ALGAE_FAULT=broken:N      write number N fails: the device does not answer
//   ALGAE_FAULT=short:N       write number N writes one byte only
//   ALGAE_FAULT=kill:N        before call number N that opens, writes, renames or removes a file the program is killed
//   ALGAE_FAULT=memory:0      (or another kind) nothing fails; at the end the number of such calls is written to ALGAE_FAULT_COUNT
//
// Where an allocation fails, the file ALGAE_FAULT_FAILED has a line for each frame of the stack, from the inside outwards: the name of the
// program or library, a blank, and the name of the function where it is known. Where the program crashes, ALGAE_FAULT_CRASH has the same.
//
// With faults of memory no thread begins, as the child of a fork has none, and as allocations of two threads have no order.
//
// glibc's own names of its functions are called, so no call is needed to find them.

#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

enum Kind { nothing, memory, full, broken, shortened, killed };
static enum Kind kind = nothing;
static long wanted = 0;
static long count = 0;  // of calls of the kind
static int in_main = 0;
static long step = 0;  // forks at each step-th allocation; 0 if it does not fork
static pid_t main_process = 0;

static int is_due(void) { return __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED) == wanted; }

/// Writes the frames of the stack into the file that a variable names.
static void write_frames(const char* variable) {
    const int was_in_main = in_main;
    in_main = 0;
    const char* const path = getenv(variable);
    const int file =
        path ? (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (file >= 0) {
        void* frames[64];
        const int number = backtrace(frames, 64);
        for (int i = 1; i < number; ++i) {
            Dl_info found;
            char line[512];
            if (!dladdr(frames[i], &found) || !found.dli_fname) continue;
            const char* const name = strrchr(found.dli_fname, '/');
            const int length =
                snprintf(line, sizeof line, "%s %s\n", name ? name + 1 : found.dli_fname,
                         found.dli_sname ? found.dli_sname : "");
            if (length > 0)
                syscall(SYS_write, file, line,
                        (size_t)length < sizeof line ? (size_t)length : sizeof line - 1);
        }
        close(file);
    }
    in_main = was_in_main;
}

/// The child of a fork at this allocation returns 1, with its output and its messages in the files of ALGAE_FAULT_OUT and
/// ALGAE_FAULT_ERR. The parent writes "NUMBER STATUS" to descriptor 198 when the child has ended, as wait tells it, returns 0 when it reads
/// a byte from 199, and ends where there is none.
static int fork_here(void) {
    in_main = 0;
    off_t places[64];  // of reading, which the two processes share
    for (int file = 3; file < 64; ++file) places[file] = lseek(file, 0, SEEK_CUR);
    const pid_t child = fork();
    if (child == 0) {
        step = 0;
        kind = nothing;
        close(198);
        close(199);
        alarm(20);
        const char* const paths[] = {getenv("ALGAE_FAULT_OUT"), getenv("ALGAE_FAULT_ERR")};
        for (int i = 0; i < 2; ++i) {
            const int file = (int)syscall(SYS_openat, AT_FDCWD, paths[i] ? paths[i] : "/dev/null",
                                          O_WRONLY | O_CREAT | O_TRUNC, 0666);
            dup2(file, 1 + i);
            close(file);
        }
        in_main = 1;
        return 1;
    }
    int status = -1;
    if (child > 0) waitpid(child, &status, 0);
    for (int file = 3; file < 64; ++file)
        if (places[file] >= 0) lseek(file, places[file], SEEK_SET);
    char text[64];
    const int length = snprintf(text, sizeof text, "%ld %d\n", count, status);
    char go;
    if (syscall(SYS_write, 198, text, (size_t)length) != length ||
        syscall(SYS_read, 199, &go, (size_t)1) != 1)
        _exit(0);
    in_main = 1;
    return 0;
}

/// Before the first write, and in a process that the program has forked itself: what follows cannot be tried by forks, which would
/// share the files and the pipes.
static void end_forks(void) {
    if (!in_main || step == 0) return;
    char text[64];
    const int length = snprintf(text, sizeof text, "end %ld\n", count);
    syscall(SYS_write, 198, text, (size_t)length);
    if (getpid() != main_process) kill(main_process, SIGKILL);
    _exit(0);
}

static int is_failing(void) {
    if (step == 0) return is_due();
    if (getpid() != main_process) end_forks();
    return ++count >= wanted && (count - wanted) % step == 0 && fork_here();
}

static int no_memory(void) {
    if (!in_main || kind != memory || !is_failing()) return 0;
    write_frames("ALGAE_FAULT_FAILED");
    errno = ENOMEM;
    return 1;
}

void* malloc(size_t bytes) { return no_memory() ? NULL : __libc_malloc(bytes); }
void* calloc(size_t number, size_t bytes) { return no_memory() ? NULL : __libc_calloc(number, bytes); }
void* realloc(void* old, size_t bytes) {
    return bytes > 0 && no_memory() ? NULL : __libc_realloc(old, bytes);
}
void* memalign(size_t alignment, size_t bytes) {
    return no_memory() ? NULL : __libc_memalign(alignment, bytes);
}
void* aligned_alloc(size_t alignment, size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** to, size_t alignment, size_t bytes) {
    void* const made = memalign(alignment, bytes);
    if (!made) return ENOMEM;
    *to = made;
    return 0;
}

static void kill_if_due(void) {
    if (in_main && kind == killed && is_due()) raise(SIGKILL);
}

/// What a write of some bytes does instead: 0 nothing else, -1 it fails, 1 it is short.
static int change_of_write(int file) {
    if (file != STDERR_FILENO) end_forks();
    kill_if_due();
    if (!in_main || file == STDERR_FILENO || kind < full || kind == killed || !is_due()) return 0;
    if (kind == shortened) return 1;
    errno = kind == full ? ENOSPC : EIO;
    return -1;
}

ssize_t write(int file, const void* bytes, size_t number) {
    const int change = change_of_write(file);
    if (change < 0) return -1;
    return syscall(SYS_write, file, bytes, change > 0 && number > 0 ? (size_t)1 : number);
}
ssize_t writev(int file, const struct iovec* pieces, int number) {
    const int change = change_of_write(file);
    if (change < 0) return -1;
    if (change > 0 && number > 0 && pieces[0].iov_len > 0)
        return syscall(SYS_write, file, pieces[0].iov_base, (size_t)1);
    return syscall(SYS_writev, file, pieces, number);
}
int fsync(int file) { return change_of_write(file) < 0 ? -1 : (int)syscall(SYS_fsync, file); }
int rename(const char* from, const char* to) {
    return change_of_write(-1) < 0 ? -1 : (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}
int unlink(const char* path) {
    end_forks();
    kill_if_due();
    return (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
}
int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    if (flags & O_CREAT) {
        end_forks();
        kill_if_due();
    }
    return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

static void write_count(void) {
    const char* const path = getenv("ALGAE_FAULT_COUNT");
    if (!path) return;
    in_main = 0;
    char text[32];
    const int length = snprintf(text, sizeof text, "%ld\n", count);
    const int file = (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file >= 0) {
        syscall(SYS_write, file, text, (size_t)length);
        close(file);
    }
}

/// What happens at a crash; the first frames are this function's, and what the system puts before the frame that crashed.
static void write_crash(int crash, siginfo_t* about, void* context) {
    (void)about;
    (void)context;
    write_frames("ALGAE_FAULT_CRASH");
    signal(crash, SIG_DFL);
    raise(crash);
}

static void watch_crashes(void) {
    void* frame;
    backtrace(&frame, 1);  // loads what it needs while there is memory
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_sigaction = write_crash;
    action.sa_flags = SA_SIGINFO | SA_RESETHAND | SA_NODEFER;
    const int crashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP};
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; ++i)
        sigaction(crashes[i], &action, NULL);
}

int pthread_create(pthread_t* made, const pthread_attr_t* how, void* (*work)(void*), void* given) {
    static int (*next)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    if (kind == memory) return EAGAIN;
    if (!next) *(void**)&next = dlsym(RTLD_NEXT, "pthread_create");
    return next(made, how, work, given);
}

static int (*real_main)(int, char**, char**);
static int counted_main(int number, char** arguments, char** environment) {
    in_main = 1;
    main_process = getpid();
    const int status = real_main(number, arguments, environment);
    end_forks();
    write_count();
    return status;
}

/// Faults begin with main: what the loader and constructors of libraries do is theirs.
int __libc_start_main(int (*main)(int, char**, char**), int number, char** arguments,
                      void (*begin)(void), void (*end)(void), void (*loader_end)(void), void* stack) {
    static const char* const names[] = {"", "memory:", "full:", "broken:", "short:", "kill:"};
    const char* const said = getenv("ALGAE_FAULT");
    for (int i = 1; said && i <= killed; ++i)
        if (strncmp(said, names[i], strlen(names[i])) == 0) {
            kind = (enum Kind)i;
            wanted = atol(said + strlen(names[i]));
        }
    if (said && sscanf(said, "memory:each:%ld:%ld", &wanted, &step) == 2) kind = memory;
    if (said) watch_crashes();
    real_main = main;
    int (*next)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void),
                void (*)(void), void*);
    *(void**)&next = dlsym(RTLD_NEXT, "__libc_start_main");
    return next(counted_main, number, arguments, begin, end, loader_end, stack);
}
