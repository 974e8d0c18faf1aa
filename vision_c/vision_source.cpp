// SPDX-License-Identifier: GPL-3.0-or-later
// The source of images: a camera, a file, a URL or a GStreamer pipeline.

#include "vision_internal.hpp"
#include "vision_settings.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <pthread.h>
#include <sched.h>
#include <strings.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>

namespace vision {

namespace {

constexpr int open_limit = 3000;  // milliseconds, of a URL
// Longer than the 2.5 s after which the supervisor closes a silent camera, so
// that it says why; the first image comes after the opening.
constexpr int read_limit = 3000;
constexpr double still_rate = 25.0;  // images a second

// What a URL may be opened with, as options of FFmpeg: streams that contain
// their images, by protocols that lead to the host of the URL alone. Otherwise
// whoever answers could name other hosts: by a redirect, or as the segments of
// a playlist. A user's own (OPENCV_FFMPEG_CAPTURE_OPTIONS) remain.
const struct {
  const char *name, *value;
} url_options[] = {
    {"protocol_whitelist", "http,https,tls,tcp,udp,rtp"},
    {"format_whitelist", "mpjpeg,mjpeg,jpeg_pipe,png_pipe,rtsp,rtp,mpegts,h264"
                         ",hevc,m4v,mpegvideo,mov,matroska,flv,avi"},
    {"max_redirects", "0"}};

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
  long period = 0;         // nanoseconds between the images of a file
  timespec next{0, 0};     // when the next one is due
};

// Never destroyed, for the reason given at vision::frame.
Source &source() {
  static Source *const the_source = new Source;
  return *the_source;
}

struct Settings {
  Settings() {
    prepare_process();
    // The reason of a failure is returned, not printed.
    if (std::getenv("OPENCV_LOG_LEVEL") == nullptr)
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  }
} const settings;

// Sets ordinary scheduling for the calling thread temporarily, because the
// threads of a video back end inherit the policy of their creator.
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
  from.is_jpeg = false;
  from.capture.release();
  from.raw = Kept();
  from.still = Kept();
}

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

// What may be secret in a URL as dots: up to the last @, so also in a password
// that should have been encoded, and from the question mark on.
std::string without_secrets(const std::string &name) {
  std::string shown;
  std::size_t done = 0;
  for (std::size_t at = 0; (at = name.find("://", done)) != std::string::npos;
       done = std::min(name.find_first_of(" \t\"'", at), name.size())) {
    at += 3;
    shown += name.substr(done, at - done);
    std::string url = name.substr(at, name.find_first_of(" \t\"'", at) - at);
    const std::size_t host = url.rfind('@');
    if (host != std::string::npos)
      url.replace(0, host, "...");
    const std::size_t query = url.find('?');
    if (query != std::string::npos)
      url.replace(query + 1, std::string::npos, "...");
    shown += url;
  }
  return shown + name.substr(done);
}

double seconds() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

// A function that OpenCV's video part calls or could call: to build against
// its libraries would be a dependency for the sake of a message. Null if it
// has none.
template <typename Function> Function *of_opencv(const char *name) {
  static void *const videoio = [] {
    Dl_info info{};
    dladdr(reinterpret_cast<void *>(cv::videoio_registry::hasBackend), &info);
    return dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  }();
  return reinterpret_cast<Function *>(
      videoio == nullptr ? nullptr : dlsym(videoio, name));
}

// Why the source that this thread opens does not open; empty if unknown.
thread_local std::string cause;

// Takes the cause from another program or library, or from the network.
void take_cause(std::string text) {
  for (char &letter : text)
    if (letter < ' ' || letter > '~')
      letter = ' ';
  text.erase(text.find_last_not_of(' ') + 1);
  if (!text.empty())
    cause = without_secrets(text).substr(0, 70);
}

bool hears_ffmpeg = false;
thread_local bool is_opening = false;

