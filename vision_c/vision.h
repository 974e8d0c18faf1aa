// SPDX-License-Identifier: GPL-3.0-or-later
/* The camera and the image processing of the supervisor: a plain C interface
 * to OpenCV 4, usable from any language.
 *
 * Threads: no function starts a thread, and OpenCV runs in the calling thread
 * only; threads of a video back end run at ordinary priority, whatever the
 * caller's. The camera (vision_open, vision_grab, vision_close) belongs to
 * one thread at a time, and so does each frame slot; the caller ensures both.
 * Different threads may use different slots at the same time.
 *
 * Errors: every function returns a vision_status and throws no C++ exception.
 * VISION_BAD_ARGUMENT too for an image of a slot in which none was stored.
 *
 * Coordinates: sub-pixel, in pixels of the whole image, x to the right and y
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

/* The four inner corners of the arena's white border, in the order top left,
 * top right, bottom right, bottom left in the image. Top is the side that,
 * with its opposite side, is closest to pointing right. */
typedef struct { vision_point corner[4]; } vision_arena;

/* A square of the image: its centre, and half its side. */
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

/* Opens SOURCE: a camera number, a device path, a file (still image or video,
 * replayed in a loop), a URL, or a GStreamer pipeline (text with a '!').
 * WIDTH, HEIGHT and FPS are requested from a camera; an image of another size
 * is scaled to fit WIDTH x HEIGHT with its aspect ratio. SOURCE remains the
 * caller's. An open source is closed first. Waits for the source, for a URL
 * at most 5 s (7 s with damaged images). VISION_NO_CAMERA if it cannot be
 * opened or delivers no image.
 *
 * JPEG from the source (Motion JPEG in an HTTP stream or a file, a V4L2
 * camera that grants MJPG) is stored as it is. The first function that needs
 * pixels decodes it, in its own thread. It is encoded again only if something
 * has been drawn into it or its size is not the requested one.
 */
vision_status vision_open(const char *source, int width, int height, int fps);

/* Waits for the next image of the open source and stores it in SLOT. Paced by
 * the source; a file is paced at its own rate (a still image at 25 per
 * second). VISION_NO_IMAGE when a URL ends, or after 2 s without an image (4
 * s with damaged images), if the source can be interrupted. Damaged: no
 * image, or a JPEG whose header cannot be decoded; a JPEG that is damaged or
 * truncated after its header is stored. Images of a live source must be
 * grabbed as fast as they arrive; otherwise they age in buffers of the
 * system. */
vision_status vision_grab(int slot);

/* The format, size and granted rate (if known) of the open source, such as
 * "MJPG 640x480, 30 a second"; empty for a still image and if none is open.
 * Never null, valid until the next call from this thread. */
const char *vision_format(void);

/* Closes the source; no effect if none is open. */
vision_status vision_close(void);

/* Finds the arena in the image of SLOT: a plain 4:3 field with a brighter
 * border of any width and brightness, in any orientation, at least a third of
 * the image's width. Robots, objects and shadows may be on it; lens
 * distortion may bend its sides. VISION_NOT_FOUND if there is none. */
vision_status vision_find_arena(int slot, vision_arena *arena);

/* Finds the robots in the image of SLOT; unless ARENA is null, only those
 * with their centre inside (tolerance: a fiftieth of its width). Writes at
 * most CAPACITY of them, lowest identifier first; COUNT is the number
 * written. VISION_NOT_FOUND with COUNT 0 if there is none. A marker needs a
 * side of 10 to 12 pixels (below 9 it is rejected) and a white margin of a
 * quarter of a module; it is not reported if its identifier is uncertain. Its
 * centre is the midpoint of its first and third corner, its direction the
 * midpoint of its first and second.
 *
 * Unless AREAS is null, searches AREAS only, near known places of the robots,
 * if the rest of the image (or arena) has not changed since the calling
 * thread's last search. Otherwise VISION_NOT_FOUND: search the whole image
 * then. The search of an area ends when it has found as many robots as the
 * last search there. The results are those of a search of the whole image. */
vision_status vision_find_robots(int slot, vision_marker marker,
                                 const vision_arena *arena,
                                 vision_robot *robots, int capacity,
                                 int *count, const vision_area *areas,
                                 int area_count);

/* Draw into the image of SLOT; after the searches, as drawings hide the
 * robots and the arena. */
vision_status vision_draw_arena(int slot, const vision_arena *arena);
vision_status vision_draw_robot(int slot, const vision_robot *robot);

/* Writes the image of SLOT as JPEG into BUFFER of CAPACITY bytes; LENGTH is
 * the number written. The camera's own bytes, up to the end of the image, are
 * used, whatever QUALITY, if they show the image as required, fit, and any
 * viewer can read them: one scan, Huffman code with its tables, an end, no
 * misplaced marker. Otherwise the image is encoded, QUALITY 1 .. 100.
 * VISION_TOO_SMALL if it does not fit (the contents of BUFFER are then
 * undefined). */
vision_status vision_encode(int slot, int quality, unsigned char *buffer,
                            int capacity, int *length);

/* Writes a page (SVG, A4) of markers to the file DESCRIPTOR: that of the
 * identifier FIRST, 0 .. 999, and those after it, as many as fit, each with a
 * black frame of SIDE mm, 20 .. 140, and a white margin of one module up to a
 * line to cut along. VISION_FAILED if it cannot be written. */
vision_status vision_print_markers(int descriptor, int first, int side);

/* The last error of the calling thread, for a log: never null, valid until
 * the next call from this thread. */
const char *vision_reason(void);

#ifdef __cplusplus
}
#endif

#endif
