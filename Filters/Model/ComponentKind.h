#ifndef galaxy_ComponentKind_h
#define galaxy_ComponentKind_h

#include "Filters/Model/Particles.h"

namespace galaxy
{
/// What a component is made of, as far as its name tells.
enum class ComponentKind
{
  Stars, ///< whatever emits and has no other name
  YoungStars,
  Bulge,
  Halo,
  AtomicGas, ///< and gas of no other name
  IonizedGas,
  MolecularGas,
  Dust, ///< whatever absorbs
};

/// From words of the name such as "bulge", "HI" or "molecular", upper or lower case.
ComponentKind kindOf(const ComponentInfo& component);
} // namespace galaxy

#endif
