//! The search for small scenes whose pictures have the largest excess: wrong pixels over those that
//! single precision must get wrong.
//!
//! A scene is a text of NFF. Half of the scenes are new, and the others are kept ones with a number
//! changed, which replace theirs if they are worse. Scenes with a note that surfaces hide what is
//! near them ([`offset_note`]) are left out: `cellray` reports these. Invariant: the scenes depend
//! only on the seed and the count.

use std::f64::consts::TAU;
use std::fmt::{Display, Write as _};
use std::fs;
use std::path::Path;

use cellray::scene::{RenderOptions, offset_note};
use glam::DVec3;
use rand::Rng as _;
use rand::seq::IndexedRandom as _;
use serde::{Deserialize, Serialize};

use crate::file::OutputError;
use crate::generator::{Generator, generator};
use crate::pictures::{PictureError, Subject, errors};
use crate::space::direction;
use crate::stability::random::magnitude;
use crate::totals::Total;

/// The folder of kept scenes.
const KEPT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/regressions/pictures");
/// The number of scenes that are kept.
const MOST: usize = 20;
/// The largest excess of a kept scene, which a test checks.
pub const MOST_EXCESS: f64 = 12.0;
/// The size of the pictures.
const SIZE: (u32, u32) = (128, 96);

/// The errors of a scene's picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct KeptRow {
    /// The scene.
    pub scene: String,
    /// The number of wrong pixels.
    pub wrong_pixels: u64,
    /// The number of pixels that single precision must get wrong.
    pub floor: u64,
}

/// A scene and the errors of its picture.
#[derive(Clone, Debug)]
pub struct Case {
    /// The errors.
    pub row: KeptRow,
    /// The scene's text.
    pub text: String,
}

impl KeptRow {
    /// The wrong pixels over the floor, or over the smallest floor that counts if that is larger.
    /// Otherwise a few wrong pixels would be a large excess by chance.
    #[must_use]
    pub fn excess(&self) -> f64 {
        self.wrong_pixels as f64 / self.floor.max(Total::SMALLEST_FLOOR) as f64
    }
}

impl Case {
    /// `None` if the scene has a note.
    fn of(name: String, text: String) -> Result<Option<Self>, PictureError> {
        let scene = scenes::parse(text.as_bytes(), &name, &scenes::Limits::default())?;
        if offset_note(&scene, RenderOptions::default()).is_some() {
            return Ok(None);
        }
        let (wrong_pixels, floor) = errors(&Subject { name: name.clone(), scene }, SIZE)?;
        Ok(Some(Self { row: KeptRow { scene: name, wrong_pixels, floor }, text }))
    }
}

/// How scenes of a kind are made, after the eye and the lights.
type Make = fn(&mut Generator) -> String;

/// The kinds of scenes.
const KINDS: [(&str, Make); 4] = [
    ("glass-in-glass", glass_in_glass),
    ("grazing-mirrors", grazing_mirrors),
    ("large-beside-small", large_beside_small),
    ("far-away", far_away),
];

/// Tries this many scenes, and returns the worst, the very worst first.
///
/// # Errors
///
/// Fails if a new scene can't be traced. A changed one that can't be is left out.
pub fn search(
    seed: u64,
    count: u32,
    mut progress: impl FnMut(&Case),
) -> Result<Vec<Case>, PictureError> {
    let mut kept: Vec<Case> = Vec::new();
    for number in 0..count {
        let mut random = generator(seed, &["pictures"], number);
        let parent = if random.random() { kept.choose(&mut random).cloned() } else { None };
        let case = match &parent {
            Some(parent) => {
                let text = changed(&parent.text, &mut random);
                Case::of(parent.row.scene.clone(), text).ok().flatten()
            }
            None => {
                let (kind, make) = KINDS[number as usize % KINDS.len()];
                Case::of(format!("{kind}-{number}"), make(&mut random))?
            }
        };
        let Some(case) = case else { continue };
        match kept.iter_mut().find(|other| other.row.scene == case.row.scene) {
            Some(other) if other.row.excess() < case.row.excess() => *other = case.clone(),
            Some(_) => continue,
            None => kept.push(case.clone()),
        }
        kept.sort_by(|a, b| b.row.excess().total_cmp(&a.row.excess()));
        kept.truncate(MOST);
        progress(&case);
    }
    Ok(kept)
}

