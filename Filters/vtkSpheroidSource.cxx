#include "vtkSpheroidSource.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/Placement.h"
#include "Filters/ParticleData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/SpheroidTables.h"
#include "Readers/Processes.h"
#include "Readers/PropertyChecks.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSpheroidSource);

namespace
{
using galaxy::Range;

const std::string proxyName = "Spheroid";
const std::string componentName = "spheroid";

/// Of the properties that are no keys of a spheroid; galaxy::requireInRange looks at the others.
void requireUsable(vtkSpheroidSource& source)
{
  const auto requireNotNegative = [](double value, const char* property) {
    galaxy::requireProperty(
      Range::notNegative().contains(value), property, "a finite number at least 0");
  };
  galaxy::requireProperty(source.GetPreset() >= vtkSpheroidSource::NONE &&
      source.GetPreset() <= vtkSpheroidSource::DWARF_IRREGULAR,
    "Preset", "one of the presets");
  galaxy::requireProperty(source.GetNumberOfParticles() >= 0, "NumberOfParticles", "at least 0");
  requireNotNegative(source.GetSmoothingLength(), "SmoothingLength");
  requireNotNegative(source.GetLuminosity(), "Luminosity");
  for (int c = 0; c < 3; ++c)
  {
    requireNotNegative(source.GetColor()[c], "Color");
    galaxy::requireProperty(
      Range::from(-1e30, 1e30).contains(source.GetCenter()[c]), "Center", "within 1e30 kpc");
  }
}

bool isGiven(const char* file)
{
  return file != nullptr && *file != 0;
}

std::vector<galaxy::StarCluster> listedClusters(vtkSpheroidSource& source)
{
  const std::string file = source.GetClusterList();
  std::vector<galaxy::StarCluster> clusters =
    galaxy::parseClusterList(galaxy::readText(file), file);
  galaxy::requireProperty(
    source.GetLuminosity() > 0, "Luminosity", "greater than 0 with a ClusterList");
  return clusters;
}

void describeShape(vtkSpheroidSource& source, galaxy::SpheroidDescription& spheroid)
{
  spheroid.profile = static_cast<galaxy::SpheroidProfile>(source.GetProfile());
  std::copy_n(source.GetSigma(), 3, spheroid.sigma.begin());
  spheroid.effectiveRadius = source.GetEffectiveRadius();
  spheroid.sersicIndex = source.GetSersicIndex();
  spheroid.scaleRadius = source.GetScaleRadius();
  spheroid.slope = source.GetSlope();
  spheroid.concentration = source.GetConcentration();
  std::copy_n(source.GetAxisRatios(), 2, spheroid.axisRatios.begin());
  spheroid.truncation = source.GetTruncation() == 0 ? spheroid.truncation : source.GetTruncation();
}

/// Whoever does not say where it ends, be it by a preset, gets the usual end.
void endSomewhere(galaxy::SpheroidDescription& spheroid)
{
  if (std::isinf(spheroid.truncation))
  {
    spheroid.truncation = galaxy::usualTruncation(spheroid);
  }
}

galaxy::SpheroidDescription describe(vtkSpheroidSource& source)
{
  requireUsable(source);
  const auto preset = static_cast<galaxy::SpheroidPreset>(source.GetPreset());
  galaxy::SpheroidDescription spheroid = galaxy::spheroidPreset(preset);
  if (preset == galaxy::SpheroidPreset::None)
  {
    describeShape(source, spheroid);
  }
  endSomewhere(spheroid);
  spheroid.tilted = false;
  spheroid.oriented = source.GetOriented();
  spheroid.positionAngle = source.GetPositionAngle();
  spheroid.inclination = source.GetInclination();
  spheroid.centralBrightness *= source.GetCentralBrightness(); // by 0 of what is dark
  if (source.GetLuminosity() > 0)
  {
    spheroid.luminosity = source.GetLuminosity();
  }
  spheroid.clusters = source.GetClusters();
  spheroid.clusterRadius = source.GetClusterRadius();
  galaxy::requireInRange(spheroid, proxyName, componentName);
  if (isGiven(source.GetClusterList()))
  {
    spheroid.listed = listedClusters(source);
  }
  if (isGiven(source.GetShells()))
  {
    const std::string file = source.GetShells();
    spheroid.ellipsoids = galaxy::parseEllipsoidShells(galaxy::readText(file), file);
  }
  return spheroid;
}
} // namespace

vtkSpheroidSource::vtkSpheroidSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkSpheroidSource::~vtkSpheroidSource()
{
  this->SetShells(nullptr);
  this->SetClusterList(nullptr);
}

int vtkSpheroidSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!galaxy::isFirstProcess())
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    galaxy::ComponentDescription component;
    component.name = componentName;
    component.type = galaxy::ComponentType::Spheroid;
    component.spheroid = describe(*this);
    component.particles = this->NumberOfParticles;
    std::copy_n(this->Color, 3, component.color.begin());
    if (this->SmoothingLength > 0)
    {
      component.smoothing.model = galaxy::SmoothingModel::Constant;
      component.smoothing.length = this->SmoothingLength;
    }
    galaxy::Galaxy input;
    input.description.file = proxyName;
    input.description.distance = 1;
    input.description.components.push_back(component);
    input.rings.rings.resize(1);
    galaxy::BuildOptions options;
    options.seed = galaxy::seedOf(this->RandomSeed);
    options.progress = galaxy::progressOf(this);
    galaxy::Particles particles = galaxy::buildGalaxy(input, options);
    galaxy::Placement placement;
    placement.centre = { this->Center[0], this->Center[1], this->Center[2] };
    galaxy::placeParticles(placement, particles);
    galaxy::toPolyData(std::move(particles), vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkSpheroidSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* values, int size) {
    os << indent << name << ":";
    std::for_each(values, values + size, [&os](double value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  vector("Sigma", this->Sigma, 3);
  os << indent << "EffectiveRadius: " << this->EffectiveRadius << "\n";
  os << indent << "SersicIndex: " << this->SersicIndex << "\n";
  os << indent << "ScaleRadius: " << this->ScaleRadius << "\n";
  os << indent << "Slope: " << this->Slope << "\n";
  os << indent << "Concentration: " << this->Concentration << "\n";
  os << indent << "Truncation: " << this->Truncation << "\n";
  vector("AxisRatios", this->AxisRatios, 2);
  os << indent << "NumberOfParticles: " << this->NumberOfParticles << "\n";
  os << indent << "Oriented: " << this->Oriented << "\n";
  os << indent << "PositionAngle: " << this->PositionAngle << "\n";
  os << indent << "Inclination: " << this->Inclination << "\n";
  os << indent << "Shells: " << (this->Shells ? this->Shells : "none") << "\n";
  os << indent << "Clusters: " << this->Clusters << "\n";
  os << indent << "ClusterRadius: " << this->ClusterRadius << "\n";
  os << indent << "ClusterList: " << (this->ClusterList ? this->ClusterList : "none") << "\n";
  vector("Center", this->Center, 3);
  os << indent << "CentralBrightness: " << this->CentralBrightness << "\n";
  os << indent << "Luminosity: " << this->Luminosity << "\n";
  vector("Color", this->Color, 3);
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
