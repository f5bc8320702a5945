//! The instruction table. It has one row for each instruction, and is the only place with facts
//! about instructions.
//!
//! The decoder, the encoder, the disassembler, the register sets and the interpreter's dispatch
//! are all expansions of [`for_each_instruction`]. Invariant: each of the 2048 values of the
//! first eleven bits belongs to at most one row. The decode table checks this at compile time.
//!
//! Columns of a row:
//!
//! | column | meaning |
//! |---|---|
//! | variant, mnemonic | the [`Op`](super::Op), and its name in assembly and in the interpreter |
//! | opcode | the opcode bits, left-aligned in the first eleven bits of the word |
//! | format | [`Format`](super::Format): the positions of the fields |
//! | `(..)` | [`Operand`](super::Operand)s in the assembler's order |
//! | `[..]` | [`Field`](super::Field)s read as source registers |
//! | target | [`Target`](super::Target): how the register rt is used |
//! | class | [`Class`](super::Class): the execution class, which determines pipe and latency |
//! | part | the interpreter's module that implements it, or `inert` if it has no semantics |
//! | machine | [`Machine`](super::Machine): every SPU, or the double-precision extension only |

/// Calls the macro `$callback` with `$context` and all rows of the table.
#[macro_export]
macro_rules! for_each_instruction {
    ($callback:ident! $context:tt) => {
        $callback! { $context
            // Loads, stores, insertion controls
            Lqd lqd 0x1a0 Ri10Quadwords (Rt, Displacement14) [Ra] Rt Ls load_store Every "Load the quadword at ra + displacement";
            Lqx lqx 0x1c4 Rr (Rt, Ra, Rb) [Ra Rb] Rt Ls load_store Every "Load the quadword at ra + rb";
            Lqa lqa 0x184 Ri16Absolute (Rt, Absolute) [] Rt Ls load_store Every "Load the quadword at an absolute address";
            Lqr lqr 0x19c Ri16Relative (Rt, Relative) [] Rt Ls load_store Every "Load the quadword at an address relative to the instruction";
            Stqd stqd 0x120 Ri10Quadwords (Rt, Displacement14) [Ra Rt] None Ls load_store Every "Store the quadword at ra + displacement";
            Stqx stqx 0x144 Rr (Rt, Ra, Rb) [Ra Rb Rt] None Ls load_store Every "Store the quadword at ra + rb";
            Stqa stqa 0x104 Ri16Absolute (Rt, Absolute) [Rt] None Ls load_store Every "Store the quadword at an absolute address";
            Stqr stqr 0x11c Ri16Relative (Rt, Relative) [Rt] None Ls load_store Every "Store the quadword at an address relative to the instruction";
            Cbd cbd 0x1f4 Ri7 (Rt, Displacement7) [Ra] Rt Shuf load_store Every "Controls for byte insertion at ra + displacement";
            Chd chd 0x1f5 Ri7 (Rt, Displacement7) [Ra] Rt Shuf load_store Every "Controls for halfword insertion at ra + displacement";
            Cwd cwd 0x1f6 Ri7 (Rt, Displacement7) [Ra] Rt Shuf load_store Every "Controls for word insertion at ra + displacement";
            Cdd cdd 0x1f7 Ri7 (Rt, Displacement7) [Ra] Rt Shuf load_store Every "Controls for doubleword insertion at ra + displacement";
            Cbx cbx 0x1d4 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf load_store Every "Controls for byte insertion at ra + rb";
            Chx chx 0x1d5 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf load_store Every "Controls for halfword insertion at ra + rb";
            Cwx cwx 0x1d6 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf load_store Every "Controls for word insertion at ra + rb";
            Cdx cdx 0x1d7 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf load_store Every "Controls for doubleword insertion at ra + rb";

            // Constants
            Il il 0x204 Ri16 (Rt, Signed16) [] Rt Fx2 constant Every "Words of a signed 16-bit constant";
            Ilh ilh 0x20c Ri16 (Rt, Unsigned16) [] Rt Fx2 constant Every "Halfwords of a 16-bit constant";
            Ilhu ilhu 0x208 Ri16 (Rt, Unsigned16) [] Rt Fx2 constant Every "Words with a 16-bit constant as upper half";
            Iohl iohl 0x304 Ri16 (Rt, Unsigned16) [Rt] Rt Fx2 constant Every "Or a 16-bit constant into the lower half of each word";
            Ila ila 0x210 Ri18 (Rt, Unsigned18) [] Rt Fx2 constant Every "Words of an unsigned 18-bit constant";
            Fsmbi fsmbi 0x194 Ri16 (Rt, Unsigned16) [] Rt Shuf constant Every "Spread each bit of a constant over a byte";

            // Add, subtract, carry
            A a 0x0c0 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Add words";
            Ah ah 0x0c8 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Add halfwords";
            Ai ai 0x0e0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Add a constant to words";
            Ahi ahi 0x0e8 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Add a constant to halfwords";
            Sf sf 0x040 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Subtract words of ra from words of rb";
            Sfh sfh 0x048 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Subtract halfwords of ra from halfwords of rb";
            Sfi sfi 0x060 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Subtract words from a constant";
            Sfhi sfhi 0x068 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Subtract halfwords from a constant";
            Addx addx 0x340 Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fx2 integer Every "Add words and the carry in rt";
            Cg cg 0x0c2 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Carry out of the sum of words";
            Cgx cgx 0x342 Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fx2 integer Every "Carry out of the sum of words and the carry in rt";
            Sfx sfx 0x341 Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fx2 integer Every "Subtract words with the borrow in rt";
            Bg bg 0x042 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "1 where subtracting ra from rb needs no borrow";
            Bgx bgx 0x343 Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fx2 integer Every "1 where subtracting ra from rb with the borrow in rt needs none";

            // Multiply
            Mpy mpy 0x3c4 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply signed lower halves";
            Mpyu mpyu 0x3cc Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply unsigned lower halves";
            Mpyi mpyi 0x3a0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fp7 integer Every "Multiply signed lower halves by a constant";
            Mpyui mpyui 0x3a8 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fp7 integer Every "Multiply unsigned lower halves by a constant taken as 16 unsigned bits";
            Mpya mpya 0x600 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Fp7 integer Every "Multiply signed lower halves and add rc";
            Mpyh mpyh 0x3c5 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply upper halves of ra by lower halves of rb, into the upper half";
            Mpys mpys 0x3c7 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply signed lower halves and keep the upper half of the product";
            Mpyhh mpyhh 0x3c6 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply signed upper halves";
            Mpyhhu mpyhhu 0x3ce Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 integer Every "Multiply unsigned upper halves";
            Mpyhha mpyhha 0x346 Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fp7 integer Every "Multiply signed upper halves and add rt";
            Mpyhhau mpyhhau 0x34e Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fp7 integer Every "Multiply unsigned upper halves and add rt";

            // Counting, bytes, sign extension
            Clz clz 0x2a5 Rr (Rt, Ra) [Ra] Rt Fx2 integer Every "Count the leading zeros of words";
            Cntb cntb 0x2b4 Rr (Rt, Ra) [Ra] Rt Fxb integer Every "Count the ones of bytes";
            Avgb avgb 0x0d3 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fxb integer Every "Average bytes, rounding up";
            Absdb absdb 0x053 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fxb integer Every "Absolute differences of bytes";
            Sumb sumb 0x253 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fxb integer Every "Sum the bytes of each word of rb and of ra, into halfwords";
            Xsbh xsbh 0x2b6 Rr (Rt, Ra) [Ra] Rt Fx2 integer Every "Extend the sign of bytes to halfwords";
            Xshw xshw 0x2ae Rr (Rt, Ra) [Ra] Rt Fx2 integer Every "Extend the sign of halfwords to words";
            Xswd xswd 0x2a6 Rr (Rt, Ra) [Ra] Rt Fx2 integer Every "Extend the sign of words to doublewords";

            // Logical
            And and 0x0c1 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "And";
            Or or 0x041 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Or";
            Xor xor 0x241 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Exclusive or";
            Nand nand 0x0c9 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Not and";
            Nor nor 0x049 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Not or";
            Eqv eqv 0x249 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Not exclusive or";
            Andc andc 0x2c1 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "And with the complement of rb";
            Orc orc 0x2c9 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 integer Every "Or with the complement of rb";
            Andi andi 0x0a0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "And words with a constant";
            Ori ori 0x020 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Or words with a constant; with 0 it moves a register";
            Xori xori 0x220 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Exclusive or of words with a constant";
            Andhi andhi 0x0a8 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "And halfwords with a constant";
            Orhi orhi 0x028 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Or halfwords with a constant";
            Xorhi xorhi 0x228 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Exclusive or of halfwords with a constant";
            Andbi andbi 0x0b0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "And bytes with a constant";
            Orbi orbi 0x030 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Or bytes with a constant";
            Xorbi xorbi 0x230 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 integer Every "Exclusive or of bytes with a constant";
            Orx orx 0x1f0 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Or the four words into the preferred one";

            // Select, shuffle, masks, gathers
            Selb selb 0x400 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Fx2 integer Every "Take bits of rb where rc has ones, else of ra";
            Shufb shufb 0x580 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Shuf integer Every "Choose bytes of ra and rb, or constants, by the bytes of rc";
            Fsm fsm 0x1b4 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Spread four bits over words";
            Fsmh fsmh 0x1b5 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Spread eight bits over halfwords";
            Fsmb fsmb 0x1b6 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Spread sixteen bits over bytes";
            Gb gb 0x1b0 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Gather the lowest bits of words";
            Gbh gbh 0x1b1 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Gather the lowest bits of halfwords";
            Gbb gbb 0x1b2 Rr (Rt, Ra) [Ra] Rt Shuf integer Every "Gather the lowest bits of bytes";

            // Shifts and rotates
            Shl shl 0x05b Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift words left";
            Shli shli 0x07b Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift words left by a constant";
            Shlh shlh 0x05f Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift halfwords left";
            Shlhi shlhi 0x07f Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift halfwords left by a constant";
            Rot rot 0x058 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Rotate words left";
            Roti roti 0x078 Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Rotate words left by a constant";
            Roth roth 0x05c Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Rotate halfwords left";
            Rothi rothi 0x07c Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Rotate halfwords left by a constant";
            Rotm rotm 0x059 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift words right by the negated count";
            Rotmi rotmi 0x079 Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift words right by a negated constant";
            Rothm rothm 0x05d Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift halfwords right by the negated count";
            Rothmi rothmi 0x07d Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift halfwords right by a negated constant";
            Rotma rotma 0x05a Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift words right with their sign by the negated count";
            Rotmai rotmai 0x07a Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift words right with their sign by a negated constant";
            Rotmah rotmah 0x05e Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx3 shift_rotate Every "Shift halfwords right with their sign by the negated count";
            Rotmahi rotmahi 0x07e Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx3 shift_rotate Every "Shift halfwords right with their sign by a negated constant";
            Shlqbi shlqbi 0x1db Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword left by bits";
            Shlqbii shlqbii 0x1fb Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Shift the quadword left by a constant of bits";
            Shlqby shlqby 0x1df Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword left by bytes";
            Shlqbyi shlqbyi 0x1ff Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Shift the quadword left by a constant of bytes";
            Shlqbybi shlqbybi 0x1cf Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword left by the bytes of a count of bits";
            Rotqbi rotqbi 0x1d8 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Rotate the quadword left by bits";
            Rotqbii rotqbii 0x1f8 Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Rotate the quadword left by a constant of bits";
            Rotqby rotqby 0x1dc Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Rotate the quadword left by bytes";
            Rotqbyi rotqbyi 0x1fc Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Rotate the quadword left by a constant of bytes";
            Rotqbybi rotqbybi 0x1cc Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Rotate the quadword left by the bytes of a count of bits";
            Rotqmbi rotqmbi 0x1d9 Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword right by the negated count of bits";
            Rotqmbii rotqmbii 0x1f9 Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Shift the quadword right by a negated constant of bits";
            Rotqmby rotqmby 0x1dd Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword right by the negated count of bytes";
            Rotqmbyi rotqmbyi 0x1fd Ri7 (Rt, Ra, Immediate7) [Ra] Rt Shuf shift_rotate Every "Shift the quadword right by a negated constant of bytes";
            Rotqmbybi rotqmbybi 0x1cd Rr (Rt, Ra, Rb) [Ra Rb] Rt Shuf shift_rotate Every "Shift the quadword right by the negated bytes of a count of bits";

            // Compares
            Ceq ceq 0x3c0 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Words equal";
            Ceqh ceqh 0x3c8 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Halfwords equal";
            Ceqb ceqb 0x3d0 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Bytes equal";
            Ceqi ceqi 0x3e0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Words equal to a constant";
            Ceqhi ceqhi 0x3e8 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Halfwords equal to a constant";
            Ceqbi ceqbi 0x3f0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Bytes equal to a constant";
            Cgt cgt 0x240 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Signed words greater";
            Cgth cgth 0x248 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Signed halfwords greater";
            Cgtb cgtb 0x250 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Signed bytes greater";
            Cgti cgti 0x260 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Signed words greater than a constant";
            Cgthi cgthi 0x268 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Signed halfwords greater than a constant";
            Cgtbi cgtbi 0x270 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Signed bytes greater than a constant";
            Clgt clgt 0x2c0 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Unsigned words greater";
            Clgth clgth 0x2c8 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Unsigned halfwords greater";
            Clgtb clgtb 0x2d0 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 compare Every "Unsigned bytes greater";
            Clgti clgti 0x2e0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Unsigned words greater than a sign-extended constant";
            Clgthi clgthi 0x2e8 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Unsigned halfwords greater than a sign-extended constant";
            Clgtbi clgtbi 0x2f0 Ri10 (Rt, Ra, Signed10) [Ra] Rt Fx2 compare Every "Unsigned bytes greater than a constant";

            // Branches and hints
            Br br 0x190 Ri16Relative (Relative) [] None Br branch Every "Branch relative";
            Bra bra 0x180 Ri16Absolute (Absolute) [] None Br branch Every "Branch absolute";
            Brsl brsl 0x198 Ri16Relative (Rt, Relative) [] Rt Br branch Every "Branch relative and set link";
            Brasl brasl 0x188 Ri16Absolute (Rt, Absolute) [] Rt Br branch Every "Branch absolute and set link";
            Brz brz 0x100 Ri16Relative (Rt, Relative) [Rt] None Br branch Every "Branch if the preferred word is zero";
            Brnz brnz 0x108 Ri16Relative (Rt, Relative) [Rt] None Br branch Every "Branch if the preferred word is not zero";
            Brhz brhz 0x110 Ri16Relative (Rt, Relative) [Rt] None Br branch Every "Branch if the preferred halfword is zero";
            Brhnz brhnz 0x118 Ri16Relative (Rt, Relative) [Rt] None Br branch Every "Branch if the preferred halfword is not zero";
            Bi bi 0x1a8 Flagged (Ra) [Ra] None Br branch Every "Branch indirect";
            Bisl bisl 0x1a9 Flagged (Rt, Ra) [Ra] Rt Br branch Every "Branch indirect and set link";
            Iret iret 0x1aa Flagged (Ra) [Ra] None Br branch Every "Return from interrupt";
            Bisled bisled 0x1ab Flagged (Rt, Ra) [Ra] Rt Br branch Every "Set link, and branch indirect if the external condition holds";
            Biz biz 0x128 Flagged (Rt, Ra) [Ra Rt] None Br branch Every "Branch indirect if the preferred word is zero";
            Binz binz 0x129 Flagged (Rt, Ra) [Ra Rt] None Br branch Every "Branch indirect if the preferred word is not zero";
            Bihz bihz 0x12a Flagged (Rt, Ra) [Ra Rt] None Br branch Every "Branch indirect if the preferred halfword is zero";
            Bihnz bihnz 0x12b Flagged (Rt, Ra) [Ra Rt] None Br branch Every "Branch indirect if the preferred halfword is not zero";
            Hbr hbr 0x1ac Hint (HintedBranch, Ra) [Ra] None Hb inert Every "Hint an indirect branch; with its p bit, reserve a slot for prefetch";
            Hbra hbra 0x080 HintAbsolute (HintedBranch, Absolute) [] None Hb inert Every "Hint a branch to an absolute address";
            Hbrr hbrr 0x090 HintRelative (HintedBranch, Relative) [] None Hb inert Every "Hint a branch to a relative address";

            // Halts
            Heq heq 0x3d8 Rr (Rt, Ra, Rb) [Ra Rb] False Fx2 branch Every "Halt if the preferred words are equal";
            Heqi heqi 0x3f8 Ri10 (Rt, Ra, Signed10) [Ra] False Fx2 branch Every "Halt if the preferred word equals a constant";
            Hgt hgt 0x258 Rr (Rt, Ra, Rb) [Ra Rb] False Fx2 branch Every "Halt if the signed preferred word is greater";
            Hgti hgti 0x278 Ri10 (Rt, Ra, Signed10) [Ra] False Fx2 branch Every "Halt if the signed preferred word is greater than a constant";
            Hlgt hlgt 0x2d8 Rr (Rt, Ra, Rb) [Ra Rb] False Fx2 branch Every "Halt if the unsigned preferred word is greater";
            Hlgti hlgti 0x2f8 Ri10 (Rt, Ra, Signed10) [Ra] False Fx2 branch Every "Halt if the unsigned preferred word is greater than a sign-extended constant";

            // Control
            Stop stop 0x000 Stop (Code) [] None Br control Every "Stop and signal";
            Stopd stopd 0x140 Rr (Rt, Ra, Rb) [Ra Rb Rt] None Br control Every "Stop and signal after three registers are ready";
            Lnop lnop 0x001 Rr () [] None Lnop inert Every "No operation of the load pipe";
            Nop nop 0x201 Rr (Rt) [] False Nop inert Every "No operation of the execute pipe";
            Sync sync 0x002 Flagged () [] None Br control Every "Synchronise and fetch again; with its c bit, channels too";
            Dsync dsync 0x003 Rr () [] None Br control Every "Synchronise data";
            Mfspr mfspr 0x00c Rr (Rt, Special) [] Rt Spr control Every "Move from a special-purpose register";
            Mtspr mtspr 0x10c Rr (Special, Rt) [Rt] None Spr inert Every "Move to a special-purpose register";

            // Channels
            Rdch rdch 0x00d Rr (Rt, Channel) [] Rt Spr channel Every "Read a channel";
            Rchcnt rchcnt 0x00f Rr (Rt, Channel) [] Rt Spr channel Every "Read a channel's count";
            Wrch wrch 0x10d Rr (Channel, Rt) [Rt] None Spr channel Every "Write a channel";

            // Single precision
            Fa fa 0x2c4 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp6 float Every "Add singles";
            Fs fs 0x2c5 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp6 float Every "Subtract singles";
            Fm fm 0x2c6 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp6 float Every "Multiply singles";
            Fma fma 0x700 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Fp6 float Every "ra * rb + rc";
            Fms fms 0x780 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Fp6 float Every "ra * rb - rc";
            Fnms fnms 0x680 Rrr (Rt, Ra, Rb, Rc) [Ra Rb Rc] Rt Fp6 float Every "rc - ra * rb";
            Frest frest 0x1b8 Rr (Rt, Ra) [Ra] Rt Shuf float Every "Estimate of the reciprocal";
            Frsqest frsqest 0x1b9 Rr (Rt, Ra) [Ra] Rt Shuf float Every "Estimate of the reciprocal square root of the magnitude";
            Fi fi 0x3d4 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fp7 float Every "Interpolate the estimate in rb";
            Csflt csflt 0x3b4 Ri8From155 (Rt, Ra, Scale) [Ra] Rt Fp7 float Every "Signed words to singles, divided by 2^scale";
            Cflts cflts 0x3b0 Ri8From173 (Rt, Ra, Scale) [Ra] Rt Fp7 float Every "Singles times 2^scale to signed words";
            Cuflt cuflt 0x3b6 Ri8From155 (Rt, Ra, Scale) [Ra] Rt Fp7 float Every "Unsigned words to singles, divided by 2^scale";
            Cfltu cfltu 0x3b2 Ri8From173 (Rt, Ra, Scale) [Ra] Rt Fp7 float Every "Singles times 2^scale to unsigned words";
            Fceq fceq 0x3c2 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float Every "Singles equal";
            Fcmeq fcmeq 0x3ca Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float Every "Magnitudes of singles equal";
            Fcgt fcgt 0x2c2 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float Every "Singles greater";
            Fcmgt fcmgt 0x2ca Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float Every "Magnitudes of singles greater";

            // Double precision
            Dfa dfa 0x2cc Rr (Rt, Ra, Rb) [Ra Rb] Rt Fpd float Every "Add doubles";
            Dfs dfs 0x2cd Rr (Rt, Ra, Rb) [Ra Rb] Rt Fpd float Every "Subtract doubles";
            Dfm dfm 0x2ce Rr (Rt, Ra, Rb) [Ra Rb] Rt Fpd float Every "Multiply doubles";
            Dfma dfma 0x35c Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fpd float Every "ra * rb + rt";
            Dfms dfms 0x35d Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fpd float Every "ra * rb - rt";
            Dfnms dfnms 0x35e Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fpd float Every "-(ra * rb - rt)";
            Dfnma dfnma 0x35f Rr (Rt, Ra, Rb) [Ra Rb Rt] Rt Fpd float Every "-(ra * rb + rt)";
            Fesd fesd 0x3b8 Rr (Rt, Ra) [Ra] Rt Fpd float Every "Left words of doublewords, as IEEE singles, to doubles";
            Frds frds 0x3b9 Rr (Rt, Ra) [Ra] Rt Fpd float Every "Doubles to IEEE singles in the left words";
            Fscrrd fscrrd 0x398 Rr (Rt) [] Rt Fpd float Every "Read the floating-point status and control register";
            Fscrwr fscrwr 0x3ba Rr (Rt, Ra) [Ra] False Fp7 float Every "Write the floating-point status and control register";
            Dfceq dfceq 0x3c3 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float DoubleExtension "Doubles equal";
            Dfcmeq dfcmeq 0x3cb Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float DoubleExtension "Magnitudes of doubles equal";
            Dfcgt dfcgt 0x2c3 Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float DoubleExtension "Doubles greater";
            Dfcmgt dfcmgt 0x2cb Rr (Rt, Ra, Rb) [Ra Rb] Rt Fx2 float DoubleExtension "Magnitudes of doubles greater";
            Dftsv dftsv 0x3bf Ri7 (Rt, Ra, Immediate7) [Ra] Rt Fx2 float DoubleExtension "Doubles of the classes that a constant selects";
        }
    };
}
