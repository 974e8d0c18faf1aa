// SPDX-License-Identifier: GPL-3.0-or-later
/* Draws what a camera above the arena would see, with the truth known: for
 * the emulator's camera and for the tests of vision_c. Plain C interface,
 * OpenCV inside; no exception leaves it. Several threads may draw at once,
 * each into a buffer of its own; a thread keeps the still part of its last
 * scene, so that an image in which only robots and noise change is cheap.
 *
 * Coordinates: pixels of the image, (0, 0) the centre of the top left one. */
#ifndef SCENE_H
#define SCENE_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  int marker;      /* 0: ArUco DICT_4X4_1000, 1: white triangle */
  int id;          /* ArUco identifier, 0 .. 999 */
  double x, y;     /* pose in the arena: centimetres from its left and from
                      its bottom inner edge, 0 .. 80 and 0 .. 60 */
  double heading;  /* degrees, counter-clockwise, 0 looks along x */
} scene_robot;

typedef struct {
  int width, height;    /* of the image, pixels */
  int arena;            /* 0: no arena in the scene */
  double fill;          /* arena's outer width over the image's, 0.3 .. 0.95;
                           less in an image too flat for that */
  double turn;          /* degrees clockwise that the arena shows turned */
  double noise;         /* standard deviation of grey noise, 0 .. 30 */
  double blur;          /* Gaussian sigma in pixels, 0 = none */
  double uneven;        /* light lost from the top left to the bottom right
                           corner, as a share, 0 .. 0.7 */
  double lean_x, lean_y; /* what lies at (X, Y) from the image's middle shows
                           at (X, Y) / (1 + lean_x X + lean_y Y), but for the
                           truth below; -0.001 .. 0.001, 0 = from above */
  unsigned seed;        /* of the noise */
  int robots;           /* how many of ROBOT are drawn, 0 .. 4 */
  scene_robot robot[4];
} scene_description;

/* A plain scene: 640 x 480, arena filling 0.85, no disturbance, no robot. */
scene_description scene_default(void);

/* Draws into BGR (WIDTH * HEIGHT * 3 bytes, the caller's). 0 if done, -1
 * when the description is out of its ranges. */
int scene_draw(const scene_description *scene, unsigned char *bgr);

/* Where the truth is in the image, pixels: centre of robot N's marker (a
 * triangle's centroid), the point it looks at (middle of the marker's top
 * edge, or the triangle's tip), and the arena's inner corners (top left,
 * top right, bottom right, bottom left). 0 if done. */
int scene_robot_truth(const scene_description *scene, int n, double *cx,
                      double *cy, double *dx, double *dy);
int scene_arena_truth(const scene_description *scene, double corner_xy[8]);

/* Draws and encodes as JPEG into BUFFER; length, or -1. */
int scene_jpeg(const scene_description *scene, int quality,
               unsigned char *buffer, int capacity);

/* Decodes a JPEG as WIDTH * HEIGHT grey levels. 0 if done, -1 where it is
 * not of that size. */
int scene_decode_grey(const unsigned char *jpeg, int length, int width,
                      int height, unsigned char *grey);

/* Draws the rectangles of an SVG page in mm, SCALE pixels each, into BGR of
 * ROOM bytes. They are subpaths "Mx yhWvHh-Wz", and an attribute fill is
 * before them. 0 if done. */
int scene_page(const char *path, int scale, unsigned char *bgr, int room,
               int *width, int *height);

/* Writes FRAMES images of the scene, their noise changing, as a Motion JPEG
 * video to PATH (.avi). 0 if done. */
int scene_video(const scene_description *scene, int frames, int fps,
                const char *path);

#ifdef __cplusplus
}
#endif

#endif
