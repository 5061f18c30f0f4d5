#include "SplatCanvas.h"

#include "OpenGLFunctions.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

namespace galaxy
{
namespace
{
const char* FragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
void main()
{
  gl_FragData[0] = vec4(texture2D(picture, texCoord).rgb, 1.0);
}
)";

/// Makes the window's context the current one again, with the framebuffer that is drawn into: a
/// widget's window binds its own where it is made current.
void returnTo(vtkOpenGLRenderWindow* window)
{
  if (!window->IsCurrent())
  {
    vtkOpenGLState* state = window->GetState();
    state->PushFramebufferBindings();
    window->MakeCurrent();
    state->ResetFramebufferBindings();
    state->PopFramebufferBindings();
  }
}
}

struct SplatCanvas::Quad
{
  vtkSmartPointer<vtkTextureObject> texture = vtkSmartPointer<vtkTextureObject>::New();
  std::unique_ptr<vtkOpenGLQuadHelper> helper;

  void draw(vtkOpenGLRenderWindow* window, const float* rgb, int width, int height)
  {
    if (!this->helper)
    {
      this->helper =
        std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, FragmentShader, nullptr);
    }
    else
    {
      window->GetShaderCache()->ReadyShaderProgram(this->helper->Program);
    }
    this->texture->SetContext(window);
    this->texture->Create2DFromRaw(width, height, 3, VTK_FLOAT, const_cast<float*>(rgb));
    this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->texture->Activate();
    this->helper->Program->SetUniformi("picture", this->texture->GetTextureUnit());
    this->helper->Render();
    this->texture->Deactivate();
  }
};

SplatCanvas::SplatCanvas()
  : quad(std::make_unique<Quad>())
{
}

SplatCanvas::~SplatCanvas() = default;

void SplatCanvas::layOnWhole(const ShownPicture& picture, vtkRenderer* renderer)
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  if (!window)
  {
    return;
  }
  returnTo(window);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
  state->vtkglScissor(origin[0], origin[1], size[0], size[1]);
  this->lay(picture, renderer);
}

void SplatCanvas::lay(const ShownPicture& picture, vtkRenderer* renderer)
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow());
  if (picture.width == 0 || !window)
  {
    return;
  }
  returnTo(window);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  if (!picture.transmittance.empty())
  {
    state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    this->quad->draw(window, picture.transmittance.data(), picture.width, picture.height);
  }
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->quad->draw(window, picture.light.data(), picture.width, picture.height);
}
} // namespace galaxy
