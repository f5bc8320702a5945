# endless   does not come to an end
#   C       void endless(void);
        .text
        .align  3
        .global endless
endless:
        br      endless
