// A hundred thousand plants of three kinds, each a copy of one mesh, on rolling ground.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
#include "grass.inc"
#declare Grass = object { Figure }
#include "daisy.inc"
#declare Daisy = object { Figure }
#declare Soft = finish { ambient 0.08 diffuse 0.8, 0.3 }
#declare Figure_Textures = array[3] { texture { pigment { srgb <0.25,0.48,0.2> } finish { Soft } }, texture { pigment { srgb <0.16,0.12,0.12> } finish { Soft } }, texture { pigment { srgb <0.86,0.16,0.1> } finish { Soft } } }
#include "daisy.inc"
#declare Poppy = object { Figure }
#declare Ground = function(x, y) { 1.3*sin(x*0.09 + 0.4)*cos(y*0.06) + 0.5*sin(x*0.21 + y*0.13) }
#declare Chance = seed(20261126);
#macro Plant(What, Scale)
  #local Far = 2.2 + 150*pow(rand(Chance), 1.35);
  #local Aside = (rand(Chance) - 0.5)*(5 + 1.15*Far);
  object { What rotate z*360*rand(Chance) rotate x*(rand(Chance)*20 - 10) scale Scale*(0.7 + 0.6*rand(Chance)) translate <Aside, Far, Ground(Aside, Far)> }
#end
union { #for (I, 1, 93000) Plant(Grass, 0.5) #end }
union { #for (I, 1, 4500) Plant(Daisy, 0.27) #end }
union { #for (I, 1, 2500) Plant(Poppy, 0.27) #end }
// The ground between them, in squares.
#declare Earth = texture { pigment { srgb <0.13,0.22,0.06> } finish { ambient 0.1 diffuse 0.6 } }
mesh {
  #for (I, -60, 59) #for (K, 0, 99)
    #local A = <I*1.7, K*1.7, Ground(I*1.7, K*1.7)>; #local B = <(I+1)*1.7, K*1.7, Ground((I+1)*1.7, K*1.7)>;
    #local C = <(I+1)*1.7, (K+1)*1.7, Ground((I+1)*1.7, (K+1)*1.7)>; #local D = <I*1.7, (K+1)*1.7, Ground(I*1.7, (K+1)*1.7)>;
    triangle { A, B, C } triangle { A, C, D }
  #end #end
  texture { Earth }
}
plane { z, -2.4 texture { pigment { srgb <0.62,0.72,0.52> } finish { ambient 0.7 diffuse 0.2 } } }
camera { location <0,-0.6,2.9> sky z up y right -x*image_width/image_height angle 54 look_at <0,16,0.9> }
light_source { <-240,-70,150> rgb <1.25,1.08,0.82> area_light x*12, z*12, 3, 3 adaptive 1 circular orient }
light_source { <80,120,140> rgb <0.26,0.32,0.42> shadowless }
sky_sphere { pigment { gradient z color_map { [0 srgb <0.97,0.90,0.78>] [0.18 srgb <0.74,0.84,0.90>] [0.7 srgb <0.34,0.56,0.82>] } } pigment { bozo turbulence 0.7 scale <0.5,0.2,0.12> color_map { [0 srgbt <1,1,1,0.2>] [0.55 srgbt <1,1,1,1>] [1 srgbt <1,1,1,1>] } } }
