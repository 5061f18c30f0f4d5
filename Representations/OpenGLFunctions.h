/**
 * @file
 * @brief OpenGL's functions, as ParaView brings them: by GLEW, or, with VTK 9.4 and later, by GLAD
 */
#ifndef OpenGLFunctions_h
#define OpenGLFunctions_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
