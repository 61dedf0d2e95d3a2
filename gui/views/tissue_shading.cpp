#include "gui/views/tissue_shading.h"

#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace vallecula::gui {
namespace {

// View coordinates: x right, y up, z to the eye; mm. Terms: light of the room by where a surface faces (top brighter),
// the lamp above the operator, a window from the left, the blade's lamp. Diffuse light is wrapped around edges by
// colour, most for red, as it scatters in tissue (d'Eon, GPU Gems 3 chapter 14, in its cheapest form), and varies
// slowly: it is computed per vertex. So are the shadows of blade and tube, which are capsules there: a ray to a light
// that is as wide as it is far off over `sharp` passes one by its nearest distance (Quilez, capsule soft shadow), and
// what lies close to one gets less of the light around. What the room sends into the mouth falls off behind the lips;
// the lamp's own light comes back from all walls of the cavity once more (`bounce`), so nothing that it reaches at all
// is black. Gloss (Blinn) and the brighter rim of what is wet (Schlick) are computed per pixel, with the eye taken as
// far away; the powers are squarings, 16 for dry and 64 for wet. Without a graphics card every operation per pixel
// costs about a millisecond a frame.
const char* const kVertexDeclarations = R"(//VTK::Normal::Dec
  in vec2 wetness;
  out vec3 litVS;       // colour under all diffuse light
  out vec3 towardsVS;   // half way between the eye and the blade's lamp
  out vec4 glossVS;     // strength of dry gloss, wet gloss, rim; of the blade's lamp
  float past(vec3 at, vec3 to, float far, vec3 a, vec3 b, float radius, float sharp) {
    vec3 ab = b - a, from = a - at;
    float along = dot(from, to), side = dot(to, ab), length2 = dot(ab, ab), back = dot(from, ab);
    float apart = max(length2 - side * side, 1e-3 * length2);
    float t = clamp((along * length2 - side * back) / apart, 1e-3, far);
    float s = clamp((side * along - back) / apart, 0.0, 1.0);
    float gap = length(a + s * ab - at - t * to) - radius;
    return smoothstep(-0.5, 0.5, sharp * gap / t);
  }
)";

