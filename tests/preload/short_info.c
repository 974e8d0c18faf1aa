// SPDX-License-Identifier: GPL-3.0-or-later
// A kernel that says little of a connection: preloaded, it gives the first 4
// bytes of TCP_INFO, as an emulated one does.

#define _GNU_SOURCE

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

int getsockopt(int socket, int level, int name, void *restrict value,
               socklen_t *restrict length) {
  if (level == IPPROTO_TCP && name == TCP_INFO && *length > 4)
    *length = 4;
  return (int)syscall(SYS_getsockopt, socket, level, name, value, length);
}
