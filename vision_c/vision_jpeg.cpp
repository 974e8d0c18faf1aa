// SPDX-License-Identifier: GPL-3.0-or-later
// JPEG: examines the camera's own, decodes it if necessary, and encodes images
// for the monitor.

#include "vision_internal.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
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
struct Errors : jpeg_error_mgr {
  std::jmp_buf leave;
  char message[JMSG_LENGTH_MAX];
};

void leave(j_common_ptr object) {
  Errors *const errors = static_cast<Errors *>(object->err);
  errors->format_message(object, errors->message);
  std::longjmp(errors->leave, 1);
}

// A decoder or an encoder, not yet created.
template <typename Object> struct Codec {
  Object object;
  Errors errors;

  Codec() {
    object.err = jpeg_std_error(&errors);
    object.mem = nullptr;
    errors.error_exit = leave;
    // What is damaged is decoded all the same, as far as it can be.
    errors.emit_message = [](j_common_ptr, int) {};
  }

  ~Codec() {
    jpeg_destroy(reinterpret_cast<j_common_ptr>(&object));
  }
};

using Decoder = Codec<jpeg_decompress_struct>;

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
  // libjpeg checks these numbers only when it starts to decode.
  const auto is_there = [](JHUFF_TBL *const *tables, int number) {
    return number >= 0 && number < NUM_HUFF_TBLS && tables[number] != nullptr;
  };
  return std::all_of(
      object.cur_comp_info, object.cur_comp_info + object.num_components,
      [&](const jpeg_component_info *component) {
        return is_there(object.dc_huff_tbl_ptrs, component->dc_tbl_no) &&
               is_there(object.ac_huff_tbl_ptrs, component->ac_tbl_no);
      });
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
  constexpr JDIMENSION smallest = 8;
  Decoder decoder;
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
  for (int k = 0; k < image.rows; ++k) {
    JSAMPROW row = image.ptr<uchar>(k);
    jpeg_read_scanlines(&decoder.object, &row, 1);
  }
  return true;
}

vision_status encode(const cv::Mat &image, int quality, unsigned char *buffer,
                     int capacity, int &length) {
  Codec<jpeg_compress_struct> encoder;
  // The buffer; once that is full, one of libjpeg's own, with all of it.
  unsigned char *place = buffer;
  unsigned long size = (unsigned long)capacity;
  if (setjmp(encoder.errors.leave) != 0)
    return fail(VISION_FAILED, "JPEG: %s", encoder.errors.message);
  jpeg_create_compress(&encoder.object);
  jpeg_mem_dest(&encoder.object, &place, &size);
  encoder.object.image_width = JDIMENSION(image.cols);
  encoder.object.image_height = JDIMENSION(image.rows);
  encoder.object.input_components = 3;
  encoder.object.in_color_space = JCS_EXT_BGR;
  jpeg_set_defaults(&encoder.object);
  jpeg_set_quality(&encoder.object, quality, TRUE);
  jpeg_start_compress(&encoder.object, TRUE);
  for (int k = 0; k < image.rows; ++k) {
    JSAMPROW row = const_cast<uchar *>(image.ptr<uchar>(k));
    jpeg_write_scanlines(&encoder.object, &row, 1);
  }
  jpeg_finish_compress(&encoder.object);

  const bool fits = size <= (unsigned long)capacity;
  if (place != buffer) {
    if (fits)
      std::memcpy(buffer, place, size);
    std::free(place);
  }
  if (!fits)
    return fail(VISION_TOO_SMALL, "the JPEG does not fit into %d bytes",
                capacity);
  length = int(size);
  return VISION_OK;
}

}  // namespace vision
