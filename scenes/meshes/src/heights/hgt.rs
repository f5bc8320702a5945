//! Tiles of the Shuttle Radar Topography Mission: a degree of latitude and of longitude each, in
//! metres, row by row from the north, big-endian.

use std::path::Path;

use super::Map;
use crate::Fault;

/// Samples of a side, in steps of three arc seconds and of one.
const SIDES: [u32; 2] = [1201, 3601];
/// The height of a sample that has none.
const VOID: i16 = i16::MIN;
/// Metres of a degree of latitude.
const DEGREE: f64 = 111_195.0;

pub(super) fn read(bytes: &[u8], file: &Path) -> Result<Map, Fault> {
    let size = |side: u32| 2 * side as usize * side as usize;
    let Some(side) = SIDES.into_iter().find(|&side| size(side) == bytes.len()) else {
        let [small, large] = SIDES;
        return Err(Fault::HeightMap(format!(
            "the file has {} bytes; SRTM's have {} for {small} x {small} samples, or {} for \
             {large} x {large}",
            bytes.len(),
            size(small),
            size(large)
        )));
    };
    let heights = bytes.chunks_exact(2).map(|pair| match i16::from_be_bytes([pair[0], pair[1]]) {
        VOID => f64::NAN,
        height => height.into(),
    });
    let mut notes = Vec::new();
    if latitude(file).is_none() {
        notes.push(
            "its name has no latitude, as in N46E008.hgt, so degrees of longitude are drawn as \
             long as those of latitude"
                .to_owned(),
        );
    }
    let step = DEGREE / f64::from(side - 1);
    Ok(Map { size: [side; 2], heights: heights.collect(), scale: Some((step, 1.0)), notes })
}

/// The latitude of a tile's middle in degrees, by its name.
fn latitude(file: &Path) -> Option<f64> {
    let name = file.file_stem()?.to_str()?;
    let degrees: f64 = name.get(1..3)?.parse::<u8>().ok()?.into();
    match name.get(..1)? {
        "N" | "n" => Some(degrees + 0.5),
        "S" | "s" => Some(degrees - 0.5),
        _ => None,
    }
    .filter(|degrees| (0.0..85.0).contains(degrees))
}

/// Leaves as many columns as make steps to the east as long as those to the south.
pub(super) fn narrow(map: &mut Map, file: &Path) {
    let Some(latitude) = latitude(file) else {
        return;
    };
    let [old, rows] = map.size;
    let last = f64::from(old - 1);
    let columns = 1 + (last * libm::cos(latitude.to_radians())).round() as u32;
    let place = |column: u32| f64::from(column) * last / f64::from(columns - 1);
    let mean = |row: &[f64], place: f64| {
        let (first, part) = (place as usize, place.fract());
        row[first] + part * (row[(first + 1).min(row.len() - 1)] - row[first])
    };
    let all = map.heights.chunks(old as usize);
    let all = all.flat_map(|row| (0..columns).map(move |column| mean(row, place(column)).round()));
    map.heights = all.collect();
    map.size = [columns, rows];
    map.notes.push(format!("{columns} columns are made of its {old}, as far apart as its rows"));
}
