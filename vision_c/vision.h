// SPDX-License-Identifier: GPL-3.0-or-later
/* The camera and the image work of the supervisor: a plain C interface
 * over OpenCV 4, usable from any language.
 *
 * Threads: no function starts a thread, and OpenCV is kept to the calling
 * one; a video back end that has threads of its own has them at ordinary
 * priority, whatever the caller's. The camera (vision_open, vision_grab,
 * vision_close) belongs to one thread at a time; each frame slot belongs to
 * one thread at a time; the caller sees to both. Different slots may be used
 * by different threads at once.
 *
 * Errors: every function returns a vision_status; no C++ exception leaves.
 *
 * Coordinates: pixels of the whole image, sub-pixel, x to the right and y
 * down, (0, 0) the centre of the top left pixel.
 */
#ifndef VISION_H
#define VISION_H

#ifdef __cplusplus
extern "C" {
#endif

/* Frame slots, numbered from 0. */
#define VISION_SLOTS 6

/* The largest frame accepted from a source, in pixels a side. */
#define VISION_MAX_SIDE 8192

typedef enum {
  VISION_OK = 0,
  VISION_NOT_FOUND = 1,   /* nothing wrong: no arena, no robot */
  VISION_NO_CAMERA = 2,   /* the source cannot be opened, or is not open */
  VISION_NO_IMAGE = 3,    /* the source delivered nothing usable */
  VISION_TOO_SMALL = 4,   /* the caller's buffer cannot hold the result */
  VISION_BAD_ARGUMENT = 5,
  VISION_FAILED = 6       /* OpenCV failed inside, or the camera's JPEG
                             cannot be decoded */
} vision_status;

typedef enum {
  VISION_MARKER_ARUCO = 0,    /* DICT_4X4_1000 */
  VISION_MARKER_TRIANGLE = 1  /* white triangle, identifier 0 */
} vision_marker;

typedef struct { double x, y; } vision_point;

/* The four inner corners of the arena's white border, in the order top
 * left, top right, bottom right, bottom left as the image shows them: the
 * side from the first to the second is that which, with the side opposite,
 * runs most to the right, however the field lies. */
typedef struct { vision_point corner[4]; } vision_arena;

/* A square of the image: its middle, and half its side. */
typedef struct {
  vision_point centre;
  double reach;
} vision_area;

typedef struct {
  int id;                  /* 0 .. 999; 0 for a triangle */
  vision_point centre;     /* of the marker */
  vision_point direction;  /* the point that the robot looks at */
  double angle;            /* atan2 (cy - dy, cx - dx), degrees, (-180, 180] */
} vision_robot;

/* Opens SOURCE: a camera number, a device path, a file (still image or
 * video, replayed in a loop), a URL, or a GStreamer pipeline (text with a
 * '!'). WIDTH, HEIGHT and FPS are asked of a camera; every frame is scaled
 * to fit WIDTH x HEIGHT, its proportions kept, when the source delivers
 * another size. SOURCE stays the caller's. An open source is closed first.
 * May take as long as the source does, 5 s at most for a URL (7 s where
 * damaged images come).
 * VISION_NO_CAMERA when it cannot be opened or gives no first image.
 *
 * Where the source has JPEG itself (Motion JPEG in an HTTP stream or a file,
 * a V4L2 camera that grants MJPG), that is what is stored: it is decoded in
 * the first function that needs pixels, in its thread, and encoded again
 * only where something has been drawn in it or its size is not that asked
 * for. */
vision_status vision_open(const char *source, int width, int height, int fps);

/* Waits for the next image of the open source and stores it in SLOT.
 * Paced by the source; a file is paced at its own rate (a still image at
 * 25 a second). VISION_NO_IMAGE when a URL ends, or after 2 s without an
 * image (4 s where damaged ones came), where the source lets itself be
 * interrupted. Damaged: no image, or, of a JPEG, a head from which nothing
 * can be decoded; one that is damaged or ends further behind is stored.
 * What a live source delivers waits in buffers of the system and grows old
 * there unless it is grabbed as fast as it comes. */
vision_status vision_grab(int slot);

/* What the open source delivers, such as "MJPG 640x480, 30 a second": the
 * format, the size and, where the source says it, the rate that it granted;
 * empty for a still image and where none is open. Never null, valid until the
 * next call from this thread. */
const char *vision_format(void);

/* Closes the source; does nothing when none is open. */
vision_status vision_close(void);

/* The size of the image in SLOT. As with all that follow:
 * VISION_BAD_ARGUMENT when nothing was ever stored there. */
vision_status vision_size(int slot, int *width, int *height);

/* Finds the arena in the image of SLOT: a plain 4:3 field in a brighter
 * border of any width and brightness, either side up, from a third of the
 * image's width. Robots, things and shadows may be on it; the lens may bend
 * its sides, which meet in the corners. VISION_NOT_FOUND if none. */
vision_status vision_find_arena(int slot, vision_arena *arena);

/* Finds the robots in the image of SLOT, inside ARENA unless it is null
 * (their centre; a fiftieth of its width outside is tolerated), and writes
 * at most CAPACITY of them, lowest identifier first; COUNT is how many were
 * written. VISION_NOT_FOUND with COUNT 0 if none. A marker needs a side of
 * 10 to 12 pixels (of less than 9 it is none) and a white margin of a quarter
 * of a module; one whose identifier is in doubt is not named. Its centre is
 * the middle of its first and third corner, its direction the middle of its
 * first and second. */
vision_status vision_find_robots(int slot, vision_marker marker,
                                 const vision_arena *arena,
                                 vision_robot *robots, int capacity,
                                 int *count);

/* The same where the robots are known to be: in AREAS only, as long as the
 * rest of the image (or of the arena) looks as it did when the calling thread
 * searched it last, here or in vision_find_robots. VISION_NOT_FOUND, too,
 * where it does not: search everywhere then. An area's search ends with as
 * many robots as the calling thread found there last. What is found is found
 * with the same result. */
vision_status vision_follow_robots(int slot, vision_marker marker,
                                   const vision_arena *arena,
                                   const vision_area *areas, int area_count,
                                   vision_robot *robots, int capacity,
                                   int *count);

/* Draw into the image of SLOT; after the searches, from which drawings hide
 * what they look for. */
vision_status vision_draw_arena(int slot, const vision_arena *arena);
vision_status vision_draw_robot(int slot, const vision_robot *robot);

/* Writes the image of SLOT as JPEG into BUFFER of CAPACITY bytes; LENGTH is
 * how many were written. The camera's own bytes, up to the end of the image,
 * whatever QUALITY says, where they show the image as it is to be, fit, and
 * are what any viewer takes: one scan, Huffman's code with its tables, an
 * end, no marker that is out of place. Else the image is encoded, QUALITY
 * 1 .. 100. VISION_TOO_SMALL when it does not fit (what BUFFER holds is
 * undefined then). */
vision_status vision_encode(int slot, int quality, unsigned char *buffer,
                            int capacity, int *length);

/* Stores an image from memory in SLOT: 8-bit BGR, rows of WIDTH * 3 bytes
 * without padding. The memory stays the caller's. */
vision_status vision_load(int slot, const unsigned char *bgr, int width,
                          int height);

/* Stores a JPEG from memory in SLOT, as vision_grab does with a camera's,
 * to be fitted to WIDTH x HEIGHT. The memory stays the caller's.
 * VISION_NO_IMAGE when it is damaged. */
vision_status vision_load_jpeg(int slot, const unsigned char *jpeg,
                               int length, int width, int height);

/* What went wrong last in the calling thread, for a log: never null, valid
 * until the next call from this thread. */
const char *vision_reason(void);

/* The version of OpenCV in use, such as "4.6.0". Static. */
const char *vision_library(void);

#ifdef __cplusplus
}
#endif

#endif
