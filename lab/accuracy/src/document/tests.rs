//! The document contains the results.

use super::*;
use crate::output::Origin;
use crate::run::{Order, run};

#[test]
fn document_has_origin_seed_tables_and_front() {
    let document = Document {
        origin: Some(Origin {
            machine: "some machine".to_owned(),
            commit: "0123456789ab".to_owned(),
            command: "cellray-bench accuracy".to_owned(),
        }),
        results: run(&Order::short(77), |_| ()).unwrap(),
    };
    let text = text(&document, &plots::plots(&document.results));
    for part in ["some machine", "0123456789ab", "Seed: 77", "`cellray-bench accuracy`"] {
        assert!(text.contains(part), "{part}");
    }
    assert!(text.contains(
        "![Run time against error of the distance: rays from the eye](accuracy-distance-eye.svg)"
    ));
    assert!(text.contains("Not beaten: perpendicular."));
    let row = document.results.spheres.iter().find(|row| row.family == "grazing").unwrap();
    let cell = figure(row.figures.distance_ulps.unwrap().max);
    let line = text.lines().find(|line| line.starts_with("| grazing ")).unwrap();
    assert!(line.contains(&cell), "{line}");
    // No pictures were traced, so the document has no section about them.
    assert!(!text.contains("Whole pictures"));
}

#[test]
fn a_part_is_replaced_or_added_and_the_rest_stays() {
    let first = with_part("# Title\n\n", "a", "one\n");
    assert_eq!(
        first,
        "# Title\n\n<!-- a: written by cellray-bench -->\n\none\n\n<!-- end of what is written -->\n"
    );
    let both = with_part(&format!("{first}\nmore\n"), "b", "three\n");
    let again = with_part(&both, "a", "two\n");
    assert_eq!(again, both.replace("one", "two"));
    assert!(again.contains("more") && again.contains("three"));
    let long = "| a table stays |\n".to_owned() + &"word ".repeat(40) + "\n  indented";
    let lines = filled(&long);
    assert_eq!(lines.replace('\n', " ").split_whitespace().count(), 46);
    assert!(lines.lines().all(|line| line.len() <= COLUMNS) && lines.lines().count() == 4);
    assert_eq!(lines.lines().last(), Some("  indented"));
}
