#ifndef galaxy_Vertices_h
#define galaxy_Vertices_h

class vtkPolyData;

namespace galaxy
{
/// Gives every point a vertex of its own, for what looks at cells: the representations Points and
/// Surface, Threshold, Clip, the spreadsheet. 8 bytes a point. (Of one cell with all points
/// Threshold would keep all points or none.)
void addVertices(vtkPolyData* points);
}

#endif
