// SPDX-License-Identifier: GPL-3.0-or-later
// A V4L2 camera for one process: preloaded, it is what /dev/video0 and so on
// stand for. It behaves as the kernel's documentation of the streaming
// interface has it, and as the file $V4L2_CAMERA says, which is read again and
// again:
//
//   format MJPG|YUYV          the only one it grants
//   size WIDTH HEIGHT         likewise
//   rate NUMBER DENOMINATOR   images a second, likewise
//   image PATH                the bytes of each image
//   broken N                  each Nth is nonsense (0: none)
//   state on|busy|gone|meta   busy: in use by somebody else; gone: unplugged;
//                             meta: the other node of a camera

#define _GNU_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

#include <linux/videodev2.h>

enum { most_buffers = 8, image_limit = 8 << 20 };

struct settings {
  char format[8], image[256], state[8];
  unsigned width, height, number, denominator, broken;
};

struct buffer {
  unsigned char *start;
  bool queued, done;
  int64_t since;       // nanoseconds: when it was queued
  unsigned sequence;   // of the image in it
  unsigned used;       // bytes
};

static int device = -1;  // readable when the next image is complete
static struct settings granted;
static struct buffer buffers[most_buffers];
static unsigned buffer_count;
static unsigned char *image;  // mapped
static unsigned image_size;
static int64_t begun;  // the stream, 0: none
static unsigned ticks;

static bool is_camera(const char *path) {
  return getenv("V4L2_CAMERA") != NULL &&
         strncmp(path, "/dev/video", 10) == 0;
}

static void read_settings(struct settings *into) {
  char line[400];
  FILE *const file = fopen(getenv("V4L2_CAMERA"), "re");
  memset(into, 0, sizeof *into);
  strcpy(into->state, "gone");
  if (file == NULL)
    return;
  while (fgets(line, sizeof line, file) != NULL) {
    sscanf(line, "format %7s", into->format);
    sscanf(line, "size %u %u", &into->width, &into->height);
    sscanf(line, "rate %u %u", &into->number, &into->denominator);
    sscanf(line, "image %255s", into->image);
    sscanf(line, "broken %u", &into->broken);
    sscanf(line, "state %7s", into->state);
  }
  fclose(file);
}

static bool is_in_state(const char *name) {
  struct settings now;
  read_settings(&now);
  return strcmp(now.state, name) == 0;
}

static int failure(int reason) {
  errno = reason;
  return -1;
}

static int64_t nanoseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * INT64_C(1000000000) + now.tv_nsec;
}

static int64_t interval(void) {
  return INT64_C(1000000000) * granted.denominator / granted.number;
}

static unsigned length(void) {  // of a buffer
  return granted.width * granted.height * 2;
}

// ------------------------------------------------------------ The stream

static void set_timer(int64_t period) {
  const struct timespec time = {period / 1000000000, period % 1000000000};
  const struct itimerspec timer = {time, time};
  timerfd_settime(device, 0, &timer, NULL);
}

static void stop(void) {
  set_timer(0);
  begun = 0;
  for (unsigned i = 0; i < most_buffers; ++i)
    buffers[i].queued = buffers[i].done = false;
}

// An image has been read out of the sensor, which takes as long as the
// interval: into a buffer that was there when it began, else it is lost.
static void complete(int64_t end) {
  struct buffer *to = NULL;
  ++ticks;
  for (unsigned i = 0; i < buffer_count; ++i)
    if (buffers[i].queued && !buffers[i].done &&
        buffers[i].since <= end - interval() &&
        (to == NULL || buffers[i].since < to->since))
      to = &buffers[i];
  if (to == NULL)
    return;
  to->done = true;
  to->sequence = ticks;
  to->used = image_size < length() ? image_size : length();
  memcpy(to->start, image, to->used);
  if (granted.broken > 0 && ticks % granted.broken == 0)
    for (unsigned i = 0; i < to->used; ++i)
      to->start[i] = (unsigned char)(i * 7 + ticks);
}

static int dequeue(struct v4l2_buffer *into) {
  uint64_t passed;
  struct buffer *first = NULL;
  if (begun == 0)
    return failure(EINVAL);
  if (read(device, &passed, sizeof passed) == sizeof passed)
    for (; passed > 0; --passed)
      complete(begun + (int64_t)(ticks + 1) * interval());
  for (unsigned i = 0; i < buffer_count; ++i)
    if (buffers[i].done &&
        (first == NULL || buffers[i].sequence < first->sequence))
      first = &buffers[i];
  if (first == NULL)
    return failure(EAGAIN);
  first->queued = first->done = false;
  into->index = (unsigned)(first - buffers);
  into->bytesused = first->used;
  into->length = length();
  into->sequence = first->sequence;
  into->m.offset = into->index * image_limit;
  return 0;
}

// ------------------------------------------------------------ The device

static int open_device(void) {
  int file;
  struct stat facts;
  struct settings now;
  read_settings(&now);
  if (strcmp(now.state, "gone") == 0)
    return failure(ENOENT);
  if (device >= 0)
    return failure(EBUSY);
  file = (int)syscall(SYS_openat, AT_FDCWD, now.image, O_RDONLY | O_CLOEXEC);
  if (file < 0 || fstat(file, &facts) != 0)
    return failure(EIO);
  image_size = (unsigned)facts.st_size;
  image = (unsigned char *)syscall(SYS_mmap, NULL, (size_t)image_size, PROT_READ,
                                   MAP_PRIVATE, file, (off_t)0);
  syscall(SYS_close, file);
  granted = now;
  buffer_count = 0;
  device = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  return device;
}

