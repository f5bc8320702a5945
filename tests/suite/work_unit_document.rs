//! Checks that the byte tables in `docs/work-unit.md` match the layout. `MAKE_REF=1` writes them.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use protocol::layout::{CONSTANTS, Field, RECORDS, Status};

const START: &str =
    "<!-- tables: written by MAKE_REF=1 cargo test -p cellray work_unit_document -->\n";

fn tables() -> String {
    let mut text = String::from("## Constants\n\n| name | value | meaning |\n|---|---|---|\n");
    for (name, value, doc) in CONSTANTS {
        let _ = writeln!(text, "| `{name}` | {value:#x} |{doc} |");
    }
    for record in RECORDS {
        let _ = write!(
            text,
            "\n## {}, {} bytes\n\n{}\n\n",
            record.name,
            record.size,
            record.doc.trim()
        );
        text.push_str("| offset | bytes | field | type | meaning |\n|---|---|---|---|---|\n");
        for Field { name, kind, offset, size, doc } in record.fields {
            let _ = writeln!(text, "| {offset} | {size} | `{name}` | `{kind}` |{doc} |");
        }
    }
    text.push_str("\n## Statuses\n\n| status | name | field | rule |\n|---|---|---|---|\n");
    for (name, status, field, rule) in Status::ALL {
        let _ = writeln!(text, "| {} | `{name}` | {field} |{rule} |", *status as u32);
    }
    text
}

#[test]
fn the_document_has_the_layout() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/work-unit.md");
    let document = fs::read_to_string(&path).unwrap();
    let (prose, written) = document.split_once(START).expect("the line that starts the tables");
    if std::env::var_os("MAKE_REF").is_some() {
        fs::write(&path, format!("{prose}{START}{}", tables())).unwrap();
    } else {
        assert!(
            written == tables(),
            "docs/work-unit.md is stale: run MAKE_REF=1 cargo test -p cellray work_unit_document"
        );
    }
}
