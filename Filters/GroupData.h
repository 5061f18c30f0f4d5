#ifndef galaxy_GroupData_h
#define galaxy_GroupData_h

#include "Filters/Model/GroupBuilder.h"

#include <string>
#include <vector>

class vtkFieldData;

/// The members of a group as field arrays of one tuple each: `MemberName`, `MemberPosition` and
/// `MemberDistance` (kpc), `MemberMagnification`; and `GroupSeparation`, one number.
namespace galaxy
{
void toFieldData(const std::vector<GroupPlace>& places, double separation, vtkFieldData* fields);

/// What a picture may say of a group.
struct GroupLabels
{
  struct Label
  {
    std::string text; ///< as "IC 4316, 4.41 Mpc (×5)", five times enlarged
    double position[3];
  };
  std::vector<Label> members;
  bool isToScale =
    true; ///< false: members are enlarged, or their distances from one another are not true
};

/// None where the arrays are not there.
GroupLabels groupLabels(vtkFieldData* fields);
}

#endif
