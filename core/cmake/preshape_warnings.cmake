# Warnings and sanitizers of our own targets.
function(preshape_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wno-psabi
    # g++ 12 raises these falsely inside inlined standard containers.
    -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-array-bounds -Wno-restrict)
  if(PRESHAPE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${PRESHAPE_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=undefined)
    target_link_options(${target} PRIVATE -fsanitize=${PRESHAPE_SANITIZE})
  endif()
endfunction()
