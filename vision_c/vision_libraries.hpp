// SPDX-License-Identifier: GPL-3.0-or-later
// Opening of a source by FFmpeg or GStreamer, and why it fails.

#ifndef VISION_LIBRARIES_HPP
#define VISION_LIBRARIES_HPP

#include <string>

#include <opencv2/videoio.hpp>

namespace vision {

// Longer than the 2.5 s after which the supervisor closes a silent camera, so
// that it says why; the first image comes after the opening.
constexpr int read_limit = 3000;  // milliseconds, of a URL

// Why the source that this thread opens does not open; empty if unknown.
extern thread_local std::string cause;

// What may be secret in a URL as dots: up to the last @, so also in a password
// that should have been encoded, and from the question mark on.
std::string without_secrets(const std::string &name);

// Opens a file or a URL.
bool open_ffmpeg(cv::VideoCapture &capture, const std::string &name);

bool open_gstreamer(cv::VideoCapture &capture, const std::string &pipeline);

}  // namespace vision

#endif
