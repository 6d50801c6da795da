"""How objects show themselves in notebooks: pieces of HTML."""

from __future__ import annotations

import base64
import html
import json
from typing import Any

__all__: list[str] = []


def escaped(text: str) -> str:
    return html.escape(text, quote=True)


def svg_element(document: str) -> str:
    """The element of an SVG document, to stand within HTML."""
    return document[max(0, document.find("<svg")):]


def preformatted(text: str) -> str:
    return f'<pre style="line-height:1.3">{escaped(text)}</pre>'


def table(head: list[str], rows: list[list[Any]]) -> str:
    cells = "".join(f"<th>{escaped(one)}</th>" for one in head)
    lines = "".join("<tr>" + "".join(f"<td>{escaped(str(one))}</td>" for one in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{cells}</tr></thead><tbody>{lines}</tbody></table>"


VERDICT_COLOURS = {"proved": "#1a7f37", "holds": "#1a7f37", "checked": "#1a7f37", "examples": "#1a7f37",
                   "refuted": "#b42318", "fails": "#b42318", "WRONG": "#b42318"}


def verdict(text: str) -> str:
    colour = VERDICT_COLOURS.get(text, "#8a6d00")
    return f'<b style="color:{colour}">{escaped(text)}</b>'


def argument(lines: list[str]) -> str:
    return "".join(
        f'<p style="margin:0.2em 0 0.2em {2 if line.startswith(" ") else 0}em">{escaped(line.strip())}</p>' for line in lines)


def error(message: str) -> str:
    """The findings of a text, as a compiler prints them."""
    return f'<pre style="color:#b42318;line-height:1.3">{escaped(message)}</pre>'


# A page that turns a figure in space: rods as strokes and triangles, sorted by their depth, on a canvas. It asks nothing of the network.
_TURNED = """<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>%(title)s</title>
<style>body{margin:0;background:#fff}canvas{width:100%%;height:100vh;display:block;touch-action:none;cursor:grab}</style>
<canvas id="figure" aria-label="%(title)s, to be turned with the mouse"></canvas><script>
"use strict";
function numbers(text){const b=atob(text),a=new Uint8Array(b.length);for(let i=0;i<b.length;++i)a[i]=b.charCodeAt(i);
return new Float32Array(a.buffer);}
const rods=numbers("%(rods)s"),faces=numbers("%(triangles)s");
const canvas=document.getElementById("figure"),pen=canvas.getContext("2d");
let low=[1e30,1e30,1e30],high=[-1e30,-1e30,-1e30];
function add(a,i){for(let k=0;k<3;++k){low[k]=Math.min(low[k],a[i+k]);high[k]=Math.max(high[k],a[i+k]);}}
for(let i=0;i<rods.length;i+=10){add(rods,i);add(rods,i+3);}
for(let i=0;i<faces.length;i+=12){add(faces,i);add(faces,i+3);add(faces,i+6);}
const middle=[0,1,2].map(k=>(low[k]+high[k])/2);
const size=Math.hypot(high[0]-low[0],high[1]-low[1],high[2]-low[2])||1;
let azimuth=%(azimuth)f*Math.PI/180,elevation=%(elevation)f*Math.PI/180,zoom=1;
function draw(){
const w=canvas.clientWidth,h=canvas.clientHeight,r=window.devicePixelRatio||1;
canvas.width=w*r;canvas.height=h*r;pen.setTransform(r,0,0,r,0,0);pen.clearRect(0,0,w,h);
const s=0.95*zoom*Math.min(w,h)/size,ca=Math.cos(azimuth),sa=Math.sin(azimuth),ce=Math.cos(elevation),se=Math.sin(elevation);
function seen(a,i){const x=a[i]-middle[0],y=a[i+1]-middle[1],z=a[i+2]-middle[2],t=x*ca+y*sa;
return[w/2+s*(y*ca-x*sa),h/2-s*(z*ce-t*se),t*ce+z*se];}
const all=[];
for(let i=0;i<rods.length;i+=10){const p=seen(rods,i),q=seen(rods,i+3);all.push([(p[2]+q[2])/2,0,p,q,i]);}
for(let i=0;i<faces.length;i+=12){const p=seen(faces,i),q=seen(faces,i+3),o=seen(faces,i+6);all.push([(p[2]+q[2]+o[2])/3,1,p,q,i,o]);}
all.sort((a,b)=>a[0]-b[0]);pen.lineCap="round";
for(const[depth,kind,p,q,i,o]of all){
const light=0.65+0.35*Math.max(-1,Math.min(1,2*depth/size)),c=kind?faces.slice(i+9,i+12):rods.slice(i+7,i+10);
const mix=v=>Math.round(255*(light*v+(1-light)*0.9)),colour="rgb("+mix(c[0])+","+mix(c[1])+","+mix(c[2])+")";
pen.beginPath();pen.moveTo(p[0],p[1]);pen.lineTo(q[0],q[1]);
if(kind){pen.lineTo(o[0],o[1]);pen.closePath();pen.fillStyle=colour;pen.fill();}
else{pen.strokeStyle=colour;pen.lineWidth=Math.max(0.7,2*rods[i+6]*s);pen.stroke();}}}
let held=null;
canvas.onpointerdown=e=>{held=[e.clientX,e.clientY];canvas.setPointerCapture(e.pointerId);};
canvas.onpointerup=()=>{held=null;};
canvas.onpointermove=e=>{if(!held)return;azimuth-=(e.clientX-held[0])/150;
elevation=Math.max(-1.57,Math.min(1.57,elevation+(e.clientY-held[1])/150));held=[e.clientX,e.clientY];draw();};
canvas.onwheel=e=>{e.preventDefault();zoom*=Math.exp(-e.deltaY/500);draw();};
window.onresize=draw;draw();
</script></html>"""


def turned(title: str, rods: Any, triangles: Any, azimuth: float, elevation: float) -> str:
    """A page that shows a figure in space and lets the mouse turn it."""
    def packed(values: Any) -> str:
        return base64.b64encode(values.astype("<f4").tobytes()).decode("ascii")

    return _TURNED % {"title": escaped(title), "rods": packed(rods), "triangles": packed(triangles),
                      "azimuth": azimuth, "elevation": elevation}


def framed(page: str, height: int = 480) -> str:
    """A page within a cell of a notebook, which cannot reach the notebook."""
    return (f'<iframe srcdoc="{escaped(page)}" sandbox="allow-scripts" '
            f'style="width:100%;height:{height}px;border:1px solid #ddd"></iframe>')


def as_json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, indent=1)