const char* const kVertexLight = R"(//VTK::Normal::Impl
  vec3 at = (MCVCMatrix * vertexMC).xyz;
  vec3 facing = normalize(normalMatrix * normalMC);
  vec3 toLamp = lampVC - at;
  float lampDistance2 = dot(toLamp, toLamp);
  float lampDistance = sqrt(lampDistance2 + 1e-3);
  toLamp /= lampDistance;
  float lamp = lampStrength * smoothstep(-0.1, 0.75, -dot(toLamp, lampBeamVC)) / (1.0 + 0.0016 * lampDistance2);
  float bounce = 0.24 * lampStrength * wetness.x / (1.0 + 0.0006 * lampDistance2);
  float inside = wetness.x * smoothstep(0.0, 16.0, dot(at - lipsVC, inwardVC));
  float fromRoom = mix(1.0, roomInside, inside), around = 1.0, roomPast = 1.0, lampPast = 1.0;
  vec3 toRoom = vec3(0.0995, 0.2488, 0.9634);
  for (int i = 0; i < solidCount; ++i) {
    vec4 a = solids[i];
    if (a.w <= 0.0) continue;
    vec3 b = solids[i + 1].xyz, ab = b - a.xyz;
    vec3 off = at - a.xyz - ab * clamp(dot(at - a.xyz, ab) / dot(ab, ab), 0.0, 1.0);
    float gap = length(off) - a.w;
    around *= 1.0 - 0.40 * exp(-0.45 * max(gap, 0.0)) * smoothstep(0.5, -0.8, dot(facing, normalize(off)));
    roomPast = min(roomPast, past(at, toRoom, 60.0, a.xyz, b, a.w, 2.5));
    if (i >= lampSolids) lampPast = min(lampPast, past(at, toLamp, lampDistance, a.xyz, b, a.w, 5.0));
  }
  fromRoom *= mix(0.62, 1.0, roomPast);
  lamp *= mix(0.30, 1.0, lampPast);
  vec3 wrap = vec3(0.40, 0.16, 0.12);
  vec3 room = clamp((vec3(dot(facing, toRoom)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 window = clamp((vec3(dot(facing, vec3(-0.8018, 0.5345, 0.2673))) + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 inner = clamp((vec3(dot(facing, toLamp)) + wrap) / (1.0 + wrap), 0.0, 1.0);
  // Light that has gone through blood comes out of a crease red, not grey; the lamp, deep inside, reaches into most.
  vec3 open = vec3(pow(wetness.y, 0.6), wetness.y, wetness.y) * around;
  vec3 ambient = mix(vec3(0.15, 0.12, 0.13), vec3(0.27, 0.26, 0.27), 0.5 + 0.5 * facing.y);
  litVS = scalarColor.rgb * (open * fromRoom * (ambient + 0.52 * room + vec3(0.24, 0.225, 0.20) * window)
        + mix(open, vec3(around), 0.75) * (lamp * vec3(1.0, 0.95, 0.86) * inner + bounce * vec3(1.0, 0.80, 0.75))
        + vec3(glow));
  litVS = min(litVS, 0.72 + 0.28 * (1.0 - exp(-3.6 * max(litVS - 0.72, 0.0))));  // bright light bleaches, and is not cut off
  towardsVS = toLamp + vec3(0.0, 0.0, 1.0);
  float mirrors = clamp(2.2 * wetness.y * around - 0.3, 0.0, 1.0);  // what lies deep mirrors little of the room
  glossVS = vec4(0.047 * (1.0 - wetness.x), 0.36 * wetness.x * fromRoom, 0.16 * wetness.x * (0.3 + 0.7 * fromRoom), 0.0)
        * mirrors;
  glossVS.w = 0.8 * lamp * wetness.x;
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
  float bright = mirror.x + glossVS.w * wet.y;
  if (rimShare > 0.0) {
    float rim = 1.0 - max(normalVCVSOutput.z, 0.0);
    bright += rimShare * glossVS.z * rim * rim * rim;
  }
  fragOutput0 = vec4(litVS + vec3(bright), opacity);
)";

// Seen from within the tissue: the light that comes through it, without any gloss.
const char* const kPixelThrough = R"(
  if (!gl_FrontFacing) fragOutput0 = vec4(vec3(0.68, 0.32, 0.29) + 0.30 * litVS * vec3(1.0, 0.72, 0.66), opacity);
)";

}  // namespace

void shade_as_tissue(vtkActor* actor, vtkPolyDataMapper* mapper, double glow, Sides sides) {
  mapper->MapDataArrayToVertexAttribute("wetness", kWetness, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  auto* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true, kVertexDeclarations, false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, kVertexLight, false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, kPixelDeclarations, false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                       sides == Sides::both ? std::string(kPixelLight) + kPixelThrough : kPixelLight,
                                       false);
  actor->GetProperty()->SetBackfaceCulling(sides == Sides::front);
  set_glow(actor, glow);
  vtkNew<vtkCamera> nobody;
  set_lighting(actor, nobody, {});
}

void set_glow(vtkActor* actor, double glow) {
  actor->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("glow", static_cast<float>(glow));
}

void set_lighting(vtkActor* actor, vtkCamera* camera, const Lighting& lighting) {
  auto* view = camera->GetViewTransformMatrix();
  const auto seen = [&](const engine::Vec3& v, double w) {
    const double in[4] = {v.x(), v.y(), v.z(), w};
    double out[4];
    view->MultiplyPoint(in, out);
    return std::array<float, 3>{static_cast<float>(out[0]), static_cast<float>(out[1]), static_cast<float>(out[2])};
  };
  auto* vertex = actor->GetShaderProperty()->GetVertexCustomUniforms();
  vertex->SetUniform3f("lampVC", seen(lighting.bulb, 1.0).data());
  vertex->SetUniform3f("lampBeamVC", seen(lighting.beam, 0.0).data());
  vertex->SetUniformf("lampStrength", static_cast<float>(lighting.lamp));
  vertex->SetUniform3f("lipsVC", seen(lighting.lips, 1.0).data());
  vertex->SetUniform3f("inwardVC", seen(lighting.inward, 0.0).data());
  vertex->SetUniformf("roomInside", static_cast<float>(lighting.room_inside));
  float solids[Lighting::kSolids][4];
  for (int i = 0; i < Lighting::kSolids; ++i) {
    const auto& s = lighting.solids[static_cast<std::size_t>(i)];
    const auto at = seen({s[0], s[1], s[2]}, 1.0);
    for (int axis = 0; axis < 3; ++axis) solids[i][axis] = at[static_cast<std::size_t>(axis)];
    solids[i][3] = s[3];
  }
  vertex->SetUniform4fv("solids", Lighting::kSolids, solids);
  vertex->SetUniformi("solidCount", lighting.shadows ? Lighting::kSolids - 1 : 0);
  vertex->SetUniformi("lampSolids", lighting.lamp_solids_from);
  actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("rimShare", lighting.rim ? 1.0f : 0.0f);
}

}  // namespace vallecula::gui
