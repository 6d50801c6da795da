// Reeds at the shore of a lake, before mountains that algae made at random.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "reeds.inc"
#declare Reeds = object { Figure }
#include "mountains.inc"
#declare Middle = (Figure_Low + Figure_High)/2;
#declare Wide = Figure_High.x - Figure_Low.x;
object { Figure translate -<Middle.x,Middle.y,Figure_Low.z> scale <160/Wide,160/Wide,95/Wide> translate <0,125,-3.2> }
#declare Chance = seed(7);
#macro Stand(Count, X, Y, Wide, Deep)
  #for (I, 1, Count)
    object { Reeds rotate z*360*rand(Chance) rotate x*(6*rand(Chance) - 3) scale 0.42*(0.7 + 0.6*rand(Chance)) translate <X + Wide*(rand(Chance) - 0.5), Y + Deep*(rand(Chance) - 0.5), -0.1> }
  #end
#end
union { Stand(46, -4.6, 9.5, 6, 4) Stand(30, 5.6, 13, 5, 4) Stand(60, -11, 21, 12, 7) Stand(50, 14, 27, 14, 8) }
plane { z, 0 texture { pigment { srgb <0.03,0.07,0.09> } normal { bumps 0.05 scale <1.6,0.5,1> } finish { ambient 0 diffuse 0.3 specular 0.4 roughness 0.01 reflection { 0.15, 0.95 fresnel on } conserve_energy } } interior { ior 1.33 } }
camera { location <0,-1,2.2> sky z up y right -x*image_width/image_height angle 56 look_at <0,30,3.0> }
light_source { <-220,-60,150> rgb <1.2,1.05,0.85> area_light x*12, z*12, 3, 3 adaptive 1 circular orient }
light_source { <90,-90,90> rgb <0.22,0.26,0.34> shadowless }
sky_sphere { pigment { gradient z color_map { [0 srgb <0.96,0.88,0.76>] [0.2 srgb <0.70,0.80,0.88>] [0.7 srgb <0.32,0.52,0.78>] } } pigment { bozo turbulence 0.7 scale <0.5,0.2,0.12> color_map { [0 srgbt <1,1,1,0.25>] [0.5 srgbt <1,1,1,1>] [1 srgbt <1,1,1,1>] } } }
