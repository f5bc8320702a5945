//! Height maps: what is read of each format, and what is refused.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use glam::DVec3;
use image::{DynamicImage, GrayImage, ImageBuffer, ImageFormat, RgbImage};
use scenes::HeightField;

use super::files::{load, refusal};

/// Heights of three columns and two rows, whose spread fits in the numbers of each format.
const HEIGHTS: [u8; 6] = [10, 20, 30, 40, 50, 250];

fn png(picture: impl Into<DynamicImage>) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    picture.into().write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

pub fn grey(columns: u32, heights: &[u8]) -> Vec<u8> {
    let rows = heights.len() as u32 / columns;
    png(GrayImage::from_raw(columns, rows, heights.to_vec()).unwrap())
}

pub fn npy(kind: &str, order: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\0", &length[..], header.as_bytes(), numbers].concat()
}

fn field(name: &str, bytes: &[u8]) -> (HeightField, Vec<String>) {
    let loaded = load(name, bytes).unwrap();
    (HeightField::clone(&loaded.scene.heights.unwrap()), loaded.notes)
}

/// The heights of all samples, as lengths.
fn lengths(field: &HeightField) -> Vec<f64> {
    let [columns, rows] = field.size().map(i64::from);
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let height = |(column, row)| field.unit() * f64::from(field.sample(column, row));
    places.map(|place| field.corner.y + height(place)).collect()
}

