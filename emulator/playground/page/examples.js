// The programs that the page offers, from three lines to a kernel of the tracer.

import threeLines from "./examples/three-lines.s";
import mail from "./examples/mail.s";
import pairs from "./examples/pairs.s";
import pack from "./examples/pack.s";
import main from "../../../examples/spu/main.s";
import dot from "../../../examples/spu/dot.s";
import dot4 from "../../../examples/spu/dot4.s";

export const examples = [
  { name: "three lines", text: threeLines },
  { name: "pairs", text: pairs },
  { name: "a dot product", text: `${main}\n${dot}` },
  { name: "four sums at once", text: `${main}\n${dot4}` },
  { name: "mail and the decrementer", text: mail },
  { name: "a kernel of the tracer", text: pack },
];
