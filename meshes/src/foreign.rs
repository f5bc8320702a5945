//! Files of other programs: names their formats, so that a message says what a file is.

use std::path::Path;

/// How files of a format begin.
const BEGINNINGS: [(&[u8], &str); 15] = [
    (b"Kaydara FBX Binary", "an FBX file"),
    (b"; FBX", "an FBX file"),
    (b"BLENDER", "a Blender (.blend) file"),
    (b"#usda", "a USD file"),
    (b"PXR-USDC", "a USD file"),
    (b"#VRML", "a VRML file"),
    (b"#X3D", "an X3D file"),
    (b"ISO-10303-21", "a STEP file"),
    (b"OFF\n", "an OFF file"),
    (b"COFF\n", "an OFF file"),
    (b"xof ", "a DirectX (.x) file"),
    (b"3D Geometry File Format", "a Rhino (.3dm) file"),
    (b"#INVENTOR", "an Open Inventor file"),
    (
        b"nff\n",
        "a Sense8 (WorldToolKit) NFF file, not one of Eric Haines' Neutral File Format",
    ),
    (
        b"nff\r",
        "a Sense8 (WorldToolKit) NFF file, not one of Eric Haines' Neutral File Format",
    ),
];

/// The endings of names of formats whose beginnings say less.
const ENDINGS: [(&str, &str); 25] = [
    ("3dm", "a Rhino (.3dm) file"),
    ("3ds", "a 3D Studio (.3ds) file"),
    ("3mf", "a 3MF file"),
    ("abc", "an Alembic file"),
    ("blend", "a Blender (.blend) file"),
    ("c4d", "a Cinema 4D file"),
    ("dae", "a COLLADA (.dae) file"),
    ("dwg", "an AutoCAD file"),
    ("dxf", "an AutoCAD file"),
    ("fbx", "an FBX file"),
    ("iges", "an IGES file"),
    ("igs", "an IGES file"),
    ("lwo", "a LightWave file"),
    ("ma", "a Maya file"),
    ("max", "a 3ds Max file"),
    ("mb", "a Maya file"),
    ("off", "an OFF file"),
    ("skp", "a SketchUp file"),
    ("step", "a STEP file"),
    ("stp", "a STEP file"),
    ("usd", "a USD file"),
    ("usda", "a USD file"),
    ("usdc", "a USD file"),
    ("usdz", "a USD file"),
    ("wrl", "a VRML file"),
];

/// The format of a file that is not read, with its article, if its beginning or its name tell it.
pub(crate) fn of(name: &Path, beginning: &[u8]) -> Option<&'static str> {
    of_bytes(beginning).or_else(|| of_name(name))
}

/// The format of a file by how it begins.
pub(crate) fn of_bytes(beginning: &[u8]) -> Option<&'static str> {
    let text = beginning.strip_prefix(b"\xef\xbb\xbf").unwrap_or(beginning);
    let text = text.trim_ascii_start();
    let mut known = BEGINNINGS.iter();
    if let Some((_, name)) = known.find(|(start, _)| text.starts_with(start)) {
        return Some(name);
    }
    let has = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
    if !text.starts_with(b"<") {
        None
    } else if has(b"<COLLADA") {
        Some("a COLLADA (.dae) file")
    } else if has(b"<X3D") {
        Some("an X3D file")
    } else {
        None
    }
}

/// The format of a file by the end of its name.
fn of_name(name: &Path) -> Option<&'static str> {
    let ending = name.extension()?.to_str()?.to_ascii_lowercase();
    let found = ENDINGS.iter().find(|(known, _)| *known == ending);
    found.map(|&(_, name)| name)
}