// Is called by FFmpeg with each line of its log. The last warning, from the
// last colon on, is the cause: "Connection to tcp://... failed: Connection
// refused", "HTTP error 404 Not Found". Of what is no stream it says only that
// it ends too soon or is not on a list, or nothing. A redirect of RTSP, which
// no option prevents, is announced just before it is followed: from then on no
// protocol is permitted.
void hear_ffmpeg(void *context, int level, const char *format,
                 va_list arguments) {
  constexpr int warning = 24, information = 32, trace = 56;  // AV_LOG_...
  static const std::string type = "header='Content-Type: ";
  static const std::string location = "header='Location: ";
  static const std::string redirected = "redirected to ";
  static const auto set_option =
      of_opencv<int(void *, const char *, const char *, int)>("av_opt_set");
  if (!is_opening ||
      (level > warning && level != information && level != trace))
    return;
  char line[300];
  std::vsnprintf(line, sizeof line, format, arguments);
  const std::string text = line;
  if (cause.rfind(redirected, 0) == 0)
    return;
  const std::size_t target = text.find(": Redirecting to ");
  if (strncasecmp(line, location.c_str(), location.size()) == 0) {
    const std::string value = text.substr(location.size());
    take_cause(redirected + value.substr(0, value.find('\'')));
  } else if (level == information && target != std::string::npos) {
    take_cause(redirected + text.substr(target + 17));
    set_option(context, "protocol_whitelist", "none", 0);
  } else if (level <= warning && text.rfind("Stream ends ", 0) != 0 &&
             text.rfind("Format not ", 0) != 0) {
    const std::size_t colon = text.rfind(": ");
    take_cause(colon == std::string::npos ? text : text.substr(colon + 2));
  } else if (strncasecmp(line, type.c_str(), type.size()) == 0) {
    const std::string value = text.substr(type.size());
    take_cause("HTTP 200 with " + value.substr(0, value.find_first_of(";'")) +
               ", no stream of images");
  }
}

// Opens a file or URL.
bool start_ffmpeg(Source &from) {
  is_opening = true;
  const double begin = seconds();
  const bool is_open = from.capture.open(
      from.name, cv::CAP_FFMPEG,
      {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, open_limit,
       cv::CAP_PROP_READ_TIMEOUT_MSEC, read_limit});
  is_opening = false;
  if (cause.empty() && hears_ffmpeg && from.kind == Kind::live)
    cause = seconds() - begin >= open_limit * 1e-3 ? "no answer"
                                                   : "no stream of images";
  return is_open;
}

// Debian's package of a GStreamer element, by how its name begins.
const struct {
  const char *element, *package;
} packages[] = {
    {"app", "plugins-base"},          {"avdec_", "libav"},
    {"decodebin", "plugins-base"},    {"h26", "plugins-bad"},
    {"jpegparse", "plugins-bad"},     {"jpeg", "plugins-good"},
    {"libcamera", "libcamera"},       {"multipart", "plugins-good"},
    {"rtp", "plugins-good"},          {"rtsp", "plugins-good"},
    {"udp", "plugins-good"},          {"uridecodebin", "plugins-base"},
    {"v4l2", "plugins-good"},         {"videoconvert", "plugins-base"},
    {"videorate", "plugins-base"},    {"videoscale", "plugins-base"},
    {"videotestsrc", "plugins-base"}, {"x264enc", "plugins-ugly"}};

struct G_Error {  // as in GLib
  unsigned domain;
  int code;
  char *message;
};

// Whether GStreamer can make the pipeline. OpenCV would go on without an
// element that is missing, and could then wait for ever.
bool can_be_made(const std::string &pipeline) {
  G_Error *error = nullptr;
  const auto prepare =
      of_opencv<int(int *, char ***, G_Error **)>("gst_init_check");
  const auto make =
      of_opencv<void *(const char *, G_Error **)>("gst_parse_launch");
  const auto release = of_opencv<void(void *)>("gst_object_unref");
  const auto forget = of_opencv<void(G_Error *)>("g_error_free");
  if (prepare == nullptr || make == nullptr || release == nullptr ||
      forget == nullptr || !prepare(nullptr, nullptr, nullptr))
    return true;  // OpenCV loads it later, or not at all
  if (void *const made = make(pipeline.c_str(), &error))
    release(made);
  if (error == nullptr)
    return true;
  std::string text = error->message;
  forget(error);
  const std::string missing = "no element \"";
  if (text.rfind(missing, 0) == 0)
    for (const auto &each : packages)
      if (text.compare(missing.size(), std::strlen(each.element),
                       each.element) == 0) {
        text += std::string(", see gstreamer1.0-") + each.package;
        break;
      }
  take_cause(text);
  return false;
}

// In nanoseconds: of the start of a pipeline, and of its first image, which an
// rtspsrc holds back for 2 s; then as of a URL.
constexpr std::uint64_t pipeline_limit = 5000000000;
std::uint64_t sample_limit = pipeline_limit;

bool start_gstreamer(Source &from) {
  if (!cv::videoio_registry::hasBackend(cv::CAP_GSTREAMER)) {
    cause = "this OpenCV has no GStreamer";
    return false;
  }
  if (!can_be_made(from.name))
    return false;
  if (from.name.find("appsink") == std::string::npos) {
    cause = "a pipeline must end with appsink";
    return false;
  }
  sample_limit = pipeline_limit;
  return from.capture.open(from.name, cv::CAP_GSTREAMER);
}

