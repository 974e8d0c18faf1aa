// SPDX-License-Identifier: GPL-3.0-or-later
// The handlers of crashes (Failures). In C++, as they may run on a
// stack that is used up (-fstack-check would fault again), and read the
// processor's registers; all that they call is safe in a signal handler.

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <termios.h>
#include <time.h>
#include <ucontext.h>
#include <unistd.h>

extern "C" {

// Robot.Serial_Line: the line's descriptor, or -1.
extern int destijl_robot_line;

// The program's own code, from the linker.
extern const char __executable_start, etext;

void destijl_catch_crashes(const unsigned char *frame, int length);

}  // extern "C"

namespace {

unsigned char stop[16];
std::size_t stop_length;

constexpr int caught[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL,
                          SIGABRT, SIGSYS, SIGTRAP};

// What was set before, by GNAT's run time.
struct sigaction before[SIGSYS + 1];

void write_stop(int line) {
  if (line >= 0 && write(line, stop, stop_length) < 0)
    return;  // nothing else can be done
}

// When the process ends the kernel closes the line, and would wait up to 30 s
// for what a device that hangs does not take.
void leave_nothing_unsent(int line) {
  for (int wait = 0; wait < 20; ++wait) {
    int unsent = 0;
    if (ioctl(line, TIOCOUTQ, &unsent) != 0 || unsent <= 0)
      return;
    const timespec pause{0, 5'000'000};
    nanosleep(&pause, nullptr);
  }
  tcflush(line, TCOFLUSH);
}

// No order follows: no task finds a line. If several threads crash at once,
// each writes a stop before it ends the process.
void stop_for_good() {
  static std::atomic<int> known{-1};
  const int line = __atomic_load_n(&destijl_robot_line, __ATOMIC_SEQ_CST);
  if (line >= 0)
    known = line;
  __atomic_store_n(&destijl_robot_line, -1, __ATOMIC_SEQ_CST);
  write_stop(known);
  leave_nothing_unsent(known);
}

bool is_own_code(const void *context) {
  const mcontext_t &machine =
      static_cast<const ucontext_t *>(context)->uc_mcontext;
#if defined(__x86_64__)
  const auto place = reinterpret_cast<const char *>(machine.gregs[REG_RIP]);
#elif defined(__aarch64__)
  const auto place = reinterpret_cast<const char *>(machine.pc);
#else
#error "where is the program counter?"
#endif
  return place >= &__executable_start && place < &etext;
}

void on_crash(int signal, siginfo_t *facts, void *context) {
  const bool is_sent = facts->si_code <= 0;  // by a process, not by a fault
  const bool raises = (before[signal].sa_flags & SA_SIGINFO) != 0;
  if (raises && (is_sent || is_own_code(context))) {
    // A library's fault must not become an exception: it would pass through
    // the library's handlers, with its locks held and its heap damaged.
    write_stop(__atomic_load_n(&destijl_robot_line, __ATOMIC_SEQ_CST));
    before[signal].sa_sigaction(signal, facts, context);
    return;
  }
  stop_for_good();
  struct sigaction fatal{};  // SIG_DFL
  sigaction(signal, &fatal, nullptr);
  raise(signal);  // pending until the handler has ended
}

// The supervisor never calls exit.
void on_exit_by_library() {
  stop_for_good();
  _exit(3);
}

}  // namespace

void destijl_catch_crashes(const unsigned char *frame, int length) {
  stop_length = std::size_t(length) < sizeof stop ? std::size_t(length)
                                                  : sizeof stop;
  std::memcpy(stop, frame, stop_length);
  for (const int signal : caught) {
    sigaction(signal, nullptr, &before[signal]);
    struct sigaction ours = before[signal];
    ours.sa_flags |= SA_SIGINFO;
    ours.sa_sigaction = on_crash;
    sigaction(signal, &ours, nullptr);
  }
  // 32: glibc's own, of pthread_cancel, which sets it when it is first used. Until
  // then it would end the process, and glibc lets no program block or handle it.
  struct {
    void (*handler)(int);
    unsigned long flags;
    void (*restorer)();
    unsigned long mask;
  } ignore{SIG_IGN, 0, nullptr, 0};
  syscall(SYS_rt_sigaction, 32, &ignore, nullptr, sizeof ignore.mask);
  std::atexit(on_exit_by_library);
}
