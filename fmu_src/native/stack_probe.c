/* What compilers for Windows call before a function takes more than a page (4096 bytes) of the
   stack, rax bytes: the stack grows only where its pages are touched one after the other. Keeps all
   registers. Their own run-time library, whose other parts come with it, makes a library half as
   large again. */
#if defined(_WIN32) && defined(__x86_64__) && defined(__clang__)
__asm__(".globl ___chkstk_ms\n"
        "___chkstk_ms:\n"
        "    push %rcx\n"
        "    push %rax\n"
        "    lea 24(%rsp), %rcx\n" /* the stack pointer of the caller */
        "1:  cmp $4096, %rax\n"
        "    jbe 2f\n"
        "    sub $4096, %rcx\n"
        "    orl $0, (%rcx)\n"
        "    sub $4096, %rax\n"
        "    jmp 1b\n"
        "2:  sub %rax, %rcx\n"
        "    orl $0, (%rcx)\n"
        "    pop %rax\n"
        "    pop %rcx\n"
        "    ret\n");
#else
typedef int stack_probe_is_not_needed; /* ISO C wants a declaration */
#endif
