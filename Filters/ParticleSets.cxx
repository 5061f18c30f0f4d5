#include "ParticleSets.h"

#include "Filters/JoinParticles.h"
#include "Filters/PointArrays.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <stdexcept>

namespace galaxy
{
namespace
{
std::string nameOf(vtkCompositeDataIterator* at)
{
  vtkInformation* about = at->HasCurrentMetaData() ? at->GetCurrentMetaData() : nullptr;
  const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "block " + std::to_string(at->GetCurrentFlatIndex());
}

vtkSmartPointer<vtkPoints> pointsOf(vtkDataSet* data)
{
  if (auto set = vtkPointSet::SafeDownCast(data))
  {
    return set->GetPoints();
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double place[3];
    data->GetPoint(i, place);
    points->SetPoint(i, place);
  }
  return points;
}

/// Its points and their arrays, without cells.
vtkSmartPointer<vtkPolyData> plainParticles(vtkDataSet* data)
{
  auto particles = vtkSmartPointer<vtkPolyData>::New();
  particles->SetPoints(pointsOf(data));
  particles->GetPointData()->ShallowCopy(data->GetPointData());
  particles->GetFieldData()->ShallowCopy(data->GetFieldData());
  return withPlainArrays(particles);
}

bool has(vtkPolyData* particles, const char* array)
{
  return particles->GetPointData()->GetArray(array) != nullptr;
}

void requireDrawable(vtkPolyData* particles)
{
  if (!has(particles, "SmoothingLength"))
  {
    throw std::runtime_error(
      "the particles have no point array SmoothingLength (kpc); use the filter SmoothingLength");
  }
  if (!has(particles, "Intensity") && !has(particles, "Emission") && !has(particles, "Absorption"))
  {
    throw std::runtime_error("the particles have none of the point arrays Intensity, Emission, "
                             "Absorption; add one, with Calculator for example");
  }
}
} // namespace

std::vector<PointSet> pointSetsOf(vtkDataObject* input)
{
  std::vector<PointSet> sets;
  const auto add = [&sets](vtkDataObject* data, const std::string& name) {
    auto set = vtkDataSet::SafeDownCast(data);
    if (set && set->GetNumberOfPoints() > 0)
    {
      sets.push_back({ set, name });
    }
  };
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> at;
    at.TakeReference(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject(), nameOf(at));
    }
    return sets;
  }
  if (input && !vtkDataSet::SafeDownCast(input))
  {
    throw std::runtime_error(std::string("a ") + input->GetClassName() +
      " has no points; use a filter that makes points of it, as Table To Points");
  }
  add(input, "");
  return sets;
}

vtkSmartPointer<vtkPolyData> particlesOf(vtkDataObject* input, ParticleUse use)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (const PointSet& set : pointSetsOf(input))
  {
    try
    {
      parts.push_back(plainParticles(set.data));
      if (use == ParticleUse::Drawn)
      {
        requireDrawable(parts.back());
      }
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error((set.name.empty() ? "" : set.name + ": ") + error.what());
    }
  }
  return joinParticles(parts);
}
} // namespace galaxy
