#include "RemotePicture.h"

#include "vtkLZ4DataCompressor.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"

#include <algorithm>

namespace galaxy
{
namespace
{
using Bytes = std::vector<unsigned char>;

constexpr int other = 1; // as each end of a socket calls the other one
constexpr int tag = 0x6a1c;

enum Header
{
  Width,
  Height,
  HasTransmittance,
  EffectsLength,
  StatisticsLength,
  HeaderSize
};

vtkMultiProcessController* wayTo(vtkPVSession::ServerFlags to)
{
  auto session =
    vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  return session ? session->GetController(to) : nullptr;
}

void sendValues(const std::vector<float>& values, vtkMultiProcessController* to)
{
  Bytes bytes(values.size());
  std::transform(values.begin(), values.end(), bytes.begin(), [](float value) {
    return static_cast<unsigned char>(255 * std::min(std::max(value, 0.0F), 1.0F) + 0.5F);
  });
  vtkNew<vtkLZ4DataCompressor> compressor;
  Bytes packed(compressor->GetMaximumCompressionSpace(bytes.size()));
  auto size = static_cast<vtkIdType>(
    compressor->Compress(bytes.data(), bytes.size(), packed.data(), packed.size()));
  to->Send(&size, 1, other, tag);
  to->Send(packed.data(), size, other, tag);
}

std::vector<float> receiveValues(std::size_t count, vtkMultiProcessController* from)
{
  vtkIdType size = 0;
  from->Receive(&size, 1, other, tag);
  Bytes packed(static_cast<std::size_t>(size)), bytes(count);
  from->Receive(packed.data(), size, other, tag);
  vtkNew<vtkLZ4DataCompressor> compressor;
  compressor->Uncompress(packed.data(), packed.size(), bytes.data(), bytes.size());
  std::vector<float> values(count);
  std::transform(bytes.begin(), bytes.end(), values.begin(),
    [](unsigned char byte) { return static_cast<float>(byte) / 255; });
  return values;
}

void sendText(const std::string& text, vtkMultiProcessController* to)
{
  if (!text.empty())
  {
    to->Send(text.data(), static_cast<vtkIdType>(text.size()), other, tag);
  }
}

std::string receiveText(int size, vtkMultiProcessController* from)
{
  std::string text(static_cast<std::size_t>(size), ' ');
  if (size > 0)
  {
    from->Receive(&text[0], size, other, tag);
  }
  return text;
}
} // namespace

vtkMultiProcessController* wayToClient()
{
  return wayTo(vtkPVSession::CLIENT);
}

vtkMultiProcessController* wayToServer()
{
  return wayTo(vtkPVSession::RENDER_SERVER_ROOT);
}

void sendPicture(const ShownPicture& picture, vtkMultiProcessController* client)
{
  int header[HeaderSize];
  header[Width] = picture.width;
  header[Height] = picture.height;
  header[HasTransmittance] = std::any_of(picture.transmittance.begin(), picture.transmittance.end(),
    [](float value) { return value != 1; });
  header[EffectsLength] = static_cast<int>(picture.activeEffects.size());
  header[StatisticsLength] = static_cast<int>(picture.renderStatistics.size());
  client->Send(header, HeaderSize, other, tag);
  sendText(picture.activeEffects, client);
  sendText(picture.renderStatistics, client);
  if (picture.width > 0)
  {
    sendValues(picture.light, client);
  }
  if (header[HasTransmittance])
  {
    sendValues(picture.transmittance, client);
  }
}

ShownPicture receivePicture(vtkMultiProcessController* server)
{
  int header[HeaderSize] = {};
  server->Receive(header, HeaderSize, other, tag);
  ShownPicture picture;
  picture.width = header[Width];
  picture.height = header[Height];
  picture.activeEffects = receiveText(header[EffectsLength], server);
  picture.renderStatistics = receiveText(header[StatisticsLength], server);
  const std::size_t values = 3 * static_cast<std::size_t>(header[Width]) * header[Height];
  if (values > 0)
  {
    picture.light = receiveValues(values, server);
  }
  if (header[HasTransmittance])
  {
    picture.transmittance = receiveValues(values, server);
  }
  return picture;
}
} // namespace galaxy
