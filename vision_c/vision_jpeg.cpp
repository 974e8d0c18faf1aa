// SPDX-License-Identifier: GPL-3.0-or-later
// JPEG: examines the camera's own, decodes it if necessary, and encodes images
// for the monitor.

#include "vision_internal.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>
#include <jerror.h>  // after that one

// Uses libjpeg directly, not OpenCV's functions: those encode into a growing
// vector, swap the colours in a separate pass, and cannot read a header
// without decoding the image.

namespace vision {

namespace {

// libjpeg ends a failed operation in error_exit, which must not return: it
// jumps back (longjmp) to the function that started it; no function in between
// has a destructor.
struct Errors {
  jpeg_error_mgr manager;
  std::jmp_buf leave;
  char message[JMSG_LENGTH_MAX];
};

void leave(j_common_ptr object) {
  Errors *const errors = reinterpret_cast<Errors *>(object->err);
  object->err->format_message(object, errors->message);
  std::longjmp(errors->leave, 1);
}

void keep_quiet(j_common_ptr, int) {
}

void prepare(Errors &errors, jpeg_error_mgr *&manager) {
  manager = jpeg_std_error(&errors.manager);
  manager->error_exit = leave;
  manager->emit_message = keep_quiet;  // what is damaged is decoded all the
                                       // same, as far as it can be
  errors.message[0] = '\0';
}

// ---------------------------------------------------------------- Decoding

struct Decoder {
  jpeg_decompress_struct object;
  Errors errors;

  Decoder() {
    prepare(errors, object.err);
    object.mem = nullptr;  // not yet created
  }

  ~Decoder() {
    jpeg_destroy_decompress(&object);
  }
};

// Reads the header; fails for an unsupported image.
void begin(Decoder &decoder, const cv::Mat &bytes) {
  jpeg_decompress_struct &object = decoder.object;
  jpeg_create_decompress(&object);
  jpeg_mem_src(&object, bytes.data, bytes.total());
  jpeg_read_header(&object, TRUE);
  if (object.image_width > VISION_MAX_SIDE ||
      object.image_height > VISION_MAX_SIDE)
    ERREXIT1(&object, JERR_IMAGE_TOO_BIG, VISION_MAX_SIDE);
  if (object.jpeg_color_space != JCS_YCbCr &&
      object.jpeg_color_space != JCS_RGB &&
      object.jpeg_color_space != JCS_GRAYSCALE)
    ERREXIT(&object, JERR_CONVERSION_NOTIMPL);
  object.out_color_space = JCS_EXT_BGR;
}

// Whether any viewer can show it: a single scan, colour or grey, Huffman code,
// with its own tables (many USB cameras omit them).
bool is_common(const jpeg_decompress_struct &object) {
  if (object.arith_code ||
      (object.jpeg_color_space != JCS_YCbCr &&
       object.jpeg_color_space != JCS_GRAYSCALE))
    return false;
  for (int k = 0; k < object.num_components; ++k) {
    const jpeg_component_info &component = *object.cur_comp_info[k];
    // libjpeg checks these numbers only when it starts to decode.
    if (component.dc_tbl_no < 0 || component.dc_tbl_no >= NUM_HUFF_TBLS ||
        component.ac_tbl_no < 0 || component.ac_tbl_no >= NUM_HUFF_TBLS)
      return false;
    if (object.dc_huff_tbl_ptrs[component.dc_tbl_no] == nullptr ||
        object.ac_huff_tbl_ptrs[component.ac_tbl_no] == nullptr)
      return false;
  }
  return true;
}

// The length of a scan including the end of the image, given the bytes after
// its header; 0 if there is no such end, or anything before it but scan data
// and restart markers.
std::size_t length_of_scan(const unsigned char *from, std::size_t size) {
  const unsigned char *next = from;
  const unsigned char *const end = from + size;
  while (next < end) {
    next = static_cast<const unsigned char *>(
        std::memchr(next, 0xFF, std::size_t(end - next)));
    if (next == nullptr || end - next < 2)
      return 0;
    const unsigned char marker = next[1];
    if (marker == JPEG_EOI)
      return std::size_t(next + 2 - from);
    if (marker == 0xFF)
      ++next;  // a byte of filling
    else if (marker == 0 ||
             (marker >= JPEG_RST0 && marker <= JPEG_RST0 + 7))
      next += 2;
    else
      return 0;
  }
  return 0;
}

}  // namespace

bool examine(const cv::Mat &bytes, Jpeg_Facts &facts) {
  Decoder decoder;
  facts = Jpeg_Facts();
  if (setjmp(decoder.errors.leave) != 0) {
    fail(VISION_NO_IMAGE, "JPEG: %s", decoder.errors.message);
    return false;
  }
  begin(decoder, bytes);
  facts.width = int(decoder.object.image_width);
  facts.height = int(decoder.object.image_height);
  // Builds the tables, which validates them. For an image in several scans it
  // would read all of them.
  const bool is_one_scan = !jpeg_has_multiple_scans(&decoder.object);
  const bool is_passed = is_one_scan && is_common(decoder.object);
  if (is_one_scan)
    jpeg_start_decompress(&decoder.object);

  // After the last byte libjpeg inserts an end of image itself.
  const jpeg_source_mgr &source = *decoder.object.src;
  const unsigned char *const end = bytes.data + bytes.total();
  if (source.bytes_in_buffer == 0 ||
      source.next_input_byte + source.bytes_in_buffer != end)
    ERREXIT(&decoder.object, JERR_INPUT_EOF);
  if (is_passed) {
    const std::size_t scan =
        length_of_scan(source.next_input_byte, source.bytes_in_buffer);
    if (scan > 0)
      facts.whole = std::size_t(source.next_input_byte - bytes.data) + scan;
  }
  return true;
}

bool decode(const cv::Mat &bytes, const cv::Size &size, cv::Mat &image) {
  constexpr int most = 16;
  constexpr JDIMENSION smallest = 8;
  Decoder decoder;
  JSAMPROW rows[most];
  if (setjmp(decoder.errors.leave) != 0) {
    fail(VISION_NO_IMAGE, "JPEG: %s", decoder.errors.message);
    return false;
  }
  begin(decoder, bytes);
  for (JDIMENSION part = 2;
       part <= smallest &&
       decoder.object.image_width >= part * JDIMENSION(size.width) &&
       decoder.object.image_height >= part * JDIMENSION(size.height);
       part *= 2)
    decoder.object.scale_denom = part;
  jpeg_start_decompress(&decoder.object);
  image.create(int(decoder.object.output_height),
               int(decoder.object.output_width), CV_8UC3);
  while (decoder.object.output_scanline < decoder.object.output_height) {
    const int first = int(decoder.object.output_scanline);
    const int count = std::min(most, image.rows - first);
    for (int k = 0; k < count; ++k)
      rows[k] = image.ptr<uchar>(first + k);
    jpeg_read_scanlines(&decoder.object, rows, JDIMENSION(count));
  }
  return true;
}

// ---------------------------------------------------------------- Encoding

namespace {

// Encodes into the caller's memory. libjpeg requests a new buffer as soon as
// one is full, even at the end: SPARE, which must be empty after the last
// byte.
struct Encoder {
  jpeg_compress_struct object;
  jpeg_destination_mgr destination;
  Errors errors;
  bool is_full;
  JOCTET spare[512];

