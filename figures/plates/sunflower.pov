// The head in the sun, close; behind it leaves that are out of focus.
#version 3.7;
#declare Only_Figure = yes;
global_settings { assumed_gamma 1 max_trace_level 4 }
#declare Velvet = finish { ambient 0.06 diffuse 0.85 specular 0.08 roughness 0.08 }
#macro Petal(C) texture { pigment { srgb C } finish { ambient 0.12 diffuse 0.8, 0.35 specular 0.1 roughness 0.1 } } #end
#include "sunflower.inc"
camera { location <10,-32,30> sky z up y right -x*image_width/image_height angle 44 look_at <0.6,-1.5,-1> }
light_source { <-60,-40,110> rgb <1.15,1.08,0.95> area_light x*22, y*22, 5, 5 adaptive 1 circular orient }
light_source { <60,-60,50> rgb <0.25,0.3,0.4> shadowless }
background { srgb <0.3,0.42,0.2> }
plane { z, -16 texture { pigment { bozo color_map { [0 srgb <0.10,0.22,0.06>] [0.5 srgb <0.24,0.40,0.12>] [1 srgb <0.5,0.6,0.22>] } scale 9 turbulence 0.4 } finish { ambient 0.3 diffuse 0.5 } } }
object { Figure }
