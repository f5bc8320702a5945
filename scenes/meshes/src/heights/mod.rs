//! Reads height maps: grey PNG pictures, SRTM's `.hgt`, and numpy's `.npy`.
//!
//! Invariant: a height field of a file has its size. Where the file has no height, the ground has
//! that of a sample beside it.

mod hgt;
mod npy;

use std::path::Path;

use glam::DVec3;
use image::{DynamicImage, GenericImageView as _};
use scenes::{HeightError, HeightField, HeightMap, MAX_SAMPLES, Material, View};

use crate::texture::reader;
use crate::{Error, Fault, Loaded, bytes, mountains};

/// The height of a map without a scale, as a part of its longer side.
const RISE: f64 = 0.125;
/// The way from the middle of a map to the eye, in longer sides.
const TO_EYE: DVec3 = DVec3::new(0.28, 0.44, 0.93);
/// The heights in whose colours the lowest and the highest ground of a file without colours are
/// drawn, in metres of the generated mountains.
const BANDS: (f64, f64) = (500.0, 1550.0);

/// A format of height maps.
#[derive(Clone, Copy)]
pub(crate) enum Format {
    Png,
    Hgt,
    Npy,
}

/// What a file has.
struct Map {
    size: [u32; 2],
    /// Row by row. NaN is none.
    heights: Vec<f64>,
    /// The distance between samples, and the length of a height of 1.
    scale: Option<(f64, f64)>,
    notes: Vec<String>,
}

/// Reads a file as a scene by itself.
pub(crate) fn read(bytes: &[u8], file: &Path, format: Format) -> Result<Loaded, Fault> {
    let mut map = map(bytes, file, format)?;
    let scale = map.scale.unwrap_or_else(|| {
        let side = map.size[0].max(map.size[1]) - 1;
        let [low, high] = map.range();
        let rise = RISE * f64::from(side);
        map.notes.push(format!(
            "it has no scale, so its heights are drawn over {rise} steps between samples; in an \
             NFF file, `#cellray heights` has a scale"
        ));
        (1.0, if high > low { rise / (high - low) } else { 1.0 })
    });
    let field = map.field(scale, None)?;
    let (low, high) = field.bounds();
    let middle = low.midpoint(high);
    let view = View {
        from: middle + (high - low).with_y(0.0).max_element() * TO_EYE,
        at: middle,
        up: DVec3::Y,
        angle: 40.0,
        hither: 0.0,
        resolution: (1280, 720),
    };
    let name = file.display().to_string();
    let notes = map.notes.into_iter().map(|note| format!("{name}: {note}")).collect();
    let scene = mountains::lit(name, view, field, vec![Material::matte(DVec3::ONE)], Vec::new());
    Ok(Loaded { scene, added_light: false, animation: None, notes })
}

/// Reads the height field that a scene names a file of, and notes about it.
pub(crate) fn named(
    scene: &scenes::Scene,
    map: &HeightMap,
) -> Result<(HeightField, Vec<String>), Error> {
    let folder = Path::new(&scene.name).parent().unwrap_or(Path::new(""));
    let wrong = |path: &Path, fault: Fault| Error::Line {
        file: scene.name.clone(),
        line: map.line as usize,
        what: format!("{}: {fault}", path.display()),
    };
    let path = folder.join(&map.file);
    let read = || -> Result<Map, Fault> {
        let bytes = bytes(&path)?;
        match crate::Format::of(&path)? {
            Some(crate::Format::Heights(format)) => self::map(&bytes, &path, format),
            _ => Err(Fault::HeightMap("it is neither PNG, .hgt nor .npy".to_owned())),
        }
    };
    let found = read().map_err(|fault| wrong(&path, fault))?;
    let colours = map.colours.as_ref().map(|name| {
        let path = folder.join(name);
        picture(&path, found.size).map_err(|fault| wrong(&path, fault))
    });
    let field = found.field(map.scale, colours.transpose()?);
    let mut field = field.map_err(|error| wrong(&path, error.into()))?;
    field.material = map.material;
    let notes = found.notes.into_iter().map(|note| format!("{}: {note}", path.display()));
    Ok((field, notes.collect()))
}

fn map(bytes: &[u8], file: &Path, format: Format) -> Result<Map, Fault> {
    let mut map = match format {
        Format::Png => grey(bytes),
        Format::Hgt => hgt::read(bytes, file),
        Format::Npy => npy::read(bytes),
    }?;
    map.fill()?;
    if matches!(format, Format::Hgt) {
        hgt::narrow(&mut map, file);
    }
    Ok(map)
}

/// A number of samples that a height field may have, before there is memory for them.
fn allowed([columns, rows]: [u32; 2]) -> Result<[u32; 2], HeightError> {
    let is_allowed = |side| (2..=MAX_SAMPLES).contains(&side);
    match is_allowed(columns) && is_allowed(rows) {
        true => Ok([columns, rows]),
        false => Err(HeightError::Size { columns, rows }),
    }
}