#[test]
fn all_formats_give_same_heights() {
    let (expected, notes) = field("t.png", &grey(3, &HEIGHTS));
    assert_eq!(expected.size(), [3, 2]);
    // An eighth of the two steps of the longer side.
    assert!(notes[0].starts_with("it has no scale, so its heights are drawn over 0.25 steps"));
    let found = lengths(&expected).into_iter().map(|it| it - lengths(&expected)[0]);
    let found: Vec<f64> = found.map(|it| it / 0.25 * 240.0).collect();
    let right = HEIGHTS.map(|height| f64::from(height) - 10.0);
    assert!(found.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");

    let wide = HEIGHTS.map(u16::from).to_vec();
    let deep = png(DynamicImage::ImageLuma16(ImageBuffer::from_raw(3, 2, wide).unwrap()));
    let mut files = vec![("t.png", deep)];
    let mut array = |kind: &str, numbers: Vec<u8>| {
        files.push(("t.npy", npy(kind, "False", "(2, 3)", &numbers)));
    };
    array("|u1", HEIGHTS.to_vec());
    array("<u2", HEIGHTS.map(|it| u16::from(it).to_le_bytes()).concat());
    array(">u2", HEIGHTS.map(|it| u16::from(it).to_be_bytes()).concat());
    array("<i2", HEIGHTS.map(|it| i16::from(it).to_le_bytes()).concat());
    array(">i2", HEIGHTS.map(|it| i16::from(it).to_be_bytes()).concat());
    array("<f4", HEIGHTS.map(|it| f32::from(it).to_le_bytes()).concat());
    array(">f4", HEIGHTS.map(|it| f32::from(it).to_be_bytes()).concat());
    array("<f8", HEIGHTS.map(|it| f64::from(it).to_le_bytes()).concat());
    array(">f8", HEIGHTS.map(|it| f64::from(it).to_be_bytes()).concat());
    let by_columns = [0, 3, 1, 4, 2, 5].map(|at| HEIGHTS[at]);
    files.push(("t.npy", npy("|u1", "True", "(2, 3)", &by_columns)));
    // The content decides the format.
    files.push(("t.obj", npy("|u1", "False", "(2, 3)", &HEIGHTS)));
    for (name, bytes) in files {
        assert_eq!(field(name, &bytes).0, expected, "{name}");
    }
}

/// Ground that no picture has, below 0 and between whole numbers, keeps its heights.
#[test]
fn numbers_of_any_range_are_kept() {
    let numbers = [-20.5_f32, -1e-3, 0.25, 1e5];
    let bytes = npy("<f4", "False", "(2, 2)", numbers.map(f32::to_le_bytes).as_flattened());
    let (field, _) = field("t.npy", &bytes);
    let found = lengths(&field);
    // The range is an eighth of a step high.
    let scale = 0.125 / (1e5 + 20.5);
    for (found, number) in found.iter().zip(numbers) {
        let error = (found / scale - f64::from(number)).abs();
        assert!(error <= 100_020.5 / 65535.0 / 2.0 + 1e-6, "{found} {number}");
    }
}

/// A tile near 60 degrees of latitude: its columns are half as far apart as its rows, so half of
/// them are left. What has no height gets that of the sample before it.
#[test]
fn tiles_of_srtm_are_in_metres() {
    let side = 1201;
    let mut heights = vec![100_i16; side * side];
    heights[side - 1] = -40;
    heights[2 * side] = i16::MIN;
    let bytes: Vec<u8> = heights.iter().flat_map(|height| height.to_be_bytes()).collect();
    let (tile, notes) = field("s60w001.hgt", &bytes);
    assert_eq!(tile.size(), [610, 1201]);
    assert!((tile.step() - 92.6625).abs() < 1e-9, "{}", tile.step());
    assert_eq!(tile.corner.y, -40.0);
    assert_eq!([tile.sample(0, 0), tile.sample(609, 0), tile.sample(0, 2)], [140, 0, 140]);
    assert_eq!(
        notes,
        [
            "1 of 1442401 samples have no height, and that of one beside them is drawn",
            "610 columns are made of its 1201, as far apart as its rows"
        ]
    );
    let (tile, notes) = field("alps.hgt", &bytes);
    assert_eq!(tile.size(), [1201, 1201]);
    assert!(notes[0].starts_with("its name has no latitude"), "{notes:?}");
    let found = refusal("N60E001.hgt", &bytes[1..]);
    assert!(found.contains("the file has 2884801 bytes; SRTM's have 2884802 for 1201"), "{found}");
}

#[test]
fn missing_heights_are_those_beside_them() {
    let none = f32::NAN;
    let numbers = [none, none, none, none, 7.0, none, none, none, 9.0_f32];
    let bytes = npy("<f4", "False", "(3, 3)", numbers.map(f32::to_le_bytes).as_flattened());
    let (field, notes) = field("t.npy", &bytes);
    let samples: Vec<u16> = (0..9).map(|at| field.sample(at % 3, at / 3)).collect();
    assert_eq!(samples, [0, 0, 0, 0, 0, 0, 2, 2, 2]);
    assert_eq!(notes[0], "7 of 9 samples have no height, and that of one beside them is drawn");
    let all = npy("<f4", "False", "(2, 2)", [none; 4].map(f32::to_le_bytes).as_flattened());
    assert_eq!(refusal("t.npy", &all), "not a valid height map: no sample has a height");
    let flat = load("t.png", &grey(2, &[3; 4])).unwrap().scene.heights.unwrap();
    assert_eq!(flat.bounds().0.y, flat.bounds().1.y);
}

#[test]
fn bad_files_are_refused() {
    let npy = |kind: &str, shape: &str, numbers: &[u8]| npy(kind, "False", shape, numbers);
    let whole = npy("<u2", "(2, 2)", &[0; 8]);
    let infinite = [0.0, f64::NEG_INFINITY, 0.0, 0.0].map(f64::to_le_bytes).concat();
    let size = "a height field of 60000 x 60000 samples: there must be 2 to 4097 in a row, and as \
                many rows";
    let cases: [(&str, Vec<u8>, &str); 13] = [
        ("t.png", grey(1, &[7]), "a height field of 1 x 1 samples"),
        ("t.png", grey(4098, &[0; 2 * 4098]), "a height field of 4098 x 2 samples"),
        ("t.png", png(RgbImage::new(4, 4)), "the picture has colours or is transparent"),
        ("t.png", grey(3, &HEIGHTS)[..50].to_vec(), "not a valid height map: "),
        ("t.npy", npy("<u2", "(60000, 60000)", &[0; 8]), size),
        ("t.npy", npy("<u2", "(99999999999, 2)", &[0; 8]), "a height field of 2 x 4294967295"),
        ("t.npy", npy("<u2", "(4,)", &[0; 8]), "its shape is (4,); a height map has two"),
        ("t.npy", npy("<c8", "(2, 2)", &[0; 32]), "its numbers are of the type \"<c8\""),
        ("t.npy", npy("<f8", "(2, 2)", &infinite), "the height in row 0, column 1 is -inf"),
        ("t.npy", whole[..whole.len() - 1].to_vec(), "states 2 x 2 numbers of type <u2, and 7"),
        ("t.npy", whole[..30].to_vec(), "the file ends inside its header"),
        ("t.npy", b"\x93NUMPY\x09\0\0\0".to_vec(), "its version is 9"),
        ("t.npy", b"PLAIN".to_vec(), "it doesn't begin as an array of numpy"),
    ];
    for (name, bytes, message) in cases {
        let found = refusal(name, &bytes);
        assert!(found.contains(message), "{found}");
    }
}

/// A scene, with a file of heights and of colours beside it.
fn scene(statement: &str, colours: &RgbImage) -> Result<meshes::Loaded, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("hills.png"), grey(3, &HEIGHTS)).unwrap();
    fs::write(folder.path().join("ground.png"), png(colours.clone())).unwrap();
    let path = folder.path().join("t.nff");
    let text = format!(
        "v\nfrom 0 9 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\nl 0 9 0\n\
         f 1 1 1 1 0 0 0 1\nf 0.5 1 1 1 0 0 0 1\n{statement}\n"
    );
    fs::write(&path, text).unwrap();
    let folder = format!("{}/", folder.path().display());
    meshes::load(Path::new(&path)).map_err(|error| error.to_string().replace(&folder, ""))
}

