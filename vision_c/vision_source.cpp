// SPDX-License-Identifier: GPL-3.0-or-later
// The source of images: a camera, a file, a URL or a GStreamer pipeline.

#include "vision_internal.hpp"

#include <cctype>
#include <chrono>
#include <string>
#include <thread>

#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <pthread.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double still_rate = 25.0;  // images a second

enum class Kind { none, still, video, live };

struct Source {
  Kind kind = Kind::none;
  cv::VideoCapture capture;
  Kept raw;              // as delivered: pixels, or
  bool is_jpeg = false;  // a row of bytes, of which there are
  Jpeg_Facts facts;
  bool waiting = false;  // RAW holds an image that has not been grabbed
  Kept still;            // as scaled
  std::string name;
  std::string shown;     // the name for messages, without secrets
  int backend = cv::CAP_FFMPEG;
  cv::Size limit;
  Clock::duration period{};  // between the images of a file
  Clock::time_point next;    // when the next one is due
};

// Never destroyed, for the reason given at vision::frame.
Source &source() {
  static Source *const the_source = new Source;
  return *the_source;
}

// Sets ordinary scheduling for the calling thread temporarily, because the
// threads of a video back end inherit the policy of their creator.
class Time_Sharing {
public:
  Time_Sharing() {
    const sched_param ordinary{};
    pthread_getschedparam(pthread_self(), &policy, &parameter);
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
  }

  ~Time_Sharing() {
    pthread_setschedparam(pthread_self(), policy, &parameter);
  }

private:
  int policy = SCHED_OTHER;
  sched_param parameter{};
};

// Makes TO, a supported image, from FROM; false on failure.
bool convert(cv::Mat &from, cv::Mat &to, const cv::Size &limit) {
  if (from.dims != 2 || from.empty() || from.depth() != CV_8U ||
      from.cols > VISION_MAX_SIDE || from.rows > VISION_MAX_SIDE)
    return false;
  if (from.channels() == 1)
    cv::cvtColor(from, from, cv::COLOR_GRAY2BGR);
  else if (from.channels() == 4)
    cv::cvtColor(from, from, cv::COLOR_BGRA2BGR);
  else if (from.channels() != 3)
    return false;
  scale(from, to, fitting(from.size(), limit));
  return true;
}

bool is_number(const std::string &name) {
  return name.size() <= 4 &&
         name.find_first_not_of("0123456789") == std::string::npos;
}

const double motion_jpeg = cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
const double yuyv = cv::VideoWriter::fourcc('Y', 'U', 'Y', 'V');

// Requests the camera's own JPEG instead of pixels, if available: FFmpeg then
// only demultiplexes the stream, V4L2 returns the driver's buffer.
void ask_for_jpeg(Source &from, int fps) {
  static const double unmarked =  // how OpenCV calls it in an HTTP stream
      cv::VideoWriter::fourcc('m', 'j', 'p', 'e');
  if (from.backend == cv::CAP_FFMPEG) {
    const double codec = from.capture.get(cv::CAP_PROP_FOURCC);
    from.is_jpeg = (codec == motion_jpeg || codec == unmarked) &&
                   from.capture.set(cv::CAP_PROP_FORMAT, -1);
  } else if (from.backend == cv::CAP_V4L2) {
    from.capture.set(cv::CAP_PROP_FOURCC, motion_jpeg);
    from.capture.set(cv::CAP_PROP_FRAME_WIDTH, from.limit.width);
    from.capture.set(cv::CAP_PROP_FRAME_HEIGHT, from.limit.height);
    from.capture.set(cv::CAP_PROP_FPS, fps);
    // Double buffering: with one buffer, a camera whose images take as long as
    // the interval between them loses every other one. Two buffers hold no old
    // image.
    from.capture.set(cv::CAP_PROP_BUFFERSIZE, 2);
    from.is_jpeg =
        from.capture.get(cv::CAP_PROP_FOURCC) == motion_jpeg &&
        from.capture.set(cv::CAP_PROP_CONVERT_RGB, 0) &&
        from.capture.get(cv::CAP_PROP_CONVERT_RGB) == 0;
  }
}

bool start(Source &from, int fps) {
  const Time_Sharing while_threads_start;
  bool is_open;
  cause.clear();
  if (from.backend == cv::CAP_FFMPEG)
    is_open = open_ffmpeg(from.capture, from.name);
  else if (from.backend == cv::CAP_GSTREAMER)
    is_open = open_gstreamer(from.capture, from.name);
  else
    is_open = from.capture.open(from.name, from.backend);
  // the device as OpenCV opens it: for no other program
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  if (is_open)
    ask_for_jpeg(from, fps);
  return is_open;
}

