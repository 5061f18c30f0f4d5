#ifndef galaxy_Particles_h
#define galaxy_Particles_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace galaxy
{
/// A plain array whose memory is not touched before it is written, which can grow or shrink at its
/// end (large ones without being copied, where the system remaps their pages), and which can be
/// given away (to VTK, which releases it with free).
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable_v<T>);

public:
  Buffer() = default;
  explicit Buffer(std::size_t size) { this->resize(size); }
  std::size_t size() const { return this->count; }
  bool empty() const { return this->count == 0; }
  T* data() { return this->items.get(); }
  const T* data() const { return this->items.get(); }
  T& operator[](std::size_t i) { return this->items.get()[i]; }
  const T& operator[](std::size_t i) const { return this->items.get()[i]; }
  T* begin() { return this->items.get(); }
  T* end() { return this->items.get() + this->count; }
  const T* begin() const { return this->items.get(); }
  const T* end() const { return this->items.get() + this->count; }

  /// Keeps what fits; new items have no value yet. Throws std::bad_alloc, then nothing has changed.
  void resize(std::size_t size)
  {
    if (size > std::numeric_limits<std::size_t>::max() / sizeof(T))
    {
      throw std::bad_alloc();
    }
    // At least one byte, for realloc to size 0 is not defined.
    void* moved = std::realloc(this->items.get(), std::max<std::size_t>(1, size * sizeof(T)));
    if (!moved)
    {
      throw std::bad_alloc();
    }
    (void)this->items.release();
    this->items.reset(static_cast<T*>(moved));
    this->count = size;
  }

  T* release()
  {
    this->count = 0;
    return this->items.release();
  }

private:
  struct Free
  {
    void operator()(T* memory) const { std::free(memory); }
  };
  std::unique_ptr<T, Free> items;
  std::size_t count = 0;
};

/// What all particles of one component share.
struct ComponentInfo
{
  std::string name;
  bool absorbs = false;                        ///< else it emits
  std::array<double, 3> absorption{ 1, 1, 1 }; ///< RGB_A of an absorber
  double size = 1;                             ///< factor on the smoothing length when drawn
  double brightness = 1;                       ///< factor on emission or cross-section when drawn
  double light = 1;                            ///< a further factor on emission alone
  bool isRecolored = false;                    ///< drawn with `color` in place of its own
  std::array<double, 3> color{ 1, 1, 1 };      ///< of its light, or of what it absorbs
};

/// Particles as structure of arrays: 24 bytes each, 36 with velocities.
struct Particles
{
  Buffer<float> position;         ///< 3 N, kpc, in the frame of Vec3.h
  Buffer<float> smoothingLength;  ///< N, kpc: the radius at which the kernel ends
  Buffer<float> intensity;        ///< N: luminosity, or an absorber's cross-section in kpc^2
  Buffer<std::uint8_t> color;     ///< 3 N: RGB_s
  Buffer<std::uint8_t> component; ///< N: index into `components`
  Buffer<float> velocity;         ///< 3 N, km/s, or empty
  std::vector<ComponentInfo> components;

  std::size_t size() const { return this->smoothingLength.size(); }
};
} // namespace galaxy

#endif
