#ifndef galaxy_ClassicLocale_h
#define galaxy_ClassicLocale_h

#include <clocale>
#include <locale.h>

namespace galaxy
{
/// While it lives, the C functions of this thread read and write numbers with a decimal point,
/// whatever the user's language: CFITSIO and WCSLIB parse headers with them.
class ClassicLocale
{
public:
  ClassicLocale()
    : before(uselocale(classic()))
  {
  }
  ~ClassicLocale() { uselocale(this->before); }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

private:
  static locale_t classic()
  {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }

  locale_t before;
};
} // namespace galaxy

#endif