// Determines the kind of source from its name; makes a number a device.
void classify(Source &from) {
  struct stat file{};
  const bool exists = stat(from.name.c_str(), &file) == 0;
  from.kind = Kind::live;
  from.backend = cv::CAP_FFMPEG;
  if (is_number(from.name))
    from.name = "/dev/video" + from.name;
  if (from.name.rfind("/dev/video", 0) == 0 ||
      (exists && S_ISCHR(file.st_mode)))
    from.backend = cv::CAP_V4L2;
  else if (exists && S_ISREG(file.st_mode))
    from.kind = cv::haveImageReader(from.name) ? Kind::still : Kind::video;
  else if (from.name.find('!') != std::string::npos)
    from.backend = cv::CAP_GSTREAMER;
  else if (from.name.find("://") == std::string::npos)
    from.kind = Kind::none;
}

void pace(Source &from, double rate) {
  from.period = std::chrono::duration_cast<Clock::duration>(Seconds(1 / rate));
  from.next = Clock::now();
}

// Waits until the next image of a file is due. After a delay the pace
// restarts; late images are not made up for.
void wait(Source &from) {
  if (Clock::now() > from.next + from.period)
    from.next = Clock::now();
  std::this_thread::sleep_until(from.next);
  from.next += from.period;
}

vision_status open_still(Source &from) {
  cv::Mat image;
  try {
    image = cv::imread(from.name, cv::IMREAD_COLOR);
  } catch (const cv::Exception &) {
    // for a file with an absurdly large image
  }
  if (!convert(image, from.still, from.limit))
    return fail(VISION_NO_CAMERA, "%s: no image that can be read",
                from.shown.c_str());
  pace(from, still_rate);
  return VISION_OK;
}

// Reads the next image into RAW, skipping a few damaged ones; false at the end
// of a file. A JPEG is not decoded: only a damaged header is detected.
bool read_next(Source &from) {
  // Without decoding, FFmpeg returns invalid data in small pieces: hundreds of
  // failures for one invalid image.
  const bool in_pieces = from.is_jpeg && from.backend == cv::CAP_FFMPEG;
  const int most_failures =
      from.kind == Kind::video ? 1 : in_pieces ? 5000 : 3;
  const Seconds patience(from.is_jpeg ? 2 : 1);  // but the last
  const Clock::time_point begin = Clock::now();
  int failures = 0;
  do {
    if (from.capture.read(from.raw) && !from.raw.empty()) {
      if (!from.is_jpeg ||
          (from.raw.type() == CV_8UC1 && from.raw.isContinuous() &&
           examine(from.raw, from.facts)))
        return true;
    } else if (++failures == most_failures) {
      return false;
    }
  } while (Clock::now() - begin <= patience);
  return false;  // nothing came at all
}

// The same; a file restarts at its end.
bool read(Source &from) {
  if (from.waiting) {
    from.waiting = false;
    return true;
  }
  if (read_next(from))
    return true;
  if (from.kind == Kind::live)
    return false;
  from.capture.release();
  return start(from, 1) && read_next(from);
}

// The granted format, size, and rate if known.
std::string description(const Source &from) {
  const unsigned format = unsigned(from.capture.get(cv::CAP_PROP_FOURCC));
  const double rate = from.capture.get(cv::CAP_PROP_FPS);
  std::string text;
  for (int shift = 0; shift < 32; shift += 8)
    if (std::isprint(format >> shift & 0xFF))
      text += char(format >> shift & 0xFF);
  text += cv::format("%s%dx%d", text.empty() ? "" : " ",
                     int(from.capture.get(cv::CAP_PROP_FRAME_WIDTH)),
                     int(from.capture.get(cv::CAP_PROP_FRAME_HEIGHT)));
  // FFmpeg invents the rate of a URL
  if (rate > 0.0 &&
      (from.kind == Kind::video || from.backend != cv::CAP_FFMPEG))
    text += cv::format(", %.4g a second", rate);
  return text;
}

