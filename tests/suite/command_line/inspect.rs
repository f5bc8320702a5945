//! `cellray render --inspect`: the page's content. `ci/browser` checks how it looks in a browser.

use super::support::{bad, good};
use crate::prelude::*;

/// What stands between each `before` and the next `after`.
fn all<'t>(text: &'t str, before: &str, after: &str) -> Vec<&'t str> {
    let parts = text.split(before).skip(1);
    parts.filter_map(|part| Some(part.split_once(after)?.0)).collect()
}

#[test]
fn page_shows_each_tile_in_each_map_and_is_repeatable() {
    let folder = tempfile::tempdir().unwrap();
    let pages = ["first.html", "second.html"].map(|name| {
        let page = folder.path().join(name);
        let (_, messages) = good(&[
            "render",
            "scenes/shadows.nff",
            "--size",
            "160x90",
            "--spus",
            "3",
            "--inspect",
            page.to_str().unwrap(),
        ]);
        let text = fs::read_to_string(page).unwrap();
        assert!(messages.contains(&format!("{} bytes", text.len())), "{messages}");
        text
    });
    assert!(pages[0] == pages[1], "the pages of two runs differ");
    let page = &pages[0];
    // 160x90 pixels are three by six tiles.
    let maps =
        ["cycles", "waits", "fetched", "finished", "spu", "bounces", "shadows", "tests", "volumes"];
    for map in maps {
        let overlay = all(page, &format!("<svg class=\"overlay for-{map}\""), "</svg>");
        assert_eq!(overlay.len(), 1, "{map}");
        let mut tiles: Vec<u32> = all(overlay[0], "<title>tile ", ",")
            .iter()
            .map(|number| number.parse().unwrap())
            .collect();
        tiles.sort_unstable();
        assert_eq!(tiles, (0..18).collect::<Vec<_>>(), "{map}");
    }
    let timelines = all(page, "<svg class=\"timelines\"", "</svg>");
    assert_eq!(timelines[0].matches("<title>tile ").count(), 18);
    assert_eq!(timelines[0].matches(">SPU ").count(), 3);
    for class in ["work", "dma", "counter", "in", "out"] {
        let path = format!("<path class=\"{class}\"");
        assert!(timelines[0].contains(&path), "{class}");
    }
    // The picture, and the samples of its pixels.
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 2);
    assert!(page.contains("Samples of each pixel: 4 in the "));
    // Each tile has its own count of shadow rays, and together they have all.
    let shadows = all(page, "<svg class=\"overlay for-shadows\"", "</svg>");
    let counts = all(shadows[0], ": ", "</title>");
    let counts = counts.iter().map(|count| count.parse::<u64>().unwrap());
    let sum = all(page, "<tr><td>shadow</td><td class=\"n\">", "</td>");
    assert_eq!(counts.sum::<u64>().to_string(), sum[0]);
    assert!(page.contains("shadow_rays_r16") && page.contains("light_r16"));
    assert!(page.contains("culling by tile, packet or node"));
    for foreign in ["<script", "http:", "https:", "@import", "url("] {
        assert!(!page.contains(foreign), "{foreign}");
    }
}

/// The map of kept pixels adds up to what the SPUs count, and only some are traced.
#[test]
fn page_shows_why_pixels_were_traced_after_another_scene() {
    let folder = tempfile::tempdir().unwrap();
    let [before, scene, page] =
        ["before.nff", "scene.nff", "page.html"].map(|name| folder.path().join(name));
    let text = fs::read_to_string("scenes/whitted16.nff").unwrap();
    let moved = text.replace("s -6.4 3.4 1.3 1.3", "s -6.4 3.5 1.3 1.3");
    assert!(moved != text);
    fs::write(&before, moved).unwrap();
    fs::write(&scene, text).unwrap();
    let [before, scene, page] = [&before, &scene, &page].map(|path| path.to_str().unwrap());
    let traced = |more: &[&str]| {
        let start = ["render", scene, "--size", "256x96", "--before", before, "--inspect", page];
        good(&[&start[..], more].concat());
        let text = fs::read_to_string(page).unwrap();
        let share = |kind: &str| -> f64 {
            let share = all(&text, &format!("</span> {kind} ("), " %)");
            share.first().map_or(0.0, |share| share.parse().unwrap())
        };
        let kept = share("kept");
        let reached = share("traced: a ray had crossed a changed object's place");
        let unrecorded = share("traced: no record of what the tile's rays had crossed");
        let unknown = share("traced: the framebuffer's contents were not known");
        assert!((kept + reached + unrecorded + unknown - 100.0).abs() < 0.3, "{kept} {reached}");
        let rays = all(&text, "<tr><td>eye</td><td class=\"n\">", "</td>")[0];
        let rays = 100.0 * rays.parse::<f64>().unwrap() / (256.0 * 96.0);
        assert!((100.0 - kept - rays).abs() < 0.1, "{kept} {rays}");
        (kept, reached, unknown)
    };
    bad(&["render", scene, "--before", scene, "--inspect", page], &["--before is the same scene"]);
    let (kept, reached, unknown) = traced(&["--antialias", "1"]);
    assert!(kept > 20.0 && reached > 20.0 && unknown == 0.0, "{kept} {reached} {unknown}");
    assert_eq!(traced(&["--antialias", "1", "--retrace"]), (0.0, 0.0, 100.0));
}

#[test]
fn one_frame_is_inspected_and_unwritable_page_is_named() {
    let scene = "scenes/paper13.nff";
    let page = ["--inspect", "/nowhere/at/all.html", "--size", "64x16"];
    let start = ["render", scene];
    let inspect = |more: &[&str], part| bad(&[&start[..], &page, more].concat(), &[part]);
    inspect(&["--frames", "2"], "--inspect traces one frame");
    inspect(&["--watch", "--out", "p.png"], "--watch");
    inspect(&[], "/nowhere/at/all.html");
}
