//! The stress suite and the guarantees: all bounds hold, saved inputs are tried, and figures are
//! reproducible. The command line reports errors in its arguments.

use ::accuracy::stability::regressions::{Regressions, keep};
use ::accuracy::stability::{Size, run};

/// The seed of the tests' run, which differs from that of the saved inputs.
const SEED: u64 = 7;

fn kept() -> Regressions {
    Regressions::kept().expect("the repository's kept inputs")
}

#[test]
fn stability_bounds_hold_with_kept_inputs() {
    let report = run(Size::Quick, SEED, None, &kept()).expect("the suite runs");
    assert!(report.held(), "{report}");
    for row in &report.rows {
        let (family, subject) = (row.family, &row.subject);
        assert!(row.replayed > 0, "there are no saved inputs of {family}, {subject}");
        let tried = row.tally.cases - row.replayed;
        assert!(tried >= 100, "{tried} cases of {family}, {subject}");
    }
}

#[test]
fn figures_depend_on_the_seed_alone() {
    let figures = |seed| {
        let report = run(Size::Quick, seed, Some("mirror-chain"), &Regressions::default());
        report.expect("the family runs").json()
    };
    assert_eq!(figures(1), figures(1));
    assert_ne!(figures(1), figures(2));
}

/// The inputs saved by one run are again the worst of the next run with the same seed. With
/// another seed, the worst is at least as bad.
#[test]
fn kept_input_reproduces_worst_error() {
    let family = Some("sphere-grazing");
    let first = run(Size::Quick, 1, family, &Regressions::default()).expect("the family runs");
    let folder = tempfile::tempdir().expect("a folder");
    keep(&first, folder.path()).expect("a file");
    let text = std::fs::read_to_string(folder.path().join("sphere-grazing.json"));
    let kept = Regressions::of_file("sphere-grazing", &text.expect("the family's file"));
    let kept = kept.expect("a good file");
    let second = run(Size::Quick, 2, family, &kept).expect("the family runs");
    for (first, second) in first.rows.iter().zip(&second.rows) {
        assert!(second.tally.worst >= first.tally.worst);
        assert!(second.replayed > 0);
    }
}

#[test]
fn kept_input_of_other_length_is_rejected() {
    let text = r#"{"inputs": [{"subject": "refract_r16", "worst": 0.0, "words": "3f800000"}]}"#;
    let kept = Regressions::of_file("refract-critical", text).expect("a good file");
    let error = run(Size::Quick, 1, Some("refract-critical"), &kept).expect_err("a short input");
    let text = error.to_string();
    assert!(text.contains("1 words, but a case has 9"), "{text}");
}

fn bench(arguments: &[&str]) -> std::process::Output {
    super::bench("stability", arguments)
}

#[test]
fn the_command_prints_a_table_and_writes_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("report.json");
    let path = file.to_str().expect("a path");
    let output = bench(&["--quick", "--only", "triangle-needles", "--json", path]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}");
    assert!(text.contains("triangle-needles") && text.contains(" ok"), "{text}");
    let json = std::fs::read(&file).expect("the report");
    let json: serde_json::Value = serde_json::from_slice(&json).expect("JSON");
    assert_eq!(json["held"], true);
    assert_eq!(json["rows"].as_array().map(Vec::len), Some(1));
}

#[test]
fn invalid_value_is_reported() {
    let nowhere = "/no/such/folder/report.json";
    for (arguments, expected) in [
        (&["--only", "spherical-cows"][..], "spherical-cows"),
        (&["--seed", "seven"], "seven"),
        (&["--quick", "--times", "2"], "--times"),
        (&["--times", "0"], "'0' for '--times <N>'"),
        (&["--quick", "--only", "mesh-thin", "--json", nowhere], nowhere),
    ] {
        let output = bench(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{arguments:?}");
        assert!(error.contains(expected), "{arguments:?}: {error}");
    }
}