// A V4L2 device gives OpenCV no reason.
const char *device_cause(const std::string &name) {
  if (access(name.c_str(), R_OK | W_OK) != 0 && errno == EACCES)
    return "your user must be in the group video";
  v4l2_capability has{};
  const int file = ::open(name.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  const bool is_known = file >= 0 && ioctl(file, VIDIOC_QUERYCAP, &has) == 0;
  if (file >= 0)
    ::close(file);
  return is_known && (has.device_caps & V4L2_CAP_VIDEO_CAPTURE) == 0
             ? "it gives no images, perhaps metadata: try another /dev/video*"
             : "no camera there, or another program uses it";
}

// The name is shortened, not the cause: the supervisor takes 120 characters
// (Vision.Library.Reason_Text).
vision_status not_opened(const Source &from) {
  const std::string text =
      ": cannot be opened" + (cause.empty() ? "" : ": " + cause);
  const std::size_t room = 120 - text.size();
  return fail(VISION_NO_CAMERA, "%s%s",
              (from.shown.size() <= room
                   ? from.shown
                   : from.shown.substr(0, room - 3) + "...")
                  .c_str(),
              text.c_str());
}

vision_status open_stream(Source &from, int fps) {
  if (!start(from, fps)) {
    if (from.backend == cv::CAP_V4L2)
      cause = device_cause(from.name);
    return not_opened(from);
  }
  bool is_there = read(from);
  if (!is_there && from.is_jpeg && from.backend == cv::CAP_V4L2) {
    // granted, but not delivered: OpenCV accepts any data that it does not
    // decode, so only another format helps
    from.is_jpeg = false;
    from.capture.set(cv::CAP_PROP_CONVERT_RGB, 1);
    from.capture.set(cv::CAP_PROP_FOURCC, yuyv);
    is_there = from.capture.get(cv::CAP_PROP_FOURCC) != motion_jpeg &&
               read(from);
  }
  if (!is_there)
    return fail(VISION_NO_CAMERA, "%s: gives no image", from.shown.c_str());
  if (from.kind == Kind::video) {
    const double rate = from.capture.get(cv::CAP_PROP_FPS);
    pace(from, rate >= 1.0 && rate <= 240.0 ? rate : still_rate);
    from.waiting = true;
  }
  return VISION_OK;
}

}  // namespace

}  // namespace vision

using namespace vision;

extern "C" {

vision_status vision_open(const char *name, int width, int height, int fps) {
  vision_close();
  const vision_status status = guarded([&] {
    if (name == nullptr || *name == '\0' || width < 1 || height < 1 ||
        width > VISION_MAX_SIDE || height > VISION_MAX_SIDE || fps < 1)
      return fail(VISION_BAD_ARGUMENT, "no source, or no size, or no rate");
    expect_images(width, height);
    frame(0);  // OpenCV's own settings
    Source &here = source();
    here.name = name;
    here.shown = without_secrets(here.name);
    here.limit = {width, height};
    classify(here);
    if (here.kind == Kind::none)
      return fail(VISION_NO_CAMERA, "%s: no such file, device or URL",
                  here.shown.c_str());
    return here.kind == Kind::still ? open_still(here)
                                    : open_stream(here, fps);
  });
  if (status != VISION_OK)
    vision_close();
  return status;
}

vision_status vision_grab(int slot) {
  return guarded([&] {
    Frame *const to = frame(slot);
    Source &from = source();
    if (to == nullptr)
      return fail(VISION_BAD_ARGUMENT, "no slot %d", slot);
    if (from.kind == Kind::none)
      return fail(VISION_NO_CAMERA, "no source is open");
    if (from.kind == Kind::still) {
      wait(from);
      from.still.copyTo(to->image);
      to->content = Frame::Content::pixels;
      return VISION_OK;
    }
    if (!read(from))
      return fail(VISION_NO_IMAGE, "%s: no image came", from.shown.c_str());
    // read before it is due: restarting a file takes time
    if (from.kind == Kind::video)
      wait(from);
    if (from.is_jpeg) {
      std::swap(from.raw, to->jpeg);
      to->facts = from.facts;
      to->limit = from.limit;
      to->content = Frame::Content::jpeg;
      return VISION_OK;
    }
    if (!convert(from.raw, to->image, from.limit))
      return fail(VISION_NO_IMAGE, "%s: an image of an unusable kind came",
                  from.shown.c_str());
    to->content = Frame::Content::pixels;
    return VISION_OK;
  });
}

const char *vision_format(void) {
  static thread_local std::string text;
  text.clear();
  guarded([] {
    if (source().capture.isOpened())
      text = description(source());
    return VISION_OK;
  });
  return text.c_str();
}

vision_status vision_close(void) {
  return guarded([] {
    source() = Source();
    return VISION_OK;
  });
}

}  // extern "C"
