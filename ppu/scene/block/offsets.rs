//! Scenes whose numbers are too unlike for singles.
//!
//! A ray starts off the surface that it leaves, by an offset that grows with the object's numbers
//! relative to the eye, because a hit is off by their rounding; docs/whitted.md has the formula.
//! It can't see what is nearer to the surface than that. So a ground of a million times the size of
//! what stands on it shows no shadows. All numbers are in range there, and every ray is
//! right for where it starts.

use scenes::{Scene, Shape};

use super::bounds::Bounds;
use super::error::BlockError;
use super::objects::{self, Object};
use super::source_location::SourceLocation;

/// The largest part of the smallest object's radius that an offset may be. A ball of radius r that
/// rests on a surface hides its shadow's first sqrt(2 offset r), which is a third of r at this
/// limit: less than what the ball itself hides from most eyes.
const MAX_RATIO: f64 = 1.0 / 16.0;

/// An object's size, and how far rays leave its surface.
#[derive(Clone, Copy)]
struct Extent {
    line: u32,
    what: &'static str,
    /// Half of its bounding box's diagonal; a sphere's radius.
    size: f64,
    leave: f64,
}

/// See [`offset_note`](crate::scene::offset_note).
pub(crate) fn offset_note(scene: &Scene) -> Option<String> {
    let extents = || scene.objects.iter().filter_map(|it| extent(scene, it));
    let extremes = extents().fold(None, |found: Option<(Extent, Extent)>, it| {
        let (smallest, largest) = found.unwrap_or((it, it));
        Some((
            if it.size < smallest.size { it } else { smallest },
            if it.leave > largest.leave { it } else { largest },
        ))
    });
    let (smallest, largest) = extremes?;
    let limit = MAX_RATIO * smallest.size;
    if largest.leave <= limit {
        return None;
    }
    let others = extents().filter(|it| it.leave > limit).count() - 1;
    let others = match others {
        0 => String::new(),
        others => format!("; {others} more object(s) are as far off"),
    };
    let place = SourceLocation { file: &scene.name, line: Some(largest.line) };
    let Extent { what, leave, .. } = largest;
    let Extent { line, size, .. } = smallest;
    let (leave, across) = (rounded(leave), rounded(2.0 * size));
    Some(format!(
        "{place}: rays leave this {what} {leave} off its surface, because its numbers are so \
         large, and miss the shadows and reflections of what is as near as that, such as the {} \
         in line {line}, {across} across: make the {what} smaller or move it nearer{others}",
        smallest.what
    ))
}

/// A number above 0 with three digits.
fn rounded(value: f64) -> f64 {
    let step = libm::exp10(libm::log10(value).floor() - 2.0);
    // A quotient by a whole number is the nearest double to what is printed.
    match step < 1.0 {
        true => (value / step).round() / step.recip().round(),
        false => (value / step).round() * step,
    }
}

/// `None` if it has no surface.
fn extent(scene: &Scene, object: &scenes::Object) -> Option<Extent> {
    let material = scene.materials.get(object.material as usize)?;
    let place = SourceLocation { file: &scene.name, line: Some(object.line) };
    let (mut bounds, mut leave) = (None::<Bounds>, 0.0_f64);
    let mut add = |primitive, sides| -> Result<(), BlockError> {
        let part = Object { primitive, sides, material: object.material };
        let hull = part.primitive.hull().bounds();
        bounds = Some(bounds.map_or(hull, |bounds| bounds.with(hull)));
        leave = leave.max(part.leave(scene.view.from));
        Ok(())
    };
    // A number that is out of range is an error of the scene itself.
    objects::of_shape(&object.shape, material, place, &mut add).ok()?;
    let what = match object.shape {
        Shape::Sphere { .. } => "sphere",
        Shape::Cone { .. } => "cone",
        Shape::Polygon { .. } | Shape::Patch { .. } => "polygon",
    };
    let half = 0.5 * bounds?.size();
    let size = match object.shape {
        Shape::Sphere { radius, .. } => radius.abs(),
        _ => half.length(),
    };
    Some(Extent { line: object.line, what, size, leave })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use scenes::Limits;

    use super::*;

    /// The largest offset of a scene relative to its smallest object.
    fn ratio(scene: &Scene) -> f64 {
        let extents = scene.objects.iter().filter_map(|it| extent(scene, it));
        let (size, leave) = extents.fold((f64::INFINITY, 0.0_f64), |(size, leave), it| {
            (it.size.min(size), it.leave.max(leave))
        });
        leave / size
    }

    #[test]
    fn scenes_and_generators_have_small_offsets() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        let files = std::fs::read_dir(folder).unwrap();
        let files = files.map(|entry| entry.unwrap().path());
        let mut scenes: Vec<_> =
            files.filter(|path| path.extension().is_some_and(|it| it == "nff")).collect();
        assert!(scenes.len() > 10, "{scenes:?}");
        let generated = ["sphereflake:0", "sphereflake:4", "tetra:1", "tetra:6"];
        scenes.extend(generated.map(Into::into));
        for name in scenes {
            let scene = scenes::load(&name).unwrap();
            let ratio = ratio(&scene);
            assert!(ratio < 0.75 * MAX_RATIO, "{}: {ratio}", name.display());
            assert_eq!(offset_note(&scene), None, "{}", name.display());
        }
    }

    const BALLS: &str = "v\nfrom 0 3 9\nat 0 1 0\nup 0 1 0\nangle 40\nhither 1\n\
                         resolution 32 24\nl 5 9 5\nf 1 1 1 1 0 0 0 1\ns 0 1 0 1\ns 3 1 0 1\n";

    fn with(object: &str) -> Scene {
        let text = format!("{BALLS}{object}\n");
        scenes::parse(text.as_bytes(), "balls.nff", &Limits::default()).unwrap()
    }

    #[test]
    fn ground_without_correct_shadows_is_named_with_line() {
        for ground in [
            "s 0 -1000000 0 1000000",
            "p 4\n-1e6 0 -1e6\n-1e6 0 1e6\n1e6 0 1e6\n1e6 0 -1e6",
            "s 0 -400000 0 400000",
        ] {
            let note = offset_note(&with(ground)).unwrap_or_else(|| panic!("none for {ground}"));
            assert!(note.starts_with("balls.nff:12: "), "{note}");
            assert!(note.contains("line 10, 2 across"), "{note}");
            assert!(!note.contains("more"), "{note}");
        }
        let note = offset_note(&with("s 0 -1000000 0 1000000")).unwrap();
        assert!(note.contains("this sphere 0.477 off"), "{note}");
    }

    #[test]
    fn ordinary_ground_loses_no_shadows() {
        for ground in ["s 0 -1000 0 1000", "s 0 -100000 0 100000"] {
            assert_eq!(offset_note(&with(ground)), None, "{ground}");
        }
    }

    #[test]
    fn objects_far_from_the_eye_are_named() {
        let text = BALLS.replace("from 0 3 9", "from 0 3 1000000");
        let scene = scenes::parse(text.as_bytes(), "balls.nff", &Limits::default()).unwrap();
        let note = offset_note(&scene).unwrap();
        assert!(note.contains("1 more object(s)"), "{note}");
    }
}
