#include "gui/views/tissue_shading.h"

#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <array>

namespace vallecula::gui {
namespace {

// View coordinates: x right, y up, z to the eye; mm. Terms: light of the room by where a surface faces (top brighter),
// the lamp above the operator, a window from the left, the blade's lamp. Diffuse light is wrapped around edges by
// colour, most for red, as it scatters in tissue (d'Eon, GPU Gems 3 chapter 14, in its cheapest form), and varies
// slowly: it is computed per vertex. Gloss (Blinn) and the brighter rim of what is wet (Schlick) are computed per
// pixel, with the eye taken as far away; the powers are squarings, 16 for dry and 64 for wet. Without a graphics card
// every operation per pixel costs about a millisecond a frame.
const char* const kVertexDeclarations = R"(//VTK::Normal::Dec
  in float wetness;
  out vec3 litVS;       // colour under all diffuse light
  out vec3 towardsVS;   // half way between the eye and the blade's lamp
  out vec4 glossVS;     // strength of dry gloss, wet gloss, rim; of the blade's lamp
)";

const char* const kVertexLight = R"(//VTK::Normal::Impl
  vec3 at = (MCVCMatrix * vertexMC).xyz;
  vec3 facing = normalize(normalMatrix * normalMC);
  vec3 toLamp = lampVC - at;
  float lampDistance2 = dot(toLamp, toLamp);
  toLamp *= inversesqrt(lampDistance2 + 1e-3);
  float lamp = lampStrength * smoothstep(-0.1, 0.75, -dot(toLamp, lampBeamVC)) / (1.0 + 0.0022 * lampDistance2);
  vec3 wrap = vec3(0.40, 0.16, 0.12);
  vec3 room = clamp((vec3(dot(facing, vec3(0.0995, 0.2488, 0.9634))) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 window = clamp((vec3(dot(facing, vec3(-0.8018, 0.5345, 0.2673))) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 inner = clamp((vec3(dot(facing, toLamp)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  litVS = scalarColor.rgb * (mix(vec3(0.15, 0.12, 0.13), vec3(0.27, 0.26, 0.27), 0.5 + 0.5 * facing.y) + 0.52 * room
        + vec3(0.24, 0.225, 0.20) * window + lamp * vec3(1.0, 0.95, 0.86) * inner + vec3(glow));
  towardsVS = toLamp + vec3(0.0, 0.0, 1.0);
  float open = clamp(3.0 * scalarColor.g - 0.25, 0.0, 1.0);  // what is dark lies deep, and mirrors nothing
  glossVS = vec4(0.047 * (1.0 - wetness), 0.36 * wetness, 0.16 * wetness, 0.0) * open;
  glossVS.w = 1.4 * lamp;
)";

const char* const kPixelDeclarations = R"(//VTK::Normal::Dec
  in vec3 litVS;
  in vec3 towardsVS;
  in vec4 glossVS;
)";

const char* const kPixelLight = R"(
  vec2 gloss = vec2(dot(normalVCVSOutput, vec3(0.0502, 0.1256, 0.9908)),
                    dot(normalVCVSOutput, towardsVS) * inversesqrt(dot(towardsVS, towardsVS) + 1e-6));
  gloss = max(gloss, vec2(0.0));
  gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
  vec2 wet = gloss * gloss;
  wet *= wet;
  vec2 mirror = glossVS.x * gloss + glossVS.y * wet;
  float rim = 1.0 - max(normalVCVSOutput.z, 0.0);
  fragOutput0 = vec4(litVS + vec3(mirror.x + glossVS.w * mirror.y + glossVS.z * rim * rim * rim), opacity);
)";

void set_lamp_uniforms(vtkShaderProperty* shader, const std::array<float, 3>& bulb, const std::array<float, 3>& beam,
                       float strength) {
  auto* vertex = shader->GetVertexCustomUniforms();
  vertex->SetUniform3f("lampVC", bulb.data());
  vertex->SetUniform3f("lampBeamVC", beam.data());
  vertex->SetUniformf("lampStrength", strength);
}

}  // namespace

void shade_as_tissue(vtkActor* actor, vtkPolyDataMapper* mapper, double glow) {
  mapper->MapDataArrayToVertexAttribute("wetness", kWetness, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  auto* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true, kVertexDeclarations, false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, kVertexLight, false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, kPixelDeclarations, false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kPixelLight, false);
  shader->GetVertexCustomUniforms()->SetUniformf("glow", static_cast<float>(glow));
  set_lamp_uniforms(shader, {0, 0, 1e4f}, {0, 0, -1}, 0.0f);
}

void set_lamp(vtkActor* actor, vtkCamera* camera, const engine::Vec3& bulb_mm, const engine::Vec3& beam,
              double strength) {
  auto* view = camera->GetViewTransformMatrix();
  const double bulb[4] = {bulb_mm.x(), bulb_mm.y(), bulb_mm.z(), 1.0},
               direction[4] = {beam.x(), beam.y(), beam.z(), 0.0};
  double bulb_view[4], direction_view[4];
  view->MultiplyPoint(bulb, bulb_view);
  view->MultiplyPoint(direction, direction_view);
  const std::array<float, 3> at{static_cast<float>(bulb_view[0]), static_cast<float>(bulb_view[1]),
                                static_cast<float>(bulb_view[2])};
  const std::array<float, 3> along{static_cast<float>(direction_view[0]), static_cast<float>(direction_view[1]),
                                   static_cast<float>(direction_view[2])};
  set_lamp_uniforms(actor->GetShaderProperty(), at, along, static_cast<float>(strength));
}

}  // namespace vallecula::gui
