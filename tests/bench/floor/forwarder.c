// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of the supervisor's orders, answers and periods: a program that
// does nothing but forward, and one that does nothing but be on time.
//
//   forwarder forward DEVICE PRIORITY
//      prints "listening on PORT", serves one connection; what comes
//      from there is written to DEVICE, and back
//   forwarder relay DEVICE PRIORITY
//      the same through three threads, which wake each other: what the
//      supervisor's tasks do between the two ends, without their work
//   forwarder tick DEVICE PRIORITY MILLISECONDS
//      writes a byte to DEVICE every so many milliseconds
//   forwarder start
//      prints "listening on PORT" and ends
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
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <termios.h>
#include <time.h>
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

// From one thread to the next
struct hand_over {
  pthread_mutex_t lock;
  pthread_cond_t arrived;
  char data[4096];
  ssize_t length;
};

struct relay {
  int from, to;
  struct hand_over first, second;
};

static void put(struct hand_over *to, const char *data, ssize_t length) {
  pthread_mutex_lock(&to->lock);
  memcpy(to->data, data, (size_t)length);
  to->length = length;
  pthread_cond_signal(&to->arrived);
  pthread_mutex_unlock(&to->lock);
}

static ssize_t take(struct hand_over *from, char *data) {
  pthread_mutex_lock(&from->lock);
  while (from->length == 0)
    pthread_cond_wait(&from->arrived, &from->lock);
  const ssize_t length = from->length;
  memcpy(data, from->data, (size_t)length);
  from->length = 0;
  pthread_mutex_unlock(&from->lock);
  return length;
}

static void *relay_first(void *argument) {
  struct relay *const relay = argument;
  char data[4096];
  for (;;) {
    const ssize_t got = read(relay->from, data, sizeof data);
    if (got <= 0)
      exit(0);
    put(&relay->first, data, got);
  }
}

static void *relay_second(void *argument) {
  struct relay *const relay = argument;
  char data[4096];
  ssize_t length;
  while ((length = take(&relay->first, data)) > 0)
    put(&relay->second, data, length);
  return NULL;
}

static void *relay_third(void *argument) {
  struct relay *const relay = argument;
  char data[4096];
  for (;;) {
    const ssize_t length = take(&relay->second, data);
    if (write(relay->to, data, (size_t)length) != length)
      exit(0);
  }
}

static void start(void *(*thread)(void *), void *argument) {
  pthread_t unused;
  // inherits policy and priority
  if (pthread_create(&unused, NULL, thread, argument) != 0)
    fail("pthread_create");
}

static void *copy_back(void *unused) {
  copy(line, connection);
  return unused;
}

static void forward(int server, int by_threads) {
  const int yes = 1;
  connection = accept(server, NULL, NULL);
  if (connection < 0 || setsockopt(connection, IPPROTO_TCP, TCP_NODELAY,
                                   &yes, sizeof yes) != 0)
    fail("accept");
  if (by_threads) {
    static struct relay there, back;
    there.from = back.to = connection;
    there.to = back.from = line;
    start(relay_third, &there);
    start(relay_second, &there);
    start(relay_third, &back);
    start(relay_second, &back);
    start(relay_first, &back);
    relay_first(&there);
  } else {
    start(copy_back, NULL);
    copy(connection, line);
  }
}

static void tick(long milliseconds) {
  struct timespec next;
  clock_gettime(CLOCK_MONOTONIC, &next);
  for (;;) {
    next.tv_nsec += milliseconds % 1000 * 1000000;
    next.tv_sec += milliseconds / 1000 + next.tv_nsec / 1000000000;
    next.tv_nsec %= 1000000000;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, NULL);
    if (write(line, "w\r", 2) != 2)
      return;
  }
}

int main(int count, char **arguments) {
  if (count == 2 && strcmp(arguments[1], "start") == 0) {
    start_server();
  } else if (count == 4 && (strcmp(arguments[1], "forward") == 0 ||
                            strcmp(arguments[1], "relay") == 0)) {
    open_line(arguments[2]);
    const int server = start_server();
    prefer_real_time(atoi(arguments[3]));
    forward(server, strcmp(arguments[1], "relay") == 0);
  } else if (count == 5 && strcmp(arguments[1], "tick") == 0) {
    open_line(arguments[2]);
    prefer_real_time(atoi(arguments[3]));
    tick(atol(arguments[4]));
  } else {
    fputs("usage: forwarder forward|relay DEVICE PRIORITY\n"
          "       forwarder tick DEVICE PRIORITY MILLISECONDS\n"
          "       forwarder start\n",
          stderr);
    return 2;
  }
  return 0;
}