/// The heights of a grey picture: 0 to 255 or to 65535.
fn grey(bytes: &[u8]) -> Result<Map, Fault> {
    let size = reader(bytes).map_err(Fault::HeightMap)?.into_dimensions();
    let size = allowed(size.map_err(|error| Fault::HeightMap(error.to_string()))?.into())?;
    let heights = match decoded(bytes)? {
        DynamicImage::ImageLuma8(grey) => grey.into_raw().into_iter().map(f64::from).collect(),
        DynamicImage::ImageLuma16(grey) => grey.into_raw().into_iter().map(f64::from).collect(),
        _ => {
            let what = "the picture has colours or is transparent; heights are in a grey one";
            return Err(Fault::HeightMap(what.to_owned()));
        }
    };
    Ok(Map { size, heights, scale: None, notes: Vec::new() })
}

fn decoded(bytes: &[u8]) -> Result<DynamicImage, Fault> {
    let reader = reader(bytes).map_err(Fault::HeightMap)?;
    reader.decode().map_err(|error| Fault::HeightMap(error.to_string()))
}

/// The colours of a picture that has a pixel for each sample.
fn picture(file: &Path, [columns, rows]: [u32; 2]) -> Result<Vec<[u8; 3]>, Fault> {
    let decoded = decoded(&bytes(file)?)?;
    if decoded.dimensions() != (columns, rows) {
        let (width, height) = decoded.dimensions();
        return Err(Fault::HeightMap(format!(
            "the picture of colours has {width} x {height} pixels for {columns} x {rows} samples"
        )));
    }
    Ok(decoded.into_rgb8().pixels().map(|pixel| pixel.0).collect())
}

impl Map {
    /// The lowest and the highest height.
    fn range(&self) -> [f64; 2] {
        let all = self.heights.iter();
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &height| {
            [low.min(height), high.max(height)]
        })
    }

    /// Gives samples without a height that of the one before them in their row, else that of the
    /// one after, and rows without any that of the row before or after.
    fn fill(&mut self) -> Result<(), Fault> {
        let columns = self.size[0] as usize;
        let infinite = self.heights.iter().position(|height| height.is_infinite());
        if let Some(at) = infinite {
            let (row, column) = (at / columns, at % columns);
            let height = self.heights[at];
            return Err(Fault::HeightMap(format!(
                "the height in row {row}, column {column} is {height}"
            )));
        }
        let missing = self.heights.iter().filter(|height| height.is_nan()).count();
        if missing == self.heights.len() {
            return Err(Fault::HeightMap("no sample has a height".to_owned()));
        }
        if missing == 0 {
            return Ok(());
        }
        for row in self.heights.chunks_mut(columns) {
            spread(row);
        }
        for column in 0..columns {
            let own = self.heights.iter().skip(column).step_by(columns);
            let mut own: Vec<f64> = own.copied().collect();
            spread(&mut own);
            let to = self.heights.iter_mut().skip(column).step_by(columns);
            to.zip(own).for_each(|(to, height)| *to = height);
        }
        self.notes.push(format!(
            "{missing} of {} samples have no height, and that of one beside them is drawn",
            self.heights.len()
        ));
        Ok(())
    }

    /// The height field, with colours by height and slope if there are none.
    fn field(
        &self,
        (step, unit): (f64, f64),
        colours: Option<Vec<[u8; 3]>>,
    ) -> Result<HeightField, HeightError> {
        let [low, high] = self.range();
        let are_counts = high - low <= f64::from(u16::MAX);
        let are_counts = are_counts && self.heights.iter().all(|height| height.fract() == 0.0);
        let part = match are_counts || high == low {
            true => 1.0,
            false => (high - low) / f64::from(u16::MAX),
        };
        let counts = self.heights.iter().map(|height| ((height - low) / part).round() as u16);
        let colours = colours.unwrap_or_else(|| {
            let lengths: Vec<f64> = self.heights.iter().map(|height| unit * height).collect();
            let band = (BANDS.1 - BANDS.0) / (unit * (high - low)).max(f64::MIN_POSITIVE);
            let metres = |height| BANDS.0 + band * (height - unit * low);
            mountains::colours(self.size, &lengths, step, metres)
        });
        let mut field = HeightField::new(self.size, counts.collect(), colours, step, part * unit)?;
        field.corner.y = unit * low;
        Ok(field)
    }
}

/// Gives each NaN the number before it, or the first one.
fn spread(numbers: &mut [f64]) {
    let Some(&first) = numbers.iter().find(|number| !number.is_nan()) else {
        return;
    };
    numbers.iter_mut().fold(first, |last, number| {
        if number.is_nan() {
            *number = last;
        }
        *number
    });
}
