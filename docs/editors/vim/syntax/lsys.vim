" Colours of L-systems, *.lsys, made by `algae lsp --editors` from its table of statements.
if exists('b:current_syntax')
  finish
endif
syntax case match
syntax match lsysNumber /\%(\w\|\.\)\@<!\d\+\%(\.\d\+\)\?/
syntax match lsysKeyword /\%(\%(^\|[;{]\)\s*\)\@<=\%(title\|source\|id\|alphabet\|let\|system\|axiom\|table\|schedule\|ignore\|terminals\|interpret\|coding\|environment\|angle\|step\|shrink\|start\|spin\|scale\|narrow\|plot\|stamp\|solid\|surface\|tropism\|susceptibility\|elasticity\|width\|colour\|turn\|camera\|light\|fog\|generation\|seed\|picture\|columns\|common-scale\|label\|expect\)\ze\%(\s\|{\)/
syntax match lsysArrow /->\|→\|-([^()[:blank:]]*)->/
syntax match lsysNameEnvironment /\s\@<=\%(x\|y\|z\|position\|heading\|clip\|collision\|light\|external\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysEnvironment /\%(\%(^\|[;{]\)\s*\)\@<=\%(environment\)\s[^;]*/ contains=lsysKeyword,lsysNameEnvironment,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameEnvironment Constant
syntax match lsysNameStart /\s\@<=\%(upward\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysStart /\%(\%(^\|[;{]\)\s*\)\@<=\%(start\)\s[^;]*/ contains=lsysKeyword,lsysNameStart,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameStart Constant
syntax match lsysNameStamp /\s\@<=\%(square\|circle\|triangle\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysStamp /\%(\%(^\|[;{]\)\s*\)\@<=\%(stamp\)\s[^;]*/ contains=lsysKeyword,lsysNameStamp,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameStamp Constant
syntax match lsysNameSolid /\s\@<=\%(box\|cylinder\|cone\|sphere\|rotation\|translation\|width\|height\|depth\|colour\|radius\|x\|y\|z\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysSolid /\%(\%(^\|[;{]\)\s*\)\@<=\%(solid\)\s[^;]*/ contains=lsysKeyword,lsysNameSolid,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameSolid Constant
syntax match lsysNameSurface /\s\@<=\%(leaf\|petal\|disc\|polygon\|patch\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysSurface /\%(\%(^\|[;{]\)\s*\)\@<=\%(surface\)\s[^;]*/ contains=lsysKeyword,lsysNameSurface,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameSurface Constant
syntax match lsysNameColour /\s\@<=\%(along\|viridis\|cividis\|aqua\|aquamarine\|beige\|black\|blue\|brown\|chartreuse\|chocolate\|coral\|crimson\|cyan\|darkblue\|darkcyan\|darkgray\|darkgreen\|darkgrey\|darkmagenta\|darkolivegreen\|darkorange\|darkred\|darkviolet\|deeppink\|deepskyblue\|dimgray\|dimgrey\|dodgerblue\|firebrick\|forestgreen\|fuchsia\|gold\|goldenrod\|gray\|green\|greenyellow\|grey\|hotpink\|indianred\|indigo\|ivory\|khaki\|lavender\|lawngreen\|lightblue\|lightgray\|lightgreen\|lightgrey\|lime\|limegreen\|magenta\|maroon\|midnightblue\|navy\|olive\|olivedrab\|orange\|orangered\|orchid\|palegreen\|peru\|pink\|plum\|purple\|red\|royalblue\|saddlebrown\|salmon\|seagreen\|sienna\|silver\|skyblue\|slateblue\|slategray\|slategrey\|springgreen\|steelblue\|tan\|teal\|tomato\|turquoise\|violet\|wheat\|white\|yellow\|yellowgreen\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysColour /\%(\%(^\|[;{]\)\s*\)\@<=\%(colour\)\s[^;]*/ contains=lsysKeyword,lsysNameColour,lsysNumber,lsysArrow,lsysComment,lsysHex
highlight default link lsysNameColour Constant
syntax match lsysNameTurn /\s\@<=\%(clockwise\|counter-clockwise\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysTurn /\%(\%(^\|[;{]\)\s*\)\@<=\%(turn\)\s[^;]*/ contains=lsysKeyword,lsysNameTurn,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameTurn Constant
syntax match lsysNameCamera /\s\@<=\%(perspective\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysCamera /\%(\%(^\|[;{]\)\s*\)\@<=\%(camera\)\s[^;]*/ contains=lsysKeyword,lsysNameCamera,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameCamera Constant
syntax match lsysNamePicture /\s\@<=\%(figure\|table\|tree\|plot\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysPicture /\%(\%(^\|[;{]\)\s*\)\@<=\%(picture\)\s[^;]*/ contains=lsysKeyword,lsysNamePicture,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNamePicture Constant
syntax match lsysNameExpect /\s\@<=\%(length\|lengths\|mean\|word\|segments\|distinct\|vertices\|end\|box\)\ze\%(\s\|;\|$\)/ contained
syntax match lsysExpect /\%(\%(^\|[;{]\)\s*\)\@<=\%(expect\)\s[^;]*/ contains=lsysKeyword,lsysNameExpect,lsysNumber,lsysArrow,lsysComment
highlight default link lsysNameExpect Constant
syntax match lsysProse /\%(\%(^\|[;{]\)\s*\)\@<=\%(title\|source\)\s[^;]*/ contains=lsysKeyword,lsysComment
syntax match lsysComment /\%(^\|\s\)\@<=#.*$/
syntax match lsysHex /\s\@<=#\x\{6}\ze\%(\s\|;\|$\)/ contained
highlight default link lsysKeyword Keyword
highlight default link lsysProse String
highlight default link lsysArrow Operator
highlight default link lsysNumber Number
highlight default link lsysHex Constant
highlight default link lsysComment Comment
let b:current_syntax = 'lsys'
