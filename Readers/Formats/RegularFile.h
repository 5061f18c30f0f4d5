#ifndef galaxy_RegularFile_h
#define galaxy_RegularFile_h

#include <string>

namespace galaxy
{
/// Throws Error saying what `file` is unless it is a regular file or a link to one: nothing is
/// opened, so that neither a pipe nor a device is waited for.
void requireRegularFile(const std::string& file);

/// What a file is that begins like this and is known to be neither text nor FITS, "compressed by
/// gzip", and what to do about it; empty where that is not known.
std::string foreignFormat(const std::string& beginning);
} // namespace galaxy

#endif
