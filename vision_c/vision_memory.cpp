// SPDX-License-Identifier: GPL-3.0-or-later
// The buffers that are reused from image to image. Measured by the system test
// Never_Keeps_The_Memory_Of_Large_Images.

#include "vision_internal.hpp"

#include <algorithm>
#include <atomic>
#include <new>

#include <malloc.h>
#include <sys/mman.h>

namespace vision {

namespace {

constexpr int least_mapped = 128 << 10;  // bytes: the C library's beginning

// Bytes of a buffer that is mapped separately.
std::atomic<int> least{least_mapped};

// Maps large buffers separately. The C library does so only if no hole of its
// heap is large enough, and OpenCV's contours leave such holes: an image there
// would prevent the heap from shrinking.
class Apart : public cv::MatAllocator {
public:
  cv::UMatData *allocate(int dimensions, const int *sizes, int type,
                         void *data, std::size_t *step, cv::AccessFlag access,
                         cv::UMatUsageFlags usage) const override {
    std::size_t bytes = CV_ELEM_SIZE(type);
    for (int k = 0; k < dimensions; ++k)
      bytes *= std::size_t(sizes[k]);
    if (data != nullptr || bytes < std::size_t(least))
      return cv::Mat::getStdAllocator()->allocate(dimensions, sizes, type,
                                                  data, step, access, usage);
    void *const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
      throw std::bad_alloc();
    cv::UMatData *const block = new cv::UMatData(this);
    block->data = block->origdata = static_cast<uchar *>(place);
    block->size = bytes;
    step[dimensions - 1] = CV_ELEM_SIZE(type);
    for (int k = dimensions - 1; k > 0; --k)
      step[k - 1] = step[k] * std::size_t(sizes[k]);
    return block;
  }

  bool allocate(cv::UMatData *block, cv::AccessFlag,
                cv::UMatUsageFlags) const override {
    return block != nullptr;
  }

  void deallocate(cv::UMatData *block) const override {
    munmap(block->origdata, block->size);
    delete block;
  }
};

}  // namespace

void expect_images(int width, int height) {
  // Buffers that images of this size need repeatedly, a byte for each pixel,
  // stay with the process; the C library returns larger blocks to the system
  // when no longer needed. Otherwise it would keep the memory of a 4K image
  // permanently.
  mallopt(M_MMAP_THRESHOLD, std::max(least_mapped, width * height / 4 * 5));
  // An image is six times as large, a camera's JPEG rarely: its size varies
  // with each image, and mapping takes time.
  least = std::max(least_mapped, width * height / 2);
}

Kept::Kept() {
#ifndef __SANITIZE_ADDRESS__  // which sees a step outside only in the heap
  // Never destroyed, for the reason given at frame.
  static cv::MatAllocator *const apart = new Apart;
  allocator = apart;
#endif
}

}  // namespace vision
