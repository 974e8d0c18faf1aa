// SPDX-License-Identifier: GPL-3.0-or-later
// The source of images: a camera, a file, a URL or a GStreamer pipeline.

#include "vision_internal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <errno.h>
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/stat.h>
#include <time.h>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace vision {

namespace {

constexpr int open_limit = 3000;  // milliseconds, of a URL
constexpr int read_limit = 2000;  // the first image comes after the opening
constexpr double still_rate = 25.0;  // images a second
constexpr int large = 1 << 20;       // bytes

enum class Kind { none, still, video, live };

struct Source {
  Kind kind = Kind::none;
  cv::VideoCapture capture;
  cv::Mat raw;           // as delivered
  bool waiting = false;  // RAW holds an image that has not been grabbed
  cv::Mat still;         // as scaled
  std::string name;
  int backend = cv::CAP_FFMPEG;
  int width = 0, height = 0;
  long period = 0;         // nanoseconds between the images of a file
  timespec next{0, 0};     // when the next one is due
};

// Never destroyed, for the reason that vision::frame gives.
Source &source() {
  static Source *const the_source = new Source;
  return *the_source;
}

// Before main, as the environment may only be changed while there is one
// thread. What the user has set stays.
struct Settings {
  Settings() {
    // The reason of a failure is returned, not printed.
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "2", 0);  // seconds
    // An image of 4K is given back to the system when it is no longer
    // needed. The C library would else keep all large memory from then on.
    mallopt(M_MMAP_THRESHOLD, large);
    if (std::getenv("OPENCV_LOG_LEVEL") == nullptr)
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  }
} const settings;

// Makes the calling thread an ordinary one for a while, because the threads
// that a video back end starts inherit the policy of their creator.
class Time_Sharing {
public:
  Time_Sharing() {
    changed = pthread_getschedparam(pthread_self(), &policy, &parameter) ==
                  0 &&
              policy != SCHED_OTHER;
    if (changed) {
      sched_param ordinary{};
      changed =
          pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary) == 0;
    }
  }

  ~Time_Sharing() {
    if (changed)
      pthread_setschedparam(pthread_self(), policy, &parameter);
  }

  Time_Sharing(const Time_Sharing &) = delete;
  Time_Sharing &operator=(const Time_Sharing &) = delete;

private:
  int policy = SCHED_OTHER;
  sched_param parameter{};
  bool changed = false;
};

void close(Source &from) {
  from.kind = Kind::none;
  from.waiting = false;
  from.capture.release();
  from.raw.release();
  from.still.release();
}

// Scales FROM to fit WIDTH x HEIGHT, into TO; false where FROM is nothing
// that an image of ours can be made of.
bool fit(cv::Mat &from, cv::Mat &to, int width, int height) {
  if (from.dims != 2 || from.empty() || from.depth() != CV_8U ||
      from.cols > VISION_MAX_SIDE || from.rows > VISION_MAX_SIDE)
    return false;
  if (from.channels() == 1)
    cv::cvtColor(from, from, cv::COLOR_GRAY2BGR);
  else if (from.channels() == 4)
    cv::cvtColor(from, from, cv::COLOR_BGRA2BGR);
  else if (from.channels() != 3)
    return false;

  const double scale = std::min(double(width) / from.cols,
                                double(height) / from.rows);
  const cv::Size size(std::max(1, cvRound(from.cols * scale)),
                      std::max(1, cvRound(from.rows * scale)));
  if (size == from.size())
    std::swap(from, to);  // the buffers go round, nothing is copied
  else
    cv::resize(from, to, size, 0, 0,
               scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return true;
}

bool is_number(const std::string &name) {
  return name.size() <= 4 &&
         name.find_first_not_of("0123456789") == std::string::npos;
}

bool start(Source &from) {
  const Time_Sharing while_threads_start;
  if (is_number(from.name))
    return from.capture.open(std::stoi(from.name), from.backend);
  if (from.backend == cv::CAP_FFMPEG)
    return from.capture.open(from.name, cv::CAP_FFMPEG,
                             {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, open_limit,
                              cv::CAP_PROP_READ_TIMEOUT_MSEC, read_limit});
  return from.capture.open(from.name, from.backend);
}

// Decides what the name stands for.
void classify(Source &from, bool &image_file) {
  struct stat file{};
  const bool exists = stat(from.name.c_str(), &file) == 0;
  image_file = false;
  from.kind = Kind::live;
  if (is_number(from.name) || (exists && S_ISCHR(file.st_mode))) {
    from.backend = cv::CAP_V4L2;
  } else if (exists && S_ISREG(file.st_mode)) {
    from.kind = Kind::video;
    from.backend = cv::CAP_FFMPEG;
    image_file = cv::haveImageReader(from.name);
  } else if (from.name.find('!') != std::string::npos) {
    from.backend = cv::CAP_GSTREAMER;
  } else if (from.name.find("://") != std::string::npos) {
    from.backend = cv::CAP_FFMPEG;
  } else {
    from.kind = Kind::none;
  }
}

void pace(Source &from, double rate) {
  from.period = std::lround(1e9 / rate);
  clock_gettime(CLOCK_MONOTONIC, &from.next);
}

double seconds() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

// Waits until the next image of a file is due. After a delay the pace starts
// anew: images that are late are not made up for.
void wait(Source &from) {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double late = double(now.tv_sec - from.next.tv_sec) * 1e9 +
                      double(now.tv_nsec - from.next.tv_nsec);
  if (late > double(from.period))
    from.next = now;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &from.next,
                         nullptr) == EINTR) {
  }
  const long nanoseconds = from.next.tv_nsec + from.period;
  from.next.tv_sec += nanoseconds / 1000000000L;
  from.next.tv_nsec = nanoseconds % 1000000000L;
}

