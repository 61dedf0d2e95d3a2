#include "gui/views/tissue_shading.h"

#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace vallecula::gui {
namespace {

// View coordinates: x right, y up, z to the eye; mm. Terms: light of the room by where a surface faces (top brighter),
// the lamp above the operator, a window from the left, the blade's lamp. Diffuse light is wrapped around edges by colour,
// most for red, as it scatters in tissue (d'Eon, GPU Gems 3 chapter 14, in its cheapest form); gloss is Blinn's, and
// Schlick's Fresnel term brightens wet rims.
const char* const kLight = R"(
  vec3 facing = normalVCVSOutput;
  vec3 toEye = normalize(-vertexVC.xyz);
  vec3 toRoom = vec3(0.0995, 0.2488, 0.9634);
  vec3 toWindow = vec3(-0.8018, 0.5345, 0.2673);
  vec3 toLamp = lampVC - vertexVC.xyz;
  float lampDistance2 = dot(toLamp, toLamp);
  toLamp *= inversesqrt(lampDistance2 + 1e-3);
  float lamp = lampStrength * smoothstep(-0.1, 0.75, -dot(toLamp, lampBeamVC)) / (1.0 + 0.0022 * lampDistance2);
  vec3 wrap = vec3(0.40, 0.16, 0.12);
  vec3 room = clamp((vec3(dot(facing, toRoom)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 window = clamp((vec3(dot(facing, toWindow)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 inner = clamp((vec3(dot(facing, toLamp)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 light = mix(vec3(0.15, 0.12, 0.13), vec3(0.27, 0.26, 0.27), 0.5 + 0.5 * facing.y) + 0.52 * room
             + vec3(0.24, 0.225, 0.20) * window + lamp * vec3(1.0, 0.95, 0.86) * inner + vec3(glow);
  float sharpness = mix(14.0, 70.0, wetnessVS);
  float gloss = mix(0.055, 0.42, wetnessVS);
  vec3 mirror = vec3(0.85) * pow(max(dot(facing, normalize(toRoom + toEye)), 0.0), sharpness)
              + vec3(0.45) * pow(max(dot(facing, normalize(toWindow + toEye)), 0.0), sharpness)
              + lamp * vec3(1.2) * pow(max(dot(facing, normalize(toLamp + toEye)), 0.0), sharpness);
  float rim = 1.0 - max(dot(facing, toEye), 0.0);
  rim = rim * rim * rim * wetnessVS * 0.16;
  float depthShade = dot(vertexColorVSOutput.rgb, vec3(0.33));
  fragOutput0 = vec4(diffuseColor * light + smoothstep(0.08, 0.4, depthShade) * (gloss * mirror + vec3(rim)), opacity);
)";

}  // namespace

void shade_as_tissue(vtkActor* actor, vtkPolyDataMapper* mapper, double glow) {
  mapper->MapDataArrayToVertexAttribute("wetness", kWetness, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  auto* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true,
                                     "//VTK::Normal::Dec\n  in float wetness;\n  out float wetnessVS;\n", false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n  wetnessVS = wetness;\n", false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n  in float wetnessVS;\n", false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kLight, false);
  auto* uniforms = shader->GetFragmentCustomUniforms();
  uniforms->SetUniformf("glow", static_cast<float>(glow));
  uniforms->SetUniformf("lampStrength", 0.0f);
  const float nowhere[3] = {0, 0, 1e4f};
  uniforms->SetUniform3f("lampVC", nowhere);
  uniforms->SetUniform3f("lampBeamVC", nowhere);
}

void set_lamp(vtkActor* actor, vtkCamera* camera, const engine::Vec3& bulb_mm, const engine::Vec3& beam, double strength) {
  auto* view = camera->GetViewTransformMatrix();
  const double bulb[4] = {bulb_mm.x(), bulb_mm.y(), bulb_mm.z(), 1.0}, direction[4] = {beam.x(), beam.y(), beam.z(), 0.0};
  double bulb_view[4], direction_view[4];
  view->MultiplyPoint(bulb, bulb_view);
  view->MultiplyPoint(direction, direction_view);
  const float at[3] = {static_cast<float>(bulb_view[0]), static_cast<float>(bulb_view[1]), static_cast<float>(bulb_view[2])};
  const float along[3] = {static_cast<float>(direction_view[0]), static_cast<float>(direction_view[1]),
                          static_cast<float>(direction_view[2])};
  auto* uniforms = actor->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniform3f("lampVC", at);
  uniforms->SetUniform3f("lampBeamVC", along);
  uniforms->SetUniformf("lampStrength", static_cast<float>(strength));
}

}  // namespace vallecula::gui