static void fill(struct v4l2_format *format) {
  struct v4l2_pix_format *const pix = &format->fmt.pix;
  memset(pix, 0, sizeof *pix);
  memcpy(&pix->pixelformat, granted.format, 4);
  pix->width = granted.width;
  pix->height = granted.height;
  pix->field = V4L2_FIELD_NONE;
  pix->bytesperline =
      strcmp(granted.format, "YUYV") == 0 ? granted.width * 2 : 0;
  pix->sizeimage = length();
}

static int request_buffers(struct v4l2_requestbuffers *request) {
  if (request->memory != V4L2_MEMORY_MMAP)
    return failure(EINVAL);
  if (is_in_state("busy") || begun != 0)
    return failure(EBUSY);
  if (request->count > 4)
    request->count = 4;
  buffer_count = request->count;
  return 0;
}

static int queue(const struct v4l2_buffer *from) {
  if (from->index >= buffer_count || buffers[from->index].queued)
    return failure(EINVAL);
  buffers[from->index].queued = true;
  buffers[from->index].since = nanoseconds();
  return 0;
}

static int do_ioctl(unsigned long request, void *argument) {
  if (is_in_state("gone"))
    return failure(ENODEV);
  switch (request) {
  case VIDIOC_QUERYCAP: {
    struct v4l2_capability *const to = argument;
    memset(to, 0, sizeof *to);
    strcpy((char *)to->driver, "v4l2_camera");
    strcpy((char *)to->card, "A camera of the tests");
    to->device_caps =
        V4L2_CAP_STREAMING | (is_in_state("meta") ? V4L2_CAP_META_CAPTURE
                                                      : V4L2_CAP_VIDEO_CAPTURE);
    to->capabilities = to->device_caps | V4L2_CAP_DEVICE_CAPS;
    return 0;
  }
  case VIDIOC_ENUM_FMT: {
    struct v4l2_fmtdesc *const to = argument;
    if (to->index > 0)
      return failure(EINVAL);
    memcpy(&to->pixelformat, granted.format, 4);
    return 0;
  }
  case VIDIOC_S_FMT:
    // while there are buffers, or somebody else streams
    if (buffer_count > 0 || is_in_state("busy"))
      return failure(EBUSY);
    fill(argument);
    return 0;
  case VIDIOC_G_FMT:
  case VIDIOC_TRY_FMT:
    fill(argument);
    return 0;
  case VIDIOC_S_PARM:
    if (begun != 0)
      return failure(EBUSY);
    /* fall through */
  case VIDIOC_G_PARM: {
    struct v4l2_streamparm *const to = argument;
    to->parm.capture.capability = V4L2_CAP_TIMEPERFRAME;
    to->parm.capture.timeperframe.numerator = granted.denominator;
    to->parm.capture.timeperframe.denominator = granted.number;
    return 0;
  }
  case VIDIOC_REQBUFS:
    return request_buffers(argument);
  case VIDIOC_QUERYBUF: {
    struct v4l2_buffer *const to = argument;
    if (to->index >= buffer_count)
      return failure(EINVAL);
    to->length = length();
    to->m.offset = to->index * image_limit;
    return 0;
  }
  case VIDIOC_QBUF:
    return queue(argument);
  case VIDIOC_DQBUF:
    return dequeue(argument);
  case VIDIOC_STREAMON:
    begun = nanoseconds();
    ticks = 0;
    set_timer(interval());
    return 0;
  case VIDIOC_STREAMOFF:
    stop();
    return 0;
  case VIDIOC_G_INPUT:
    *(int *)argument = 0;
    return 0;
  case VIDIOC_S_INPUT:
    return 0;
  case VIDIOC_QUERYCTRL:
  case VIDIOC_G_CTRL:
  case VIDIOC_S_CTRL:
    return failure(EINVAL);  // it has no controls
  default:
    return failure(ENOTTY);
  }
}

static int facts_of_device(struct stat *to) {
  if (is_in_state("gone"))
    return failure(ENOENT);
  memset(to, 0, sizeof *to);
  to->st_mode = S_IFCHR | 0660;
  return 0;
}

// ------------------------------------------- In place of the C library's

int open(const char *path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  return is_camera(path)
             ? open_device()
             : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

int open64(const char *path, int flags, ...) __attribute__((alias("open")));
int __open_2(const char *path, int flags) { return open(path, flags); }
int __open64_2(const char *path, int flags) { return open(path, flags); }

int stat(const char *restrict path, struct stat *restrict to) {
  return is_camera(path)
             ? facts_of_device(to)
             : (int)syscall(SYS_newfstatat, AT_FDCWD, path, to, 0);
}

// the same where this runs
int stat64(const char *restrict path, struct stat64 *restrict to)
    __attribute__((alias("stat")));

int ioctl(int file, unsigned long request, ...) {
  va_list rest;
  void *argument;
  va_start(rest, request);
  argument = va_arg(rest, void *);
  va_end(rest);
  return file >= 0 && file == device
             ? do_ioctl(request, argument)
             : (int)syscall(SYS_ioctl, file, request, argument);
}

void *mmap(void *where, size_t size, int access, int flags, int file,
           off_t offset) {
  if (file >= 0 && file == device) {
    void *const place =
        (void *)syscall(SYS_mmap, where, size, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, (off_t)0);
    buffers[offset / image_limit].start = place;
    return place;
  }
  return (void *)syscall(SYS_mmap, where, size, access, flags, file, offset);
}

void *mmap64(void *where, size_t size, int access, int flags, int file,
             off64_t offset) __attribute__((alias("mmap")));

int close(int file) {
  if (file >= 0 && file == device) {
    stop();
    syscall(SYS_munmap, image, image_size);
    buffer_count = 0;
    device = -1;
  }
  return (int)syscall(SYS_close, file);
}