// Empty where there is no image to be read. OpenCV throws where a file says
// that it holds an absurdly large one.
cv::Mat read_still(const std::string &name) {
  try {
    return cv::imread(name, cv::IMREAD_COLOR);
  } catch (const cv::Exception &) {
    return {};
  }
}

vision_status open_still(Source &from) {
  cv::Mat image = read_still(from.name);
  if (!fit(image, from.still, from.width, from.height))
    return fail(VISION_NO_CAMERA, "%s: no image that can be read",
                from.name.c_str());
  from.kind = Kind::still;
  pace(from, still_rate);
  return VISION_OK;
}

vision_status open_stream(Source &from, int fps) {
  if (!start(from))
    return fail(VISION_NO_CAMERA, "%s: cannot be opened", from.name.c_str());
  if (from.backend == cv::CAP_V4L2) {
    from.capture.set(cv::CAP_PROP_FRAME_WIDTH, from.width);
    from.capture.set(cv::CAP_PROP_FRAME_HEIGHT, from.height);
    from.capture.set(cv::CAP_PROP_FPS, fps);
    from.capture.set(cv::CAP_PROP_BUFFERSIZE, 1);  // nothing old
  }
  if (!from.capture.read(from.raw) || from.raw.empty())
    return fail(VISION_NO_CAMERA, "%s: gives no image", from.name.c_str());
  if (from.kind == Kind::video) {
    const double rate = from.capture.get(cv::CAP_PROP_FPS);
    pace(from, rate >= 1.0 && rate <= 240.0 ? rate : still_rate);
    from.waiting = true;
  }
  return VISION_OK;
}

bool read_once(Source &from) {
  return from.capture.read(from.raw) && !from.raw.empty();
}

// Reads the next image into RAW. A file that ends begins again; a live source
// may deliver a damaged image now and then.
bool read(Source &from) {
  constexpr int attempts = 3;
  constexpr double patience = 1.0;  // seconds, for all but the last
  if (from.waiting) {
    from.waiting = false;
    return true;
  }
  if (from.kind == Kind::video) {
    if (read_once(from))
      return true;
    from.capture.release();
    return start(from) && read_once(from);
  }
  const double begin = seconds();
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (read_once(from))
      return true;
    if (seconds() - begin > patience)
      return false;  // nothing came at all
  }
  return false;
}

}  // namespace

}  // namespace vision

using vision::fail;
using vision::Frame;
using vision::guarded;
using vision::Kind;
using vision::Source;

extern "C" {

vision_status vision_open(const char *source, int width, int height,
                          int fps) {
  vision_close();
  const vision_status status = guarded([&] {
    if (source == nullptr || *source == '\0' || width < 1 || height < 1 ||
        width > VISION_MAX_SIDE || height > VISION_MAX_SIDE || fps < 1)
      return fail(VISION_BAD_ARGUMENT, "no source, or no size, or no rate");
    vision::frame(0);  // OpenCV's own settings
    Source &here = vision::source();
    here.name = source;
    here.width = width;
    here.height = height;
    bool image_file = false;
    vision::classify(here, image_file);
    if (here.kind == Kind::none)
      return fail(VISION_NO_CAMERA, "%s: no such file, device or URL",
                  source);
    return image_file ? vision::open_still(here)
                      : vision::open_stream(here, fps);
  });
  if (status != VISION_OK)
    guarded([] {
      vision::close(vision::source());
      return VISION_OK;
    });
  return status;
}

vision_status vision_grab(int slot) {
  return guarded([&] {
    Frame *const to = vision::frame(slot);
    Source &from = vision::source();
    if (to == nullptr)
      return fail(VISION_BAD_ARGUMENT, "no slot %d", slot);
    if (from.kind == Kind::none)
      return fail(VISION_NO_CAMERA, "no source is open");
    if (from.kind != Kind::live)
      vision::wait(from);
    if (from.kind == Kind::still) {
      from.still.copyTo(to->image);
      return VISION_OK;
    }
    if (!vision::read(from))
      return fail(VISION_NO_IMAGE, "%s: no image came", from.name.c_str());
    if (!vision::fit(from.raw, to->image, from.width, from.height))
      return fail(VISION_NO_IMAGE, "%s: an image of an unusable kind came",
                  from.name.c_str());
    return VISION_OK;
  });
}

vision_status vision_close(void) {
  return guarded([] {
    vision::close(vision::source());
    return VISION_OK;
  });
}

}  // extern "C"
