//! The files of results contain what was measured.

use super::*;
use crate::run::{self, Order};

fn document() -> Document {
    Document { origin: None, results: run::run(&Order::short(11), |_| ()).unwrap() }
}

#[test]
fn json_and_csv_parse_back_to_the_results() {
    let place = tempfile::tempdir().unwrap();
    let document = document();
    folder(place.path()).unwrap();
    let file = place.path().join("results.json");
    json(&document, &file).unwrap();
    let text = fs::read_to_string(&file).unwrap();
    assert!(serde_json::from_str::<Document>(&text).unwrap() == document);

    tables(&document.results, place.path()).unwrap();
    let mut spheres = csv::Reader::from_path(place.path().join("spheres.csv")).unwrap();
    let head = spheres.headers().unwrap().clone();
    let column = |name: &str| head.iter().position(|head| head == name).unwrap();
    let rows: Vec<csv::StringRecord> = spheres.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), document.results.spheres.len());
    for (cells, row) in rows.iter().zip(&document.results.spheres) {
        assert_eq!(cells[column("family")], row.family);
        assert_eq!(cells[column("wrong_hits")], row.figures.wrong_hits.to_string());
        let summary = row.figures.distance_ulps.unwrap();
        for (name, value) in [
            ("distance_ulps_max", summary.max),
            ("distance_ulps_mean", summary.mean),
            ("distance_ulps_p999", summary.p999),
        ] {
            assert_eq!(cells[column(name)].parse(), Ok(value), "{name}");
        }
        let cycles: f64 = cells[column("cycles_a_ray")].parse().unwrap();
        assert!(cycles > 1.0);
    }
}

#[test]
fn the_same_seed_gives_the_same_results() {
    assert!(document() == document());
}

#[test]
fn invalid_folder_is_reported() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("file");
    fs::write(&file, "").unwrap();
    let error = folder(&file.join("below")).unwrap_err();
    assert!(error.to_string().contains("file/below"), "{error}");
}
