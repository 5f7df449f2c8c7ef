# Man pages and completions as the program writes them.
# usage: cmake -DPROGRAM=rigor -DFOLDER=folder -P WriteManuals.cmake
file(REMOVE_RECURSE ${FOLDER})
set(ENV{ASAN_OPTIONS} detect_leaks=0)

# write_output(file argument...): the file with what the program prints.
function(write_output file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${FOLDER}/${file} "${text}")
endfunction()

write_output(completions/bash completion bash)
write_output(completions/zsh completion zsh)
write_output(completions/fish completion fish)
write_output(man1/rigor.1 manual)
# The commands are those that the page of the program refers to.
file(READ ${FOLDER}/man1/rigor.1 page)
string(REGEX MATCHALL "rigor.-[a-z]+.fR\\(1\\)" commands "${page}")
foreach(command ${commands})
  string(REGEX REPLACE "rigor.-([a-z]+).*" "\\1" command "${command}")
  write_output(man1/rigor-${command}.1 manual ${command})
endforeach()
