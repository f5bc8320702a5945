// The editor: CodeMirror with the SPU's notation, errors in place, breakpoints and the next line.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import {
  HighlightStyle,
  StreamLanguage,
  defaultHighlightStyle,
  syntaxHighlighting,
} from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState, RangeSet, StateEffect, StateField } from "@codemirror/state";
import {
  Decoration,
  EditorView,
  GutterMarker,
  drawSelection,
  gutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";

const notation = StreamLanguage.define({
  startState: () => ({ named: false }),
  token(stream, state) {
    if (stream.sol()) state.named = false;
    if (stream.eatSpace()) return null;
    if (stream.match(/#.*/)) return "comment";
    if (stream.match(/"(?:[^"\\]|\\.)*"?/)) return "string";
    if (stream.match(/\$[\w.]+/)) return "variableName";
    if (stream.match(/[\w.$]+:/)) return "labelName";
    if (stream.match(/;/)) return ((state.named = false), null);
    if (stream.match(/\.[a-z]\w*/)) return ((state.named = true), "meta");
    if (stream.match(/-?(?:0x[\da-f]+|\d[\d.e]*)/i)) return "number";
    if (stream.match(/[a-z_]\w*/i)) {
      const first = !state.named;
      state.named = true;
      return first ? "keyword" : null;
    }
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: "#" } },
});

const dark = HighlightStyle.define([
  { tag: tags.keyword, color: "#8fc7ff" },
  { tag: tags.comment, color: "#8f9aa6" },
  { tag: tags.labelName, color: "#f0c674" },
  { tag: tags.number, color: "#b5d99c" },
  { tag: tags.variableName, color: "#e4e7eb" },
  { tag: tags.meta, color: "#cf93ea" },
  { tag: tags.string, color: "#f0944d" },
]);

const here = StateEffect.define();
const hereField = StateField.define({
  create: () => Decoration.none,
  update(value, transaction) {
    value = value.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(here)) {
        const line = effect.value;
        const known = line > 0 && line <= transaction.state.doc.lines;
        const mark = Decoration.line({ class: "cm-here" });
        value = known
          ? Decoration.set([mark.range(transaction.state.doc.line(line).from)])
          : Decoration.none;
      }
    return value;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const dot = new (class extends GutterMarker {
  toDOM() {
    return document.createTextNode("●");
  }
})();
const toggle = StateEffect.define({ map: (at, changes) => changes.mapPos(at) });
const breakpointField = StateField.define({
  create: () => RangeSet.empty,
  update(set, transaction) {
    set = set.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(toggle)) {
        let found = false;
        set.between(effect.value, effect.value, () => {
          found = true;
        });
        set = found
          ? set.update({ filter: (from) => from !== effect.value })
          : set.update({ add: [dot.range(effect.value)] });
      }
    return set;
  },
});

const clicks = {
  mousedown(shown, line) {
    shown.dispatch({ effects: toggle.of(line.from) });
    return true;
  },
};

/** An editor in `parent`, which calls `changed` with each new text. */
export function editor(parent, changed) {
  const darkScheme = matchMedia("(prefers-color-scheme: dark)").matches;
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        gutter({
          class: "cm-breakpoints",
          markers: (shown) => shown.state.field(breakpointField),
          initialSpacer: () => dot,
          domEventHandlers: clicks,
        }),
        lineNumbers({ domEventHandlers: clicks }),
        lintGutter(),
        history(),
        drawSelection(),
        notation,
        hereField,
        breakpointField,
        syntaxHighlighting(darkScheme ? dark : defaultHighlightStyle),
        EditorView.contentAttributes.of({ "aria-label": "SPU assembly", spellcheck: "false" }),
        EditorView.theme({}, { dark: darkScheme }),
        EditorState.tabSize.of(8),
        keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) changed(update.state.doc.toString());
        }),
      ],
    }),
  });
  return {
    view,
    get text() {
      return view.state.doc.toString();
    },
    set text(text) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
    },
    /** The lines that have breakpoints. */
    breakpoints() {
      const lines = [];
      view.state.field(breakpointField).between(0, view.state.doc.length, (from) => {
        lines.push(view.state.doc.lineAt(from).number);
      });
      return lines;
    },
    /** Marks the line of the next instruction; 0 is none. */
    mark(line) {
      view.dispatch({ effects: here.of(line) });
    },
    /** Shows errors, each with a line, a column and a message. */
    errors(errors) {
      const diagnostics = errors.map(({ line, column, message }) => {
        const at = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
        const from = Math.min(at.from + Math.max(column - 1, 0), at.to);
        const word = /^[$\w.]+/.exec(at.text.slice(from - at.from));
        return {
          from,
          to: Math.max(from + (word ? word[0].length : 0), Math.min(from + 1, at.to)),
          severity: "error",
          message,
        };
      });
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },
  };
}
