" Which groups Vim's syntax files give to places of files: `vim -es -u NONE -N --cmd 'let g:places = FILE' --cmd 'let g:said = FILE' -S editors.vim`.
" A place is a line `group<Tab>line<Tab>column<Tab>path`, all places of a file behind each other. Writes what is otherwise.

syntax on
let s:wrong = []
let s:count = 0
let s:path = ''
for s:place in readfile(g:places)
  let [s:group, s:line, s:column, s:file] = split(s:place, "\t")
  if s:file !=# s:path
    execute 'silent edit! ' . fnameescape(s:file)
    execute 'setlocal syntax=' . fnamemodify(s:file, ':e')
    syntax sync fromstart
    let s:path = s:file
  endif
  let s:seen = synIDattr(synID(s:line, s:column, 1), 'name')
  let s:count += 1
  if s:seen !=# s:group
    call add(s:wrong, s:place . "\t" . s:seen)
  endif
endfor
call writefile([s:count . ' ' . len(s:wrong)] + s:wrong[:20], g:said)
quitall!
