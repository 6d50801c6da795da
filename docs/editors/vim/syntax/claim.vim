" Colours of claims on L-systems, *.claim, made by `algae lsp --editors` from its table of statements.
if exists('b:current_syntax')
  finish
endif
syntax case match
syntax match claimNumber /\%(\w\|\.\)\@<!\d\+\%(\.\d\+\)\?/
syntax match claimKeyword /\%(\%(^\|[;{]\)\s*\)\@<=\%(claim\|source\|note\|alphabet\|allow\|let\|theorem\|show\|lemma\|refute\|closed\|not\)\ze\%(\s\|{\)/
syntax match claimWord /\<\%(for\|all\|some\|every\|there\|is\|not\|and\|or\|implies\|iff\|with\|in\|steps\|by\|up\|to\|over\|languages\|language\|systems\|words\|word\|numbers\|number\|letters\|morphisms\|finite\|infinite\|empty\|regular\|under\)\>/
syntax match claimOperator /->\|→\|==>\|==\|!=\|<=\|>=\|[=|&~*+^\\]/
syntax match claimKeyword /\%(\%(^\|[;{]\)\s*\)\@<=\%(claim\|source\|note\|alphabet\|allow\|let\|theorem\|show\|lemma\|refute\|closed\|not\)\ze\s/
syntax match claimProse /\%(\%(^\|[;{]\)\s*\)\@<=\%(claim\|source\|note\)\s[^;]*/ contains=claimKeyword,claimComment
syntax match claimComment /\%(^\|\s\)\@<=#.*$/
highlight default link claimKeyword Keyword
highlight default link claimProse String
highlight default link claimWord Statement
highlight default link claimOperator Operator
highlight default link claimNumber Number
highlight default link claimComment Comment
let b:current_syntax = 'claim'
