# Installs the manual pages of the program and of its commands, and the completions for bash, zsh and fish, as the program
# writes them. Run by `cmake --install` with `program`, its path, and `folder`, a folder for the pages until then.
execute_process(COMMAND ${program} --generate commands OUTPUT_VARIABLE commands OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)

# generate(FILE KIND...): what the program writes, as a file.
function(generate file)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${program} --generate ${ARGN} OUTPUT_FILE ${folder}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

generate(lober.1 man)
set(pages ${folder}/lober.1)
string(REPLACE "\n" ";" commands "${commands}")
foreach(command ${commands})
  generate(lober-${command}.1 man ${command})
  list(APPEND pages ${folder}/lober-${command}.1)
endforeach()
generate(lober complete-bash)
generate(_lober complete-zsh)
generate(lober.fish complete-fish)

set(share ${CMAKE_INSTALL_PREFIX}/share)
file(INSTALL ${pages} DESTINATION ${share}/man/man1)
file(INSTALL ${folder}/lober DESTINATION ${share}/bash-completion/completions)
file(INSTALL ${folder}/_lober DESTINATION ${share}/zsh/site-functions)
file(INSTALL ${folder}/lober.fish DESTINATION ${share}/fish/vendor_completions.d)
