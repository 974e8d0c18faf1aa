// SPDX-License-Identifier: GPL-3.0-or-later
// What an image's way is compared with: libjpeg-turbo alone; and a monitor that
// takes whatever it is sent.

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <jpeglib.h>

#include "vision_internal.hpp"

namespace {

[[noreturn]] void give_up(const char *what) {
  std::perror(what);
  std::exit(1);
}

// Takes everything, until it is closed.
void drain(int socket) {
  static char place[1 << 20];
  while (read(socket, place, sizeof place) > 0) {
  }
  close(socket);
}

}  // namespace

extern "C" {

// Decodes what is in a slot, if it has not been: the first half of every
// search and drawing.
int image_decode(int slot) {
  return vision::make_pixels(*vision::frame(slot)) ? 0 : -1;
}

// The image of a slot as it is, encoded with libjpeg's own destination in
// memory, the same subsampling and the same quality. The length.
int image_floor_encode(int slot, int quality) {
  const cv::Mat &image = vision::frame(slot)->image;
  static unsigned char *place = nullptr;
  static unsigned long room = 0;
  if (place == nullptr) {
    room = 1 << 24;
    place = static_cast<unsigned char *>(std::malloc(room));
  }
  unsigned char *result = place;
  unsigned long length = room;
  jpeg_compress_struct object;
  jpeg_error_mgr errors;
  object.err = jpeg_std_error(&errors);
  jpeg_create_compress(&object);
  jpeg_mem_dest(&object, &result, &length);
  object.image_width = JDIMENSION(image.cols);
  object.image_height = JDIMENSION(image.rows);
  object.input_components = 3;
  object.in_color_space = JCS_EXT_BGR;
  jpeg_set_defaults(&object);
  jpeg_set_quality(&object, quality, TRUE);
  jpeg_start_compress(&object, TRUE);
  while (object.next_scanline < object.image_height) {
    JSAMPROW row =
        const_cast<uchar *>(image.ptr<uchar>(int(object.next_scanline)));
    jpeg_write_scanlines(&object, &row, 1);
  }
  jpeg_finish_compress(&object);
  jpeg_destroy_compress(&object);
  return int(length);
}

// A connection over the loop-back interface, set as the supervisor sets it.
int image_connect(void) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  const int sender = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  socklen_t size = sizeof address;
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (listener < 0 || sender < 0 ||
      bind(listener, reinterpret_cast<sockaddr *>(&address), size) != 0 ||
      listen(listener, 1) != 0 ||
      getsockname(listener, reinterpret_cast<sockaddr *>(&address), &size) !=
          0 ||
      connect(sender, reinterpret_cast<sockaddr *>(&address), size) != 0)
    give_up("loop-back");
  const int receiver = accept(listener, nullptr, nullptr);
  const int one = 1;
  if (receiver < 0 ||
      setsockopt(sender, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one) != 0)
    give_up("loop-back");
  close(listener);
  std::thread(drain, receiver).detach();
  return sender;
}

void image_send(int socket, const char *data, int length) {
  while (length > 0) {
    const ssize_t put =
        send(socket, data, std::size_t(length), MSG_NOSIGNAL);
    if (put <= 0)
      give_up("send");
    data += put;
    length -= int(put);
  }
}

}  // extern "C"
