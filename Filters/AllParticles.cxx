#include "AllParticles.h"

#include "Filters/JoinParticles.h"
#include "Readers/Processes.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

namespace galaxy
{
namespace
{
constexpr int particlesTag = 0x6a1a;

/// How many particles there are, and a number that others' places would hardly give.
struct Fingerprint
{
  unsigned long long values[2] = { 0, 14695981039346656037ULL };

  explicit Fingerprint(vtkPolyData* particles)
  {
    this->values[0] = static_cast<unsigned long long>(particles->GetNumberOfPoints());
    if (this->values[0] == 0)
    {
      return;
    }
    const auto* places = static_cast<const float*>(particles->GetPoints()->GetVoidPointer(0));
    for (std::size_t i = 0; i < 3 * this->values[0]; ++i)
    {
      std::uint32_t bits;
      std::memcpy(&bits, places + i, sizeof(bits));
      this->values[1] = (this->values[1] ^ bits) * 1099511628211ULL; // FNV-1a
    }
  }
};

/// Throws what the first process that has a problem says, on all of them.
void agreeOn(const std::string& problem, vtkMultiProcessController* all)
{
  const int me = all->GetLocalProcessId();
  int own = problem.empty() ? all->GetNumberOfProcesses() : me, who = 0;
  all->AllReduce(&own, &who, 1, vtkCommunicator::MIN_OP);
  if (who == all->GetNumberOfProcesses())
  {
    return;
  }
  int length = static_cast<int>(problem.size());
  all->Broadcast(&length, 1, who);
  std::string text = problem;
  text.resize(static_cast<std::size_t>(length));
  all->Broadcast(&text[0], length, who);
  throw std::runtime_error(text);
}

/// This process's, and what kept it from having them.
vtkSmartPointer<vtkPolyData> ownParticles(
  vtkDataObject* input, ParticleUse use, std::string& problem)
{
  try
  {
    return particlesOf(input, use);
  }
  catch (const std::bad_alloc&)
  {
    problem = "not enough memory for the particles of a process; use fewer of them";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  return nullptr;
}

/// The first process receives what the others have; `counts` are theirs.
std::vector<vtkSmartPointer<vtkPolyData>> receive(
  vtkPolyData* own, const std::vector<unsigned long long>& counts, vtkMultiProcessController* all)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  if (counts[0] > 0)
  {
    parts.emplace_back(own);
  }
  for (std::size_t from = 1; from < counts.size(); ++from)
  {
    if (counts[from] > 0)
    {
      auto part = vtkSmartPointer<vtkPolyData>::New();
      all->Receive(part, static_cast<int>(from), particlesTag);
      parts.push_back(part);
    }
  }
  return parts;
}
} // namespace

AllParticles gatherParticles(vtkDataObject* input, ParticleUse use)
{
  if (numberOfProcesses() == 1)
  {
    return { particlesOf(input, use), { 0 } };
  }
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  std::string problem;
  vtkSmartPointer<vtkPolyData> own = ownParticles(input, use, problem);
  agreeOn(problem, all);
  const Fingerprint mine(own);
  Fingerprint first = mine;
  all->Broadcast(first.values, 2, 0);
  const bool isFirst = isFirstProcess();
  const bool isCopy = !isFirst && mine.values[0] == first.values[0] && //
    mine.values[1] == first.values[1];
  const unsigned long long count = isCopy ? 0 : mine.values[0];
  std::vector<unsigned long long> counts(static_cast<std::size_t>(numberOfProcesses()));
  all->AllGather(&count, counts.data(), 1);
  if (!isFirst)
  {
    if (count > 0)
    {
      all->Send(own, 0, particlesTag);
    }
    return { vtkSmartPointer<vtkPolyData>::New(), {} };
  }
  AllParticles gathered{ joinParticles(receive(own, counts, all)), {} };
  vtkIdType next = 0;
  for (const unsigned long long each : counts)
  {
    gathered.first.push_back(each > 0 ? next : 0); // a copy is the first one's
    next += static_cast<vtkIdType>(each);
  }
  return gathered;
}
} // namespace galaxy
