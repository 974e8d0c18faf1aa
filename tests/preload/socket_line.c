// SPDX-License-Identifier: GPL-3.0-or-later
// A serial line without the kernel's terminals: preloaded, it opens a socket as
// if it were a device. Only one is open at a time.

#define _GNU_SOURCE

#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int line = -1;
static bool is_output_discarded;

static bool is_line(int file) { return file >= 0 && file == line; }

static bool is_socket(const char *path) {
  struct stat facts;
  return NEXT(stat)(path, &facts) == 0 && S_ISSOCK(facts.st_mode);
}

int open(const char *path, int flags, ...) {
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  if (!is_socket(path) || strlen(path) >= sizeof address.sun_path)
    return NEXT(open)(path, flags, mode);
  line = socket(AF_UNIX, SOCK_STREAM | (flags & O_CLOEXEC ? SOCK_CLOEXEC : 0),
                0);
  is_output_discarded = false;
  strcpy(address.sun_path, path);
  if (connect(line, (struct sockaddr *)&address, sizeof address) != 0) {
    close(line);
    line = -1;
  } else if (flags & O_NONBLOCK) {
    fcntl(line, F_SETFL, O_NONBLOCK);
  }
  return line;
}

int open64(const char *path, int flags, ...) __attribute__((alias("open")));

// Whether the emulator has not yet taken all that was written.
static bool has_unsent(int file) {
  int unsent = 0;
  return ioctl(file, TIOCOUTQ, &unsent) == 0 && unsent > 0;
}

// Waits as the kernel does for a serial device, but without its 30 s.
int close(int file) {
  if (is_line(file)) {
    while (!is_output_discarded && has_unsent(file))
      usleep(1000);
    line = -1;
  }
  return NEXT(close)(file);
}

int ioctl(int file, unsigned long request, ...) {
  va_list rest;
  va_start(rest, request);
  void *argument = va_arg(rest, void *);
  va_end(rest);
  return is_line(file) && request == TCSETS
             ? 0
             : NEXT(ioctl)(file, request, argument);
}

int tcflush(int file, int queue) {
  char waste[256];
  if (!is_line(file))
    return NEXT(tcflush)(file, queue);
  if (queue != TCIFLUSH)
    is_output_discarded = true;
  while (queue != TCOFLUSH && recv(file, waste, sizeof waste, MSG_DONTWAIT) > 0)
    ;
  return 0;
}