#[test]
fn scenes_name_heights_and_colours() {
    let colours = RgbImage::from_fn(3, 2, |x, y| image::Rgb([x as u8, y as u8, 9]));
    let loaded = scene("#cellray heights hills.png 2 0.5 ground.png # hills", &colours).unwrap();
    let field = loaded.scene.heights.as_ref().unwrap();
    assert_eq!((field.step(), field.unit(), field.material), (2.0, 0.5, 1));
    assert_eq!(field.corner, DVec3::new(-2.0, 5.0, -1.0));
    assert_eq!([field.colour(2, 1), field.colour(0, 1)], [[2, 1, 9], [0, 1, 9]]);
    assert_eq!(lengths(field), HEIGHTS.map(|height| f64::from(height) / 2.0));
    let plain = scene("#cellray heights hills.png 2 0.5", &colours).unwrap();
    let field = plain.scene.heights.unwrap();
    // High ground is snow unless it is steep, and low ground is not.
    assert_ne!(field.colour(0, 0), field.colour(2, 1));

    for (statement, message) in [
        (
            "#cellray heights none.png 1 1",
            "t.nff:11: none.png: No such file or directory (os error 2)",
        ),
        ("#cellray heights t.nff 1 1", "t.nff:11: t.nff: not a valid height map: it is neither"),
        ("#cellray heights hills.png 1 1 t.nff", "t.nff:11: t.nff: not a valid height map: it is"),
        ("#cellray heights hills.png 0 1", "t.nff:11: height map step 0 is not above 0"),
        ("#cellray heights hills.png 1", "t.nff:11: height map unit is missing"),
    ] {
        let found = scene(statement, &colours).unwrap_err();
        assert!(found.starts_with(message), "{found}");
    }
    let found = scene("#cellray heights hills.png 1 1 ground.png", &RgbImage::new(4, 2));
    let message = "t.nff:11: ground.png: not a valid height map: the picture of colours has 4 x 2 \
                   pixels for 3 x 2 samples";
    assert_eq!(found.unwrap_err(), message);
}