bool start(Source &from, int fps) {
  const Time_Sharing while_threads_start;
  bool is_open;
  cause.clear();
  if (is_number(from.name))
    is_open = from.capture.open(std::stoi(from.name), from.backend);
  else if (from.backend == cv::CAP_FFMPEG)
    is_open = start_ffmpeg(from);
  else if (from.backend == cv::CAP_GSTREAMER)
    is_open = start_gstreamer(from);
  else
    is_open = from.capture.open(from.name, from.backend);
  // the device as OpenCV opens it: for no other program
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  if (is_open)
    ask_for_jpeg(from, fps);
  return is_open;
}

// Determines the kind of source from its name.
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

// Waits until the next image of a file is due. After a delay the pace
// restarts; late images are not made up for.
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

// Empty if no image can be read. OpenCV throws for a file with an absurdly
// large image.
cv::Mat read_still(const std::string &name) {
  try {
    return cv::imread(name, cv::IMREAD_COLOR);
  } catch (const cv::Exception &) {
    return {};
  }
}

vision_status open_still(Source &from) {
  cv::Mat image = read_still(from.name);
  if (!convert(image, from.still, from.limit))
    return fail(VISION_NO_CAMERA, "%s: no image that can be read",
                from.shown.c_str());
  from.kind = Kind::still;
  pace(from, still_rate);
  return VISION_OK;
}

// Whether RAW is an image. A JPEG is not decoded for this: only a damaged
// header is detected.
bool is_image(Source &from) {
  return !from.is_jpeg ||
         (from.raw.type() == CV_8UC1 && from.raw.isContinuous() &&
          examine(from.raw, from.facts));
}

// Reads the next image of a live source into RAW, skipping a few damaged ones.
bool read_live(Source &from) {
  // Without decoding, FFmpeg returns invalid data in small pieces: hundreds of
  // failures for one invalid image.
  const bool in_pieces = from.is_jpeg && from.backend == cv::CAP_FFMPEG;
  const int most_failures = in_pieces ? 5000 : 3;
  const double patience = from.is_jpeg ? 2.0 : 1.0;  // seconds, but the last
  const double begin = seconds();
  int failures = 0;
  do {
    if (from.capture.read(from.raw) && !from.raw.empty()) {
      if (is_image(from))
        return true;
    } else if (++failures == most_failures) {
      return false;
    }
  } while (seconds() - begin <= patience);
  return false;  // nothing came at all
}

// The same for a file: false at its end.
bool read_video(Source &from) {
  while (from.capture.read(from.raw) && !from.raw.empty())
    if (is_image(from))
      return true;
  return false;
}

// Reads the next image into RAW. A file restarts at its end.
bool read(Source &from) {
  if (from.waiting) {
    from.waiting = false;
    return true;
  }
  if (from.kind == Kind::live)
    return read_live(from);
  if (read_video(from))
    return true;
  from.capture.release();
  return start(from, 1) && read_video(from);
}

// Describes the granted format, size, and rate if known.
void describe(const Source &from, char *text, std::size_t capacity) {
  const unsigned format = unsigned(from.capture.get(cv::CAP_PROP_FOURCC));
  const double rate = from.capture.get(cv::CAP_PROP_FPS);
  // FFmpeg invents it for a URL
  const bool rate_known =
      rate > 0.0 &&
      (from.kind == Kind::video || from.backend != cv::CAP_FFMPEG);
  int length = 0;
  for (int shift = 0; shift < 32 && length < 4; shift += 8) {
    const unsigned char letter = (unsigned char)(format >> shift);
    if (std::isprint(letter))
      text[length++] = char(letter);
  }
  length += std::snprintf(
      text + length, capacity - length, "%s%dx%d", length > 0 ? " " : "",
      int(from.capture.get(cv::CAP_PROP_FRAME_WIDTH)),
      int(from.capture.get(cv::CAP_PROP_FRAME_HEIGHT)));
  if (rate_known)
    std::snprintf(text + length, capacity - length, ", %.4g a second", rate);
}

