// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of the supervisor's orders and answers: a program that does nothing
// but forward.
//
//   forwarder DEVICE PRIORITY
//      prints "listening on PORT", serves one connection; what comes
//      from there is written to DEVICE, and back
//
// PRIORITY: of SCHED_FIFO, 0 for an ordinary process.

#define _GNU_SOURCE
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

static int line, connection;

static void fail(const char *what) {
  perror(what);
  exit(1);
}

static void prefer_real_time(int priority) {
  const struct sched_param parameter = {.sched_priority = priority};
  if (priority == 0)
    return;  // an ordinary user's limit would leave no room for stacks
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
    fail("sched_setscheduler");
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    fputs("forwarder: memory not locked\n", stderr);
}

static void open_line(const char *device) {
  struct termios raw;
  line = open(device, O_RDWR | O_NOCTTY);
  if (line < 0 || tcgetattr(line, &raw) != 0)
    fail(device);
  cfmakeraw(&raw);
  cfsetspeed(&raw, B9600);
  if (tcsetattr(line, TCSANOW, &raw) != 0)
    fail(device);
}

static int start_server(void) {
  struct sockaddr_in place = {.sin_family = AF_INET,
                              .sin_addr = {htonl(INADDR_LOOPBACK)}};
  socklen_t size = sizeof place;
  const int server = socket(AF_INET, SOCK_STREAM, 0);
  if (server < 0 || bind(server, (struct sockaddr *)&place, size) != 0 ||
      listen(server, 1) != 0 ||
      getsockname(server, (struct sockaddr *)&place, &size) != 0)
    fail("server");
  fprintf(stderr, "listening on 127.0.0.1:%d\n", ntohs(place.sin_port));
  return server;
}

// From FROM to TO, until the end of either.
static void copy(int from, int to) {
  char data[4096];
  for (;;) {
    const ssize_t got = read(from, data, sizeof data);
    if (got <= 0 || write(to, data, (size_t)got) != got)
      return;
  }
}

static void *copy_back(void *unused) {
  copy(line, connection);
  return unused;
}

static void forward(int server) {
  const int yes = 1;
  pthread_t unused;
  connection = accept(server, NULL, NULL);
  if (connection < 0 || setsockopt(connection, IPPROTO_TCP, TCP_NODELAY,
                                   &yes, sizeof yes) != 0)
    fail("accept");
  // inherits policy and priority
  if (pthread_create(&unused, NULL, copy_back, NULL) != 0)
    fail("pthread_create");
  copy(connection, line);
}

int main(int count, char **arguments) {
  if (count != 3) {
    fputs("usage: forwarder DEVICE PRIORITY\n", stderr);
    return 2;
  }
  open_line(arguments[1]);
  const int server = start_server();
  prefer_real_time(atoi(arguments[2]));
  forward(server);
  return 0;
}