  Encoder() {
    prepare(errors, object.err);
    object.mem = nullptr;
  }

  ~Encoder() {
    jpeg_destroy_compress(&object);
  }
};

Encoder &encoder_of(j_compress_ptr object) {
  return *reinterpret_cast<Encoder *>(object);
}

void begin_output(j_compress_ptr) {
}

void end_output(j_compress_ptr) {
}

boolean turn_to_spare(j_compress_ptr object) {
  Encoder &encoder = encoder_of(object);
  if (encoder.is_full)
    ERREXIT(object, JERR_CANT_SUSPEND);
  encoder.is_full = true;
  encoder.destination.next_output_byte = encoder.spare;
  encoder.destination.free_in_buffer = sizeof encoder.spare;
  return TRUE;
}

}  // namespace

vision_status encode(const cv::Mat &image, int quality, unsigned char *buffer,
                     int capacity, int &length) {
  constexpr int most = 16;
  static_assert(offsetof(Encoder, object) == 0, "see encoder_of");
  Encoder encoder;
  JSAMPROW rows[most];
  length = 0;
  encoder.is_full = capacity < 1;
  if (setjmp(encoder.errors.leave) != 0)
    return encoder.is_full
               ? fail(VISION_TOO_SMALL, "the JPEG does not fit into %d bytes",
                      capacity)
               : fail(VISION_FAILED, "JPEG: %s", encoder.errors.message);
  jpeg_create_compress(&encoder.object);
  encoder.destination.init_destination = begin_output;
  encoder.destination.empty_output_buffer = turn_to_spare;
  encoder.destination.term_destination = end_output;
  encoder.destination.next_output_byte =
      capacity < 1 ? encoder.spare : buffer;
  encoder.destination.free_in_buffer =
      capacity < 1 ? sizeof encoder.spare : std::size_t(capacity);
  encoder.object.dest = &encoder.destination;

  encoder.object.image_width = JDIMENSION(image.cols);
  encoder.object.image_height = JDIMENSION(image.rows);
  encoder.object.input_components = 3;
  encoder.object.in_color_space = JCS_EXT_BGR;
  jpeg_set_defaults(&encoder.object);
  jpeg_set_quality(&encoder.object, quality, TRUE);
  jpeg_start_compress(&encoder.object, TRUE);
  while (encoder.object.next_scanline < encoder.object.image_height) {
    const int first = int(encoder.object.next_scanline);
    const int count = std::min(most, image.rows - first);
    for (int k = 0; k < count; ++k)
      rows[k] = const_cast<uchar *>(image.ptr<uchar>(first + k));
    jpeg_write_scanlines(&encoder.object, rows, JDIMENSION(count));
  }
  jpeg_finish_compress(&encoder.object);
  if (encoder.is_full &&
      encoder.destination.free_in_buffer < sizeof encoder.spare)
    ERREXIT(&encoder.object, JERR_CANT_SUSPEND);
  length = encoder.is_full
               ? capacity
               : capacity - int(encoder.destination.free_in_buffer);
  return VISION_OK;
}

}  // namespace vision