/// Writes scenes to a folder, with a comment about how wrong their pictures were.
///
/// # Errors
///
/// Fails if a file can't be written.
pub fn keep(cases: &[Case], folder: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(folder).map_err(OutputError::of(folder.display()))?;
    for case in cases {
        let KeptRow { scene, wrong_pixels, floor } = &case.row;
        let path = folder.join(format!("{scene}.nff"));
        let text = format!("# {wrong_pixels} wrong pixels, floor {floor}.\n{}", case.text);
        fs::write(&path, text).map_err(OutputError::of(path.display()))?;
    }
    Ok(())
}

/// The kept scenes with their errors now, the worst first.
///
/// # Errors
///
/// Fails if a file can't be read or traced.
pub fn kept() -> Result<Vec<KeptRow>, PictureError> {
    let failed = |error| format!("{KEPT}: {error}");
    let mut rows = Vec::new();
    for entry in fs::read_dir(KEPT).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let text = fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let case = Case::of(name, text)?;
        rows.extend(case.map(|case| case.row));
    }
    rows.sort_by(|a, b| b.excess().total_cmp(&a.excess()).then_with(|| a.scene.cmp(&b.scene)));
    Ok(rows)
}

/// The scene with one number of an object or of the eye's position multiplied.
fn changed(text: &str, random: &mut Generator) -> String {
    let mut lines: Vec<Vec<String>> =
        text.lines().map(|line| line.split(' ').map(str::to_owned).collect()).collect();
    let is_changed = |line: &Vec<String>| {
        ["from", "s"].contains(&line[0].as_str()) || line[0].parse::<f64>().is_ok()
    };
    let places: Vec<usize> = (0..lines.len()).filter(|&at| is_changed(&lines[at])).collect();
    if let Some(&place) = places.choose(random) {
        let line = &mut lines[place];
        let word = random.random_range(usize::from(line.len() != 3)..line.len());
        if let Ok(number) = line[word].parse::<f64>() {
            let factor =
                1.0 + magnitude(-12, -1, random) * if random.random() { 1.0 } else { -1.0 };
            line[word] = (number * factor).to_string();
        }
    }
    let lines: Vec<String> = lines.into_iter().map(|line| line.join(" ")).collect();
    lines.join("\n") + "\n"
}

/// The eye, `distance` away from the origin, so that `size` fills the picture; and the lights.
fn view(distance: f64, size: f64, random: &mut Generator) -> String {
    let from = DVec3::from_array(direction(random)) * distance;
    let angle = 2.0 * libm::atan2(size, distance).to_degrees();
    let (width, height) = SIZE;
    let mut text = format!(
        "v\nfrom {}\nat 0 0 0\nup 0.1 0.2 1\nangle {angle}\nhither 0\nresolution {width} {height}\n\
         b 0.3 0.5 0.8\n",
        written(from)
    );
    for _ in 0..random.random_range(1..=2) {
        let far = DVec3::from_array(direction(random)) * size * random.random_range(3.0..30.0);
        _ = writeln!(text, "l {}", written(far));
    }
    text
}

fn written(point: DVec3) -> String {
    format!("{} {} {}", point.x, point.y, point.z)
}

fn point(size: f64, random: &mut Generator) -> DVec3 {
    DVec3::from_array(direction(random)) * random.random_range(0.0..size)
}

fn sphere(centre: DVec3, radius: impl Display) -> String {
    format!("s {} {radius}\n", written(centre))
}

fn mirror(random: &mut Generator) -> String {
    let colour = [(); 3].map(|()| random.random_range(0.2..1.0));
    format!("f {} 0.2 {} 50 0 1\n", written(colour.into()), random.random_range(0.5..0.95))
}

fn glass(random: &mut Generator) -> String {
    format!("f 1 0.95 0.9 0.05 0.1 50 0.9 {}\n", random.random_range(1.05..2.4))
}

