// SPDX-License-Identifier: GPL-3.0-or-later
// FFmpeg and GStreamer below OpenCV. OpenCV calls some of their functions here
// instead, as this library comes first: for limits that OpenCV 4.6 cannot set,
// and for causes of failure.

#include "vision_internal.hpp"

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <strings.h>

#include <opencv2/videoio/registry.hpp>

namespace vision {

thread_local std::string cause;

namespace {

constexpr int open_limit = 3000;  // milliseconds, of a URL
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

// A function that OpenCV calls or could call: to build against its libraries
// would be a dependency for the sake of a message. Null if there is none.
template <typename Function> Function *next(const char *name) {
  return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
}

thread_local bool is_opening = false;

// Takes the cause from another program or library, or from the network.
void take_cause(std::string text) {
  for (char &letter : text)
    if (letter < ' ' || letter > '~')
      letter = ' ';
  text.erase(text.find_last_not_of(' ') + 1);
  if (!text.empty())
    cause = without_secrets(text).substr(0, 70);
}

// Is called by FFmpeg with each line of its log. The last warning, from the
// last colon on, is the cause: "Connection to tcp://... failed: Connection
// refused", "HTTP error 404 Not Found". Of what is no stream it says only that
// it ends too soon or is not on a list, or nothing. A redirect of RTSP, which
// no option prevents, is announced just before it is followed: from then on no
// protocol is permitted.
void hear_ffmpeg(void *context, int level, const char *format,
                 va_list arguments) {
  constexpr int warning = 24, information = 32;  // AV_LOG_...
  static const std::string type = "header='Content-Type: ";
  static const std::string location = "header='Location: ";
  static const std::string redirected = "redirected to ";
  if (!is_opening || cause.rfind(redirected, 0) == 0)
    return;
  char line[300];
  std::vsnprintf(line, sizeof line, format, arguments);
  const std::string text = line;
  const std::size_t target = text.find(": Redirecting to ");
  if (strncasecmp(line, location.c_str(), location.size()) == 0) {
    const std::string value = text.substr(location.size());
    take_cause(redirected + value.substr(0, value.find('\'')));
  } else if (level == information && target != std::string::npos) {
    take_cause(redirected + text.substr(target + 17));
    next<int(void *, const char *, const char *, int)>("av_opt_set")(
        context, "protocol_whitelist", "none", 0);
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

// Whether FFmpeg's log is heard; not if the user has it printed by OpenCV.
bool hears_ffmpeg() {
  static const bool hears = [] {
    const auto set_log =
        next<void(decltype(hear_ffmpeg) *)>("av_log_set_callback");
    if (set_log == nullptr || std::getenv("OPENCV_FFMPEG_LOGLEVEL") != nullptr)
      return false;
    set_log(hear_ffmpeg);
    return true;
  }();
  return hears;
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

// In nanoseconds: of the start of a pipeline, and of its first image, which an
// rtspsrc holds back for 2 s; then as of a URL.
constexpr std::uint64_t pipeline_limit = 5000000000;
std::uint64_t sample_limit = pipeline_limit;

}  // namespace

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

bool open_ffmpeg(cv::VideoCapture &capture, const std::string &name) {
  const auto begin = std::chrono::steady_clock::now();
  const bool hears = hears_ffmpeg();
  is_opening = true;
  const bool is_open = capture.open(
      name, cv::CAP_FFMPEG,
      {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, open_limit,
       cv::CAP_PROP_READ_TIMEOUT_MSEC, read_limit});
  is_opening = false;
  if (cause.empty() && hears)
    cause = std::chrono::steady_clock::now() - begin >=
                    std::chrono::milliseconds(open_limit)
                ? "no answer"
                : "no stream of images";
  return is_open;
}

bool open_gstreamer(cv::VideoCapture &capture, const std::string &pipeline) {
  sample_limit = pipeline_limit;
  const bool is_open = capture.open(pipeline, cv::CAP_GSTREAMER);
  if (!cv::videoio_registry::hasBackend(cv::CAP_GSTREAMER))
    cause = "this OpenCV has no GStreamer";
  else if (cause.empty() && pipeline.find("appsink") == std::string::npos)
    cause = "a pipeline must end with appsink";
  return is_open;
}

}  // namespace vision

using namespace vision;

extern "C" {

// OpenCV calls these instead of the functions of their names, because this
// library comes first. FFmpeg's: a URL, with what it may be opened with.
int avformat_open_input(void **context, const char *name, const void *format,
                        void **options) {
  const auto set =
      next<int(void **, const char *, const char *, int)>("av_dict_set");
  constexpr int keep = 16;  // AV_DICT_DONT_OVERWRITE
  if (std::strstr(name, "://") != nullptr)
    for (const auto &each : url_options)
      set(options, each.name, each.value, keep);
  return next<decltype(avformat_open_input)>("avformat_open_input")(
      context, name, format, options);
}

// GStreamer's. OpenCV would go on without an element that is missing.
void *gst_parse_launch(const char *pipeline, G_Error **error) {
  void *const made =
      next<decltype(gst_parse_launch)>("gst_parse_launch")(pipeline, error);
  if (*error == nullptr)
    return made;
  std::string text = (*error)->message;
  const std::string missing = "no element \"";
  if (text.rfind(missing, 0) == 0)
    for (const auto &each : packages)
      if (text.compare(missing.size(), std::strlen(each.element),
                       each.element) == 0) {
        text += std::string(", see gstreamer1.0-") + each.package;
        break;
      }
  take_cause(text);
  if (made != nullptr)
    next<void(void *)>("gst_object_unref")(made);
  return nullptr;
}

// OpenCV lets it wait for ever, from 4.7 on for 30 s.
int gst_element_get_state(void *element, int *state, int *pending,
                          std::uint64_t limit) {
  constexpr int failure = 0, incomplete = 2, null = 1;  // as in GStreamer
  const int result = next<decltype(gst_element_get_state)>(
      "gst_element_get_state")(element, state, pending,
                               std::min(limit, pipeline_limit));
  if (result != incomplete || limit <= pipeline_limit)
    return result;
  // OpenCV releases it, which it may not otherwise
  next<int(void *, int)>("gst_element_set_state")(element, null);
  cause = "no image in time";
  return failure;
}

void *gst_app_sink_try_pull_sample(void *sink, std::uint64_t limit) {
  static const auto pull = next<decltype(gst_app_sink_try_pull_sample)>(
      "gst_app_sink_try_pull_sample");
  void *const sample = pull(sink, std::min(limit, sample_limit));
  if (sample != nullptr)
    sample_limit = read_limit * std::uint64_t{1000000};
  return sample;
}

void *gst_app_sink_pull_sample(void *sink) {
  return gst_app_sink_try_pull_sample(sink, sample_limit);
}

// Where OpenCV reads an error.
void gst_message_parse_error(void *message, G_Error **error, char **details) {
  next<decltype(gst_message_parse_error)>("gst_message_parse_error")(
      message, error, details);
  if (error != nullptr && *error != nullptr)
    take_cause((*error)->message);
}

}  // extern "C"
