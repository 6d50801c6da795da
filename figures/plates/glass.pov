// Hilbert's curve in space, in glass, in the light of a window.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 }
#declare Figure_Textures = array[1] { texture { pigment { srgbf <0.93,0.98,0.99,0.95> } finish { ambient 0 diffuse 0.03 specular 0.9 roughness 0.002 reflection { 0.03, 1 fresnel on } conserve_energy } } }
#include "hilbert-3d.inc" // -n 2 --facets 24
#declare Middle = (Figure_Low + Figure_High)/2;
#declare Size = vlength(Figure_High - Figure_Low);
object { Figure interior { ior 1.46 fade_distance 1.2 fade_power 1 fade_color srgb <0.20,0.70,0.74> } translate -<Middle.x,Middle.y,Figure_Low.z> scale 10/Size rotate z*22 }
plane { z, -0.02 texture { pigment { gradient x color_map { [0 srgb <0.92,0.90,0.86>] [0.5 srgb <0.92,0.90,0.86>] [0.5 srgb <0.55,0.66,0.70>] [1 srgb <0.55,0.66,0.70>] } scale 2.2 rotate z*-30 } finish { ambient 0 diffuse 0.75 } } }
camera { location <8,-14,9.5> sky z up y right -x*image_width/image_height angle 36 look_at <0,0,2.6> }
light_source { <-16,-4,24> rgb 1.2 area_light x*6, y*6, 3, 3 adaptive 0 circular orient }
light_source { <20,-20,16> rgb 0.25 shadowless }
sky_sphere { pigment { gradient z color_map { [0 srgb <0.85,0.88,0.92>] [0.5 srgb <0.55,0.68,0.84>] [1 srgb <0.25,0.40,0.62>] } } }
