//! A document is only changed between its markers, and a stale one is detected.

use std::fs;

use kernels::document::{BEGIN, DocumentError, END, check, write};

#[test]
fn text_outside_markers_is_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.md");
    fs::write(&file, format!("before\n{BEGIN}\nold\n{END}\nbehind\n")).expect("a file");
    write(&file, "| new |\n").expect("written");
    let text = fs::read_to_string(&file).expect("the file");
    assert_eq!(text, format!("before\n{BEGIN}\n\n| new |\n\n{END}\nbehind\n"));
    check(&file, "| new |\n").expect("up to date");
    write(&file, "| new |\n").expect("written again");
    assert_eq!(text, fs::read_to_string(&file).expect("the file"));
}

#[test]
fn a_stale_table_is_shown_by_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.md");
    fs::write(&file, format!("{BEGIN}\n{END}\n")).expect("a file");
    write(&file, "one\ntwo\n").expect("written");
    let error = check(&file, "one\ntoo\n").expect_err("it is stale");
    let DocumentError::Stale { line, found, expected, .. } = error else {
        panic!("{error}");
    };
    assert_eq!((line, found.as_str(), expected.as_str()), (4, "two", "too"));
}

#[test]
fn missing_markers_or_document_are_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.md");
    let missing = write(&file, "").expect_err("there is no file");
    assert!(matches!(missing, DocumentError::File { .. }), "{missing}");
    for text in ["", BEGIN, &format!("{END}\n{BEGIN}\n")] {
        fs::write(&file, text).expect("a file");
        for outcome in [write(&file, ""), check(&file, "")] {
            let error = outcome.expect_err("no markers");
            assert!(matches!(error, DocumentError::Markers { .. }), "{error}");
        }
        assert_eq!(fs::read_to_string(&file).expect("the file"), text);
    }
}
