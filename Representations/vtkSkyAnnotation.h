/**
 * @class   vtkSkyAnnotation
 * @brief   a scale bar, a compass and the names of galaxies in a view
 *
 * The bar's length holds at the distance of the camera's focal point; the compass shows where North
 * (+Y) and East (-X) of the galaxy's sky point in the picture, shorter where they point out of it.
 * A label stands below the centre of each member of a group; where something is enlarged or drawn
 * together, the scale bar says "not to scale".
 * Drawn over everything else.
 */
#ifndef vtkSkyAnnotation_h
#define vtkSkyAnnotation_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkNew.h"                        // for what it is made of
#include "vtkProp.h"

#include <memory> // for the group

class vtkActor2D;
class vtkCellArray;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSkyAnnotation : public vtkProp
{
public:
  static vtkSkyAnnotation* New();
  vtkTypeMacro(vtkSkyAnnotation, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What is drawn (default: nothing).
  vtkSetMacro(ScaleBar, bool);
  vtkGetMacro(ScaleBar, bool);
  vtkSetMacro(Compass, bool);
  vtkGetMacro(Compass, bool);
  vtkSetMacro(Labels, bool);
  vtkGetMacro(Labels, bool);
  ///@}
  ///@{
  /// From Earth, kpc: the scale bar then says its angle too. 0 (default): not known.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}
  /// What is labelled: the members of a group (Filters/GroupData.h), or nothing.
  void SetGroup(vtkFieldData* fields);

  ///@{
  /// Of lines and text (default: white).
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSkyAnnotation();
  ~vtkSkyAnnotation() override;

private:
  vtkSkyAnnotation(const vtkSkyAnnotation&) = delete;
  void operator=(const vtkSkyAnnotation&) = delete;

  void AddScaleBar(vtkRenderer* renderer, double aspect);
  void AddCompass(vtkRenderer* renderer, double aspect);
  void AddLabels(vtkRenderer* renderer);
  void AddLine(double x0, double y0, double x1, double y1);
  void AddText(int which, const char* text, double x, double y);

  bool ScaleBar = false;
  bool Compass = false;
  bool Labels = false;
  double Distance = 0;
  double Color[3] = { 1, 1, 1 };

  static constexpr int Texts = 3; // the bar's label, N and E
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkPolyData> Drawing;
  vtkNew<vtkActor2D> LineActor;
  vtkNew<vtkTextActor> TextActors[Texts];
  struct Group; // the labels and their actors
  std::unique_ptr<Group> Members;
};

#endif
