//! `cellray render --inspect`: traces one frame in simulated time, and writes the page about it.

mod kept;
mod maps;

use std::fs;
use std::path::Path;

use cellray_inspector::{Inspection, Recording, Statistic, Tile, Unit, page};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _, RgbImage};
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

use super::Outcome;
use super::options::Options;
use super::run::{Prepared, report_run, traced};
use crate::engine::TracedTile;
use crate::framebuffer::{Geometry, PictureFile, write_labelled};
use crate::{Report, Scene};

/// libspe2's recording of this run. If there is none, runs this program again with the environment
/// that makes libspe2 record, and exits with that run's status: it has reported all errors.
pub fn record() -> Result<Recording, Box<dyn std::error::Error>> {
    if let Some(recording) = Recording::of_this_run() {
        return Ok(recording);
    }
    let status = Recording::run_again()?;
    std::process::exit(status.code().unwrap_or(1))
}

/// Traces a frame, after one of the scene `before` if there is one, and writes its page, and its
/// picture if that is asked for.
pub fn frame(
    options: &Options,
    recording: &Recording,
    prepared: &Prepared,
    before: Option<&Scene>,
    geometry: Geometry,
    out: Option<&Path>,
    to: &Path,
) -> Outcome {
    let Prepared { program, source, scene, labels, .. } = prepared;
    if let Some(out) = out {
        PictureFile::new(out, geometry)?;
    }
    let written = kept::Written::default();
    let framebuffer = Box::new(kept::Watched::new(geometry, written.clone())?);
    // The SPUs keep records of their rays from the first change on.
    let earlier = before.map_or(Vec::new(), |before| vec![before, scene, before]);
    let (engine, report) = traced(options, prepared, framebuffer, &earlier, |traced| traced > 0)?;
    let picture = engine.picture().ok_or("the picture can't be read back")?;
    let traced = engine.traced_units().ok_or("the SPUs were lost")?;
    if traced.units.is_empty() {
        return Err("--before is the same scene, so that the SPUs had nothing to trace".into());
    }
    // libspe2 writes the last figures when the contexts are destroyed.
    drop(engine);
    let (timeline, profile) = (recording.timeline()?, recording.profile()?);
    if let Some(out) = out {
        write_labelled(out, &picture, labels)?;
    }

    let settings = options.settings(*program);
    let pixel_map = match before {
        Some(_) => Some(kept::map(geometry, &written, &traced, report.tiles.causes)),
        None => maps::of_samples(
            settings,
            source,
            scene.render_options(),
            (program, geometry),
            report.rays.samples,
        )?,
    };
    // Without skipping, no tile is traced alone. After another frame, tiles are not traced as a
    // whole.
    let tile_maps = match options.no_skip || before.is_some() {
        true => Vec::new(),
        false => maps::of_tiles(settings, scene, geometry)?,
    };

    let tile = |tile: &TracedTile| Tile { number: tile.number, ticks: tile.ticks };
    let units = traced.units.iter().map(|tiles| Unit { tiles: tiles.iter().map(tile).collect() });
    let text = page(&Inspection {
        scene: scene.file(),
        picture: &png(&picture)?,
        size: (geometry.width, geometry.height),
        tile_size: (TILE_WIDTH, TILE_HEIGHT),
        units: &units.collect::<Vec<_>>(),
        costs: (traced.costs, traced.distance),
        tile_maps: &tile_maps,
        pixel_maps: pixel_map.as_slice(),
        earlier_frames: earlier.len(),
        statistics: &statistics_of(&report),
        program: program.image(),
        timeline: &timeline,
        profile: &profile,
    })?;
    fs::write(to, &text).map_err(|error| format!("page {}: {error}", to.display()))?;
    let what = format!("{}, {} bytes", to.display(), text.len());
    report_run(options, &what, report)
}

/// The picture as the bytes of a PNG file.
fn png(picture: &RgbImage) -> Result<Vec<u8>, image::ImageError> {
    let mut bytes = Vec::new();
    let (width, height) = picture.dimensions();
    PngEncoder::new(&mut bytes).write_image(
        picture.as_raw(),
        width,
        height,
        ExtendedColorType::Rgb8,
    )?;
    Ok(bytes)
}

fn statistics_of(report: &Report) -> Vec<Statistic> {
    let of = |group, name, value: u64, meaning| Statistic {
        group,
        name,
        value: value.to_string(),
        meaning,
    };
    let Report { tests, tiles, packets, rays, phases, .. } = report;
    let causes = tiles.causes;
    let tile = "Tiles of 64x16 pixels";
    let packet = "Packets of 16 rays";
    let test = "Tests of one ray with one object";
    let ray = "Rays";
    let mut all = vec![
        of(tile, "traced", tiles.traced, "an object may be visible in them"),
        of(tile, "filled", tiles.filled, "skipped: no object is visible in them"),
        of(tile, "blank", tiles.blank, "filled ones that were not even written"),
        of(tile, "retained", tiles.retained, "skipped: the framebuffer showed them already"),
        of(tile, "unknown", causes.unknown, "traced: the framebuffer's contents were not known"),
        of(tile, "view", causes.view, "traced: the camera, a light or an option had changed"),
        of(tile, "unrecorded", causes.unrecorded, "traced: no record of what their rays crossed"),
        of(tile, "reached", causes.reached, "traced: a ray had crossed a changed object's place"),
        of(packet, "traced", packets.traced, "packets of primary rays"),
        of(packet, "filled", packets.filled, "skipped: culling left no object for them"),
        of(test, "made", tests.made, "a kernel computed them"),
        of(
            test,
            "computed",
            tests.intersections_computed,
            "went on, because a ray of the packet could hit",
        ),
        of(
            test,
            "skipped",
            tests.skipped,
            "culling by tile, packet or node found them unnecessary",
        ),
        of(test, "hidden", tests.hidden, "of those, because all rays had hit something nearer"),
        of(test, "unseen", tests.unseen, "the object was not sent: the picture can't show it"),
        of("Tests of bounding volumes", "made", tests.cull, "with frusta and packets' cones"),
        of(ray, "eye", rays.eye, "through pixels"),
        of(ray, "samples", rays.samples, "of those, beyond the first of each pixel"),
        of(ray, "eye, hit", rays.eye_hit, "of those, hit something"),
        of(ray, "reflected", rays.reflected, "that are not too weak to change a byte"),
        of(ray, "refracted", rays.refracted, "likewise"),
        of(ray, "shadow", rays.shadow, "from hits to lights"),
        of(ray, "background", rays.background, "hit nothing"),
    ];
    let busy: f64 = report.spu.iter().map(|spu| spu.busy).sum();
    for (name, seconds, meaning) in [
        ("fetching", phases.fetch, "the frame and its scene"),
        ("culling", phases.cull, "objects that a tile or packet can't meet"),
        ("making rays", phases.rays, "primary and secondary"),
        ("testing", phases.isect, "rays with objects"),
        ("shading", phases.shade, "and packing pixels"),
    ] {
        let part = if busy > 0.0 { 100.0 * seconds / busy } else { 0.0 };
        all.push(Statistic {
            group: "Time at work, by phase",
            name,
            value: format!("{part:.1} %"),
            meaning,
        });
    }
    all
}
