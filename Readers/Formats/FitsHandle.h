#ifndef galaxy_FitsHandle_h
#define galaxy_FitsHandle_h

#include <fitsio.h>

#include <string>

namespace galaxy
{
class FitsBytes;
struct FitsHdu;

/// A FITS file open in CFITSIO for reading; closes itself.
class FitsHandle
{
public:
  /// `bytes` must outlive the handle. Throws Error with CFITSIO's messages.
  explicit FitsHandle(FitsBytes& bytes);
  ~FitsHandle();
  FitsHandle(const FitsHandle&) = delete;
  FitsHandle& operator=(const FitsHandle&) = delete;

  operator fitsfile*() const { return this->handle; }

  /// Throws Error where CFITSIO understands the HDU in another way than our own reading of it.
  void moveTo(const FitsHdu& hdu);

  /// Throws Error with CFITSIO's message stack, which is emptied, where `status` is an error.
  void check(int status, const std::string& where) const;

  const std::string file;

private:
  fitsfile* handle = nullptr;
  void* memory = nullptr;
  std::size_t memorySize = 0;
};
} // namespace galaxy

#endif
