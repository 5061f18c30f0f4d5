#ifndef galaxy_ActiveGalaxy_h
#define galaxy_ActiveGalaxy_h

#include <vector>

class pqOutputPort;
class pqView;

/// Which galaxy the window's actions are about, and what the client knows of it.
namespace galaxy
{
/// The numbers of a field array of one tuple, from the data information; empty where there is none.
std::vector<double> fieldNumbers(pqOutputPort* port, const char* name);

/// Of the active source, of what it feeds, or of what is visible in the view, the first whose
/// output has this field array; null where there is none.
pqOutputPort* portWithField(pqView* view, const char* name);

/// Whether anything but this output is visible in the view.
bool showsOthers(pqView* view, const pqOutputPort* port);
}

#endif