// A V4L2 device gives OpenCV no reason.
const char *device_cause(const std::string &name) {
  const std::string path = is_number(name) ? "/dev/video" + name : name;
  if (access(path.c_str(), R_OK | W_OK) != 0 && errno == EACCES)
    return "your user must be in the group video";
  v4l2_capability has{};
  const int file = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
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

using vision::fail;
using vision::Frame;
using vision::guarded;
using vision::Kind;
using vision::Source;

extern "C" {

// OpenCV calls this instead of FFmpeg's function, because this library comes
// first: before it opens anything, with a log of its own that prints.
void av_log_set_callback(decltype(vision::hear_ffmpeg) *log) {
  static const auto set_log =
      vision::of_opencv<void(decltype(log))>("av_log_set_callback");
  const char *const level = std::getenv("OPENCV_FFMPEG_LOGLEVEL");
  const bool is_users = level != nullptr && std::strcmp(level, "-8") != 0;
  vision::hears_ffmpeg = set_log != nullptr && log != nullptr && !is_users;
  if (set_log != nullptr)
    set_log(vision::hears_ffmpeg ? vision::hear_ffmpeg : log);
}

// The same: of a URL, with what it may be opened with.
int avformat_open_input(void **context, const char *name, const void *format,
                        void **options) {
  static const auto open = vision::of_opencv<decltype(avformat_open_input)>(
      "avformat_open_input");
  static const auto set =
      vision::of_opencv<int(void **, const char *, const char *, int)>(
          "av_dict_set");
  constexpr int keep = 16;  // AV_DICT_DONT_OVERWRITE
  if (vision::source().kind == Kind::live)
    for (const auto &each : vision::url_options)
      set(options, each.name, each.value, keep);
  return open(context, name, format, options);
}

// The same of GStreamer: OpenCV lets it wait for ever, from 4.7 on for 30 s.
int gst_element_get_state(void *element, int *state, int *pending,
                          std::uint64_t limit) {
  constexpr int failure = 0, incomplete = 2, null = 1;  // as in GStreamer
  static const auto get_state =
      vision::of_opencv<decltype(gst_element_get_state)>(
          "gst_element_get_state");
  static const auto set_state =
      vision::of_opencv<int(void *, int)>("gst_element_set_state");
  const int result = get_state(element, state, pending,
                               std::min(limit, vision::pipeline_limit));
  if (result != incomplete || limit <= vision::pipeline_limit)
    return result;
  set_state(element, null);  // OpenCV releases it, which it may not otherwise
  vision::cause = "no image in time";
  return failure;
}

void *gst_app_sink_try_pull_sample(void *sink, std::uint64_t limit) {
  static const auto pull =
      vision::of_opencv<decltype(gst_app_sink_try_pull_sample)>(
          "gst_app_sink_try_pull_sample");
  void *const sample = pull(sink, std::min(limit, vision::sample_limit));
  if (sample != nullptr)
    vision::sample_limit = vision::read_limit * std::uint64_t{1000000};
  return sample;
}

void *gst_app_sink_pull_sample(void *sink) {
  return gst_app_sink_try_pull_sample(sink, vision::sample_limit);
}

// Where OpenCV reads an error.
void gst_message_parse_error(void *message, vision::G_Error **error,
                             char **details) {
  static const auto parse =
      vision::of_opencv<decltype(gst_message_parse_error)>(
          "gst_message_parse_error");
  parse(message, error, details);
  if (error != nullptr && *error != nullptr)
    vision::take_cause((*error)->message);
}

vision_status vision_open(const char *source, int width, int height,
                          int fps) {
  vision_close();
  const vision_status status = guarded([&] {
    if (source == nullptr || *source == '\0' || width < 1 || height < 1 ||
        width > VISION_MAX_SIDE || height > VISION_MAX_SIDE || fps < 1)
      return fail(VISION_BAD_ARGUMENT, "no source, or no size, or no rate");
    vision::expect_images(width, height);
    vision::frame(0);  // OpenCV's own settings
    Source &here = vision::source();
    here.name = source;
    here.shown = vision::without_secrets(here.name);
    here.limit = {width, height};
    bool image_file = false;
    vision::classify(here, image_file);
    if (here.kind == Kind::none)
      return fail(VISION_NO_CAMERA, "%s: no such file, device or URL",
                  here.shown.c_str());
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
    if (from.kind == Kind::still) {
      vision::wait(from);
      from.still.copyTo(to->image);
      to->content = Frame::Content::pixels;
      return VISION_OK;
    }
    if (!vision::read(from))
      return fail(VISION_NO_IMAGE, "%s: no image came", from.shown.c_str());
    // read before it is due: restarting a file takes time
    if (from.kind == Kind::video)
      vision::wait(from);
    if (from.is_jpeg) {
      std::swap(from.raw, to->jpeg);
      to->facts = from.facts;
      to->limit = from.limit;
      to->content = Frame::Content::jpeg;
      return VISION_OK;
    }
    if (!vision::convert(from.raw, to->image, from.limit))
      return fail(VISION_NO_IMAGE, "%s: an image of an unusable kind came",
                  from.shown.c_str());
    to->content = Frame::Content::pixels;
    return VISION_OK;
  });
}

const char *vision_format(void) {
  static thread_local char text[80];
  text[0] = '\0';
  guarded([] {
    const Source &from = vision::source();
    if (from.kind == Kind::video || from.kind == Kind::live)
      vision::describe(from, text, sizeof text);
    return VISION_OK;
  });
  return text;
}

vision_status vision_close(void) {
  return guarded([] {
    vision::close(vision::source());
    return VISION_OK;
  });
}

}  // extern "C"
