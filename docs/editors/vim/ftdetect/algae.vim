autocmd BufRead,BufNewFile *.lsys setfiletype lsys
autocmd BufRead,BufNewFile *.claim setfiletype claim
