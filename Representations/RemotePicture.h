#ifndef galaxy_RemotePicture_h
#define galaxy_RemotePicture_h

#include "SplatCanvas.h"

class vtkMultiProcessController;

/// A server's picture on its way to the client, who lays it over the view: what ParaView sends
/// there has one opacity for three transmittances, and is smoothed (FXAA) on arrival.
namespace galaxy
{
/// The way to the client; null unless this is the first process of a server.
vtkMultiProcessController* wayToClient();
/// The way to the server that draws; null unless this is the client of one.
vtkMultiProcessController* wayToServer();

/// In 8 bits a channel.
void sendPicture(const ShownPicture& picture, vtkMultiProcessController* client);
ShownPicture receivePicture(vtkMultiProcessController* server);
} // namespace galaxy

#endif