fn matte(random: &mut Generator) -> String {
    let colour = [(); 3].map(|()| random.random_range(0.1..1.0));
    format!("f {} 1 0 1 0 1\n", written(colour.into()))
}

/// Glass spheres, each within the one before it, and one or two bodies beside them.
fn glass_in_glass(random: &mut Generator) -> String {
    let mut text = view(magnitude(1, 4, random), 1.5, random);
    let (mut centre, mut radius) = (DVec3::ZERO, 1.0);
    for _ in 0..random.random_range(1..=4) {
        text += &(glass(random) + &sphere(centre, radius));
        let inner = radius * random.random_range(0.3..0.98);
        centre += point(radius - inner, random);
        radius = inner;
    }
    for _ in 0..random.random_range(1..=2) {
        let radius = magnitude(-2, 1, random);
        let place = DVec3::from_array(direction(random)) * (1.0 + radius);
        text += &(matte(random) + &sphere(place, radius));
    }
    text
}

/// Two large mirrors that meet at a small angle, and mirrored spheres between them.
fn grazing_mirrors(random: &mut Generator) -> String {
    let mut text = view(magnitude(1, 4, random), 1.5, random);
    let tilt = magnitude(-10, -1, random);
    for (height, tilt) in [(-1.0, 0.0), (1.0, tilt)] {
        text += &mirror(random);
        let corners = [(-8.0, -8.0), (8.0, -8.0), (8.0, 8.0), (-8.0, 8.0)];
        let corner = |(x, y): (f64, f64)| written(DVec3::new(x, y, height + tilt * x)) + "\n";
        // Each mirror faces the other.
        let corners: Vec<String> = if height < 0.0 {
            corners.map(corner).into()
        } else {
            corners.into_iter().rev().map(corner).collect()
        };
        text += &format!("p 4\n{}", corners.concat());
    }
    for _ in 0..random.random_range(1..=4) {
        text += &(mirror(random) + &sphere(point(1.5, random), random.random_range(0.1..0.9)));
    }
    text
}

/// A huge sphere, and small ones that touch it.
fn large_beside_small(random: &mut Generator) -> String {
    let mut text = view(magnitude(1, 4, random), 1.5, random);
    let huge = magnitude(6, 18, random);
    text += &(mirror(random) + &sphere(DVec3::new(0.0, 0.0, -huge), huge));
    for _ in 0..random.random_range(1..=5) {
        let radius = magnitude(-4, 0, random);
        let (turn, out) = (random.random_range(0.0..TAU), random.random_range(0.0..1.5));
        let (sine, cosine) = libm::sincos(turn);
        let along = DVec3::new(out * cosine, out * sine, huge).normalize();
        let centre = along * (huge + radius) - DVec3::new(0.0, 0.0, huge);
        let finish = [mirror, glass, matte].choose(random).map(|make| make(random));
        text += &(finish.unwrap_or_default() + &sphere(centre, radius));
    }
    text
}

/// Spheres far from the eye.
fn far_away(random: &mut Generator) -> String {
    let mut text = view(magnitude(8, 17, random), 2.0, random);
    for _ in 0..random.random_range(2..=6) {
        let finish = [mirror, glass, matte].choose(random).map(|make| make(random));
        let radius = random.random_range(0.2..1.0);
        text += &(finish.unwrap_or_default() + &sphere(point(2.0, random), radius));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_two_to_six_objects_and_change() {
        for (name, make) in KINDS {
            let mut differ = 0;
            for round in 0..50 {
                let mut random = generator(3, &[name], round);
                let text = make(&mut random);
                let parse =
                    |text: &str| scenes::parse(text.as_bytes(), name, &scenes::Limits::default());
                let scene = parse(&text).unwrap();
                assert!((2..=6).contains(&scene.objects.len()), "{name}: {text}");
                let changed = changed(&text, &mut random);
                differ += u32::from(text != changed);
                assert!(text.lines().count() == changed.lines().count());
            }
            // A factor leaves a 0 as it is.
            assert!(differ > 30, "{name}: {differ} of 50");
        }
    }
}
